//! Bindings of `tessellate`.

use glam::DVec3;
use nearfar_core::tessellate::{self, Precision, Rule, ServedMorphs, Settings};
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

use crate::convert::{Read1, Read2, Report, array_of_rows, run};
use crate::scene::Scene;

/// Settings by their public names; `grown` has the least radius of a growing cylinder, and whether its strength is
/// always 1; `chosen` has a flag for each object of a scene, then one for the faces without an object.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct SplitArguments<'py> {
    center: [f64; 3],
    radii: [f64; 2],
    grown: Option<(f64, bool)>,
    reach: f64,
    tolerance: f64,
    #[pyo3(default)]
    chosen: Option<Read1<'py, bool>>,
}

impl SplitArguments<'_> {
    /// Converts to settings in which positions are relative to an origin.
    fn convert(&self, origin: DVec3) -> Settings {
        let Self { radii: [r1, r2], reach, tolerance, .. } = *self;
        // With a cylinder, points beyond r₂ move along the ray.
        let (served, drawn) = match self.grown {
            Some((least, is_full)) => (ServedMorphs::Cylinder { least, is_full }, f64::INFINITY),
            None => (ServedMorphs::Blend, r2),
        };
        Settings { center: DVec3::from_array(self.center) - origin, r1, r2, drawn, reach, tolerance, served }
    }
}

/// Splits the static triangles of a scene, and returns counters by name.
#[pyfunction]
#[pyo3(signature = (scene, settings, *, report=None))]
pub fn tessellate_scene<'py>(
    py: Python<'py>,
    scene: &Scene,
    settings: SplitArguments<'py>,
    report: Report,
) -> PyResult<(Scene, Bound<'py, PyDict>)> {
    let chosen = settings.chosen.as_ref().map(|chosen| chosen.as_slice()).transpose()?;
    // Object −1, for no object, uses the last entry.
    let is_chosen = |object: i32| {
        chosen.is_none_or(|chosen| chosen.get(object as usize).or(chosen.last()).copied().unwrap_or(false))
    };
    let local = settings.convert(scene.0.origin);
    let (split, counts) = run::long(py, report, |progress| {
        tessellate::tessellate_scene(&scene.0, &Rule::new(&local, Precision::Single)?, is_chosen, progress)
    })?;
    let counts =
        [("before", counts.before), ("after", counts.after), ("examined", counts.examined), ("split", counts.split)];
    Ok((Scene(split), counts.into_py_dict(py)?))
}

/// New vertices with their source faces and barycentric weights; all faces, and the source face of each.
#[pyfunction]
#[pyo3(signature = (vertices, faces, settings, *, report=None))]
pub fn tessellate_arrays<'py>(
    py: Python<'py>,
    vertices: Read2<'py, f64>,
    faces: Read2<'py, u32>,
    settings: SplitArguments<'py>,
    report: Report,
) -> PyResult<Bound<'py, PyDict>> {
    let (rows, triples) = (vertices.as_slice()?.as_chunks::<3>().0, faces.as_slice()?.as_chunks::<3>().0);
    let settings = settings.convert(DVec3::ZERO);
    let split = run::long(py, report, |progress| {
        tessellate::tessellate_arrays(rows, triples, &Rule::new(&settings, Precision::Double)?, progress)
    })?;
    let arrays = PyDict::new(py);
    arrays.set_item("points", array_of_rows(py, split.points)?)?;
    arrays.set_item("point_faces", split.point_faces.into_pyarray(py))?;
    arrays.set_item("weights", array_of_rows(py, split.weights)?)?;
    arrays.set_item("faces", array_of_rows(py, split.faces)?)?;
    arrays.set_item("sources", split.sources.into_pyarray(py))?;
    Ok(arrays)
}
