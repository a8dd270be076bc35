//! NumPy arrays as kernel buffers. The Python side guarantees that they are contiguous and of the right type.

use std::slice;

use nearfar_core::base::Buffer;
use numpy::ndarray::IntoDimension;
use numpy::{
    Element, IntoPyArray, PyArray, PyArray2, PyArrayDyn, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::one_of::one_of;

one_of! {
    /// Rows of coordinates, float32 or float64.
    pub enum Points<'py> {
        Single(PyReadonlyArray2<'py, f32>),
        Double(PyReadonlyArray2<'py, f64>),
    }
}

/// Evaluates an expression with the array in an enum of arrays, for any type.
macro_rules! with_array {
    ($kind:ident::{$($variant:ident),+}, $value:expr, $array:ident => $body:expr) => {
        match $value {
            $($kind::$variant($array) => $body,)+
        }
    };
}

/// Evaluates an expression with rows of 3 coordinates, for any type.
macro_rules! with_rows {
    ($points:expr, $rows:ident => $body:expr) => {
        $crate::convert::arrays::with_array!(Points::{Single, Double}, $points, array => {
            let $rows = array.as_slice()?.as_chunks::<3>().0;
            $body
        })
    };
}

pub(crate) use {with_array, with_rows};

/// A new array whose values a kernel writes.
pub fn filled<'py, T: Element, S: IntoDimension>(
    py: Python<'py>,
    shape: S,
    write: impl FnOnce(&mut [T]) -> PyResult<()>,
) -> PyResult<Bound<'py, PyArray<T, S::Dim>>> {
    let array = PyArray::zeros(py, shape, false);
    write(array.readwrite().as_slice_mut()?)?;
    Ok(array)
}

/// Rows as an array (N, C), without a copy.
pub fn array_of_rows<T: Element, const C: usize>(
    py: Python<'_>,
    rows: Vec<[T; C]>,
) -> PyResult<Bound<'_, PyArray2<T>>> {
    let count = rows.len();
    rows.into_flattened().into_pyarray(py).reshape([count, C])
}

/// A NumPy array that is kept alive while kernels read its memory.
struct Borrowed<T> {
    _owner: Py<PyAny>,
    first: *const T,
    length: usize,
}

// SAFETY: the memory is only read, its owner lives as long as this value, and `buffer` has made it read-only. A `Py`
// may be dropped on any thread.
unsafe impl<T: Sync> Send for Borrowed<T> {}
// SAFETY: as above.
unsafe impl<T: Sync> Sync for Borrowed<T> {}

impl<T> AsRef<[T]> for Borrowed<T> {
    fn as_ref(&self) -> &[T] {
        if self.length == 0 {
            return &[];
        }
        // SAFETY: `buffer` checked that `first` points to `length` initialised, aligned elements of a C-contiguous
        // array; `_owner` keeps them alive.
        unsafe { slice::from_raw_parts(self.first, self.length) }
    }
}

/// Borrows a C-contiguous array of rows of `R` elements as a buffer of rows, without a copy. The array becomes
/// read-only, because a scene is immutable.
pub fn buffer<T: Element + Sync + 'static, const R: usize>(
    array: &Bound<'_, PyArrayDyn<T>>,
) -> PyResult<Buffer<[T; R]>> {
    let shape = array.shape();
    let rows = match (R, shape) {
        (1, [rows]) => *rows,
        (_, [rows, columns]) if *columns == R => *rows,
        _ => return Err(PyValueError::new_err(format!("expected rows of {R}, got shape {shape:?}"))),
    };
    if !array.is_c_contiguous() || !(array.data() as usize).is_multiple_of(align_of::<T>()) {
        return Err(PyValueError::new_err("expected an aligned C-contiguous array"));
    }
    array.call_method1("setflags", (false,))?;
    let owner: Py<PyAny> = array.clone().into_any().unbind();
    Ok(Buffer::from_owner(Borrowed::<[T; R]> { _owner: owner, first: array.data().cast(), length: rows }))
}

/// Borrows a one-dimensional array like `buffer`.
pub fn flat_buffer<T: Element + Sync + 'static>(array: &Bound<'_, PyArrayDyn<T>>) -> PyResult<Buffer<T>> {
    struct Flat<T>(Buffer<[T; 1]>);
    impl<T> AsRef<[T]> for Flat<T> {
        fn as_ref(&self) -> &[T] {
            self.0.as_flattened()
        }
    }
    Ok(Buffer::from_owner(Flat(buffer::<T, 1>(array)?)))
}
