//! Calls of the file system that Python does not have.

use std::path::PathBuf;

use pyo3::prelude::*;

/// Exchanges what two paths of a file system name, at once; returns false where the system cannot.
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
        // Old kernels, and file systems without it.
        Err(Errno::NOSYS | Errno::INVAL | Errno::NOTSUP) => Ok(false),
        Err(error) => Err(std::io::Error::from(error).into()),
    }
}

#[cfg(not(any(target_os = "linux", target_os = "android", target_vendor = "apple")))]
fn exchange(_first: PathBuf, _second: PathBuf) -> PyResult<bool> {
    Ok(false)
}
