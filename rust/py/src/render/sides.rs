//! Bindings of `render::sides`.

use nearfar_core::camera;
use nearfar_core::render::{Luma, Sides};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;

use crate::camera::Camera;
use crate::convert::{Array3, Read3, run};
use crate::scene::Scene;

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
    let mask = run::long(py, None, |progress| Sides::new(scene, &cameras, progress)?.silhouettes(progress))?;
    PyArray1::from_vec(py, mask).reshape(shape(&cameras))
}

/// Luma (V, H, W) of pixels at most `reach` pixels across and down from one in `mask`; 0 elsewhere.
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
    let luma = run::long(py, None, |progress| Sides::new(scene, &cameras, progress)?.luma(mask, &settings, progress))?;
    PyArray1::from_vec(py, luma).reshape(shape(&cameras))
}
