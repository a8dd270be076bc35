//! Bindings of `orthoview::splat`, on the CPU and on adapters.

use std::sync::Arc;

use glam::{DVec3, UVec3};
use nearfar_core::orthoview::Cell;
use nearfar_core::orthoview::splat::{Counts, Picture, Placed, Splats, blended, draw, expected};
use nearfar_gpu::splat as on_device;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

use super::cut::OrthoRule;
use super::views::OrthoViews;
use crate::camera::Camera;
use crate::convert::{Read4, Report, run, to_python};
use crate::gpu::device::GpuDevice;
use crate::render::frame::{Settings, frame_of, images};

/// A view of a cell, ready to be splatted.
#[pyclass(frozen, module = "nearfar._core")]
pub struct OrthoSplats(pub(crate) Arc<Splats>);

impl From<Splats> for OrthoSplats {
    fn from(splats: Splats) -> Self {
        Self(Arc::new(splats))
    }
}

#[pymethods]
impl OrthoSplats {
    /// Prepares a view of a cell, given by its least corner and its side; `connected` (D, size, size, 1) has the
    /// connections of all views.
    #[new]
    fn new(
        py: Python<'_>,
        views: &OrthoViews,
        number: usize,
        connected: Read4<'_, u8>,
        cell: ([f64; 3], f64),
    ) -> PyResult<Self> {
        let cell = Cell::new(DVec3::from_array(cell.0), cell.1).map_err(to_python)?;
        let connected = connected.as_slice()?;
        run::short(py, || Splats::new(&views.0, number, connected, &cell)).map(Self::from)
    }

    /// Keeps splats whose centres lie in a box, given by its least and its greatest corner.
    fn crop_to_box(&self, py: Python<'_>, low: [f64; 3], high: [f64; 3]) -> PyResult<Self> {
        run::short(py, || Ok(self.0.clip_to_box(DVec3::from_array(low), DVec3::from_array(high)))).map(Self::from)
    }

    /// Keeps splats whose centres are at least `radius` away from the vertical axis through a point.
    fn outside_cylinder(&self, py: Python<'_>, center: [f64; 3], radius: f64) -> PyResult<Self> {
        run::short(py, || Ok(self.0.clip_outside_cylinder(DVec3::from_array(center), radius))).map(Self::from)
    }

    #[getter]
    fn count(&self) -> usize {
        self.0.count()
    }

    /// Memory in bytes.
    #[getter]
    fn bytes(&self) -> usize {
        self.0.bytes()
    }

    /// GPU memory in bytes.
    #[getter]
    fn compressed_bytes(&self, py: Python<'_>) -> PyResult<usize> {
        run::short(py, || Ok(size_of_val(&*self.0.compressed().words)))
    }
}

/// A view of a cut: its layers, level, place and direction, and whether finer cells replace some of its splats.
type View<'py> = (Vec<Bound<'py, OrthoSplats>>, u32, [u32; 3], u8, bool);

fn read_views<'a>(views: &'a [View<'_>]) -> PyResult<Vec<Placed<'a>>> {
    let placed = |(layers, level, place, direction, is_partial): &'a View<'_>| {
        if layers.is_empty() {
            return Err(PyValueError::new_err("views: expected at least one layer of each, got none"));
        }
        let layers = layers.iter().map(|layer| &*layer.get().0).collect();
        let cell = (*level, UVec3::from_array(*place));
        Ok(Placed { cell, direction: *direction, is_partial: *is_partial, layers })
    };
    views.iter().map(placed).collect()
}

/// Reduces the layers of a cut's views to the splats that are drawn where levels blend.
#[pyfunction]
pub fn blend_orthoviews<'py>(
    py: Python<'py>,
    views: Vec<View<'py>>,
    rule: &OrthoRule,
) -> PyResult<Vec<Vec<Bound<'py, OrthoSplats>>>> {
    let layers = {
        let placed = read_views(&views)?;
        run::short(py, || Ok(blended(&placed, &rule.0)))?
    };
    let layer = |(whole, part): (Bound<'py, OrthoSplats>, Option<Splats>)| match part {
        Some(part) => Bound::new(py, OrthoSplats::from(part)),
        None => Ok(whole),
    };
    views.into_iter().zip(layers).map(|(view, parts)| view.0.into_iter().zip(parts).map(layer).collect()).collect()
}

/// Estimated number of splats that `blend_orthoviews` keeps.
#[pyfunction]
pub fn expected_orthoviews(py: Python<'_>, views: Vec<View<'_>>, rule: &OrthoRule) -> PyResult<f64> {
    let placed = read_views(&views)?;
    run::short(py, || Ok(expected(&placed, &rule.0)))
}

fn shared_splats(views: &[Bound<'_, OrthoSplats>]) -> Vec<Arc<Splats>> {
    views.iter().map(|view| Arc::clone(&view.get().0)).collect()
}

/// Renders views to images by name, with counters as `stats`. `grid` is the number of samples along each axis of a
/// pixel; `before` has images of the rest of the scene at `grid` times the picture's size. Without a device the CPU
/// renders.
#[pyfunction]
#[pyo3(signature = (views, camera, settings, *, origin, grid, before=None, report=None, device=None))]
#[expect(clippy::too_many_arguments, reason = "parts of a picture, which callers take from different objects")]
pub fn splat_orthoviews<'py>(
    py: Python<'py>,
    views: Vec<Bound<'py, OrthoSplats>>,
    camera: &Camera,
    settings: Settings<'py>,
    origin: [f64; 3],
    grid: u32,
    before: Option<Bound<'py, PyDict>>,
    report: Report,
    device: Option<&GpuDevice>,
) -> PyResult<Bound<'py, PyDict>> {
    let before = before.as_ref().map(frame_of).transpose()?;
    let views = shared_splats(&views);
    let picture = Picture {
        camera: &camera.0,
        origin: DVec3::from_array(origin),
        channels: settings.channels()?,
        grid,
        limits: settings.limits()?,
        pixels: settings.pixels()?,
        before: before.as_ref(),
    };
    let (frame, counts) = run::long(py, report, |progress| match device {
        Some(device) => on_device::draw(&device.0, &views, &picture, progress),
        None => draw(&views.iter().map(|view| &**view).collect::<Vec<_>>(), &picture, progress),
    })?;
    let images = images(py, frame, (camera.0.height as usize, camera.0.width as usize))?;
    add_counts(&images, &counts)?;
    Ok(images)
}

/// Adds the counters of a picture as `stats`.
fn add_counts(images: &Bound<'_, PyDict>, counts: &Counts) -> PyResult<()> {
    let stats = [
        ("splats", counts.total),
        ("splats_in_picture", counts.in_picture),
        ("splats_seen", counts.seen),
        ("splats_projected", counts.projected),
    ];
    images.set_item("stats", stats.into_py_dict(images.py())?)
}

/// Uploads views to a device ahead of their first use.
#[pyfunction]
pub fn gpu_keep_orthoviews(py: Python<'_>, device: &GpuDevice, views: Vec<Bound<'_, OrthoSplats>>) -> PyResult<()> {
    let views = shared_splats(&views);
    run::long(py, None, |progress| on_device::keep(&device.0, &views, progress))
}

/// Bytes of the views on a device.
#[pyfunction]
pub fn gpu_orthoview_bytes(py: Python<'_>, device: &GpuDevice) -> PyResult<u64> {
    run::short(py, || Ok(on_device::kept_bytes(&device.0)))
}
