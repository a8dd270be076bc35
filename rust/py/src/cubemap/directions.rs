//! Rows of directions in either precision, and filters by name.

use nearfar_core::base::{Error, Result};
use nearfar_core::cubemap::TexelFilter;

/// A filter by its public name.
pub(crate) fn filter(name: &str) -> Result<TexelFilter> {
    match name {
        "linear" => Ok(TexelFilter::Linear),
        "cubic" => Ok(TexelFilter::Cubic),
        "min" => Ok(TexelFilter::Min),
        "max" => Ok(TexelFilter::Max),
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
