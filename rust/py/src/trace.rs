//! Bindings of `trace`.

use nearfar_core::trace::{self, cast};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::convert::arrays::{Points, array_of_rows};
use crate::convert::errors::to_python;
use crate::convert::run;
use crate::scene::Scene;

/// Rows of 3 coordinates in the kernels' type.
fn rows<'a>(points: &'a Points<'_>) -> PyResult<trace::Points<'a>> {
    fn triples<'a, T: numpy::Element>(array: &'a PyReadonlyArray2<'_, T>) -> PyResult<&'a [[T; 3]]> {
        if !array.is_c_contiguous() || array.shape()[1] != 3 {
            return Err(PyValueError::new_err("expected a C-contiguous array of rows of 3"));
        }
        Ok(array.as_slice()?.as_chunks().0)
    }
    match points {
        Points::Single(array) => triples(array).map(trace::Points::Single),
        Points::Double(array) => triples(array).map(trace::Points::Double),
    }
}

type Hits<'py> =
    (Bound<'py, PyArray1<f32>>, Bound<'py, PyArray1<i64>>, Bound<'py, PyArray1<i32>>, Bound<'py, PyArray2<f32>>);

/// Distance, triangle, object and barycentric weights of the nearest hits.
#[pyfunction]
#[pyo3(signature = (scene, origins, directions, t_max, report=None))]
pub(crate) fn cast_rays<'py>(
    py: Python<'py>,
    scene: &Scene,
    origins: Points<'py>,
    directions: Points<'py>,
    t_max: f32,
    report: Option<Py<PyAny>>,
) -> PyResult<Hits<'py>> {
    let (origins, directions) = (rows(&origins)?, rows(&directions)?);
    let hits = run::long(py, report, |progress| cast(&scene.0, origins, directions, t_max, progress))?;
    let weights = array_of_rows(py, hits.barycentric)?;
    Ok((hits.t_hit.into_pyarray(py), hits.triangle_index.into_pyarray(py), hits.object_id.into_pyarray(py), weights))
}

type Near<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<i64>>, Bound<'py, PyArray2<f64>>);

/// Distance, triangle and barycentric weights of the nearest points of the surface.
#[pyfunction]
#[pyo3(signature = (scene, points, *, facing=None, report=None))]
pub(crate) fn nearest_points<'py>(
    py: Python<'py>,
    scene: &Scene,
    points: Points<'py>,
    facing: Option<PyReadonlyArray2<'py, f32>>,
    report: Option<Py<PyAny>>,
) -> PyResult<Near<'py>> {
    let points = rows(&points)?;
    let facing = facing.as_ref().map(|rows| rows.as_slice()).transpose()?.map(|rows| rows.as_chunks().0);
    let found = run::long(py, report, |progress| trace::nearest(&scene.0, points, facing, progress))?;
    let weights = array_of_rows(py, found.barycentric)?;
    Ok((found.distance.into_pyarray(py), found.triangle_index.into_pyarray(py), weights))
}

/// Names of the instruction sets that tracing can use on this processor, the best last.
#[pyfunction]
pub(crate) fn instruction_sets() -> Vec<&'static str> {
    trace::instruction_sets()
}

/// Chooses an instruction set for this process; for tests and timing.
#[pyfunction]
pub(crate) fn use_instruction_set(name: &str) -> PyResult<()> {
    trace::use_instruction_set(name).map_err(to_python)
}
