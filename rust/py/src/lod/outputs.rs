//! Arrays that the selection kernels fill.

use nearfar_core::lod::{self, SelectionCounts};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;

pub(super) type Levels<'py> = Bound<'py, PyArray1<i32>>;
pub(super) type Column<'py> = Bound<'py, PyArray1<f64>>;

pub(super) fn count_list(counts: &SelectionCounts) -> Vec<u64> {
    let SelectionCounts { culled, one_level, settled, large, asked, lens, table, formula } = *counts;
    vec![culled, one_level, settled, large, asked, lens, table, formula]
}

/// Creates the arrays of levels and, if requested, of the additional columns, and fills them by a function.
pub(super) fn filled<'py, T>(
    py: Python<'py>,
    count: usize,
    full: bool,
    fill: impl FnOnce(&mut [i32], Option<[&mut [f64]; lod::COLUMNS]>) -> PyResult<T>,
) -> PyResult<(Levels<'py>, Vec<Column<'py>>, T)> {
    let level = PyArray1::<i32>::zeros(py, count, false);
    let columns: Vec<_> =
        (0..if full { lod::COLUMNS } else { 0 }).map(|_| PyArray1::<f64>::zeros(py, count, false)).collect();
    let mut write = level.readwrite();
    let mut writes: Vec<_> = columns.iter().map(|column| column.readwrite()).collect();
    let mut slices = Vec::new();
    for column in &mut writes {
        slices.push(column.as_slice_mut()?);
    }
    let result = fill(write.as_slice_mut()?, slices.try_into().ok())?;
    drop(writes);
    Ok((level, columns, result))
}
