//! Bindings of `scene::polygons`.

use nearfar_core::base::Result;
use nearfar_core::scene::polygons::{Faces, Polygons, prisms, triangulate, wkb};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::convert::arrays::array_of_rows;
use crate::convert::run;

/// Faces (F, 3), and their offsets by polygon.
type FacesOf<'py> = (Bound<'py, PyArray2<u32>>, Bound<'py, PyArray1<i64>>);
/// Points (N, 2), offsets of rings, polygons and rows, and the number of skipped geometries.
type Outlines<'py> =
    (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray1<i64>>, Bound<'py, PyArray1<i64>>, Bound<'py, PyArray1<i64>>, u64);

fn faces_of(py: Python<'_>, faces: Faces) -> PyResult<FacesOf<'_>> {
    Ok((array_of_rows(py, faces.faces)?, faces.offsets.into_pyarray(py)))
}

/// Triangulates polygons; also returns the triangles' offsets by polygon.
#[pyfunction]
pub(crate) fn triangulate_polygons<'py>(
    py: Python<'py>,
    points: PyReadonlyArray2<'py, f64>,
    rings: PyReadonlyArray1<'py, i64>,
    polygons: PyReadonlyArray1<'py, i64>,
) -> PyResult<FacesOf<'py>> {
    let (points, rings, polygons) = (points.as_slice()?.as_chunks::<2>().0, rings.as_slice()?, polygons.as_slice()?);
    let faces = run::long(py, None, |progress| -> Result<Faces> {
        triangulate(&Polygons::new(points, rings, polygons)?, progress)
    })?;
    faces_of(py, faces)
}

/// Faces of prisms over polygons, and their offsets by polygon.
#[pyfunction]
pub(crate) fn polygon_prisms<'py>(
    py: Python<'py>,
    points: PyReadonlyArray2<'py, f64>,
    rings: PyReadonlyArray1<'py, i64>,
    polygons: PyReadonlyArray1<'py, i64>,
    has_floor: PyReadonlyArray1<'py, bool>,
) -> PyResult<FacesOf<'py>> {
    let (points, rings, polygons) = (points.as_slice()?.as_chunks::<2>().0, rings.as_slice()?, polygons.as_slice()?);
    let has_floor = has_floor.as_slice()?;
    let faces = run::long(py, None, |progress| -> Result<Faces> {
        prisms(&Polygons::new(points, rings, polygons)?, has_floor, progress)
    })?;
    faces_of(py, faces)
}

/// Reads polygons from rows in WKB.
#[pyfunction]
pub(crate) fn read_wkb<'py>(
    py: Python<'py>,
    data: PyReadonlyArray1<'py, u8>,
    offsets: PyReadonlyArray1<'py, i64>,
) -> PyResult<Outlines<'py>> {
    let (bytes, offsets) = (data.as_slice()?, offsets.as_slice()?);
    let found = run::long(py, None, |progress| wkb::read(bytes, offsets, progress))?;
    let [rings, polygons, rows] = [found.rings, found.polygons, found.rows].map(|ends| ends.into_pyarray(py));
    Ok((array_of_rows(py, found.points)?, rings, polygons, rows, found.skipped))
}
