//! Bindings of `render::bake` and `render::bake_rings`.

use glam::DVec3;
use nearfar_core::render::bake::{self, Bake};
use nearfar_core::render::bake_rings as by_ring;
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::frame::images;
use crate::convert::run;
use crate::scene::Scene;

/// Channels of an environment map by name: colour (6, S, S, 3) and, if requested, range and object_id (6, S, S); and
/// the number of rays.
#[pyfunction(name = "bake")]
#[pyo3(signature = (scene, *, center, radius, size, samples, range, object_id, report=None))]
#[expect(clippy::too_many_arguments, reason = "keywords of a Python function")]
pub(crate) fn bake_map<'py>(
    py: Python<'py>,
    scene: &Scene,
    center: [f64; 3],
    radius: f64,
    size: u32,
    samples: u32,
    range: bool,
    object_id: bool,
    report: Option<Py<PyAny>>,
) -> PyResult<(Bound<'py, PyDict>, u64)> {
    let settings = Bake { center: DVec3::from_array(center), radius, size, samples, range, object_id };
    let frame = run::long(py, report, |progress| bake::bake(&scene.0, &settings, progress))?;
    let side = size as usize;
    Ok((images(py, frame, (6 * side, side))?, bake::rays(&settings)))
}

/// Channels of map 0 as from `bake`; and for each ring up to `count` the numbers of the changed texels (N,), and
/// their channels: colour (N, 1, 3), range and object_id (N, 1).
#[pyfunction]
#[pyo3(signature = (scene, *, center, size, samples, range, object_id, rings, count, report=None))]
#[expect(clippy::too_many_arguments, reason = "keywords of a Python function")]
pub(crate) fn bake_rings<'py>(
    py: Python<'py>,
    scene: &Scene,
    center: [f64; 3],
    size: u32,
    samples: u32,
    range: bool,
    object_id: bool,
    rings: PyReadonlyArray1<'py, u16>,
    count: u16,
    report: Option<Py<PyAny>>,
) -> PyResult<(Bound<'py, PyDict>, Vec<RingChange<'py>>)> {
    let settings = Bake { center: DVec3::from_array(center), radius: 0.0, size, samples, range, object_id };
    let rings = rings.as_slice()?;
    let maps = run::long(py, report, |progress| by_ring::bake_rings(&scene.0, &settings, rings, count, progress))?;
    let side = size as usize;
    let changes = maps.changes.into_iter().map(|change| {
        let shape = (change.texels.len(), 1);
        Ok((PyArray1::from_vec(py, change.texels), images(py, change.frame, shape)?))
    });
    Ok((images(py, maps.first, (6 * side, side))?, changes.collect::<PyResult<_>>()?))
}

/// Numbers of texels, and their channels by name.
type RingChange<'py> = (Bound<'py, PyArray1<i64>>, Bound<'py, PyDict>);
