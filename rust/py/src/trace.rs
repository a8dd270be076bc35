//! Bindings of `trace`.

use nearfar_core::trace::{self, cast};
use numpy::IntoPyArray;
use pyo3::prelude::*;

use crate::convert::{Array1, Array2, Points, Read2, Report, array_of_rows, run, to_python};
use crate::scene::Scene;

/// Rows of 3 coordinates in the kernels' type.
fn rows<'a>(points: &'a Points<'_>) -> PyResult<trace::Points<'a>> {
    Ok(match points {
        Points::Single(array) => trace::Points::Single(array.as_slice()?.as_chunks().0),
        Points::Double(array) => trace::Points::Double(array.as_slice()?.as_chunks().0),
    })
}

type Hits<'py> = (Array1<'py, f32>, Array1<'py, i64>, Array1<'py, i32>, Array2<'py, f32>);

/// Distance, triangle, object and barycentric weights of the nearest hits.
#[pyfunction]
#[pyo3(signature = (scene, origins, directions, t_max, report=None))]
pub fn cast_rays<'py>(
    py: Python<'py>,
    scene: &Scene,
    origins: Points<'py>,
    directions: Points<'py>,
    t_max: f32,
    report: Report,
) -> PyResult<Hits<'py>> {
    let (origins, directions) = (rows(&origins)?, rows(&directions)?);
    let hits = run::long(py, report, |progress| cast(&scene.0, origins, directions, t_max, progress))?;
    let weights = array_of_rows(py, hits.barycentric)?;
    Ok((hits.t_hit.into_pyarray(py), hits.triangle_index.into_pyarray(py), hits.object_id.into_pyarray(py), weights))
}

type Near<'py> = (Array1<'py, f64>, Array1<'py, i64>, Array2<'py, f64>);

/// Distance, triangle and barycentric weights of the nearest points of the surface.
#[pyfunction]
#[pyo3(signature = (scene, points, *, facing=None, report=None))]
pub fn nearest_points<'py>(
    py: Python<'py>,
    scene: &Scene,
    points: Points<'py>,
    facing: Option<Read2<'py, f32>>,
    report: Report,
) -> PyResult<Near<'py>> {
    let points = rows(&points)?;
    let facing = facing.as_ref().map(|rows| rows.as_slice()).transpose()?.map(|rows| rows.as_chunks().0);
    let nearest = run::long(py, report, |progress| trace::nearest(&scene.0, points, facing, progress))?;
    let weights = array_of_rows(py, nearest.barycentric)?;
    Ok((nearest.distance.into_pyarray(py), nearest.triangle_index.into_pyarray(py), weights))
}

/// Names of the instruction sets that tracing can use on this processor, the best last.
#[pyfunction]
pub fn instruction_sets() -> Vec<&'static str> {
    trace::instruction_sets()
}

/// Chooses an instruction set for this process; for tests and timing.
#[pyfunction]
pub fn use_instruction_set(name: &str) -> PyResult<()> {
    trace::use_instruction_set(name).map_err(to_python)
}
