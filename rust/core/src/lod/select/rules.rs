//! Rules for the selection of levels, and effects of lenses and eyes on sizes.

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

/// Size that is compared with `Rules::reference`.
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
    /// Size that is compared with the reference.
    pub limit: SizeLimit,
    /// Whether objects outside the view get no level.
    pub cull: bool,
    /// Margin by which a coarser level's score must exceed the threshold to replace a finer level.
    pub hysteresis: f64,
    /// Fraction of the interval between two levels' scores over which they are blended; 0 disables blending.
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

/// Rule for the displayed size σ′.
#[derive(Clone, Copy, Debug)]
pub enum Apparent<'a> {
    /// σ
    Own,
    /// σ (α⁺ − α⁻)/2μ, which applies the lens along one axis, as published (Liebisch 2021, Eq. 4.10–4.12).
    Axis(EyeLens<'a>),
    /// The size of `Axis` times sin α′/sin α of the centre, which applies the lens along both axes.
    Area(EyeLens<'a>),
    /// σ·D(α) of the centre, proportional to pixels of the panel, behind a lens if there is one.
    Panel(Option<EyeLens<'a>>),
}

/// Acuity: the smallest visible angle at eccentricity e is slope · e + limit, in degrees (Guenter et al. 2012, Eq. 1).
#[derive(Clone, Copy, Debug)]
pub struct Acuity {
    /// Unit viewing direction in the world.
    pub gaze: DVec3,
    /// Increase of the smallest visible angle, in degrees, per degree of eccentricity.
    pub slope: f64,
    /// Smallest visible angle at the gaze, degrees.
    pub limit: f64,
    /// Smallest angle that the display shows: that of a pixel in degrees, at least `limit`.
    pub best: f64,
}

impl ThresholdLine {
    pub(crate) fn value(&self, sigma: f64) -> f64 {
        self.level + self.rise * sigma
    }
}
