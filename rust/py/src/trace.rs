//! Bindings of `trace`.

use nearfar_core::trace::{self, Points, cast};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::errors::to_python;
use crate::run;
use crate::scene::Scene;

/// C-contiguous (N, 3) in either precision.
#[derive(FromPyObject)]
enum PointsArgument<'py> {
    Single(PyReadonlyArray2<'py, f32>),
    Double(PyReadonlyArray2<'py, f64>),
}

impl PointsArgument<'_> {
    fn rows(&self) -> PyResult<Points<'_>> {
        fn rows<'a, T: numpy::Element>(array: &'a PyReadonlyArray2<'_, T>) -> PyResult<&'a [[T; 3]]> {
            if !array.is_c_contiguous() || array.shape()[1] != 3 {
                return Err(PyValueError::new_err("expected a C-contiguous array of rows of 3"));
            }
            Ok(array.as_slice()?.as_chunks().0)
        }
        match self {
            Self::Single(array) => rows(array).map(Points::Single),
            Self::Double(array) => rows(array).map(Points::Double),
        }
    }
}

type Hits<'py> =
    (Bound<'py, PyArray1<f32>>, Bound<'py, PyArray1<i64>>, Bound<'py, PyArray1<i32>>, Bound<'py, PyArray2<f32>>);

/// Distance, triangle, object and weights of the nearest hits.
#[pyfunction]
#[pyo3(signature = (scene, origins, directions, t_max, report=None))]
fn cast_rays<'py>(
    py: Python<'py>,
    scene: &Scene,
    origins: PointsArgument<'py>,
    directions: PointsArgument<'py>,
    t_max: f32,
    report: Option<Py<PyAny>>,
) -> PyResult<Hits<'py>> {
    let (origins, directions) = (origins.rows()?, directions.rows()?);
    let hits = run::long(py, report, |progress| cast(&scene.0, origins, directions, t_max, progress))?;
    let rows = hits.barycentric.len();
    let weights = hits.barycentric.into_flattened().into_pyarray(py).reshape([rows, 2])?;
    Ok((hits.t_hit.into_pyarray(py), hits.triangle_index.into_pyarray(py), hits.object_id.into_pyarray(py), weights))
}

type Near<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<i64>>, Bound<'py, PyArray2<f64>>);

/// Distance, triangle and weights of the nearest points of the surface.
#[pyfunction]
#[pyo3(signature = (scene, points, *, facing=None, report=None))]
fn nearest_points<'py>(
    py: Python<'py>,
    scene: &Scene,
    points: PointsArgument<'py>,
    facing: Option<PyReadonlyArray2<'py, f32>>,
    report: Option<Py<PyAny>>,
) -> PyResult<Near<'py>> {
    let points = points.rows()?;
    let facing = facing.as_ref().map(|rows| rows.as_slice()).transpose()?.map(|rows| rows.as_chunks().0);
    let found = run::long(py, report, |progress| trace::nearest(&scene.0, points, facing, progress))?;
    let rows = found.barycentric.len();
    let weights = found.barycentric.into_flattened().into_pyarray(py).reshape([rows, 2])?;
    Ok((found.distance.into_pyarray(py), found.triangle_index.into_pyarray(py), weights))
}

/// Names of the instruction sets that tracing can use here, the best last.
#[pyfunction]
fn instruction_sets() -> Vec<&'static str> {
    trace::instruction_sets()
}

/// Chooses one for this process; for tests and timing.
#[pyfunction]
fn use_instruction_set(name: &str) -> PyResult<()> {
    trace::use_instruction_set(name).map_err(to_python)
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(cast_rays, module)?)?;
    module.add_function(wrap_pyfunction!(nearest_points, module)?)?;
    module.add_function(wrap_pyfunction!(instruction_sets, module)?)?;
    module.add_function(wrap_pyfunction!(use_instruction_set, module)?)
}
