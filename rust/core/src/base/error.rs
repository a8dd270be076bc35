//! The one error type of the kernels. The bindings map each kind to the Python exception named beside it.

/// Errors of kernels, each a sentence without a full stop.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    /// An argument's value is out of its domain (`ValueError`).
    #[error("{argument}: expected {expected}, got {got}")]
    Value {
        /// The argument's public name.
        argument: &'static str,
        /// Values that would have been accepted.
        expected: String,
        /// Value that came.
        got: String,
    },
    /// A scene's own contents are unusable (`nearfar.SceneError`).
    #[error("{0}")]
    Scene(String),
    /// One of our own files is not what it should be (`nearfar.FormatError`).
    #[error("{0}")]
    Format(String),
    /// A graphics adapter that is missing, was lost or refused something (`nearfar.DeviceError`).
    #[error("{0}")]
    Device(String),
    /// A result that the system has no memory for (`MemoryError`).
    #[error("the result needs {bytes} bytes, which the system does not have")]
    Memory {
        /// Bytes that were asked for.
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

/// A number for a message: with an exponent where digits alone would make a row of zeros.
pub fn number(value: f64) -> String {
    let size = value.abs();
    let plain = size == 0.0 || (1e-4..1e16).contains(&size) || !size.is_finite();
    if plain { value.to_string() } else { format!("{value:e}") }
}

/// Result of a kernel.
pub type Result<T, E = Error> = std::result::Result<T, E>;

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn messages_have_no_rows_of_zeros() {
        let shown = [0.0, -0.0, 0.1, -1.5, 1e-4, 9.9e-5, -1e-310, 9_999_999_999_999_998.0, 1e16, -f64::MAX];
        let words = [
            "0",
            "-0",
            "0.1",
            "-1.5",
            "0.0001",
            "9.9e-5",
            "-1e-310",
            "9999999999999998",
            "1e16",
            "-1.7976931348623157e308",
        ];
        assert_eq!(shown.map(number), words);
        assert_eq!([f64::NAN, f64::INFINITY, f64::NEG_INFINITY].map(number), ["NaN", "inf", "-inf"]);
    }

    #[test]
    fn numbers_in_messages_read_back_as_they_were() {
        for value in [1.0 / 3.0, f64::MIN_POSITIVE / 3.0, 2f64.powi(60) + 1024.0, -1e-4 / 3.0] {
            assert_eq!(number(value).parse(), Ok(value));
        }
    }
}
