//! Texture filters by their public names.

use nearfar_core::base::Result;
use nearfar_core::cubemap::TexelFilter;

use crate::convert::names::choice;

/// A filter by its public name.
pub(crate) fn filter(name: &str) -> Result<TexelFilter> {
    use TexelFilter::{Cubic, Linear, Max, Min};
    choice("filter", name, &[("linear", Linear), ("cubic", Cubic), ("min", Min), ("max", Max)])
}
