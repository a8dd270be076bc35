//! Bindings of `render::truth`.

use nearfar_core::render::truth;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::frame::{Settings, images};
use crate::camera::Camera;
use crate::convert::run;
use crate::scene::Scene;

/// Ground truth of a view.
#[pyfunction]
#[pyo3(signature = (scene, camera, settings, *, report=None))]
pub(crate) fn render_truth<'py>(
    py: Python<'py>,
    scene: &Scene,
    camera: &Camera,
    settings: Settings<'py>,
    report: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let (channels, limits, pixels) = (settings.channels()?, settings.limits()?, settings.pixels()?);
    let (scene, camera, samples) = (&scene.0, &camera.0, settings.samples);
    let frame =
        run::long(py, report, |progress| truth::render(scene, camera, channels, samples, limits, pixels, progress))?;
    images(py, frame, (camera.height as usize, camera.width as usize))
}
