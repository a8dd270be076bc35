//! Bindings of `orthoview::cut`.

use std::sync::{PoisonError, RwLock};

use glam::{DVec3, UVec3};
use nearfar_core::orthoview::cut::{Cells, Drawn, Gaze, Grid, Lift, Rule, View, cut};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::views::directions_of;
use crate::camera::Camera;
use crate::convert::{Read1, array_of_rows, run, to_python};

/// Occupied cells of a tree, as far as its subtrees have been added.
#[pyclass(frozen, module = "nearfar._core")]
pub struct OrthoCells(RwLock<Cells>);

/// Distances from which a viewer draws each level. `band` is the width of the distance band in which splats of a level
/// replace finer ones; `gaze` is a pixel position, and the slope and limit of the eye's acuity.
#[pyclass(frozen, module = "nearfar._core")]
pub struct OrthoRule(pub Rule);

#[pymethods]
impl OrthoRule {
    #[new]
    #[pyo3(signature = (camera, *, pitch, error, band=None, gaze=None))]
    fn new(
        camera: &Camera,
        pitch: f64,
        error: f64,
        band: Option<f64>,
        gaze: Option<([f64; 2], f64, f64)>,
    ) -> PyResult<Self> {
        let gaze = gaze.map(|(pixel, slope, limit)| Gaze { pixel, slope, limit });
        Rule::new(&camera.0, pitch, error, band, gaze.as_ref()).map(Self).map_err(to_python)
    }
}

/// Settings of a cut: its views, and whether leaves draw geometry. `lift_deg` is the angle by which the viewer's
/// direction is raised before views are chosen.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct CutArguments {
    directions: Vec<[i8; 3]>,
    views: usize,
    geometry: bool,
    around: bool,
    #[pyo3(default)]
    lift_deg: f64,
}

/// Tier and place of a subtree.
type Subtree = (u32, [u32; 3]);

#[pymethods]
impl OrthoCells {
    /// Creates the cells of a grid, given by its least corner and the side of a cell at level 0; `subtree` is the
    /// number of levels per subtree.
    #[new]
    fn new(origin: [f64; 3], side: f64, levels: u32, subtree: u32) -> PyResult<Self> {
        let grid = Grid { origin: DVec3::from_array(origin), side, levels, subtree };
        Cells::new(grid).map(|cells| Self(RwLock::new(cells))).map_err(to_python)
    }

    /// Adds a subtree: for each of its levels, from the lowest, a bit mask per cell. The bits are directions whose
    /// views are not empty.
    fn add(&self, tier: u32, place: [u32; 3], levels: Vec<Read1<'_, u32>>) -> PyResult<()> {
        let levels: Result<Vec<Box<[u32]>>, _> = levels.iter().map(|masks| masks.as_slice().map(Box::from)).collect();
        let mut cells = self.0.write().unwrap_or_else(PoisonError::into_inner);
        cells.add(tier, UVec3::from_array(place), levels?).map_err(to_python)
    }

    #[getter]
    fn subtree_count(&self) -> usize {
        self.0.read().unwrap_or_else(PoisonError::into_inner).subtree_count()
    }

    /// Cut for a viewer, the nearest cells first: arrays of the cells drawn as views and, with the prefix "leaf_", of
    /// those drawn as geometry; the distance at which a leaf's pixels are as fine as required; the missing subtrees;
    /// and the number of largest cells that are not built yet.
    fn cut<'py>(
        &self,
        py: Python<'py>,
        camera: &Camera,
        rule: &OrthoRule,
        settings: CutArguments,
    ) -> PyResult<(Bound<'py, PyDict>, f64, Vec<Subtree>, usize)> {
        let CutArguments { directions, views, geometry, around, lift_deg } = settings;
        let (directions, lift) = (directions_of(directions)?, Lift::new(lift_deg).map_err(to_python)?);
        let view = View { camera: &camera.0, rule: rule.0, directions: &directions, views, lift, geometry, around };
        let result = run::short(py, || cut(&self.0.read().unwrap_or_else(PoisonError::into_inner), &view))?;
        let arrays = PyDict::new(py);
        for (prefix, cells) in [("", &result.cells), ("leaf_", &result.leaves)] {
            put(&arrays, prefix, cells)?;
        }
        let numbers = result.cells.iter().map(|cell| -> [i8; Drawn::MAX] {
            std::array::from_fn(|n| if n < cell.count { cell.directions[n] as i8 } else { -1 })
        });
        let partial = result.cells.iter().map(|cell| cell.is_partial);
        arrays.set_item("partial", PyArray1::from_iter(py, partial))?;
        arrays.set_item("directions", array_of_rows(py, numbers.collect())?)?;
        let unknown = result.unknown.into_iter().map(|(tier, place)| (tier, place.to_array())).collect();
        Ok((arrays, result.reach, unknown, result.unbuilt))
    }
}

fn put(arrays: &Bound<'_, PyDict>, prefix: &str, cells: &[Drawn]) -> PyResult<()> {
    let py = arrays.py();
    let set = |name: &str, array: Bound<'_, PyAny>| arrays.set_item(format!("{prefix}{name}"), array);
    let places = cells.iter().map(|cell| cell.place.to_array().map(i64::from)).collect();
    set("place", array_of_rows(py, places)?.into_any())?;
    set("level", PyArray1::from_iter(py, cells.iter().map(|cell| i64::from(cell.level))).into_any())?;
    set("distance", PyArray1::from_iter(py, cells.iter().map(|cell| cell.distance)).into_any())?;
    set("in_picture", PyArray1::from_iter(py, cells.iter().map(|cell| cell.in_picture)).into_any())
}
