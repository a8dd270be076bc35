//! File system calls that Python lacks.

use std::path::PathBuf;

use pyo3::prelude::*;

/// Atomically exchanges two paths of a file system; returns false if that is unsupported.
#[pyfunction]
pub(crate) fn exchange_paths(py: Python<'_>, first: PathBuf, second: PathBuf) -> PyResult<bool> {
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
