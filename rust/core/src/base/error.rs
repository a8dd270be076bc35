//! The one error type of the kernels. The bindings map each kind to the Python exception named beside it.

/// What a kernel refuses, and why, as a sentence without a full stop.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    /// An argument's value is out of its domain (`ValueError`).
    #[error("{argument}: expected {expected}, got {got}")]
    Value {
        /// The argument's public name.
        argument: &'static str,
        /// What would have been accepted.
        expected: String,
        /// What came.
        got: String,
    },
    /// A scene's own contents are unusable (`nearfar.SceneError`).
    #[error("{0}")]
    Scene(String),
    /// One of our own files is not what it should be (`nearfar.FormatError`).
    #[error("{0}")]
    Format(String),
    /// A result that the system has no memory for (`MemoryError`).
    #[error("the result needs {bytes} bytes, which the system does not have")]
    Memory {
        /// What was asked for.
        bytes: u64,
    },
    /// The caller asked a long kernel to stop (the pending signal's own exception, as a rule `KeyboardInterrupt`).
    #[error("cancelled")]
    Cancelled,
}

impl Error {
    /// An argument out of its domain.
    pub fn value(argument: &'static str, expected: impl Into<String>, got: impl ToString) -> Self {
        Self::Value { argument, expected: expected.into(), got: got.to_string() }
    }
}

/// Result of a kernel.
pub type Result<T, E = Error> = std::result::Result<T, E>;
