//! Split positions of edges.

/// Position at which an edge is split.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    /// Fraction of the way along the edge.
    pub share: f64,
    /// Length of the edge in the rule's own measure: the longest edge of a triangle is split first.
    pub size: f64,
}
