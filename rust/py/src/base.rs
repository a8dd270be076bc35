//! Bindings of `base`: random numbers, the thread count, a kernel that tests of the policies call, and a file system call
//! that Python lacks.

use std::path::PathBuf;
use std::thread;
use std::time::Duration;

use nearfar_core::base::{Error, Progress, Result, pool, random};
use pyo3::prelude::*;

use crate::convert::{Array1, Read1, Report, filled, run, to_python};

/// A float64 in [0, 1) for each index.
#[pyfunction]
pub fn uniform<'py>(py: Python<'py>, seed: u64, cell: u64, index: Read1<'py, u64>) -> PyResult<Array1<'py, f64>> {
    let index = index.as_slice()?;
    filled(py, index.len(), |draws| {
        run::long(py, None, |progress| random::fill_uniform(seed, cell, index, draws, progress))
    })
}

#[pyfunction]
pub fn thread_count() -> PyResult<usize> {
    pool::thread_count().map_err(to_python)
}

/// Test kernel for cancellation, forking and panics. "wait" runs until it is cancelled, "panic" panics on a pool
/// thread, other values return a kernel error.
#[pyfunction]
#[pyo3(signature = (behaviour, report=None))]
pub fn probe(py: Python<'_>, behaviour: &str, report: Report) -> PyResult<()> {
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

/// Atomically exchanges two paths of a file system; returns false if that is unsupported.
#[pyfunction]
pub fn exchange_paths(py: Python<'_>, first: PathBuf, second: PathBuf) -> PyResult<bool> {
    py.detach(|| exchange(first, second))
}

#[cfg(any(target_os = "linux", target_os = "android", target_vendor = "apple"))]
fn exchange(first: PathBuf, second: PathBuf) -> PyResult<bool> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    use rustix::io::Errno;

    match renameat_with(CWD, first, CWD, second, RenameFlags::EXCHANGE) {
        Ok(()) => Ok(true),
        // Old kernels and some file systems do not support it.
        Err(Errno::NOSYS | Errno::INVAL | Errno::NOTSUP) => Ok(false),
        Err(error) => Err(std::io::Error::from(error).into()),
    }
}

#[cfg(not(any(target_os = "linux", target_os = "android", target_vendor = "apple")))]
fn exchange(_first: PathBuf, _second: PathBuf) -> PyResult<bool> {
    Ok(false)
}
