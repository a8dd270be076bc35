//! Frames of the GPU back end: frames in progress, and frames kept on the device.

use std::sync::{Arc, Mutex, PoisonError};

use nearfar_core::base::{Error, Progress, Result};
use nearfar_core::camera::Camera;
use nearfar_core::render::Frame;
use nearfar_core::render::reduced::FrameCounts;
use nearfar_gpu::{DeviceFrame, Job};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::convert::{Report, run, to_python};
use crate::render::frame::{add_counts, images};

/// A frame in progress.
#[pyclass(frozen, module = "nearfar._core")]
pub struct GpuJob {
    batch: Arc<Mutex<Batch>>,
    /// Index of the frame in its batch.
    number: usize,
    contents: Contents,
}

/// Frames drawn as a batch: a job in progress, or finished frames that were not taken yet.
struct Batch {
    job: Option<Job>,
    frames: Vec<Option<Frame>>,
}

impl Batch {
    fn new(job: Job) -> Arc<Mutex<Self>> {
        Arc::new(Mutex::new(Self { job: Some(job), frames: Vec::new() }))
    }

    /// Takes one of the frames; the first call waits for all. Fails on the second call for a frame.
    fn take(&mut self, number: usize, progress: &Progress) -> Result<Frame> {
        if let Some(job) = self.job.take() {
            self.frames = job.finish(progress)?.into_iter().map(Some).collect();
        }
        self.frames.get_mut(number).and_then(Option::take).ok_or_else(read_twice)
    }
}

fn read_twice() -> Error {
    Error::value("frame", "a frame that was not read yet", "one that was read")
}

/// Size of a frame, and its counters if it shows a reduced scene.
#[derive(Clone, Copy)]
struct Contents {
    shape: (usize, usize),
    counts: Option<FrameCounts>,
}

impl Contents {
    /// Images by name, and the counters as `stats`.
    fn to_dict<'py>(self, py: Python<'py>, frame: Frame) -> PyResult<Bound<'py, PyDict>> {
        let images = images(py, frame, self.shape)?;
        if let Some(counts) = &self.counts {
            add_counts(&images, counts)?;
        }
        Ok(images)
    }
}

impl GpuJob {
    /// Creates a job whose frame has the camera's size.
    pub fn new(job: Job, camera: &Camera, counts: Option<FrameCounts>) -> Self {
        Self::of_frame(&Batch::new(job), 0, camera, counts)
    }

    /// Splits a job into its frames, each with the next camera's size.
    pub fn split<'a>(job: Job, cameras: &mut impl Iterator<Item = &'a Camera>) -> Vec<Self> {
        let count = job.frame_count();
        let batch = Batch::new(job);
        cameras.take(count).enumerate().map(|(number, camera)| Self::of_frame(&batch, number, camera, None)).collect()
    }

    fn of_frame(batch: &Arc<Mutex<Batch>>, number: usize, camera: &Camera, counts: Option<FrameCounts>) -> Self {
        let shape = (camera.height as usize, camera.width as usize);
        Self { batch: Arc::clone(batch), number, contents: Contents { shape, counts } }
    }

    /// Takes the job; fails on the second call.
    fn take(&self) -> PyResult<Job> {
        let job = self.batch.lock().unwrap_or_else(PoisonError::into_inner).job.take();
        job.ok_or_else(|| to_python(read_twice()))
    }
}

#[pymethods]
impl GpuJob {
    /// Waits for the frame and returns its images by name, and the counters of a reduced scene's frame as `stats`. Can
    /// be called once.
    #[pyo3(signature = (report=None))]
    fn finish<'py>(&self, py: Python<'py>, report: Report) -> PyResult<Bound<'py, PyDict>> {
        // Another thread may hold the lock while it waits for another frame; it has released the interpreter.
        let frame = run::long(py, report, |progress| {
            self.batch.lock().unwrap_or_else(PoisonError::into_inner).take(self.number, progress)
        })?;
        self.contents.to_dict(py, frame)
    }
}

/// A frame kept on the device.
#[pyclass(frozen, module = "nearfar._core")]
pub struct GpuFrame {
    pub(crate) frame: DeviceFrame,
    contents: Contents,
}

#[pymethods]
impl GpuFrame {
    /// Name and back end of the adapter that holds the frame.
    #[getter]
    fn label(&self) -> String {
        self.frame.device().report().label()
    }

    /// Images by name, and the counters of a reduced scene's frame as `stats`.
    #[pyo3(signature = (report=None))]
    fn read<'py>(&self, py: Python<'py>, report: Report) -> PyResult<Bound<'py, PyDict>> {
        let frame = run::long(py, report, |progress| self.frame.read(progress))?;
        self.contents.to_dict(py, frame)
    }
}

/// Finishes a job and keeps its frame on the device. Can be called once per job.
#[pyfunction]
#[pyo3(signature = (job, report=None))]
pub fn gpu_keep(py: Python<'_>, job: &GpuJob, report: Report) -> PyResult<GpuFrame> {
    let taken = job.take()?;
    let frame = run::long(py, report, |progress| taken.keep(progress))?;
    Ok(GpuFrame { frame, contents: job.contents })
}
