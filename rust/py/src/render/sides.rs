//! Bindings of `render::sides`.

use nearfar_core::camera;
use nearfar_core::render::{Luma, Sides};
use numpy::{PyArray1, PyArray3, PyArrayMethods, PyReadonlyArray3};
use pyo3::prelude::*;

use crate::camera::Camera;
use crate::convert::run;
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
pub(crate) fn silhouettes<'py>(
    py: Python<'py>,
    scene: &Scene,
    cameras: Vec<Py<Camera>>,
) -> PyResult<Bound<'py, PyArray3<bool>>> {
    let (scene, cameras) = (&scene.0, views(&cameras));
    let shown = run::long(py, None, |progress| Sides::new(scene, &cameras, progress)?.silhouettes(progress))?;
    PyArray1::from_vec(py, shown).reshape(shape(&cameras))
}

/// Luma (V, H, W) of pixels at most `reach` pixels across and down from one in `shown`; 0 elsewhere.
#[pyfunction]
#[pyo3(signature = (scene, cameras, shown, *, samples, weights, reach))]
pub(crate) fn luma_near<'py>(
    py: Python<'py>,
    scene: &Scene,
    cameras: Vec<Py<Camera>>,
    shown: PyReadonlyArray3<'py, bool>,
    samples: u32,
    weights: [f64; 3],
    reach: usize,
) -> PyResult<Bound<'py, PyArray3<f64>>> {
    let (scene, cameras, shown) = (&scene.0, views(&cameras), shown.as_slice()?);
    let how = Luma { samples, weights, reach };
    let luma = run::long(py, None, |progress| Sides::new(scene, &cameras, progress)?.luma(shown, &how, progress))?;
    PyArray1::from_vec(py, luma).reshape(shape(&cameras))
}
