//! Bindings of `scene::meshopt`.

use nearfar_core::scene::meshopt::{Filter, Layout, Mode, decode};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::convert::errors::to_python;
use crate::convert::names::choice;
use crate::convert::run;

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
pub(crate) fn decode_meshopt<'py>(
    py: Python<'py>,
    data: PyReadonlyArray1<'py, u8>,
    count: usize,
    stride: usize,
    mode: &str,
    filter: &str,
) -> PyResult<Bound<'py, PyArray1<u32>>> {
    let mode = choice("mode", mode, &MODES).map_err(to_python)?;
    let filter = choice("filter", filter, &FILTERS).map_err(to_python)?;
    let bytes = data.as_slice()?;
    let words = run::short(py, || decode(bytes, Layout { count, stride, mode, filter }))?;
    Ok(words.into_pyarray(py))
}
