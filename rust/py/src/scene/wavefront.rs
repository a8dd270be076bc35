//! Bindings of `scene::wavefront`.

use nearfar_core::scene::wavefront;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::convert::run;

/// Returns OBJ text that general readers read right; None for text that they do.
#[pyfunction]
pub(crate) fn plain_wavefront<'py>(py: Python<'py>, text: &[u8]) -> PyResult<Option<Bound<'py, PyBytes>>> {
    let plain = run::short(py, || wavefront::plain(text))?;
    Ok(plain.map(|plain| PyBytes::new(py, &plain)))
}
