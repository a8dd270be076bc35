//! Frames of the GPU back end: frames being drawn, and frames kept on the device.

use std::sync::{Mutex, PoisonError};

use nearfar_core::base::Error;
use nearfar_core::camera::Camera;
use nearfar_gpu::{DeviceFrame, Job};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::convert::errors::to_python;
use crate::convert::run;
use crate::render::frame::images;

/// A frame that is being drawn.
#[pyclass(frozen, module = "nearfar._core")]
pub struct GpuJob {
    job: Mutex<Option<Job>>,
    shape: (usize, usize),
}

impl GpuJob {
    /// A job whose frame has the camera's size.
    pub(crate) fn new(job: Job, camera: &Camera) -> Self {
        Self { job: Mutex::new(Some(job)), shape: (camera.height as usize, camera.width as usize) }
    }

    /// Takes the job; fails on the second call.
    fn take(&self) -> PyResult<Job> {
        let job = self.job.lock().unwrap_or_else(PoisonError::into_inner).take();
        job.ok_or_else(|| to_python(Error::value("frame", "one that was not read yet", "one that was")))
    }
}

#[pymethods]
impl GpuJob {
    /// Waits for the frame and returns its images by name. It can be called once.
    #[pyo3(signature = (report=None))]
    fn finish<'py>(&self, py: Python<'py>, report: Option<Py<PyAny>>) -> PyResult<Bound<'py, PyDict>> {
        let job = self.take()?;
        let frame = run::long(py, report, |progress| job.finish(progress))?;
        images(py, frame, self.shape)
    }
}

/// A frame kept on the device.
#[pyclass(frozen, module = "nearfar._core")]
pub struct GpuFrame {
    pub(crate) frame: DeviceFrame,
    shape: (usize, usize),
}

#[pymethods]
impl GpuFrame {
    /// Name and back end of the adapter that holds the frame.
    #[getter]
    fn label(&self) -> String {
        self.frame.device().report().label()
    }

    /// The images by name.
    #[pyo3(signature = (report=None))]
    fn read<'py>(&self, py: Python<'py>, report: Option<Py<PyAny>>) -> PyResult<Bound<'py, PyDict>> {
        let frame = run::long(py, report, |progress| self.frame.read(progress))?;
        images(py, frame, self.shape)
    }
}

/// Finishes a job and keeps its frame on the device. It can be called once per job.
#[pyfunction]
#[pyo3(signature = (job, report=None))]
pub(crate) fn gpu_keep(py: Python<'_>, job: &GpuJob, report: Option<Py<PyAny>>) -> PyResult<GpuFrame> {
    let taken = job.take()?;
    let frame = run::long(py, report, |progress| taken.keep(progress))?;
    Ok(GpuFrame { frame, shape: job.shape })
}
