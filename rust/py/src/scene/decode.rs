//! Bindings of decoders: OBJ, PLY, meshoptimizer's streams in glTF, polygons in WKB; and faces of polygons.

use nearfar_core::base::Result;
use nearfar_core::scene::meshopt::{Filter, Layout, Mode, decode, encode_triangles, encode_words};
use nearfar_core::scene::ply::{self, ScalarType};
use nearfar_core::scene::polygons::{Faces, Polygons, prisms, triangulate, triangulate_faces as faces_in_space, wkb};
use nearfar_core::scene::wavefront::{self, Skipped};
use numpy::{IntoPyArray, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::convert::{Array1, Array2, Read1, Read2, array_of_rows, bytes_of, choice, run, to_python};

type Rows<'py, T> = Array2<'py, T>;
/// Indices of the object's and material's names, index rows of the vertices, and triangles.
type Part<'py> = (Option<u32>, Option<u32>, Rows<'py, u32>, Rows<'py, u32>);
/// Positions, colours, texture coordinates, normals.
type Columns<'py> = (Rows<'py, f64>, Rows<'py, f64>, Rows<'py, f64>, Rows<'py, f64>);

/// Parses OBJ text: its columns, names of material files, all names, parts, and the numbers of skipped faces, lines,
/// points and free forms, of large polygons, and of polygons that cross themselves.
#[pyfunction]
#[allow(clippy::type_complexity, reason = "a tuple without names crosses to Python once")]
pub fn read_wavefront<'py>(
    py: Python<'py>,
    text: &[u8],
) -> PyResult<(Columns<'py>, Vec<String>, Vec<String>, Vec<Part<'py>>, [u64; 6])> {
    let read = run::long(py, None, |progress| wavefront::read(text, progress))?;
    let parts = read.parts.into_iter().map(|part| {
        let (vertices, faces) = (array_of_rows(py, part.vertices)?, array_of_rows(py, part.faces)?);
        Ok((part.object, part.material, vertices, faces))
    });
    let parts = parts.collect::<PyResult<_>>()?;
    let columns = (
        array_of_rows(py, read.positions)?,
        array_of_rows(py, read.colors)?,
        array_of_rows(py, read.uvs)?,
        array_of_rows(py, read.normals)?,
    );
    let Skipped { faces, lines, points, free_forms } = read.skipped;
    let counts = [faces, lines, points, free_forms, read.fans.large, read.fans.crossing];
    Ok((columns, read.libraries, read.names, parts, counts))
}

/// Types of lengths of lists by NumPy's codes.
const LENGTHS: [(&str, ScalarType); 10] = [
    ("i1", ScalarType::I8),
    ("u1", ScalarType::U8),
    ("i2", ScalarType::I16),
    ("u2", ScalarType::U16),
    ("i4", ScalarType::I32),
    ("u4", ScalarType::U32),
    ("i8", ScalarType::I64),
    ("u8", ScalarType::U64),
    ("f4", ScalarType::F32),
    ("f8", ScalarType::F64),
];
/// Bytes of the values, and offsets of the rows; the offsets of single values are empty.
type Column<'py> = (Array1<'py, u8>, Array1<'py, i64>);

/// Reads rows of a PLY file whose lists differ in length: the columns, and the end of the rows. A property has the bytes
/// of a value, and the NumPy type of a list's length, or "".
#[pyfunction]
pub fn read_ply_rows<'py>(
    py: Python<'py>,
    data: &[u8],
    start: usize,
    count: usize,
    properties: Vec<(usize, String)>,
    is_big_endian: bool,
) -> PyResult<(Vec<Column<'py>>, usize)> {
    let property = |(size, code): &(usize, String)| {
        let length = (!code.is_empty()).then(|| choice("properties", code, &LENGTHS)).transpose()?;
        Ok(ply::Property { size: *size, length })
    };
    let properties: Vec<ply::Property> = properties.iter().map(property).collect::<Result<_>>().map_err(to_python)?;
    let data = ply::Data { bytes: data, is_big_endian };
    let (columns, end) = run::long(py, None, |progress| ply::read_rows(data, start, count, &properties, progress))?;
    let columns = columns.into_iter().map(|column| (column.bytes.into_pyarray(py), column.offsets.into_pyarray(py)));
    Ok((columns.collect(), end))
}

/// Parses numbers of a text that are separated by white space.
#[pyfunction]
pub fn parse_numbers<'py>(py: Python<'py>, text: &[u8]) -> PyResult<Array1<'py, f64>> {
    Ok(run::long(py, None, |progress| ply::parse_numbers(text, progress))?.into_pyarray(py))
}

/// Names of modes and filters in glTF.
const MODES: [(&str, Mode); 3] =
    [("ATTRIBUTES", Mode::Attributes), ("TRIANGLES", Mode::Triangles), ("INDICES", Mode::Indices)];
const FILTERS: [(&str, Filter); 5] = [
    ("NONE", Filter::None),
    ("OCTAHEDRAL", Filter::Octahedral),
    ("QUATERNION", Filter::Quaternion),
    ("EXPONENTIAL", Filter::Exponential),
    ("COLOR", Filter::Color),
];

/// Decodes a stream to rows, as 32-bit words; the last word may have two padding bytes.
#[pyfunction]
pub fn decode_meshopt<'py>(
    py: Python<'py>,
    data: Read1<'py, u8>,
    count: usize,
    stride: usize,
    mode: &str,
    filter: &str,
) -> PyResult<Array1<'py, u32>> {
    let mode = choice("mode", mode, &MODES).map_err(to_python)?;
    let filter = choice("filter", filter, &FILTERS).map_err(to_python)?;
    let bytes = data.as_slice()?;
    let words = run::short(py, || decode(bytes, Layout { count, stride, mode, filter }))?;
    Ok(words.into_pyarray(py))
}

/// Encodes rows (N, 1 to 4) of 32-bit words of vertex attributes, to which a filter has been applied.
#[pyfunction]
pub fn encode_meshopt_rows<'py>(py: Python<'py>, rows: Read2<'py, u32>) -> PyResult<Bound<'py, PyBytes>> {
    let (words, width) = (rows.as_slice()?, rows.shape()[1]);
    bytes_of(py, &run::short(py, || encode_words(words, width))?)
}

/// Encodes the corners of triangles (F, 3), numbers below `vertex_count`.
#[pyfunction]
pub fn encode_meshopt_triangles<'py>(
    py: Python<'py>,
    faces: Read2<'py, u32>,
    vertex_count: usize,
) -> PyResult<Bound<'py, PyBytes>> {
    let corners = faces.as_slice()?;
    bytes_of(py, &run::short(py, || encode_triangles(corners, vertex_count))?)
}

/// Faces (F, 3), their offsets by polygon, and numbers of polygons that have other faces than their outlines ask for.
type FacesOf<'py, N> = (Array2<'py, u32>, Array1<'py, i64>, N);
/// Points (N, 2), offsets of rings, polygons and rows, and the number of skipped geometries.
type Outlines<'py> = (Array2<'py, f64>, Array1<'py, i64>, Array1<'py, i64>, Array1<'py, i64>, u64);

fn faces_of<N>(py: Python<'_>, (faces, counts): (Faces, N)) -> PyResult<FacesOf<'_, N>> {
    Ok((array_of_rows(py, faces.faces)?, faces.offsets.into_pyarray(py), counts))
}

/// Triangulates polygons; also returns the triangles' offsets by polygon, and the number of polygons whose rings cross.
#[pyfunction]
pub fn triangulate_polygons<'py>(
    py: Python<'py>,
    points: Read2<'py, f64>,
    rings: Read1<'py, i64>,
    polygons: Read1<'py, i64>,
) -> PyResult<FacesOf<'py, u64>> {
    let (points, rings, polygons) = (points.as_slice()?.as_chunks::<2>().0, rings.as_slice()?, polygons.as_slice()?);
    faces_of(py, run::long(py, None, |progress| triangulate(&Polygons::new(points, rings, polygons)?, progress))?)
}

/// Triangulates polygons in space: triangles of corner numbers, their offsets by polygon, and the numbers of large
/// polygons and of those that cross themselves, which are fans.
#[pyfunction]
pub fn triangulate_faces<'py>(
    py: Python<'py>,
    points: Read2<'py, f64>,
    corners: Read1<'py, u32>,
    offsets: Read1<'py, i64>,
) -> PyResult<FacesOf<'py, [u64; 2]>> {
    let (points, corners, offsets) = (points.as_slice()?.as_chunks::<3>().0, corners.as_slice()?, offsets.as_slice()?);
    let (faces, fans) = run::long(py, None, |progress| faces_in_space(points, corners, offsets, progress))?;
    faces_of(py, (faces, [fans.large, fans.crossing]))
}

/// Faces of prisms over polygons, their offsets by polygon, and the number of polygons whose rings cross.
#[pyfunction]
pub fn polygon_prisms<'py>(
    py: Python<'py>,
    points: Read2<'py, f64>,
    rings: Read1<'py, i64>,
    polygons: Read1<'py, i64>,
    has_floor: Read1<'py, bool>,
) -> PyResult<FacesOf<'py, u64>> {
    let (points, rings, polygons) = (points.as_slice()?.as_chunks::<2>().0, rings.as_slice()?, polygons.as_slice()?);
    let has_floor = has_floor.as_slice()?;
    faces_of(py, run::long(py, None, |progress| prisms(&Polygons::new(points, rings, polygons)?, has_floor, progress))?)
}

/// Reads polygons from rows in WKB.
#[pyfunction]
pub fn read_wkb<'py>(py: Python<'py>, data: Read1<'py, u8>, offsets: Read1<'py, i64>) -> PyResult<Outlines<'py>> {
    let (bytes, offsets) = (data.as_slice()?, offsets.as_slice()?);
    let outlines = run::long(py, None, |progress| wkb::read(bytes, offsets, progress))?;
    let ends = [outlines.rings, outlines.polygons, outlines.rows];
    let [rings, polygons, rows] = ends.map(|ends| ends.into_pyarray(py));
    Ok((array_of_rows(py, outlines.points)?, rings, polygons, rows, outlines.skipped))
}
