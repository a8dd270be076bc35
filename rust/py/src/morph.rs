//! Bindings of `morph` and `bend`.

use nearfar_core::base::Error;
use nearfar_core::bend;
use nearfar_core::morph::{Kind, Morph};
use numpy::IntoPyArray;
use pyo3::prelude::*;

use crate::convert::{Array1, Points, Read2, Report, Write2, argument_enum, choice, run, to_python};

argument_enum! {
    pub enum Morphed<'py> {
        Single(Write2<'py, f32>),
        Double(Write2<'py, f64>),
    }
}

/// Arguments of a morph, by the names in the result of `kernel_arguments`.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct MorphArguments {
    user: [f64; 3],
    center: [f64; 3],
    r1: f64,
    r2: f64,
    kind: String,
    strength: f64,
}

impl MorphArguments {
    pub fn convert(&self) -> PyResult<Morph> {
        choice("kind", &self.kind, &[("blend", Kind::Blend), ("cylinder", Kind::Cylinder)])
            .and_then(|kind| Morph::new(self.user.into(), self.center.into(), self.r1, self.r2, kind))
            .and_then(|morph| morph.with_strength(self.strength))
            .map_err(to_python)
    }
}

/// Writes morphed points. Returns the number of points that user and centre see in opposite directions.
#[pyfunction]
pub fn morph(py: Python<'_>, points: Points<'_>, morphed: Morphed<'_>, arguments: MorphArguments) -> PyResult<u64> {
    let morph = arguments.convert()?;
    match (&points, morphed) {
        (Points::Single(points), Morphed::Single(mut morphed)) => {
            let (rows, to) = (points.as_slice()?.as_chunks::<3>().0, morphed.as_slice_mut()?.as_chunks_mut::<3>().0);
            run::long(py, None, |progress| morph.apply_all(rows, to, progress))
        }
        (Points::Double(points), Morphed::Double(mut morphed)) => {
            let (rows, to) = (points.as_slice()?.as_chunks::<3>().0, morphed.as_slice_mut()?.as_chunks_mut::<3>().0);
            run::long(py, None, |progress| morph.apply_all(rows, to, progress))
        }
        _ => Err(to_python(Error::value("out", "the type of points", "another one"))),
    }
}

/// Polylines (N, K, 3) as a flat array padded with NaN, and their length K.
#[pyfunction]
#[pyo3(signature = (directions, morph, *, tolerance, report=None))]
pub fn bend_rays<'py>(
    py: Python<'py>,
    directions: Read2<'py, f64>,
    morph: MorphArguments,
    tolerance: f64,
    report: Report,
) -> PyResult<(Array1<'py, f64>, usize)> {
    let (morph, rows) = (morph.convert()?, directions.as_slice()?.as_chunks::<3>().0);
    let (points, length) = run::long(py, report, |progress| bend::bend_rays(&morph, rows, tolerance, progress))?;
    Ok((points.into_flattened().into_pyarray(py), length))
}

/// Fold margin in metres.
#[pyfunction]
pub fn fold_margin(py: Python<'_>, morph: MorphArguments) -> PyResult<f64> {
    let morph = morph.convert()?;
    run::short(py, || bend::margin(&morph))
}
