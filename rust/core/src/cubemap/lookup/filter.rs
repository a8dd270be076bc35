//! Texture filters of cube maps.

/// Rule that combines the texels around a direction to one value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TexelFilter {
    /// Seamless bilinear.
    Linear,
    /// Seamless bicubic.
    Cubic,
    /// Minimum of the texels that `Linear` would mix.
    Min,
    /// Maximum of the texels that `Linear` would mix.
    Max,
}

impl TexelFilter {
    /// Returns the number of texels that the filter reads before and after the texel above and to the left of a
    /// direction.
    pub(in crate::cubemap) fn reach(self) -> [u32; 2] {
        if self == Self::Cubic { [1, 2] } else { [0, 1] }
    }
}
