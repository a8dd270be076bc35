//! Bindings of `morph`.

use nearfar_core::base::{Error, Result};
use nearfar_core::morph::{Kind, Morph};
use numpy::PyReadwriteArray2;
use pyo3::prelude::*;

use crate::convert::arrays::Points;
use crate::convert::errors::to_python;
use crate::convert::names::choice;
use crate::convert::one_of::one_of;
use crate::convert::run;

one_of! {
    pub(crate) enum Shown<'py> {
        Single(PyReadwriteArray2<'py, f32>),
        Double(PyReadwriteArray2<'py, f64>),
    }
}

pub(crate) fn kind(name: &str) -> Result<Kind> {
    choice("kind", name, &[("blend", Kind::Blend), ("cylinder", Kind::Cylinder)])
}

/// Writes morphed points. Returns the number of points that user and centre see in opposite directions.
#[pyfunction]
#[pyo3(signature = (points, shown, *, user, center, r1, r2, kind, strength))]
#[expect(clippy::too_many_arguments, reason = "named ones, as Python passes them")]
pub(crate) fn morph<'py>(
    py: Python<'py>,
    points: Points<'py>,
    shown: Shown<'py>,
    user: [f64; 3],
    center: [f64; 3],
    r1: f64,
    r2: f64,
    kind: &str,
    strength: f64,
) -> PyResult<u64> {
    let make = || Morph::new(user.into(), center.into(), r1, r2, self::kind(kind)?)?.with_strength(strength);
    match (&points, shown) {
        (Points::Single(points), Shown::Single(mut shown)) => {
            let (rows, to) = (points.as_slice()?.as_chunks::<3>().0, shown.as_slice_mut()?.as_chunks_mut::<3>().0);
            run::long(py, None, |progress| make()?.apply_all_f32(rows, to, progress))
        }
        (Points::Double(points), Shown::Double(mut shown)) => {
            let (rows, to) = (points.as_slice()?.as_chunks::<3>().0, shown.as_slice_mut()?.as_chunks_mut::<3>().0);
            run::long(py, None, |progress| make()?.apply_all_f64(rows, to, progress))
        }
        _ => Err(to_python(Error::value("out", "the type of points", "another one"))),
    }
}
