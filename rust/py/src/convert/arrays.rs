//! NumPy arrays as kernel buffers. The Python side has made them contiguous and of the right type.

use std::slice;

use nearfar_core::base::Buffer;
use numpy::{Element, PyArrayDyn, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Rows of coordinates in either precision.
#[derive(FromPyObject)]
pub enum Points<'py> {
    Single(PyReadonlyArray2<'py, f32>),
    Double(PyReadonlyArray2<'py, f64>),
}

/// Keeps a NumPy array alive while kernels read its memory.
struct Borrowed<T> {
    _owner: Py<PyAny>,
    first: *const T,
    length: usize,
}

// SAFETY: the memory is only read, its owner is alive as long as this value, and `buffer` has made it read-only;
// dropping a `Py` from any thread is sound.
unsafe impl<T: Sync> Send for Borrowed<T> {}
// SAFETY: as above.
unsafe impl<T: Sync> Sync for Borrowed<T> {}

impl<T> AsRef<[T]> for Borrowed<T> {
    fn as_ref(&self) -> &[T] {
        if self.length == 0 {
            return &[];
        }
        // SAFETY: `buffer` checked that `first` points to `length` initialised, aligned elements of a C-contiguous
        // array, and `_owner` keeps them alive.
        unsafe { slice::from_raw_parts(self.first, self.length) }
    }
}

/// Borrows a C-contiguous array of rows of `R` elements as a buffer of rows, without a copy. The array is made
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

/// Borrows a one-dimensional array as a buffer, as `buffer` does.
pub fn flat_buffer<T: Element + Sync + 'static>(array: &Bound<'_, PyArrayDyn<T>>) -> PyResult<Buffer<T>> {
    struct Flat<T>(Buffer<[T; 1]>);
    impl<T> AsRef<[T]> for Flat<T> {
        fn as_ref(&self) -> &[T] {
            self.0.as_flattened()
        }
    }
    Ok(Buffer::from_owner(Flat(buffer::<T, 1>(array)?)))
}
