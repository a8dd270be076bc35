//! Bindings of `base`: random numbers and the thread count.

use nearfar_core::base::{pool, random};
use numpy::{PyArray1, PyReadonlyArray1, ToPyArray};
use pyo3::prelude::*;

use crate::errors::to_python;
use crate::run;

/// Float64 in [0, 1) for each index.
#[pyfunction]
fn uniform<'py>(
    py: Python<'py>,
    seed: u64,
    cell: u64,
    index: PyReadonlyArray1<'py, u64>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let index = index.as_slice()?;
    let draws: Vec<f64> = run::short(py, || Ok(index.iter().map(|&i| random::uniform(seed, cell, i)).collect()))?;
    Ok(draws.to_pyarray(py))
}

/// Number of threads of the pool.
#[pyfunction]
fn thread_count() -> PyResult<usize> {
    pool::thread_count().map_err(to_python)
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(uniform, module)?)?;
    module.add_function(wrap_pyfunction!(thread_count, module)?)
}
