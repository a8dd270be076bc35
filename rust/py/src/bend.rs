//! Bindings of `bend`.

use nearfar_core::bend;
use nearfar_core::morph::Morph;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::convert::errors::to_python;
use crate::convert::run;
use crate::morph::kind;

fn morph(user: [f64; 3], center: [f64; 3], [r1, r2]: [f64; 2], (name, strength): (&str, f64)) -> PyResult<Morph> {
    let full = kind(name).and_then(|kind| Morph::new(user.into(), center.into(), r1, r2, kind));
    full.and_then(|morph| morph.with_strength(strength)).map_err(to_python)
}

/// Polylines (N, K, 3) as a flat array padded with NaN, and their length K.
#[pyfunction]
#[pyo3(signature = (directions, *, user, center, r1, r2, kind, strength, tolerance, report=None))]
#[expect(clippy::too_many_arguments, reason = "keywords of a Python function")]
pub(crate) fn bend_rays<'py>(
    py: Python<'py>,
    directions: PyReadonlyArray2<'py, f64>,
    user: [f64; 3],
    center: [f64; 3],
    r1: f64,
    r2: f64,
    kind: &str,
    strength: f64,
    tolerance: f64,
    report: Option<Py<PyAny>>,
) -> PyResult<(Bound<'py, PyArray1<f64>>, usize)> {
    let morph = morph(user, center, [r1, r2], (kind, strength))?;
    let rows = directions.as_slice()?.as_chunks::<3>().0;
    let (points, longest) = run::long(py, report, |progress| bend::bend_rays(&morph, rows, tolerance, progress))?;
    Ok((points.into_flattened().into_pyarray(py), longest))
}

/// Fold margin in metres.
#[pyfunction]
#[pyo3(signature = (user, *, center, r1, r2, kind, strength))]
pub(crate) fn fold_margin(
    py: Python<'_>,
    user: [f64; 3],
    center: [f64; 3],
    r1: f64,
    r2: f64,
    kind: &str,
    strength: f64,
) -> PyResult<f64> {
    let morph = morph(user, center, [r1, r2], (kind, strength))?;
    run::short(py, || bend::margin(&morph))
}
