//! Rows of directions in either precision, and filters by name.

use nearfar_core::base::{Error, Result};
use nearfar_core::cubemap::Filter;

/// A filter by its public name.
pub(crate) fn filter(name: &str) -> Result<Filter> {
    match name {
        "linear" => Ok(Filter::Linear),
        "cubic" => Ok(Filter::Cubic),
        "min" => Ok(Filter::Min),
        "max" => Ok(Filter::Max),
        _ => Err(Error::value("filter", "'linear', 'cubic', 'min' or 'max'", format!("'{name}'"))),
    }
}

/// Calls a kernel with the rows of directions, whatever their type.
macro_rules! along {
    ($directions:expr, $rows:ident => $call:expr) => {
        match &$directions {
            Points::Single(array) => {
                let $rows = array.as_slice()?.as_chunks::<3>().0;
                $call
            }
            Points::Double(array) => {
                let $rows = array.as_slice()?.as_chunks::<3>().0;
                $call
            }
        }
    };
}

pub(crate) use along;
