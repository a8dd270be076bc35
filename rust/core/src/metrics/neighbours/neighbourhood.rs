//! Neighbourhoods of pixels in the truth.

/// Radius within which pixels are neighbours, and the resolution of the truth.
#[derive(Clone, Copy, Debug)]
pub struct Neighbourhood {
    /// ε: pixels of the truth within which points are neighbours.
    pub epsilon: f64,
    /// Distances in the truth below this, its resolution, are raised to it. Pixels.
    pub least: f64,
}
