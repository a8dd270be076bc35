//! Bindings of `render::bake`.

use glam::DVec3;
use nearfar_core::render::bake::{self, Bake};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::frame::images;
use crate::convert::run;
use crate::scene::Scene;

/// The channels of an environment map by name: colour (6, S, S, 3) and, if requested, range and object_id (6, S, S);
/// and the number of rays.
#[pyfunction(name = "bake")]
#[pyo3(signature = (scene, *, center, radius, size, samples, range, object_id, report=None))]
#[expect(clippy::too_many_arguments, reason = "keywords of a Python function")]
pub(crate) fn bake_map<'py>(
    py: Python<'py>,
    scene: &Scene,
    center: [f64; 3],
    radius: f64,
    size: u32,
    samples: u32,
    range: bool,
    object_id: bool,
    report: Option<Py<PyAny>>,
) -> PyResult<(Bound<'py, PyDict>, u64)> {
    let settings = Bake { center: DVec3::from_array(center), radius, size, samples, range, object_id };
    let frame = run::long(py, report, |progress| bake::bake(&scene.0, &settings, progress))?;
    let side = size as usize;
    Ok((images(py, frame, (6 * side, side))?, bake::rays(&settings)))
}
