//! Bindings of `tessellate`.

use glam::DVec3;
use nearfar_core::tessellate::{self, Precision, Rule, Settings, Stages};
use numpy::{IntoPyArray, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::convert::arrays::array_of_rows;
use crate::convert::run;
use crate::scene::Scene;

/// Settings from their public names; `stages` has the least radius of a cylinder's growth, and whether it has full
/// strength.
fn settings(center: [f64; 3], [r1, r2]: [f64; 2], stages: Option<(f64, bool)>, reach: f64, tolerance: f64) -> Settings {
    let stages = match stages {
        Some((least, is_full)) => Stages::Cylinder { least, is_full },
        None => Stages::Blend,
    };
    // With a cylinder, points beyond r₂ move along the ray.
    let drawn = if stages == Stages::Blend { r2 } else { f64::INFINITY };
    Settings { center: DVec3::from_array(center), r1, r2, drawn, reach, tolerance, stages }
}

/// Splits the static triangles of a scene, and returns counters by name; `chosen` has a flag for each object, then
/// one for the faces without an object.
#[pyfunction]
#[pyo3(signature = (scene, *, center, radii, stages, reach, tolerance, chosen=None, report=None))]
#[expect(clippy::too_many_arguments, reason = "keywords of a Python function")]
pub(crate) fn tessellate_scene<'py>(
    py: Python<'py>,
    scene: &Scene,
    center: [f64; 3],
    radii: [f64; 2],
    stages: Option<(f64, bool)>,
    reach: f64,
    tolerance: f64,
    chosen: Option<PyReadonlyArray1<'py, bool>>,
    report: Option<Py<PyAny>>,
) -> PyResult<(Scene, Bound<'py, PyDict>)> {
    let world = settings(center, radii, stages, reach, tolerance);
    let chosen = chosen.as_ref().map(|chosen| chosen.as_slice()).transpose()?;
    // Object −1, for no object, uses the last entry.
    let is_chosen = |object: i32| {
        chosen.is_none_or(|chosen| chosen.get(object as usize).or(chosen.last()).copied().unwrap_or(false))
    };
    let (split, counts) = run::long(py, report, |progress| {
        let local = Settings { center: world.center - scene.0.origin, ..world };
        tessellate::tessellate_scene(&scene.0, &Rule::new(&local, Precision::Single)?, is_chosen, progress)
    })?;
    let named = PyDict::new(py);
    for (name, count) in
        [("before", counts.before), ("after", counts.after), ("examined", counts.examined), ("split", counts.split)]
    {
        named.set_item(name, count)?;
    }
    Ok((Scene(split), named))
}

/// New vertices with their source faces and barycentric weights; all faces, and the source face of each.
#[pyfunction]
#[pyo3(signature = (vertices, faces, *, center, radii, stages, reach, tolerance, report=None))]
#[expect(clippy::too_many_arguments, reason = "keywords of a Python function")]
pub(crate) fn tessellate_arrays<'py>(
    py: Python<'py>,
    vertices: PyReadonlyArray2<'py, f64>,
    faces: PyReadonlyArray2<'py, u32>,
    center: [f64; 3],
    radii: [f64; 2],
    stages: Option<(f64, bool)>,
    reach: f64,
    tolerance: f64,
    report: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let (rows, triples) = (vertices.as_slice()?.as_chunks::<3>().0, faces.as_slice()?.as_chunks::<3>().0);
    let settings = settings(center, radii, stages, reach, tolerance);
    let made = run::long(py, report, |progress| {
        tessellate::tessellate_arrays(rows, triples, &Rule::new(&settings, Precision::Double)?, progress)
    })?;
    let named = PyDict::new(py);
    named.set_item("points", array_of_rows(py, made.points)?)?;
    named.set_item("point_faces", made.point_faces.into_pyarray(py))?;
    named.set_item("weights", array_of_rows(py, made.weights)?)?;
    named.set_item("faces", array_of_rows(py, made.faces)?)?;
    named.set_item("sources", made.sources.into_pyarray(py))?;
    Ok(named)
}
