//! Adapters and devices of the GPU back end, and the frames that they draw.

use std::sync::Arc;

use nearfar_core::base::Progress;
use nearfar_gpu::{Device, device, render};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::frame::GpuJob;
use crate::camera::Camera;
use crate::convert::{Report, run, to_python};
use crate::render::bake::{BakeArguments, map_images};
use crate::render::frame::{Settings, channels};
use crate::render::reduced::{MorphingArguments, Reduced};
use crate::scene::Scene;

/// All adapters: name, back end, kind, driver, reason why it is unusable, greatest size of a binding and of an image.
#[pyfunction]
#[expect(clippy::type_complexity, reason = "a row of a table")]
pub fn gpu_adapters(py: Python<'_>) -> PyResult<Vec<(String, &'static str, &'static str, String, String, u64, u32)>> {
    let reports = run::short(py, device::adapters)?;
    let row = |a: nearfar_gpu::AdapterReport| {
        (a.name, a.backend, a.kind.name(), a.driver, a.refusal_reason, a.largest_binding, a.largest_image)
    };
    Ok(reports.into_iter().map(row).collect())
}

/// Whether an adapter, by default the best one, is hardware instead of software on the CPU.
#[pyfunction]
#[pyo3(signature = (adapter=None))]
pub fn gpu_is_hardware(py: Python<'_>, adapter: Option<&str>) -> PyResult<bool> {
    run::short(py, || device::is_hardware(adapter))
}

/// Makes a forked child process exit without the exit handlers of drivers.
#[pyfunction]
pub fn gpu_forked() {
    device::end_without_drivers();
}

/// Closes all devices once their work is done.
#[pyfunction]
pub fn gpu_close(py: Python<'_>) -> PyResult<()> {
    run::long(py, None, device::close)
}

/// Device of the best adapter that `adapter` matches.
#[pyclass(frozen, module = "nearfar._core")]
pub struct GpuDevice(pub(crate) Arc<Device>);

#[pymethods]
impl GpuDevice {
    #[new]
    #[pyo3(signature = (adapter=None))]
    fn new(py: Python<'_>, adapter: Option<&str>) -> PyResult<Self> {
        run::short(py, || device::device(adapter)).map(Self)
    }

    /// Name and back end of the device's adapter.
    #[getter]
    fn label(&self) -> String {
        self.0.report().label()
    }

    /// Kind of processor that executes the device's work.
    #[getter]
    fn kind(&self) -> &'static str {
        self.0.report().kind.name()
    }

    /// Number of buffers and textures created, their bytes, bytes uploaded, and triangles in draw calls.
    fn counters(&self) -> (u64, u64, u64, u64) {
        let counters = self.0.counters();
        (counters.allocations, counters.allocated_bytes, counters.uploaded_bytes, counters.triangles)
    }

    /// Seconds of raster and of resolve passes by timestamp queries; None without them.
    fn pass_seconds(&self) -> Option<[f64; 2]> {
        let seconds = self.0.counters().pass_nanoseconds.map(|nanoseconds| 1e-9 * nanoseconds as f64);
        self.0.has_clock().then_some(seconds)
    }

    /// Fails for a frame that is too large to stay on the device.
    fn check_whole(&self, camera: &Camera, channels: Vec<String>) -> PyResult<()> {
        self.0.check_whole(&camera.0, self::channels(&channels)?).map_err(to_python)
    }

    /// Enables or disables drawing both eyes in one pass; returns the previous setting.
    fn allow_two_views(&self, allowed: bool) -> bool {
        self.0.allow_two_views(allowed)
    }

    /// Enables or disables 64-bit atomic integers in kernels; returns the previous setting.
    fn allow_long_atomics(&self, allowed: bool) -> bool {
        self.0.allow_long_atomics(allowed)
    }

    /// Whether kernels use 64-bit atomic integers.
    #[getter]
    fn uses_long_atomics(&self) -> bool {
        self.0.uses_long_atomics()
    }

    /// Closes the device as a driver failure would.
    fn lose(&self, py: Python<'_>) -> PyResult<()> {
        run::short(py, || {
            self.0.lose();
            Ok(())
        })
    }

    /// Starts frames of a scene, one for each camera.
    #[pyo3(signature = (scene, cameras, settings, *, report=None))]
    fn truth(
        &self,
        py: Python<'_>,
        scene: &Scene,
        cameras: Vec<PyRef<'_, Camera>>,
        settings: Settings<'_>,
        report: Report,
    ) -> PyResult<Vec<GpuJob>> {
        let (channels, limits, pixels) = (settings.channels()?, settings.limits()?, settings.pixels()?);
        let (scene, samples) = (&scene.0, settings.samples);
        let cameras: Vec<_> = cameras.iter().map(|camera| camera.0).collect();
        let begin = |progress: &Progress| {
            render::begin_truth(&self.0, scene, &cameras, channels, samples, (limits, pixels), progress)
        };
        let jobs = run::long(py, report, begin)?;
        let mut cameras = cameras.iter();
        let split = |job: nearfar_gpu::Job| GpuJob::split(job, &mut cameras);
        Ok(jobs.into_iter().flat_map(split).collect())
    }

    /// Channels of an environment map by name, as `bake` returns them.
    #[pyo3(signature = (scene, settings, *, report=None))]
    fn bake<'py>(
        &self,
        py: Python<'py>,
        scene: &Scene,
        settings: BakeArguments,
        report: Report,
    ) -> PyResult<Bound<'py, PyDict>> {
        let settings = settings.convert();
        let frame = run::long(py, report, |progress| render::bake(&self.0, &scene.0, &settings, progress))?;
        map_images(py, frame, settings.size)
    }

    /// Starts a frame of a reduced scene; `scene` is the original scene, in any pose.
    #[pyo3(signature = (reduced, scene, camera, settings, morphing, *, report=None))]
    fn reduced(
        &self,
        reduced: &Bound<'_, Reduced>,
        scene: &Scene,
        camera: &Camera,
        settings: Settings<'_>,
        morphing: MorphingArguments,
        report: Report,
    ) -> PyResult<GpuJob> {
        let drawing = morphing.drawing(&settings)?;
        let (py, reduced, scene, camera) = (reduced.py(), reduced.get(), &scene.0, &camera.0);
        let (job, counts) = run::long(py, report, |progress| {
            reduced.on_gpu(progress)?.begin(&self.0, (&reduced.core, scene), camera, &drawing, progress)
        })?;
        Ok(GpuJob::new(job, camera, Some(counts)))
    }
}
