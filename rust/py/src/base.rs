//! Bindings of `base`: random numbers, the thread count, and a kernel that tests of the policies call.

use std::thread;
use std::time::Duration;

use nearfar_core::base::{Error, Progress, Result, pool, random};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::convert::arrays::filled;
use crate::convert::errors::to_python;
use crate::convert::run;

/// A float64 in [0, 1) for each index.
#[pyfunction]
pub(crate) fn uniform<'py>(
    py: Python<'py>,
    seed: u64,
    cell: u64,
    index: PyReadonlyArray1<'py, u64>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let index = index.as_slice()?;
    filled(py, index.len(), |draws| {
        run::long(py, None, |progress| random::fill_uniform(seed, cell, index, draws, progress))
    })
}

/// Number of threads of the pool.
#[pyfunction]
pub(crate) fn thread_count() -> PyResult<usize> {
    pool::thread_count().map_err(to_python)
}

/// Test kernel for cancellation, forking and panics. "wait" runs until it is cancelled, "panic" panics on a pool
/// thread, other values return a kernel error.
#[pyfunction]
#[pyo3(signature = (behaviour, report=None))]
pub(crate) fn probe(py: Python<'_>, behaviour: &str, report: Option<Py<PyAny>>) -> PyResult<()> {
    run::long(py, report, |progress| behave(behaviour, progress))
}

fn behave(behaviour: &str, progress: &Progress) -> Result<()> {
    match behaviour {
        "wait" => loop {
            progress.report(1)?;
            thread::sleep(Duration::from_millis(1));
        },
        "panic" => std::panic::panic_any("asked to panic"),
        other => Err(Error::value("behaviour", "'wait' or 'panic'", format!("'{other}'"))),
    }
}
