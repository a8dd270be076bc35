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
use crate::convert::{Report, buffer, choice, flat_buffer, run, to_python};
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
        let lock = || self.gpu.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(gathered) = lock().clone() {
            return Ok(gathered);
        }
        // The lock is not held here: a thread that waits inside rayon may run another frame's task, which takes this
        // lock.
        let gathered = Arc::new(nearfar_gpu::Reduced::new(&self.partition.get().0, &self.core, progress)?);
        Ok(Arc::clone(lock().get_or_insert(gathered)))
    }
}

/// Settings of a reduced scene's picture in addition to `Settings`, by the names in the result of `kernel_settings`,
/// and the user's world position.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct MorphingArguments {
    user: Option<[f64; 3]>,
    radius: Option<f64>,
    strength: f64,
    method: String,
    mapped: bool,
    tolerance_px: f64,
    conventional_dynamic: String,
}

impl MorphingArguments {
    pub fn drawing<'a>(&self, settings: &'a Settings<'_>) -> PyResult<Drawing<'a>> {
        let methods = [("vertex", MorphMethod::Vertex), ("exact", MorphMethod::Exact)];
        let places = [ConventionalDynamic::Center, ConventionalDynamic::User, ConventionalDynamic::Omit];
        let places = places.map(|place| (place.name(), place));
        let place = choice("conventional_dynamic", &self.conventional_dynamic, &places);
        Ok(Drawing {
            channels: settings.channels()?,
            samples: settings.samples,
            limits: settings.limits()?,
            pixels: settings.pixels()?,
            user: self.user.map(DVec3::from_array),
            growth: Growth { radius: self.radius, strength: self.strength },
            method: choice("method", &self.method, &methods).map_err(to_python)?,
            mapped: self.mapped,
            tolerance_px: self.tolerance_px,
            conventional_dynamic: place.map_err(to_python)?,
        })
    }
}

/// Channels of a map as rows: (6 S S, 3), (6 S S,), (6 S S,).
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct MapArguments<'py> {
    size: u32,
    color: Array<'py, f32>,
    #[pyo3(default)]
    range: Option<Array<'py, f32>>,
    #[pyo3(default)]
    object_id: Option<Array<'py, i32>>,
}

impl MapArguments<'_> {
    fn convert(&self) -> PyResult<EnvironmentMap> {
        let range = self.range.as_ref().map(flat_buffer).transpose()?;
        let object_id = self.object_id.as_ref().map(flat_buffer).transpose()?;
        EnvironmentMap::new(self.size, buffer(&self.color)?, range, object_id).map_err(to_python)
    }
}

#[pymethods]
impl Reduced {
    /// `morph` is "blend", "cylinder" or "none"; for "none", `boundary` is the radius at which the near part ends.
    #[new]
    #[pyo3(signature = (partition, *, morph, boundary, map, report=None))]
    fn new(
        py: Python<'_>,
        partition: Py<Partition>,
        morph: &str,
        boundary: f64,
        map: Option<MapArguments<'_>>,
        report: Report,
    ) -> PyResult<Self> {
        let join = match morph {
            "blend" => Join::Morph(Kind::Blend),
            "cylinder" => Join::Morph(Kind::Cylinder),
            "none" => Join::Conventional { radius: boundary },
            _ => return Err(to_python(Error::value("morph", "'blend', 'cylinder' or 'none'", morph))),
        };
        let (zones, map) = (&partition.get().0, map.as_ref().map(MapArguments::convert).transpose()?);
        let core = run::long(py, report, |progress| reduced::Reduced::new(zones, join, map, progress))?;
        Ok(Self { core, partition, gpu: Mutex::default() })
    }

    /// Images of a view by name, and its counters as `stats`; `scene` is the original scene, in any pose.
    #[pyo3(signature = (scene, camera, settings, morphing, *, report=None))]
    fn render<'py>(
        &self,
        py: Python<'py>,
        scene: &Scene,
        camera: &Camera,
        settings: Settings<'py>,
        morphing: MorphingArguments,
        report: Report,
    ) -> PyResult<Bound<'py, PyDict>> {
        let (drawing, scene, camera) = (morphing.drawing(&settings)?, &scene.0, &camera.0);
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
