//! Where edges are split.

/// Where an edge is split.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    /// Share of the way along the edge.
    pub share: f64,
    /// Length of the edge in a measure of its own: of a triangle's edges, the longest is split first.
    pub size: f64,
}
