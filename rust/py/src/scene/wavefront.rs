//! Bindings of `scene::wavefront`.

use nearfar_core::scene::wavefront;
use numpy::PyArray2;
use pyo3::prelude::*;

use crate::convert::arrays::array_of_rows;
use crate::convert::run;

type Rows<'py, T> = Bound<'py, PyArray2<T>>;
/// Indices of the object's and material's names, index rows of the vertices, and triangles.
type Part<'py> = (Option<u32>, Option<u32>, Rows<'py, u32>, Rows<'py, u32>);
/// Positions, colours, texture coordinates, normals.
type Columns<'py> = (Rows<'py, f64>, Rows<'py, f64>, Rows<'py, f64>, Rows<'py, f64>);

/// Parses OBJ text: its columns, names of material files, all names, parts, and the number of skipped faces.
#[pyfunction]
#[allow(clippy::type_complexity, reason = "a tuple without names crosses to Python once")]
pub(crate) fn read_wavefront<'py>(
    py: Python<'py>,
    text: &[u8],
) -> PyResult<(Columns<'py>, Vec<String>, Vec<String>, Vec<Part<'py>>, u64)> {
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
    Ok((columns, read.libraries, read.names, parts, read.skipped))
}
