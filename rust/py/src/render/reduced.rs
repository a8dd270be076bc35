//! Bindings of `render::reduced`.

use std::sync::{Arc, Mutex, PoisonError};

use glam::DVec3;
use nearfar_core::base::{Error, Progress, Result};
use nearfar_core::cubemap::EnvironmentMap;
use nearfar_core::morph::Kind;
use nearfar_core::render::reduced::{self, ConventionalDynamic, Drawing, Growth, Join, MorphMethod};
use numpy::PyArrayDyn;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::frame::{Settings, add_counts, images};
use crate::camera::Camera;
use crate::convert::arrays::{buffer, flat_buffer};
use crate::convert::errors::to_python;
use crate::convert::names::choice;
use crate::convert::run;
use crate::partition::Partition;
use crate::scene::Scene;

type Array<'py, T> = Bound<'py, PyArrayDyn<T>>;

/// A reduced scene, ready to be drawn.
#[pyclass(frozen, module = "nearfar._core")]
pub struct Reduced {
    pub core: reduced::Reduced,
    partition: Py<Partition>,
    /// The GPU's copy of the near part, created when a device draws it for the first time.
    gpu: Mutex<Option<Arc<nearfar_gpu::Reduced>>>,
}

impl Reduced {
    /// Near part in the form that devices draw.
    pub fn on_gpu(&self, progress: &Progress) -> Result<Arc<nearfar_gpu::Reduced>> {
        let gathered = || self.gpu.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = gathered().clone() {
            return Ok(known);
        }
        // The lock is not held here: a thread that waits inside rayon may run another frame's task, which takes this
        // lock.
        let made = Arc::new(nearfar_gpu::Reduced::new(&self.partition.get().0, &self.core, progress)?);
        Ok(Arc::clone(gathered().get_or_insert(made)))
    }
}

/// Creates the settings of a frame from their public names.
pub fn drawing<'a>(
    settings: &'a Settings<'_>,
    (user, growth): (Option<[f64; 3]>, Growth),
    (method, mapped, tolerance_px): (&str, bool, f64),
    conventional_dynamic: &str,
) -> PyResult<Drawing<'a>> {
    let method = match method {
        "vertex" => MorphMethod::Vertex,
        "exact" => MorphMethod::Exact,
        _ => return Err(to_python(Error::value("method", "'vertex' or 'exact'", method))),
    };
    let named = [ConventionalDynamic::Center, ConventionalDynamic::User, ConventionalDynamic::Omit];
    let named = named.map(|place| (place.name(), place));
    let conventional_dynamic = choice("conventional_dynamic", conventional_dynamic, &named).map_err(to_python)?;
    let (channels, limits, pixels) = (settings.channels()?, settings.limits()?, settings.pixels()?);
    let (samples, user) = (settings.samples, user.map(DVec3::from_array));
    Ok(Drawing { channels, samples, limits, pixels, user, growth, method, mapped, tolerance_px, conventional_dynamic })
}

#[pymethods]
impl Reduced {
    /// `morph` is "blend", "cylinder" or "none"; for "none", `boundary` is the radius at which the near part ends. The
    /// map's channels are rows: (6 S S, 3), (6 S S,), (6 S S,).
    #[new]
    #[pyo3(signature = (partition, *, morph, boundary, size=0, color=None, range=None, object_id=None, report=None))]
    #[expect(clippy::too_many_arguments, reason = "keywords of a Python constructor")]
    fn new<'py>(
        py: Python<'py>,
        partition: Py<Partition>,
        morph: &str,
        boundary: f64,
        size: u32,
        color: Option<Array<'py, f32>>,
        range: Option<Array<'py, f32>>,
        object_id: Option<Array<'py, i32>>,
        report: Option<Py<PyAny>>,
    ) -> PyResult<Self> {
        let join = match morph {
            "blend" => Join::Morph(Kind::Blend),
            "cylinder" => Join::Morph(Kind::Cylinder),
            "none" => Join::Conventional { radius: boundary },
            _ => return Err(to_python(Error::value("morph", "'blend', 'cylinder' or 'none'", morph))),
        };
        let map = match &color {
            Some(color) => {
                let color = buffer(color)?;
                let range = range.as_ref().map(flat_buffer).transpose()?;
                let object_id = object_id.as_ref().map(flat_buffer).transpose()?;
                Some(EnvironmentMap::new(size, color, range, object_id).map_err(to_python)?)
            }
            None => None,
        };
        let zones = &partition.get().0;
        let core = run::long(py, report, |progress| reduced::Reduced::new(zones, join, map, progress))?;
        Ok(Self { core, partition, gpu: Mutex::default() })
    }

    /// Images of a view by name, and its counters as `stats`; `scene` is the original scene, in any pose.
    #[pyo3(signature = (
        scene, camera, settings, *, user, radius, strength, method, mapped, tolerance_px, conventional_dynamic,
        report=None
    ))]
    #[expect(clippy::too_many_arguments, reason = "keywords of a Python function")]
    fn render<'py>(
        &self,
        py: Python<'py>,
        scene: &Scene,
        camera: &Camera,
        settings: Settings<'py>,
        user: Option<[f64; 3]>,
        radius: Option<f64>,
        strength: f64,
        method: &str,
        mapped: bool,
        tolerance_px: f64,
        conventional_dynamic: &str,
        report: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let how = (method, mapped, tolerance_px);
        let drawing = drawing(&settings, (user, Growth { radius, strength }), how, conventional_dynamic)?;
        let (scene, camera) = (&scene.0, &camera.0);
        let (frame, counts) = run::long(py, report, |progress| self.core.render(scene, camera, &drawing, progress))?;
        let images = images(py, frame, (camera.height as usize, camera.width as usize))?;
        add_counts(&images, &counts)?;
        Ok(images)
    }

    /// Distance in metres that a user at a world position may still move before the picture folds.
    fn fold_margin(&self, py: Python<'_>, user: [f64; 3], radius: Option<f64>, strength: f64) -> PyResult<f64> {
        run::short(py, || self.core.fold_margin(DVec3::from_array(user), Growth { radius, strength }))
    }

    /// Size of the copies of near geometry, bytes.
    #[getter]
    fn near_bytes(&self) -> usize {
        self.core.near_bytes()
    }
}
