//! Bindings of `lod`: simplification of surfaces, and curves fitted to samples of SSIM.

use nearfar_core::base::memory::try_list;
use nearfar_core::lod::{self, Allowance, ConnectedSurface, LogisticCurve, Status, Unfit, Vertices};
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
    let places =
        run::long(py, report, |progress| ConnectedSurface::new(positions, faces)?.places(corners, starts, progress))?;
    let places = places.as_flattened();
    let weights = try_list(places.iter().map(|place| place.weights)).map_err(to_python)?;
    let faces = try_list(places.iter().map(|place| place.face)).map_err(to_python)?;
    Ok((faces.into_pyarray(py), array_of_rows(py, weights)?))
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
    let (positions, attributes, weights, is_protected) = &vertices;
    let vertices = Vertices {
        positions: positions.as_slice()?.as_chunks().0,
        attributes: attributes.as_slice()?,
        weights: weights.as_slice()?,
        is_protected: is_protected.as_slice()?,
    };
    let faces = faces.as_slice()?.as_chunks().0;
    let named = [("nothing", Allowance::Nothing), ("seams", Allowance::Seams), ("parts", Allowance::Parts)];
    let allowance = choice("sacrifice", sacrifice, &named).map_err(to_python)?;
    let (faces, error) = run::short(py, || lod::collapse(vertices, faces, target, allowance))?;
    Ok((array_of_rows(py, faces)?, error))
}

/// Code of a result: its row in the table of results in `nearfar.lod`.
fn code(status: Status) -> u8 {
    match status {
        Status::Fitted => 0,
        Status::Step => 1,
        Status::Open => 2,
        Status::Constant => 3,
        Status::Flat => 4,
        Status::Unfit(Unfit::TooFew) => 5,
        Status::Unfit(Unfit::Negative) => 6,
        Status::Unfit(Unfit::Overflow) => 7,
    }
}

/// Rows of parameters, and a result code for each row.
type Fits<'py> = (Array2<'py, f64>, Array1<'py, u8>);

/// Fits curves: rows of a, b, c, d and rms, and the result code of each fit.
#[pyfunction]
#[pyo3(signature = (x, y, *, count, report=None))]
pub fn fit_4pl<'py>(
    py: Python<'py>,
    x: Read1<'py, f64>,
    y: Read1<'py, f64>,
    count: usize,
    report: Report,
) -> PyResult<Fits<'py>> {
    let (x, y) = (x.as_slice()?, y.as_slice()?);
    let curves = run::long(py, report, |progress| lod::fit_4pl(x, y, count, progress))?;
    let rows = curves.iter().map(|&LogisticCurve { a, b, c, d, rms, .. }| [a, b, c, d, rms]).collect();
    Ok((array_of_rows(py, rows)?, PyArray1::from_iter(py, curves.iter().map(|curve| code(curve.status)))))
}
