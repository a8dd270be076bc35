//! Neighbourhoods of pixels in the truth.

/// Which pixels are compared.
#[derive(Clone, Copy, Debug)]
pub struct Neighbourhood {
    /// ε: pixels of the truth within which points are neighbours.
    pub epsilon: f64,
    /// Distances in the truth below this, its resolution, are raised to it. Pixels.
    pub least: f64,
}
