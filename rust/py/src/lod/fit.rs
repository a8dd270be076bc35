//! Bindings of `lod`: curves fitted to samples of SSIM.

use nearfar_core::lod::{self, LogisticCurve, Status, Unfit};
use numpy::PyArray1;
use pyo3::prelude::*;

use crate::convert::{Array1, Array2, Read1, Report, array_of_rows, run};

/// Code of a result: its row in the table of results in `nearfar.lod`.
fn code(status: Status) -> u8 {
    match status {
        Status::Fitted => 0,
        Status::Step => 1,
        Status::Open => 2,
        Status::Constant => 3,
        Status::Flat => 4,
        Status::Unfit(Unfit::TooFew) => 5,
        Status::Unfit(Unfit::Negative) => 6,
        Status::Unfit(Unfit::Overflow) => 7,
    }
}

/// Rows of parameters, and a result code for each row.
type Fits<'py> = (Array2<'py, f64>, Array1<'py, u8>);

/// Fits curves: rows of a, b, c, d and rms, and the result code of each fit.
#[pyfunction]
#[pyo3(signature = (x, y, *, count, report=None))]
pub fn fit_4pl<'py>(
    py: Python<'py>,
    x: Read1<'py, f64>,
    y: Read1<'py, f64>,
    count: usize,
    report: Report,
) -> PyResult<Fits<'py>> {
    let (x, y) = (x.as_slice()?, y.as_slice()?);
    let curves = run::long(py, report, |progress| lod::fit_4pl(x, y, count, progress))?;
    let rows = curves.iter().map(|&LogisticCurve { a, b, c, d, rms, .. }| [a, b, c, d, rms]).collect();
    Ok((array_of_rows(py, rows)?, PyArray1::from_iter(py, curves.iter().map(|curve| code(curve.status)))))
}
