//! The error type of all kernels. The bindings map each kind to the Python exception named in its comment.

/// An error of a kernel. Its message is one sentence without a full stop.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    /// An argument's value lies outside its domain (`ValueError`).
    #[error("{argument}: expected {expected}, got {got}")]
    Value {
        /// The argument's public name.
        argument: &'static str,
        /// Description of the accepted values.
        expected: String,
        /// The refused value.
        got: String,
    },
    /// The contents of a scene are unusable (`nearfar.SceneError`).
    #[error("{0}")]
    Scene(String),
    /// A file in one of nearfar's own formats is malformed (`nearfar.FormatError`).
    #[error("{0}")]
    Format(String),
    /// A graphics adapter is missing, was lost or refused a request (`nearfar.DeviceError`).
    #[error("{0}")]
    Device(String),
    /// The system has not enough memory for a result (`MemoryError`).
    #[error("the result needs {bytes} bytes, which the system does not have")]
    Memory {
        /// Number of bytes requested.
        bytes: u64,
    },
    /// The caller cancelled a long kernel (the exception of the pending signal, usually `KeyboardInterrupt`).
    #[error("cancelled")]
    Cancelled,
}

impl Error {
    /// Creates the error for an argument outside its domain.
    pub fn value(argument: &'static str, expected: impl Into<String>, got: impl ToString) -> Self {
        Self::Value { argument, expected: expected.into(), got: got.to_string() }
    }
}

/// Returns `Error::value(argument, expected, got)` from the calling function unless a condition holds.
macro_rules! ensure {
    ($holds:expr, $argument:expr, $expected:expr, $got:expr $(,)?) => {
        if $holds {
        } else {
            return Err($crate::base::Error::value($argument, $expected, $got));
        }
    };
}

pub(crate) use ensure;

/// Formats a number for a message; uses an exponent where plain digits would contain a long row of zeros.
pub fn number(value: f64) -> String {
    let size = value.abs();
    let plain = size == 0.0 || (1e-4..1e16).contains(&size) || !size.is_finite();
    if plain { value.to_string() } else { format!("{value:e}") }
}

/// Result type of kernels.
pub type Result<T, E = Error> = std::result::Result<T, E>;

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn messages_have_no_rows_of_zeros() {
        let values = [0.0, -0.0, 0.1, -1.5, 1e-4, 9.9e-5, -1e-310, 9_999_999_999_999_998.0, 1e16, -f64::MAX];
        let expected = "0 -0 0.1 -1.5 0.0001 9.9e-5 -1e-310 9999999999999998 1e16 -1.7976931348623157e308";
        assert_eq!(values.map(number).join(" "), expected);
        assert_eq!([f64::NAN, f64::INFINITY, f64::NEG_INFINITY].map(number), ["NaN", "inf", "-inf"]);
    }

    #[test]
    fn numbers_in_messages_are_parsed_back_unchanged() {
        for value in [1.0 / 3.0, f64::MIN_POSITIVE / 3.0, 2f64.powi(60) + 1024.0, -1e-4 / 3.0] {
            assert_eq!(number(value).parse(), Ok(value));
        }
    }
}
