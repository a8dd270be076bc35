//! Bindings of `morph`.

use glam::DVec3;
use nearfar_core::base::{Error, Result};
use nearfar_core::morph::{Kind, Morph};
use numpy::{PyArray2, PyArrayMethods, PyReadonlyArray2};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;

use crate::run;

#[derive(FromPyObject)]
enum Points<'py> {
    Single(PyReadonlyArray2<'py, f32>),
    Double(PyReadonlyArray2<'py, f64>),
}

pub(crate) fn kind(name: &str) -> Result<Kind> {
    match name {
        "blend" => Ok(Kind::Blend),
        "cylinder" => Ok(Kind::Cylinder),
        _ => Err(Error::value("kind", "'blend' or 'cylinder'", format!("'{name}'"))),
    }
}

/// Morphed points, and how many of them user and centre see in opposite directions.
#[pyfunction]
#[pyo3(signature = (points, *, user, center, r1, r2, kind))]
fn morph<'py>(
    py: Python<'py>,
    points: Points<'py>,
    user: [f64; 3],
    center: [f64; 3],
    r1: f64,
    r2: f64,
    kind: &str,
) -> PyResult<(Py<PyAny>, u64)> {
    let make = || Morph::new(DVec3::from_array(user), DVec3::from_array(center), r1, r2, self::kind(kind)?);
    match &points {
        Points::Single(points) => {
            let rows = points.as_slice()?.as_chunks::<3>().0;
            let shown = PyArray2::<f32>::zeros(py, [rows.len(), 3], false);
            let mut write = shown.readwrite();
            let to = write.as_slice_mut()?.as_chunks_mut::<3>().0;
            let opposed = run::short(py, || Ok(make()?.apply_all_f32(rows, to)))?;
            Ok((shown.into_py_any(py)?, opposed))
        }
        Points::Double(points) => {
            let rows = points.as_slice()?.as_chunks::<3>().0;
            let shown = PyArray2::<f64>::zeros(py, [rows.len(), 3], false);
            let mut write = shown.readwrite();
            let to = write.as_slice_mut()?.as_chunks_mut::<3>().0;
            let opposed = run::short(py, || Ok(make()?.apply_all_f64(rows, to)))?;
            Ok((shown.into_py_any(py)?, opposed))
        }
    }
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(morph, module)?)
}
