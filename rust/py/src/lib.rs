//! Bindings of nearfar-core: each function converts, releases the interpreter, calls, and maps the error.

mod arrays;
mod base;
mod cubemap;
mod errors;
mod run;
mod scene;

use pyo3::prelude::*;

#[pymodule]
fn _core(module: &Bound<'_, PyModule>) -> PyResult<()> {
    errors::register(module)?;
    base::register(module)?;
    scene::register(module)?;
    cubemap::register(module)
}
