//! Bindings of `bend`.

use nearfar_core::bend;
use numpy::IntoPyArray;
use pyo3::prelude::*;

use crate::convert::{Array1, Read2, Report, run};
use crate::morph::MorphArguments;

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
