//! Bindings of `render`: images by name, sRGB codes, ground truth, and accumulation over frames.

use std::mem;

use nearfar_core::base::memory::try_copy;
use nearfar_core::render::reduced::FrameCounts;
use nearfar_core::render::{Channels, Frame, Limits, Moving, Pixels, Segment, shade, tiles, truth};
use nearfar_core::scene::srgb::srgb_from_all_linear;
use numpy::ndarray::IntoDimension;
use numpy::{Element, PyArray1, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::camera::Camera;
use crate::convert::{
    Array1, Array2, Array3, Read1, Read2, Read3, ReadAny, Report, array_of_rows, filled, run, to_python,
};
use crate::scene::Scene;

/// Settings of a picture that all renderers take in addition to the camera, by the names in `Shot.settings`.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Settings<'py> {
    channels: Vec<String>,
    pub samples: u32,
    t_min: f32,
    t_max: f32,
    clip: Vec<[f64; 4]>,
    mask: Option<Read2<'py, bool>>,
    bare: bool,
    occlusion: bool,
    instances: Option<Read1<'py, bool>>,
}

impl Settings<'_> {
    pub fn channels(&self) -> PyResult<Channels> {
        channels(&self.channels)
    }

    /// Visibility limits: a segment of each ray, and half-spaces (n, d) in the world.
    pub fn limits(&self) -> PyResult<Limits> {
        Limits::new(Segment { t_min: self.t_min, t_max: self.t_max }, &self.clip).map_err(to_python)
    }

    pub fn pixels(&self) -> PyResult<Pixels<'_>> {
        let mask = self.mask.as_ref().map(Read2::as_slice).transpose()?;
        let instances = self.instances.as_ref().map(Read1::as_slice).transpose()?;
        Ok(Pixels { mask, bare: self.bare, culls_masked: self.occlusion, instances })
    }
}

/// The requested channels, by their public names.
pub fn channels(names: &[String]) -> PyResult<Channels> {
    let mut channels = Channels::default();
    match names.iter().find(|name| !channels.add(name)) {
        Some(name) => Err(PyValueError::new_err(format!("channels: unknown channel '{name}'"))),
        None => Ok(channels),
    }
}

/// Images of three components by their public names.
fn vectors(frame: &mut Frame) -> [(&'static str, &mut Vec<[f32; 3]>); 5] {
    [
        ("color", &mut frame.color),
        ("position", &mut frame.position),
        ("normal", &mut frame.normal),
        ("albedo", &mut frame.albedo),
        ("shading_normal", &mut frame.shading_normal),
    ]
}

/// Images of a frame by their public names, (height, width) or (height, width, 3).
pub fn images<'py>(py: Python<'py>, mut frame: Frame, (height, width): (usize, usize)) -> PyResult<Bound<'py, PyDict>> {
    let images = PyDict::new(py);
    for (name, image) in vectors(&mut frame) {
        put(&images, name, mem::take(image).into_flattened(), [height, width, 3])?;
    }
    put(&images, "coverage", frame.coverage, [height, width])?;
    put(&images, "range", frame.range, [height, width])?;
    put(&images, "object_id", frame.object_id, [height, width])?;
    put(&images, "face_id", frame.face_id, [height, width])?;
    Ok(images)
}

/// Creates a frame from contiguous images by their public names.
pub fn frame_of(images: &Bound<'_, PyDict>) -> PyResult<Frame> {
    let mut frame = Frame::default();
    for (name, image) in vectors(&mut frame) {
        *image = try_copy(image_values(images, name)?.as_chunks().0).map_err(to_python)?;
    }
    frame.coverage = image_values(images, "coverage")?;
    frame.range = image_values(images, "range")?;
    frame.object_id = image_values(images, "object_id")?;
    frame.face_id = image_values(images, "face_id")?;
    Ok(frame)
}

/// Values of an image; empty if there is no such image.
fn image_values<T: Element + Copy>(images: &Bound<'_, PyDict>, name: &str) -> PyResult<Vec<T>> {
    let Some(image) = images.get_item(name)? else { return Ok(vec![]) };
    try_copy(image.extract::<ReadAny<'_, T>>()?.as_slice()?).map_err(to_python)
}

/// Adds the counters of a reduced scene's frame to its images, by their public names.
pub fn add_counts(images: &Bound<'_, PyDict>, counts: &FrameCounts) -> PyResult<()> {
    let stats = PyDict::new(images.py());
    stats.set_item("frame_triangles", counts.triangles)?;
    stats.set_item("dynamic_triangles", counts.moving)?;
    stats.set_item("tolerance_held", counts.bounded)?;
    stats.set_item("opposed_directions", counts.opposed)?;
    stats.set_item("fold_margin", counts.fold_margin)?;
    images.set_item("stats", stats)
}

/// Adds an image if the frame has it.
fn put<T: Element, S: IntoDimension>(images: &Bound<'_, PyDict>, name: &str, values: Vec<T>, shape: S) -> PyResult<()> {
    if values.is_empty() {
        return Ok(());
    }
    images.set_item(name, PyArray1::from_vec(images.py(), values).reshape(shape)?)
}

/// Linear RGB (N, 3) that white surfaces with unit normals (N, 3) reflect towards their outer side.
#[pyfunction]
pub fn irradiance<'py>(py: Python<'py>, normals: Read2<'py, f32>) -> PyResult<Array2<'py, f32>> {
    let normals = normals.as_slice()?.as_chunks::<3>().0;
    let light = run::short(py, || Ok(normals.iter().map(|&n| shade::irradiance(n.into())).collect()))?;
    array_of_rows(py, light)
}

/// Encodes linear values as sRGB codes, in a one-dimensional array.
#[pyfunction]
pub fn encode_srgb<'py>(py: Python<'py>, linear: ReadAny<'py, f32>) -> PyResult<Array1<'py, u8>> {
    let linear = linear.as_slice()?;
    filled(py, linear.len(), |codes| run::long(py, None, |progress| srgb_from_all_linear(linear, codes, progress)))
}

/// Ground truth of a view.
#[pyfunction]
#[pyo3(signature = (scene, camera, settings, *, report=None))]
pub fn render_truth<'py>(
    py: Python<'py>,
    scene: &Scene,
    camera: &Camera,
    settings: Settings<'py>,
    report: Report,
) -> PyResult<Bound<'py, PyDict>> {
    let (channels, limits, pixels) = (settings.channels()?, settings.limits()?, settings.pixels()?);
    let (scene, camera, samples) = (&scene.0, &camera.0, settings.samples);
    let frame =
        run::long(py, report, |progress| truth::render(scene, camera, channels, samples, limits, pixels, progress))?;
    images(py, frame, (camera.height as usize, camera.width as usize))
}

/// Blends a picture (H, W, 3) with the reprojected accumulation of earlier pictures; `share` is the picture's weight.
#[pyfunction]
pub fn gather_frames<'py>(
    py: Python<'py>,
    color: Read3<'py, f32>,
    motion: Read3<'py, f32>,
    distance: Read2<'py, f32>,
    gathered: Read3<'py, f32>,
    share: f32,
) -> PyResult<Array3<'py, f32>> {
    let (height, width) = (color.shape()[0], color.shape()[1]);
    let (color, motion, range) =
        (color.as_slice()?.as_chunks().0, motion.as_slice()?.as_chunks().0, distance.as_slice()?);
    let (moving, gathered) = (Moving { width, color, motion, range }, gathered.as_slice()?.as_chunks().0);
    filled(py, [height, width, 3], |mixed: &mut [f32]| {
        run::long(py, None, |progress| moving.gather(gathered, share, mixed.as_chunks_mut().0, progress))
    })
}

/// Positions of a pixel's samples within it, from its upper left corner.
#[pyfunction]
pub fn sample_offsets(samples: u32) -> Vec<[f64; 2]> {
    tiles::sample_offsets(samples)
}
