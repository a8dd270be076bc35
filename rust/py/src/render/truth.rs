//! Bindings of `render::truth`.

use nearfar_core::render::truth;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::frame::{channels, images, limits};
use crate::camera::Camera;
use crate::convert::run;
use crate::scene::Scene;

/// Ground truth of a view.
#[pyfunction]
#[pyo3(signature = (scene, camera, *, channels, samples, t_min=0.0, t_max=f32::INFINITY, clip=Vec::new(), report=None))]
#[expect(clippy::too_many_arguments, reason = "keywords of a Python function")]
pub(crate) fn render_truth<'py>(
    py: Python<'py>,
    scene: &Scene,
    camera: &Camera,
    channels: Vec<String>,
    samples: u32,
    t_min: f32,
    t_max: f32,
    clip: Vec<[f64; 4]>,
    report: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let wanted = self::channels(&channels)?;
    let (scene, camera) = (&scene.0, &camera.0);
    let limits = limits(t_min, t_max, &clip)?;
    let frame = run::long(py, report, |progress| truth::render(scene, camera, wanted, samples, limits, progress))?;
    images(py, frame, (camera.height as usize, camera.width as usize))
}
