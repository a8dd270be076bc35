//! Bindings of `lod`: simplification of surfaces.

use nearfar_core::lod::{self, Allowance, Charts, Vertices};
use numpy::{IntoPyArray, PyArray1, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::convert::{Array1, Array2, Read1, Read2, Read3, Report, array_of_rows, choice, run, to_python};

/// For each row of bytes, the index of the first row equal to it.
#[pyfunction]
pub fn first_alike<'py>(py: Python<'py>, rows: Read2<'py, u8>) -> PyResult<Array1<'py, u32>> {
    let (width, rows) = (rows.shape()[1], rows.as_slice()?);
    Ok(run::long(py, None, |progress| lod::first_alike(rows, width, progress))?.into_pyarray(py))
}

/// Connected component of each face; faces that share a vertex belong to one component.
#[pyfunction]
pub fn pieces<'py>(py: Python<'py>, faces: Read2<'py, u32>, vertex_count: usize) -> PyResult<Array1<'py, u32>> {
    let faces = faces.as_slice()?.as_chunks().0;
    Ok(run::long(py, None, |progress| lod::pieces(faces, vertex_count, progress))?.into_pyarray(py))
}

/// Faces, and barycentric weights of their second and third vertex.
type Places<'py> = (Array1<'py, u32>, Array2<'py, f64>);

/// Maps the corners (T, 3, 3) of triangles to positions on a base surface, without crossing seams; one row per corner.
#[pyfunction]
#[pyo3(signature = (positions, faces, corners, starts, *, report=None))]
pub fn carry<'py>(
    py: Python<'py>,
    positions: Read2<'py, f32>,
    faces: Read2<'py, u32>,
    corners: Read3<'py, f32>,
    starts: Read1<'py, u32>,
    report: Report,
) -> PyResult<Places<'py>> {
    let (positions, faces) = (positions.as_slice()?.as_chunks().0, faces.as_slice()?.as_chunks().0);
    let (corners, starts) = (corners.as_slice()?.as_chunks().0.as_chunks().0, starts.as_slice()?);
    let places = run::long(py, report, |progress| Charts::new(positions, faces)?.places(corners, starts, progress))?;
    let places = places.as_flattened();
    let weights = places.iter().map(|place| place.weights).collect();
    Ok((PyArray1::from_iter(py, places.iter().map(|place| place.face)), array_of_rows(py, weights)?))
}

/// Positions, attributes, weights of the attributes, and whether each vertex is on a seam.
type VertexArrays<'py> = (Read2<'py, f32>, Read2<'py, f32>, Read1<'py, f32>, Read1<'py, bool>);

/// Collapses edges by meshoptimizer; returns the faces and the estimated error as a share of the extent.
#[pyfunction]
pub fn collapse<'py>(
    py: Python<'py>,
    vertices: VertexArrays<'py>,
    faces: Read2<'py, u32>,
    target: usize,
    sacrifice: &str,
) -> PyResult<(Array2<'py, u32>, f32)> {
    let (positions, attributes, weights, is_seam) = &vertices;
    let vertices = Vertices {
        positions: positions.as_slice()?.as_chunks().0,
        attributes: attributes.as_slice()?,
        weights: weights.as_slice()?,
        is_seam: is_seam.as_slice()?,
    };
    let faces = faces.as_slice()?.as_chunks().0;
    let named = [("nothing", Allowance::Nothing), ("seams", Allowance::Seams), ("parts", Allowance::Parts)];
    let allowance = choice("sacrifice", sacrifice, &named).map_err(to_python)?;
    let (faces, error) = run::short(py, || lod::collapse(vertices, faces, target, allowance))?;
    Ok((array_of_rows(py, faces)?, error))
}
