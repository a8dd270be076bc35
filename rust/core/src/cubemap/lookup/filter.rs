//! How texels around a direction become one value.

/// How texels around a direction become one value.
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
    /// How many texels it reaches before and after the one above and to the left of a direction.
    pub(in crate::cubemap) fn reach(self) -> [u32; 2] {
        if self == Self::Cubic { [1, 2] } else { [0, 1] }
    }
}
