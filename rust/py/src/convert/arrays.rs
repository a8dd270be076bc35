//! NumPy arrays as kernel buffers. The Python side guarantees that they are contiguous and of the right type.

use std::slice;

use nearfar_core::base::Buffer;
use nearfar_core::base::memory::room_for_values;
use numpy::ndarray::{Dimension, IntoDimension, Ix2};
use numpy::{
    Element, IntoPyArray, PyArray, PyArray1, PyArray2, PyArray3, PyArray4, PyArrayDyn, PyArrayMethods, PyReadonlyArray,
    PyReadwriteArray, PyUntypedArrayMethods,
};
/// Short names for input and output arrays of kernels, by number of dimensions.
pub use numpy::{
    PyReadonlyArray1 as Read1, PyReadonlyArray2 as Read2, PyReadonlyArray3 as Read3, PyReadonlyArray4 as Read4,
    PyReadonlyArrayDyn as ReadAny, PyReadwriteArray1 as Write1, PyReadwriteArray2 as Write2,
    PyReadwriteArray3 as Write3, PyReadwriteArray4 as Write4,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use super::errors::to_python;

/// Defines an enum of argument types, usually arrays; type parameters are the arrays' dimensions. Extraction yields the
/// first variant that fits.
///
/// pyo3's derived enums would compose a message for each variant that does not fit. That runs Python code, which may
/// consume a pending Ctrl-C.
macro_rules! argument_enum {
    (
        $(#[$attribute:meta])*
        $visibility:vis enum $name:ident$(<$life:lifetime $(, $dimension:ident)*>)? { $($variant:ident($type:ty)),+ $(,)? }
    ) => {
        $(#[$attribute])*
        $visibility enum $name$(<$life $(, $dimension: numpy::ndarray::Dimension)*>)? {
            $($variant($type)),+
        }

        impl<'a, 'py $($(, $dimension: numpy::ndarray::Dimension + 'static)*)?> pyo3::FromPyObject<'a, 'py>
            for $name$(<$life $(, $dimension)*>)?
        {
            type Error = pyo3::PyErr;

            fn extract(value: pyo3::Borrowed<'a, 'py, pyo3::PyAny>) -> pyo3::PyResult<Self> {
                $(
                    if let Ok(extracted) = value.extract::<$type>() {
                        return Ok(Self::$variant(extracted));
                    }
                )+
                Err(pyo3::exceptions::PyTypeError::new_err("expected a value of another type or shape"))
            }
        }
    };
}

pub type Array1<'py, T> = Bound<'py, PyArray1<T>>;
pub type Array2<'py, T> = Bound<'py, PyArray2<T>>;
pub type Array3<'py, T> = Bound<'py, PyArray3<T>>;
pub type Array4<'py, T> = Bound<'py, PyArray4<T>>;

argument_enum! {
    /// An array of D dimensions, float32 or float64.
    pub enum Floats<'py, D> {
        Single(PyReadonlyArray<'py, f32, D>),
        Double(PyReadonlyArray<'py, f64, D>),
    }
}

/// Rows of coordinates.
pub type Points<'py> = Floats<'py, Ix2>;

argument_enum! {
    /// An array of D dimensions, and an output array of E dimensions and the same type.
    pub enum FloatsInOut<'py, D, E> {
        Single((PyReadonlyArray<'py, f32, D>, PyReadwriteArray<'py, f32, E>)),
        Double((PyReadonlyArray<'py, f64, D>, PyReadwriteArray<'py, f64, E>)),
    }
}

argument_enum! {
    /// Arrays as in `FloatsInOut` for kernels that only copy values: of any type, which is given by its size in bytes.
    pub enum BitsInOut<'py, D, E> {
        One((PyReadonlyArray<'py, u8, D>, PyReadwriteArray<'py, u8, E>)),
        Two((PyReadonlyArray<'py, u16, D>, PyReadwriteArray<'py, u16, E>)),
        Four((PyReadonlyArray<'py, u32, D>, PyReadwriteArray<'py, u32, E>)),
        Eight((PyReadonlyArray<'py, u64, D>, PyReadwriteArray<'py, u64, E>)),
    }
}

/// Evaluates an expression with the array of an enum, whatever its variant.
macro_rules! with_array {
    ($kind:ident::{$($variant:ident),+}, $value:expr, $array:ident => $body:expr) => {
        match $value {
            $($kind::$variant($array) => $body,)+
        }
    };
}

/// Evaluates an expression with points as rows of 3 coordinates, whatever their type.
macro_rules! with_rows {
    ($points:expr, $rows:ident => $body:expr) => {
        $crate::convert::with_array!(Points::{Single, Double}, $points, array => {
            let $rows = array.as_slice()?.as_chunks::<3>().0;
            $body
        })
    };
}

pub(crate) use {argument_enum, with_array, with_rows};

/// Creates an array of zeros; raises MemoryError where `PyArray::zeros` would panic.
pub fn zeros<T: Element, S: IntoDimension>(py: Python<'_>, shape: S) -> PyResult<Bound<'_, PyArray<T, S::Dim>>> {
    let shape = shape.into_dimension();
    room_for_values::<T>(shape.size()).map_err(to_python)?;
    Ok(PyArray::zeros(py, shape, false))
}

/// Copies values to a bytes object; raises MemoryError where `PyBytes::new` would panic.
pub fn bytes_of<'py>(py: Python<'py>, values: &[u8]) -> PyResult<Bound<'py, PyBytes>> {
    room_for_values::<u8>(values.len()).map_err(to_python)?;
    Ok(PyBytes::new(py, values))
}

/// Creates an array whose values a kernel writes.
pub fn filled<'py, T: Element, S: IntoDimension>(
    py: Python<'py>,
    shape: S,
    write: impl FnOnce(&mut [T]) -> PyResult<()>,
) -> PyResult<Bound<'py, PyArray<T, S::Dim>>> {
    let array = zeros(py, shape)?;
    write(array.readwrite().as_slice_mut()?)?;
    Ok(array)
}

/// Converts rows to an array (N, C), without a copy.
pub fn array_of_rows<T: Element, const C: usize>(py: Python<'_>, rows: Vec<[T; C]>) -> PyResult<Array2<'_, T>> {
    let count = rows.len();
    rows.into_flattened().into_pyarray(py).reshape([count, C])
}

/// A NumPy array that is kept alive while kernels read its memory.
struct Borrowed<T> {
    _owner: Py<PyAny>,
    first: *const T,
    length: usize,
}

// SAFETY: the memory is only read, its owner lives as long as this value, and `borrow` has made it read-only. A `Py`
// may be dropped on any thread.
unsafe impl<T: Sync> Send for Borrowed<T> {}
// SAFETY: as above.
unsafe impl<T: Sync> Sync for Borrowed<T> {}

impl<T> AsRef<[T]> for Borrowed<T> {
    fn as_ref(&self) -> &[T] {
        if self.length == 0 {
            return &[];
        }
        // SAFETY: `borrow` checked that `first` points to `length` initialised, aligned elements of a C-contiguous
        // array; `_owner` keeps them alive.
        unsafe { slice::from_raw_parts(self.first, self.length) }
    }
}

/// Borrows a C-contiguous array of rows of `R` elements as a buffer of rows, without a copy. The array becomes
/// read-only, because a scene is immutable.
pub fn buffer<T: Element + Sync + 'static, const R: usize>(
    array: &Bound<'_, PyArrayDyn<T>>,
) -> PyResult<Buffer<[T; R]>> {
    match array.shape() {
        [rows, columns] if *columns == R => borrow(array, *rows),
        shape => Err(PyValueError::new_err(format!("expected rows of {R}, got shape {shape:?}"))),
    }
}

/// Borrows a one-dimensional array like `buffer`.
pub fn flat_buffer<T: Element + Sync + 'static>(array: &Bound<'_, PyArrayDyn<T>>) -> PyResult<Buffer<T>> {
    match array.shape() {
        [length] => borrow(array, *length),
        shape => Err(PyValueError::new_err(format!("expected one dimension, got shape {shape:?}"))),
    }
}

/// Borrows an array of T as `length` values of U, each of one or more T.
fn borrow<T: Element, U: Sync + 'static>(array: &Bound<'_, PyArrayDyn<T>>, length: usize) -> PyResult<Buffer<U>> {
    if !array.is_c_contiguous() || !(array.data() as usize).is_multiple_of(align_of::<T>()) {
        return Err(PyValueError::new_err("expected an aligned C-contiguous array"));
    }
    array.call_method1("setflags", (false,))?;
    let owner: Py<PyAny> = array.clone().into_any().unbind();
    Ok(Buffer::from_owner(Borrowed::<U> { _owner: owner, first: array.data().cast(), length }))
}
