//! Enums for arguments of one of several types.

/// Defines an enum, of arrays with the dimensions that it names; extraction yields its first variant whose type fits.
///
/// The derived enums of pyo3 compose a message for each type that does not fit. This runs Python code, which may
/// consume a pending Ctrl-C.
macro_rules! one_of {
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

pub(crate) use one_of;
