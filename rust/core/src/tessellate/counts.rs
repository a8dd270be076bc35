//! Numbers of triangles before and after splitting.

/// Numbers of triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SplitCounts {
    /// Triangles of the source.
    pub before: u64,
    /// Triangles of the result.
    pub after: u64,
    /// Triangles of the source that were examined; the others lie within r₁ or beyond r₂, or move.
    pub examined: u64,
    /// Triangles of the source that were split.
    pub split: u64,
}
