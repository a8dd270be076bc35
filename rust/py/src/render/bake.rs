//! Bindings of `render::bake`, `render::bake_rings` and `render::surrounding_views`.

use glam::DVec3;
use nearfar_core::camera;
use nearfar_core::render::bake::{self, Bake};
use nearfar_core::render::{Frame, Luma, SurroundingViews, bake_rings as ring_maps};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::frame::images;
use crate::camera::Camera;
use crate::convert::{Array1, Array3, Read1, Read3, Report, run};
use crate::scene::Scene;

/// Settings of baking by their public names; `bake_rings` needs no radius.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct BakeArguments {
    center: [f64; 3],
    #[pyo3(default)]
    radius: f64,
    size: u32,
    samples: u32,
    range: bool,
    object_id: bool,
}

impl BakeArguments {
    pub fn convert(self) -> Bake {
        let Self { center, radius, size, samples, range, object_id } = self;
        Bake { center: DVec3::from_array(center), radius, size, samples, range, object_id }
    }
}

/// Channels of an environment map by name: colour (6 S, S, 3) and, if requested, range and object_id (6 S, S).
pub fn map_images(py: Python<'_>, frame: Frame, size: u32) -> PyResult<Bound<'_, PyDict>> {
    images(py, frame, (6 * size as usize, size as usize))
}

/// Channels of an environment map by name, and the number of rays.
#[pyfunction(name = "bake")]
#[pyo3(signature = (scene, settings, *, report=None))]
pub fn bake_map<'py>(
    py: Python<'py>,
    scene: &Scene,
    settings: BakeArguments,
    report: Report,
) -> PyResult<(Bound<'py, PyDict>, u64)> {
    let settings = settings.convert();
    let frame = run::long(py, report, |progress| bake::bake(&scene.0, &settings, progress))?;
    Ok((map_images(py, frame, settings.size)?, bake::rays(&settings)))
}

/// Bakes map 0 and the changes of the maps of rings 1 to `count`. Map 0 is like the result of `bake`. Entry i of the
/// changes belongs to ring i + 1: the numbers of the changed texels (N,), and their channels by name: colour (N, 1, 3),
/// range and object_id (N, 1).
#[pyfunction]
#[pyo3(signature = (scene, settings, *, rings, count, report=None))]
pub fn bake_rings<'py>(
    py: Python<'py>,
    scene: &Scene,
    settings: BakeArguments,
    rings: Read1<'py, u16>,
    count: u16,
    report: Report,
) -> PyResult<(Bound<'py, PyDict>, Vec<RingChange<'py>>)> {
    let (settings, rings) = (settings.convert(), rings.as_slice()?);
    let maps = run::long(py, report, |progress| ring_maps::bake_rings(&scene.0, &settings, rings, count, progress))?;
    let changes = maps.changes.into_iter().map(|change| {
        let shape = (change.texels.len(), 1);
        Ok((PyArray1::from_vec(py, change.texels), images(py, change.frame, shape)?))
    });
    Ok((map_images(py, maps.first, settings.size)?, changes.collect::<PyResult<_>>()?))
}

/// Numbers of texels, and their channels by name.
type RingChange<'py> = (Array1<'py, i64>, Bound<'py, PyDict>);

fn views(cameras: &[Py<Camera>]) -> Vec<camera::Camera> {
    cameras.iter().map(|camera| camera.get().0).collect()
}

/// Shape (V, H, W) of the cameras' pictures.
fn shape(cameras: &[camera::Camera]) -> [usize; 3] {
    let size = |camera: &camera::Camera| [cameras.len(), camera.height as usize, camera.width as usize];
    cameras.first().map_or([0; 3], size)
}

/// Whether the centre of each pixel shows the scene, (V, H, W).
#[pyfunction]
#[pyo3(signature = (scene, cameras))]
pub fn silhouettes<'py>(py: Python<'py>, scene: &Scene, cameras: Vec<Py<Camera>>) -> PyResult<Array3<'py, bool>> {
    let (scene, cameras) = (&scene.0, views(&cameras));
    let mask = run::long(py, None, |progress| SurroundingViews::new(scene, &cameras, progress)?.silhouettes(progress))?;
    PyArray1::from_vec(py, mask).reshape(shape(&cameras))
}

/// Luma (V, H, W) of the pixels within `reach` columns and rows of a pixel in `mask`; 0 elsewhere.
#[pyfunction]
#[pyo3(signature = (scene, cameras, mask, *, samples, weights, reach))]
pub fn luma_near<'py>(
    py: Python<'py>,
    scene: &Scene,
    cameras: Vec<Py<Camera>>,
    mask: Read3<'py, bool>,
    samples: u32,
    weights: [f64; 3],
    reach: usize,
) -> PyResult<Array3<'py, f64>> {
    let (scene, cameras, mask) = (&scene.0, views(&cameras), mask.as_slice()?);
    let settings = Luma { samples, weights, reach };
    let luma = run::long(py, None, |progress| {
        SurroundingViews::new(scene, &cameras, progress)?.luma(mask, &settings, progress)
    })?;
    PyArray1::from_vec(py, luma).reshape(shape(&cameras))
}
