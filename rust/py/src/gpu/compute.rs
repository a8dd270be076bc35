//! Kernels of the GPU back end.

use nearfar_core::base::{Error, Result};
use nearfar_core::cubemap::CubeFaces;
use nearfar_core::metrics::{Neighbourhood, Window};
use nearfar_gpu::compute::{self, Filter};
use numpy::IntoPyArray;
use pyo3::prelude::*;

use super::device::GpuDevice;
use super::frame::GpuFrame;
use crate::camera::Camera;
use crate::convert::{Array1, Read2, Read4, Report, Write2, choice, run};
use crate::cubemap::face_values;
use crate::morph::MorphArguments;

/// Mean similarity of two frames and, if `full`, its map as a flat array.
#[pyfunction]
#[pyo3(signature = (reference, test, *, window, size, sigma, full))]
pub fn gpu_similarity<'py>(
    py: Python<'py>,
    reference: &GpuFrame,
    test: &GpuFrame,
    window: &str,
    size: usize,
    sigma: f64,
    full: bool,
) -> PyResult<(f64, Option<Array1<'py, f32>>)> {
    let similarity = run::long(py, None, |progress| {
        let window = match window {
            "gaussian" => Window::gaussian(size, sigma),
            "uniform" => Window::uniform(size),
            _ => return Err(Error::value("window", "'gaussian' or 'uniform'", format!("'{window}'"))),
        };
        compute::similarity([&reference.frame, &test.frame], &window, full, progress)
    })?;
    Ok((similarity.mean, similarity.map.map(|map| map.into_pyarray(py))))
}

/// Discontinuity of each pixel of a frame, as a flat array.
#[pyfunction]
#[pyo3(signature = (frame, *, camera, epsilon, min_distance, report=None))]
pub fn gpu_discontinuity<'py>(
    py: Python<'py>,
    frame: &GpuFrame,
    camera: &Camera,
    epsilon: f64,
    min_distance: f64,
    report: Report,
) -> PyResult<Array1<'py, f32>> {
    let neighbourhood = Neighbourhood { epsilon, least: min_distance };
    let map =
        run::long(py, report, |progress| compute::discontinuity(&frame.frame, &camera.0, neighbourhood, progress))?;
    Ok(map.into_pyarray(py))
}

/// Writes morphed points.
#[pyfunction]
pub fn gpu_morph(
    py: Python<'_>,
    device: &GpuDevice,
    points: Read2<'_, f32>,
    mut morphed: Write2<'_, f32>,
    arguments: MorphArguments,
) -> PyResult<()> {
    let (rows, to) = (points.as_slice()?.as_chunks::<3>().0, morphed.as_slice_mut()?.as_chunks_mut::<3>().0);
    let morph = arguments.convert()?;
    run::long(py, None, |progress| compute::morph(&device.0, &morph, rows, to, progress))
}

fn filter(name: &str) -> Result<Filter> {
    choice("filter", name, &[("nearest", Filter::Nearest), ("min", Filter::Min), ("max", Filter::Max)])
}

/// Writes values of a cube map in directions.
#[pyfunction]
pub fn gpu_cube_lookup(
    py: Python<'_>,
    device: &GpuDevice,
    maps: (Read4<'_, f32>, Write2<'_, f32>),
    directions: Read2<'_, f32>,
    filter: &str,
) -> PyResult<()> {
    let (faces, mut out) = maps;
    let (values, size, channels) = face_values(&faces)?;
    let (rows, to) = (directions.as_slice()?.as_chunks::<3>().0, out.as_slice_mut()?);
    run::long(py, None, |progress| {
        let (map, filter) = (CubeFaces::new(values, size, channels)?, self::filter(filter)?);
        compute::lookup(&device.0, map, rows, filter, to, progress)
    })
}
