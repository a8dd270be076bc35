//! Bindings of nearfar-core: each function converts, releases the interpreter, calls, and maps the error.

mod arrays;
mod base;
mod bend;
mod bounds;
mod camera;
mod cubemap;
mod errors;
mod exr;
mod gpu;
mod gpu_compute;
mod lens;
mod levels;
mod lod;
mod layout;
mod metrics;
mod morph;
mod parts;
mod partition;
mod reduce;
mod render;
mod run;
mod scene;
mod simplify;
mod tessellate;
mod trace;

use pyo3::prelude::*;

#[pymodule]
fn _core(module: &Bound<'_, PyModule>) -> PyResult<()> {
    errors::register(module)?;
    base::register(module)?;
    scene::register(module)?;
    parts::register(module)?;
    levels::register(module)?;
    trace::register(module)?;
    camera::register(module)?;
    partition::register(module)?;
    morph::register(module)?;
    bend::register(module)?;
    tessellate::register(module)?;
    cubemap::register(module)?;
    layout::register(module)?;
    render::register(module)?;
    reduce::register(module)?;
    metrics::register(module)?;
    bounds::register(module)?;
    lens::register(module)?;
    lod::register(module)?;
    simplify::register(module)?;
    exr::register(module)?;
    gpu::register(module)?;
    gpu_compute::register(module)
}
