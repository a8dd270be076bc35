//! Rules for the selection of levels, and the influence of lenses and eyes.

use glam::DVec3;

use crate::lens::RadialLens;

/// SSIM threshold as a linear function of the solid angle: f(σ) = level + rise · σ.
#[derive(Clone, Copy, Debug)]
pub struct ThresholdLine {
    /// f at σ = 0.
    pub level: f64,
    /// Slope of f per steradian.
    pub rise: f64,
}

/// Size that must not exceed the reference for a level other than 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SizeLimit {
    /// Undistorted size σ.
    Own,
    /// Displayed size σ′.
    Seen,
}

/// SSIM threshold as a function of solid angle, and its limits.
#[derive(Clone, Copy, Debug)]
pub struct Rules {
    /// SSIM threshold f(σ).
    pub line: ThresholdLine,
    /// Solid angle in steradians above which level 0 is used.
    pub reference: f64,
    /// Size that the reference limits.
    pub limit: SizeLimit,
    /// Whether objects outside the view get no level.
    pub cull: bool,
    /// Score above the threshold that a coarser level needs to replace a finer one.
    pub hysteresis: f64,
    /// Fraction of the distance between levels over which they are blended; 0 disables blending.
    pub fade: f64,
}

/// A lens between an eye and its screen.
#[derive(Clone, Copy, Debug)]
pub struct EyeLens<'a> {
    /// The lens.
    pub lens: &'a RadialLens,
    /// Tangent of half the horizontal field of view; the larger of its two sides.
    pub tan_omega: f64,
    /// Whether to invert the lens by Newton's method instead of the table.
    pub exact: bool,
}

/// Relation between σ and the displayed size.
#[derive(Clone, Copy, Debug)]
pub enum Apparent<'a> {
    /// σ itself.
    Own,
    /// Through a lens along one axis, as published: σ (α⁺ − α⁻)/2μ (Liebisch 2021, Eq. 4.10–4.12).
    Axis(EyeLens<'a>),
    /// Through a lens along both axes: the above times sin α′/sin α of the centre.
    Area(EyeLens<'a>),
    /// Pixels of the panel, behind a lens if there is one: σ·D(α) of the centre.
    Panel(Option<EyeLens<'a>>),
}

/// Acuity of an eye: the smallest visible angle at eccentricity e, both in degrees, is slope · e + limit (Guenter et
/// al. 2012, Eq. 1).
#[derive(Clone, Copy, Debug)]
pub struct Acuity {
    /// Unit viewing direction in the world.
    pub gaze: DVec3,
    /// Increase of the smallest visible angle per degree of eccentricity, degrees.
    pub slope: f64,
    /// Smallest visible angle at the gaze, degrees.
    pub limit: f64,
    /// Angle of a pixel in degrees, at least `limit`: the display shows nothing finer.
    pub best: f64,
}

impl ThresholdLine {
    pub(crate) fn value(&self, sigma: f64) -> f64 {
        self.level + self.rise * sigma
    }
}
