//! Orthoviews on adapters.

use std::sync::Arc;

use glam::DVec3;
use nearfar_core::orthoview::splat::{Picture, Splats};
use nearfar_gpu::splat;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::device::GpuDevice;
use crate::camera::Camera;
use crate::convert::run;
use crate::orthoview::splat::{OrthoSplats, add_counts};
use crate::render::frame::{Settings, frame_of, images};

fn shared(views: &[Bound<'_, OrthoSplats>]) -> Vec<Arc<Splats>> {
    views.iter().map(|view| Arc::clone(&view.get().0)).collect()
}

/// The same as `splat_orthoviews`, drawn by a device.
#[pyfunction]
#[pyo3(signature = (device, views, camera, settings, *, origin, grid, before=None, report=None))]
#[expect(clippy::too_many_arguments, reason = "keywords of a Python function")]
pub(crate) fn gpu_splat_orthoviews<'py>(
    py: Python<'py>,
    device: &GpuDevice,
    views: Vec<Bound<'py, OrthoSplats>>,
    camera: &Camera,
    settings: Settings<'py>,
    origin: [f64; 3],
    grid: u32,
    before: Option<Bound<'py, PyDict>>,
    report: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let before = before.as_ref().map(frame_of).transpose()?;
    let views = shared(&views);
    let picture = Picture {
        camera: &camera.0,
        origin: DVec3::from_array(origin),
        channels: settings.channels()?,
        grid,
        limits: settings.limits()?,
        pixels: settings.pixels()?,
        before: before.as_ref(),
    };
    let (frame, counts) = run::long(py, report, |progress| splat::draw(&device.0, &views, &picture, progress))?;
    let images = images(py, frame, (camera.0.height as usize, camera.0.width as usize))?;
    add_counts(&images, &counts)?;
    Ok(images)
}

/// Brings views to a device before a picture shows them.
#[pyfunction]
pub(crate) fn gpu_keep_orthoviews(
    py: Python<'_>,
    device: &GpuDevice,
    views: Vec<Bound<'_, OrthoSplats>>,
) -> PyResult<()> {
    let views = shared(&views);
    run::long(py, None, |progress| splat::keep(&device.0, &views, progress))
}

/// Bytes of the views that lie on a device.
#[pyfunction]
pub(crate) fn gpu_orthoview_bytes(py: Python<'_>, device: &GpuDevice) -> PyResult<u64> {
    run::short(py, || Ok(splat::kept_bytes(&device.0)))
}
