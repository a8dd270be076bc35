//! Bindings of the GPU back end's kernels.

use nearfar_core::base::{Error, Result};
use nearfar_core::metrics::{Neighbourhood, Window};
use nearfar_core::morph::Morph;
use nearfar_gpu::DeviceFrame;
use nearfar_gpu::compute::{self, Filter, Map};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray2, PyReadonlyArray4, PyReadwriteArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::camera::Camera;
use crate::gpu::{GpuDevice, GpuJob};
use crate::morph::kind;
use crate::render::images;
use crate::run;

/// A frame that stays on the device.
#[pyclass(frozen, module = "nearfar._core")]
pub struct GpuFrame {
    frame: DeviceFrame,
    shape: (usize, usize),
}

#[pymethods]
impl GpuFrame {
    /// Name and back end of the adapter that holds it.
    #[getter]
    fn label(&self) -> String {
        self.frame.device().report().label()
    }

    /// Its images by name.
    #[pyo3(signature = (report=None))]
    fn read<'py>(&self, py: Python<'py>, report: Option<Py<PyAny>>) -> PyResult<Bound<'py, PyDict>> {
        let frame = run::long(py, report, |progress| self.frame.read(progress))?;
        images(py, frame, self.shape)
    }
}

/// Leaves a frame under way on its device; once.
#[pyfunction]
#[pyo3(signature = (job, report=None))]
fn gpu_keep(py: Python<'_>, job: &GpuJob, report: Option<Py<PyAny>>) -> PyResult<GpuFrame> {
    let taken = job.take()?;
    let frame = run::long(py, report, |progress| taken.keep(progress))?;
    Ok(GpuFrame { frame, shape: job.shape })
}

/// Mean similarity of two frames, and its map, flat, where it is wanted.
#[pyfunction]
#[pyo3(signature = (reference, test, *, window, size, sigma, full))]
fn gpu_similarity<'py>(
    py: Python<'py>,
    reference: &GpuFrame,
    test: &GpuFrame,
    window: &str,
    size: usize,
    sigma: f64,
    full: bool,
) -> PyResult<(f64, Option<Bound<'py, PyArray1<f32>>>)> {
    let compared = run::long(py, None, |progress| {
        let window = match window {
            "gaussian" => Window::gaussian(size, sigma),
            "uniform" => Window::uniform(size),
            _ => return Err(Error::value("window", "'gaussian' or 'uniform'", format!("'{window}'"))),
        };
        compute::similarity([&reference.frame, &test.frame], &window, full, progress)
    })?;
    Ok((compared.mean, compared.map.map(|map| map.into_pyarray(py))))
}

/// Discontinuity of each pixel of a frame, flat.
#[pyfunction]
#[pyo3(signature = (frame, *, camera, epsilon, min_distance, report=None))]
fn gpu_discontinuity<'py>(
    py: Python<'py>,
    frame: &GpuFrame,
    camera: &Camera,
    epsilon: f64,
    min_distance: f64,
    report: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyArray1<f32>>> {
    let around = Neighbourhood { epsilon, least: min_distance };
    let map = run::long(py, report, |progress| compute::discontinuity(&frame.frame, &camera.0, around, progress))?;
    Ok(map.into_pyarray(py))
}

/// Writes morphed points.
#[pyfunction]
#[pyo3(signature = (device, points, shown, *, user, center, r1, r2, kind))]
#[expect(clippy::too_many_arguments, reason = "named ones, as Python passes them")]
fn gpu_morph(
    py: Python<'_>,
    device: &GpuDevice,
    points: PyReadonlyArray2<'_, f32>,
    mut shown: PyReadwriteArray2<'_, f32>,
    user: [f64; 3],
    center: [f64; 3],
    r1: f64,
    r2: f64,
    kind: &str,
) -> PyResult<()> {
    let (rows, to) = (points.as_slice()?.as_chunks::<3>().0, shown.as_slice_mut()?.as_chunks_mut::<3>().0);
    run::long(py, None, |progress| {
        let morph = Morph::new(user.into(), center.into(), r1, r2, self::kind(kind)?)?;
        compute::morph(&device.0, &morph, rows, to, progress)
    })
}

fn filter(name: &str) -> Result<Filter> {
    match name {
        "nearest" => Ok(Filter::Nearest),
        "min" => Ok(Filter::Min),
        "max" => Ok(Filter::Max),
        _ => Err(Error::value("filter", "'nearest', 'min' or 'max'", format!("'{name}'"))),
    }
}

/// Writes values of a cube map along directions.
#[pyfunction]
fn gpu_cube_lookup(
    py: Python<'_>,
    device: &GpuDevice,
    maps: (PyReadonlyArray4<'_, f32>, PyReadwriteArray2<'_, f32>),
    directions: PyReadonlyArray2<'_, f32>,
    filter: &str,
) -> PyResult<()> {
    let (faces, mut out) = maps;
    let [size, channels] = [faces.shape()[1], faces.shape()[3]].map(|n| u32::try_from(n).unwrap_or(u32::MAX));
    let map = Map { values: faces.as_slice()?, size, channels };
    let (rows, to) = (directions.as_slice()?.as_chunks::<3>().0, out.as_slice_mut()?);
    run::long(py, None, |progress| compute::lookup(&device.0, map, rows, self::filter(filter)?, to, progress))
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<GpuFrame>()?;
    module.add_function(wrap_pyfunction!(gpu_keep, module)?)?;
    module.add_function(wrap_pyfunction!(gpu_similarity, module)?)?;
    module.add_function(wrap_pyfunction!(gpu_discontinuity, module)?)?;
    module.add_function(wrap_pyfunction!(gpu_morph, module)?)?;
    module.add_function(wrap_pyfunction!(gpu_cube_lookup, module)?)
}
