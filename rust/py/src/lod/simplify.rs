//! Bindings of `lod`: simplification of surfaces.

use nearfar_core::base::Result;
use nearfar_core::lod::{self, Allowance, Charts, Vertices};
use numpy::{
    IntoPyArray, PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2, PyReadonlyArray3, PyUntypedArrayMethods,
};
use pyo3::prelude::*;

use crate::convert::arrays::array_of_rows;
use crate::convert::names::choice;
use crate::convert::run;

/// For each row of bytes, the index of the first row equal to it.
#[pyfunction]
pub(crate) fn first_alike<'py>(
    py: Python<'py>,
    rows: PyReadonlyArray2<'py, u8>,
) -> PyResult<Bound<'py, PyArray1<u32>>> {
    let (width, rows) = (rows.shape()[1], rows.as_slice()?);
    Ok(run::long(py, None, |progress| lod::first_alike(rows, width, progress))?.into_pyarray(py))
}

/// Connected component of each face; faces that share a vertex belong to one component.
#[pyfunction]
pub(crate) fn pieces<'py>(
    py: Python<'py>,
    faces: PyReadonlyArray2<'py, u32>,
    vertex_count: usize,
) -> PyResult<Bound<'py, PyArray1<u32>>> {
    let faces = faces.as_slice()?.as_chunks().0;
    Ok(run::long(py, None, |progress| lod::pieces(faces, vertex_count, progress))?.into_pyarray(py))
}

/// Faces, and barycentric weights of their second and third vertex.
type Places<'py> = (Bound<'py, PyArray1<u32>>, Bound<'py, PyArray2<f64>>);

/// Maps the corners (T, 3, 3) of triangles to positions on a base surface, without crossing seams; one row per corner.
#[pyfunction]
#[pyo3(signature = (positions, faces, corners, starts, *, report=None))]
pub(crate) fn carry<'py>(
    py: Python<'py>,
    positions: PyReadonlyArray2<'py, f32>,
    faces: PyReadonlyArray2<'py, u32>,
    corners: PyReadonlyArray3<'py, f32>,
    starts: PyReadonlyArray1<'py, u32>,
    report: Option<Py<PyAny>>,
) -> PyResult<Places<'py>> {
    let (positions, faces) = (positions.as_slice()?.as_chunks().0, faces.as_slice()?.as_chunks().0);
    let (corners, starts) = (corners.as_slice()?.as_chunks().0.as_chunks().0, starts.as_slice()?);
    let places = run::long(py, report, |progress| Charts::new(positions, faces)?.places(corners, starts, progress))?;
    let places = places.as_flattened();
    let weights = places.iter().map(|place| place.weights).collect();
    Ok((PyArray1::from_iter(py, places.iter().map(|place| place.face)), array_of_rows(py, weights)?))
}

fn giving_up(name: &str) -> Result<Allowance> {
    choice("given", name, &[("nothing", Allowance::Nothing), ("seams", Allowance::Seams), ("parts", Allowance::Parts)])
}

/// Collapses edges by meshoptimizer; returns the faces and the estimated error as a share of the extent.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "what the simplifier weighs")]
pub(crate) fn collapse<'py>(
    py: Python<'py>,
    positions: PyReadonlyArray2<'py, f32>,
    attributes: PyReadonlyArray2<'py, f32>,
    weights: PyReadonlyArray1<'py, f32>,
    is_seam: PyReadonlyArray1<'py, bool>,
    faces: PyReadonlyArray2<'py, u32>,
    target: usize,
    given: &str,
) -> PyResult<(Bound<'py, PyArray2<u32>>, f32)> {
    let vertices = Vertices {
        positions: positions.as_slice()?.as_chunks().0,
        attributes: attributes.as_slice()?,
        weights: weights.as_slice()?,
        is_seam: is_seam.as_slice()?,
    };
    let faces = faces.as_slice()?.as_chunks().0;
    let (left, error) = run::short(py, || lod::collapse(vertices, faces, target, giving_up(given)?))?;
    Ok((array_of_rows(py, left)?, error))
}
