//! Bindings of `render::bake` and `render::bake_rings`.

use glam::DVec3;
use nearfar_core::render::Frame;
use nearfar_core::render::bake::{self, Bake};
use nearfar_core::render::bake_rings as by_ring;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::frame::images;
use crate::convert::{Array1, Read1, Report, run};
use crate::scene::Scene;

/// Settings of baking by their public names; rings need no radius.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct BakeArguments {
    center: [f64; 3],
    #[pyo3(default)]
    radius: f64,
    size: u32,
    samples: u32,
    range: bool,
    object_id: bool,
}

impl BakeArguments {
    pub fn convert(self) -> Bake {
        let Self { center, radius, size, samples, range, object_id } = self;
        Bake { center: DVec3::from_array(center), radius, size, samples, range, object_id }
    }
}

/// Channels of an environment map by name: colour (6 S, S, 3) and, if requested, range and object_id (6 S, S).
pub fn map_images(py: Python<'_>, frame: Frame, size: u32) -> PyResult<Bound<'_, PyDict>> {
    images(py, frame, (6 * size as usize, size as usize))
}

/// Channels of an environment map by name, and the number of rays.
#[pyfunction(name = "bake")]
#[pyo3(signature = (scene, settings, *, report=None))]
pub fn bake_map<'py>(
    py: Python<'py>,
    scene: &Scene,
    settings: BakeArguments,
    report: Report,
) -> PyResult<(Bound<'py, PyDict>, u64)> {
    let settings = settings.convert();
    let frame = run::long(py, report, |progress| bake::bake(&scene.0, &settings, progress))?;
    Ok((map_images(py, frame, settings.size)?, bake::rays(&settings)))
}

/// Channels of map 0 as from `bake`; and for each ring up to `count` the numbers of the changed texels (N,), and
/// their channels: colour (N, 1, 3), range and object_id (N, 1).
#[pyfunction]
#[pyo3(signature = (scene, settings, *, rings, count, report=None))]
pub fn bake_rings<'py>(
    py: Python<'py>,
    scene: &Scene,
    settings: BakeArguments,
    rings: Read1<'py, u16>,
    count: u16,
    report: Report,
) -> PyResult<(Bound<'py, PyDict>, Vec<RingChange<'py>>)> {
    let (settings, rings) = (settings.convert(), rings.as_slice()?);
    let maps = run::long(py, report, |progress| by_ring::bake_rings(&scene.0, &settings, rings, count, progress))?;
    let changes = maps.changes.into_iter().map(|change| {
        let shape = (change.texels.len(), 1);
        Ok((PyArray1::from_vec(py, change.texels), images(py, change.frame, shape)?))
    });
    Ok((map_images(py, maps.first, settings.size)?, changes.collect::<PyResult<_>>()?))
}

/// Numbers of texels, and their channels by name.
type RingChange<'py> = (Array1<'py, i64>, Bound<'py, PyDict>);
