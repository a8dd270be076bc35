//! Operations that every instruction set provides.

/// An instruction set. A value of this type proves that the processor supports it.
pub(crate) trait Isa: Copy {
    /// Lanes for one ray and the triangles of a block.
    type Four: Lanes<Self>;
    /// Lanes for one ray and the children of a node.
    type Eight: Lanes<Self>;
    /// Lanes for a group of rays and one box or triangle.
    type Group: Lanes<Self>;
}

/// A vector of `N` float32 numbers. Comparison masks are integers whose lowest bit is the first lane.
pub(crate) trait Lanes<I>: Copy {
    const N: usize;
    /// Returns a vector with the same number in all lanes.
    fn splat(isa: I, x: f32) -> Self;
    /// Loads the first `N` numbers of a slice.
    fn load(isa: I, from: &[f32]) -> Self;
    /// Stores to the first `N` numbers of a slice.
    fn store(self, to: &mut [f32]);
    fn add(self, other: Self) -> Self;
    fn sub(self, other: Self) -> Self;
    fn mul(self, other: Self) -> Self;
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
    /// Returns the lanes of `self` where the mask is set, otherwise those of `other`.
    fn select(self, mask: u32, other: Self) -> Self;
    fn abs(self) -> Self;
}
