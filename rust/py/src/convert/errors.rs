//! The only place where kernel errors become Python exceptions. `nearfar._base.errors` re-exports these exceptions.

use std::any::Any;

use nearfar_core::base::Error;
use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyKeyboardInterrupt, PyMemoryError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;

create_exception!(nearfar, NearfarError, PyException, "Base of nearfar's own exceptions.");
create_exception!(nearfar, SceneError, NearfarError, "A user's scene or file is unusable; names it and says why.");
create_exception!(nearfar, FormatError, NearfarError, "A file in nearfar's format is damaged or too new; names it.");
create_exception!(nearfar, DeviceError, NearfarError, "A graphics adapter is missing or was lost; says which.");

/// Maps each kind of kernel error to its exception.
pub fn to_python(error: Error) -> PyErr {
    match error {
        Error::Value { .. } => PyValueError::new_err(error.to_string()),
        Error::Scene(message) => SceneError::new_err(message),
        Error::Format(message) => FormatError::new_err(message),
        Error::Device(message) => DeviceError::new_err(message),
        Error::Memory { .. } => PyMemoryError::new_err(error.to_string()),
        Error::Cancelled => PyKeyboardInterrupt::new_err(()),
    }
}

/// Converts a panic to a `RuntimeError` that asks for a report, because every panic is a bug in nearfar.
pub fn from_panic(payload: &(dyn Any + Send)) -> PyErr {
    let text = payload
        .downcast_ref::<&str>()
        .map(ToString::to_string)
        .or_else(|| payload.downcast_ref::<String>().cloned())
        .unwrap_or_else(|| "no message".to_string());
    PyRuntimeError::new_err(format!("internal error in nearfar, please report it: {text}"))
}

pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = module.py();
    module.add("Error", py.get_type::<NearfarError>())?;
    module.add("SceneError", py.get_type::<SceneError>())?;
    module.add("FormatError", py.get_type::<FormatError>())?;
    module.add("DeviceError", py.get_type::<DeviceError>())
}
