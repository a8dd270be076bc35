//! Bindings of `render`: ground truth, and the frame that all renderers fill.

use nearfar_core::render::{self, Channels, truth};
use nearfar_core::scene::srgb::srgb_from_linear;
use numpy::{Element, PyArray, PyArray1, PyArrayMethods, PyReadonlyArrayDyn};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;

use crate::camera::Camera;
use crate::run;
use crate::scene::Scene;

/// The wanted images, by their public names.
pub fn channels(names: &[String]) -> PyResult<Channels> {
    let mut channels = Channels::default();
    for name in names {
        match name.as_str() {
            "color" => channels.color = true,
            "range" => channels.range = true,
            "object_id" => channels.object_id = true,
            "face_id" => channels.face_id = true,
            "position" => channels.position = true,
            "normal" => channels.normal = true,
            _ => return Err(PyValueError::new_err(format!("channels: unknown channel '{name}'"))),
        }
    }
    Ok(channels)
}

/// The images of a frame by their public names, (height, width) or (height, width, 3).
pub fn images<'py>(
    py: Python<'py>,
    frame: render::Frame,
    (height, width): (usize, usize),
) -> PyResult<Bound<'py, PyDict>> {
    let images = PyDict::new(py);
    let vectors = [("color", frame.color), ("position", frame.position), ("normal", frame.normal)];
    for (name, image) in vectors.into_iter().filter(|(_, image)| !image.is_empty()) {
        images.set_item(name, array(py, image.into_flattened(), [height, width, 3])?)?;
    }
    if !frame.range.is_empty() {
        images.set_item("range", array(py, frame.range, [height, width])?)?;
    }
    if !frame.object_id.is_empty() {
        images.set_item("object_id", array(py, frame.object_id, [height, width])?)?;
    }
    if !frame.face_id.is_empty() {
        images.set_item("face_id", array(py, frame.face_id, [height, width])?)?;
    }
    Ok(images)
}

fn array<T: Element, const N: usize>(
    py: Python<'_>,
    values: Vec<T>,
    shape: [usize; N],
) -> PyResult<Bound<'_, PyArray<T, numpy::ndarray::Dim<[usize; N]>>>>
where
    numpy::ndarray::Dim<[usize; N]>: numpy::ndarray::Dimension,
    [usize; N]: numpy::ndarray::IntoDimension<Dim = numpy::ndarray::Dim<[usize; N]>>,
{
    PyArray1::from_vec(py, values).reshape(shape)
}

/// Ground truth of a view.
#[pyfunction]
#[pyo3(signature = (scene, camera, *, channels, samples, report=None))]
fn render_truth<'py>(
    py: Python<'py>,
    scene: &Scene,
    camera: &Camera,
    channels: Vec<String>,
    samples: u32,
    report: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let wanted = self::channels(&channels)?;
    let (scene, camera) = (&scene.0, &camera.0);
    let frame = run::long(py, report, |progress| truth::render(scene, camera, wanted, samples, progress))?;
    images(py, frame, (camera.height as usize, camera.width as usize))
}

/// sRGB codes of linear values, in one dimension.
#[pyfunction]
fn encode_srgb<'py>(py: Python<'py>, linear: PyReadonlyArrayDyn<'py, f32>) -> PyResult<Bound<'py, PyArray1<u8>>> {
    let linear = linear.as_slice()?;
    let codes = run::short(py, || Ok(linear.par_iter().map(|&x| srgb_from_linear(x)).collect::<Vec<u8>>()))?;
    Ok(PyArray1::from_vec(py, codes))
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(render_truth, module)?)?;
    module.add_function(wrap_pyfunction!(encode_srgb, module)?)
}
