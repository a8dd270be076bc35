//! Bindings of `render::bake` and `render::bake_rings`.

use glam::DVec3;
use nearfar_core::render::bake::{self, Bake};
use nearfar_core::render::bake_rings::{self as by_ring, Shown};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::frame::images;
use crate::convert::run;
use crate::scene::Scene;

/// The channels of an environment map by name: colour (6, S, S, 3) and, if requested, range and object_id (6, S, S);
/// and the number of rays.
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

/// The channels of the map of what lies after a ring, as `bake`; and the least ring that each texel shows (6 S²,).
#[pyfunction]
#[pyo3(signature = (scene, *, center, size, samples, range, object_id, rings, after, mask=None, report=None))]
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
    after: u16,
    mask: Option<PyReadonlyArray1<'py, bool>>,
    report: Option<Py<PyAny>>,
) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyArray1<u16>>)> {
    let settings = Bake { center: DVec3::from_array(center), radius: 0.0, size, samples, range, object_id };
    let shown = Shown { rings: rings.as_slice()?, after };
    let mask = mask.as_ref().map(PyReadonlyArray1::as_slice).transpose()?;
    let found = run::long(py, report, |progress| by_ring::bake_rings(&scene.0, &settings, shown, mask, progress))?;
    let side = size as usize;
    Ok((images(py, found.frame, (6 * side, side))?, PyArray1::from_vec(py, found.least)))
}
