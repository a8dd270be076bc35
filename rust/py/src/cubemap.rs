//! Bindings of `cubemap`.

use nearfar_core::base::{Error, Result};
use nearfar_core::cubemap::{self, Faces, Filter, Real};
use numpy::{
    Element, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2, PyReadonlyArray4, PyUntypedArrayMethods, ToPyArray,
};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;

use crate::run;

#[derive(FromPyObject)]
enum Directions<'py> {
    Single(PyReadonlyArray2<'py, f32>),
    Double(PyReadonlyArray2<'py, f64>),
}

#[derive(FromPyObject)]
enum Maps<'py> {
    Single(PyReadonlyArray4<'py, f32>),
    Double(PyReadonlyArray4<'py, f64>),
}

pub(crate) fn filter(name: &str) -> Result<Filter> {
    match name {
        "nearest" => Ok(Filter::Nearest),
        "linear" => Ok(Filter::Linear),
        "min" => Ok(Filter::Min),
        "max" => Ok(Filter::Max),
        _ => Err(Error::value("filter", "'nearest', 'linear', 'min' or 'max'", format!("'{name}'"))),
    }
}

fn sample<'py, T: Real + Element, D: Real + Element>(
    py: Python<'py>,
    faces: &PyReadonlyArray4<'py, T>,
    directions: &PyReadonlyArray2<'py, D>,
    name: &str,
) -> PyResult<Py<PyAny>> {
    let (size, channels) = (faces.shape()[1], faces.shape()[3]);
    let (values, rows) = (faces.as_slice()?, directions.as_slice()?.as_chunks::<3>().0);
    let out = run::short(py, || {
        let faces = Faces::new(values, u32::try_from(size).unwrap_or(u32::MAX), channels)?;
        let mut out = vec![T::from_f64(0.0); rows.len() * channels];
        cubemap::lookup(faces, rows, filter(name)?, &mut out)?;
        Ok(out)
    })?;
    let out: Bound<'py, PyArray2<T>> = PyArray1::from_vec(py, out).reshape([rows.len(), channels])?;
    out.into_py_any(py)
}

/// Values (N, C) of faces (6, S, S, C) along directions (N, 3), in the faces' type.
#[pyfunction]
fn cube_lookup<'py>(
    py: Python<'py>,
    faces: Maps<'py>,
    directions: Directions<'py>,
    filter: &str,
) -> PyResult<Py<PyAny>> {
    match (&faces, &directions) {
        (Maps::Single(faces), Directions::Single(directions)) => sample(py, faces, directions, filter),
        (Maps::Single(faces), Directions::Double(directions)) => sample(py, faces, directions, filter),
        (Maps::Double(faces), Directions::Single(directions)) => sample(py, faces, directions, filter),
        (Maps::Double(faces), Directions::Double(directions)) => sample(py, faces, directions, filter),
    }
}

/// Number of the texel that each direction (N, 3) passes through.
#[pyfunction]
fn cube_texels<'py>(
    py: Python<'py>,
    size: u32,
    directions: PyReadonlyArray2<'py, f64>,
) -> PyResult<Bound<'py, PyArray1<u32>>> {
    let rows = directions.as_slice()?.as_chunks::<3>().0;
    Ok(run::short(py, || cubemap::texels(size, rows))?.to_pyarray(py))
}

/// Directions (6 S S, 3) of all texel centres; the longest component is 1 or -1.
#[pyfunction]
fn cube_directions(py: Python<'_>, size: u32) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let flat = run::short(py, || cubemap::directions(size))?;
    PyArray1::from_vec(py, flat.into_flattened()).reshape([6 * (size as usize).pow(2), 3])
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(cube_lookup, module)?)?;
    module.add_function(wrap_pyfunction!(cube_texels, module)?)?;
    module.add_function(wrap_pyfunction!(cube_directions, module)?)
}
