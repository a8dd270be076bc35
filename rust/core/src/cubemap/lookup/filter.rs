//! Texture filters.

/// Filter that makes one value of the texels around a direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TexelFilter {
    /// Seamless bilinear.
    Linear,
    /// Seamless bicubic.
    Cubic,
    /// The least of the texels that `Linear` would mix.
    Min,
    /// The greatest of the texels that `Linear` would mix.
    Max,
}

impl TexelFilter {
    /// Texels that it reads before and after the one above and to the left of a direction.
    pub(in crate::cubemap) fn reach(self) -> [u32; 2] {
        if self == Self::Cubic { [1, 2] } else { [0, 1] }
    }
}
