//! Operations that every instruction set has.

/// An instruction set. A value of this type proves that the processor has it.
pub(crate) trait Isa: Copy {
    /// One ray against the triangles of a block.
    type Four: Lanes<Self>;
    /// One ray against the children of a node.
    type Eight: Lanes<Self>;
    /// A group of rays against one box or triangle.
    type Group: Lanes<Self>;
}

/// `N` float32. Masks are bits, the lowest for the first lane.
pub(crate) trait Lanes<I>: Copy {
    /// Number of lanes.
    const N: usize;
    /// The same number in all lanes.
    fn splat(isa: I, x: f32) -> Self;
    /// The first `N` of a slice.
    fn load(isa: I, from: &[f32]) -> Self;
    /// Writes to the first `N` of a slice.
    fn store(self, to: &mut [f32]);
    /// Sum.
    fn add(self, other: Self) -> Self;
    /// Difference.
    fn sub(self, other: Self) -> Self;
    /// Product.
    fn mul(self, other: Self) -> Self;
    /// Quotient.
    fn div(self, other: Self) -> Self;
    /// `self < other ? self : other`.
    fn min(self, other: Self) -> Self;
    /// `self > other ? self : other`.
    fn max(self, other: Self) -> Self;
    /// `self < other`; false for NaN.
    fn lt(self, other: Self) -> u32;
    /// `self <= other`; false for NaN.
    fn le(self, other: Self) -> u32;
    /// `self == other`; false for NaN.
    fn eq(self, other: Self) -> u32;
    /// Lanes of `self` where the mask is set, else of `other`.
    fn select(self, mask: u32, other: Self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
}
