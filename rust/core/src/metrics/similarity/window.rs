//! Windows, and the constants of the measure.

/// Weights of the pixels around each pixel.
#[derive(Clone, Debug, PartialEq)]
pub enum Window {
    /// Symmetric separable weights that sum to 1; an even number extends one pixel further up and left.
    Weights(Vec<f64>),
    /// The whole image at once.
    Global,
}

impl Window {
    /// Creates a Gaussian of σ pixels, truncated to `size` pixels.
    pub fn gaussian(size: usize, sigma: f64) -> Self {
        let middle = (size as f64 - 1.0) / 2.0;
        let nearest = if size.is_multiple_of(2) { 0.25 } else { 0.0 };
        // Subtracting the smallest exponent keeps at least one weight, however narrow the Gaussian is.
        let weight = |i: usize| match (i as f64 - middle).powi(2) - nearest {
            0.0 => 1.0,
            farther => (-0.5 * farther / sigma / sigma).exp(),
        };
        let weights: Vec<f64> = (0..size).map(weight).collect();
        let sum: f64 = weights.iter().sum();
        Self::Weights(weights.into_iter().map(|weight| weight / sum).collect())
    }

    /// Creates `size` equal weights.
    pub fn uniform(size: usize) -> Self {
        Self::Weights(vec![1.0 / size as f64; size])
    }
}

/// Constants of the measure, (k₁ L)² and (k₂ L)², which keep it defined if means or variances vanish.
#[derive(Clone, Copy, Debug)]
pub struct Similarity {
    /// Constant of the means.
    pub c1: f64,
    /// Constant of the variances.
    pub c2: f64,
}
