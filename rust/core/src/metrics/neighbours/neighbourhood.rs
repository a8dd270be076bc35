//! Neighbourhoods of pixels in the truth.

/// Neighbourhood radius, and the resolution of the truth.
#[derive(Clone, Copy, Debug)]
pub struct Neighbourhood {
    /// ε: distance in the truth within which points are neighbours, pixels.
    pub epsilon: f64,
    /// Resolution of the truth: smaller distances are raised to it, pixels.
    pub least: f64,
}
