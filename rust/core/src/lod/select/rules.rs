//! Rules by which levels are chosen, and how lenses and eyes change them.

use glam::DVec3;

use crate::lens::RadialLens;

/// SSIM threshold that is linear in the solid angle: f(σ) = level + rise · σ.
#[derive(Clone, Copy, Debug)]
pub struct ThresholdLine {
    /// f at σ = 0.
    pub level: f64,
    /// Slope, for each steradian.
    pub rise: f64,
}

/// SSIM threshold as a function of solid angle, and its limits.
#[derive(Clone, Copy, Debug)]
pub struct Rules {
    /// SSIM threshold f(σ).
    pub line: ThresholdLine,
    /// Solid angle in steradians above which level 0 is used.
    pub reference: f64,
    /// True where objects out of view get no level.
    pub cull: bool,
    /// Score above the threshold that a level needs to replace a finer one.
    pub hysteresis: f64,
    /// Share of the way between levels over which they are blended; 0 for not at all.
    pub fade: f64,
}

/// A lens between an eye and its screen.
#[derive(Clone, Copy, Debug)]
pub struct EyeLens<'a> {
    /// The lens.
    pub lens: &'a RadialLens,
    /// Tangent of half the horizontal field of view, the larger side of it.
    pub tan_omega: f64,
    /// True for Newton's inverse, else the table's.
    pub exact: bool,
}

/// Acuity of an eye: the least visible angle at e degrees from its gaze is slope · e + limit (Guenter et al. 2012,
/// Eq. 1).
#[derive(Clone, Copy, Debug)]
pub struct Acuity {
    /// Viewing direction in the world, of length 1.
    pub gaze: DVec3,
    /// Degrees of the least angle for each degree of eccentricity.
    pub slope: f64,
    /// Least angle at the gaze, degrees.
    pub limit: f64,
    /// Angle of a pixel in degrees, at least `limit`: nothing finer is drawn.
    pub best: f64,
}

impl ThresholdLine {
    pub(super) fn at(&self, sigma: f64) -> f64 {
        self.level + self.rise * sigma
    }
}
