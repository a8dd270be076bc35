//! Morphs and users for which surfaces are split.

use glam::{DVec2, DVec3};

use crate::base::{Result, ensure};
use crate::morph::{Kind, Morph};

/// Fractions of r₁ within which a user's error has a bound: 0.6 for a blend and 0.5 for a cylinder, reduced because
/// triangles may pass r₁.
const MAX_BLEND_REACH: f64 = 0.59;
const MAX_CYLINDER_REACH: f64 = 0.498;

/// Reach and tolerance in steps of √2, so that one split serves all users at similar distances from the centre.
pub type Steps = [i32; 2];

/// Cylinders and region of users for which surfaces are split.
#[derive(Clone, Copy, Debug, Default)]
pub struct Settings {
    /// The centre O, in the frame of the points.
    pub center: DVec3,
    /// r₁, metres: at full strength points inside do not move.
    pub r1: f64,
    /// r₂, metres: for points outside, the weight w of the user's view is 0.
    pub r2: f64,
    /// Radius up to which surfaces are drawn, metres; at least r₂.
    pub drawn: f64,
    /// Maximum distance of a user from the centre, metres.
    pub reach: f64,
    /// Maximum error in radians as the user sees it.
    pub tolerance: f64,
    /// Morphs whose error is within the tolerance.
    pub served: ServedMorphs,
}

/// Morphs that one split serves: their kind, and the radii and strengths that they take while they grow.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ServedMorphs {
    /// `Kind::Blend` with these radii and full strength.
    #[default]
    Blend,
    /// `Kind::Cylinder` while it grows.
    Cylinder {
        /// Minimum outer radius, metres. The split serves all outer radii from it to r₂, with r₁ in proportion.
        least: f64,
        /// Whether it serves only full strength; otherwise all strengths.
        is_full: bool,
    },
}

/// Returns the radius from which a morph bends triangles: r₁, or 0 if points within r₁ move too.
pub fn bent_from(morph: &Morph) -> f64 {
    if morph.strength < 1.0 { 0.0 } else { morph.r1 }
}

impl Settings {
    /// Creates settings for one morph. A blend below full strength bends triangles from the axis on, but w still falls
    /// only between r₁ and r₂, so the tolerance is reduced in proportion.
    pub fn from_morph(morph: &Morph, drawn: f64, reach: f64, tolerance: f64) -> Self {
        let Morph { center, r1, r2, strength, .. } = *morph;
        match morph.kind {
            Kind::Cylinder => {
                let served = ServedMorphs::Cylinder { least: r2, is_full: strength == 1.0 };
                Self { center, r1, r2, drawn, reach, tolerance, served }
            }
            Kind::Blend => {
                let from = bent_from(morph);
                let fraction = if r2 > from { (r2 - r1) / (r2 - from) } else { 1.0 };
                Self {
                    center,
                    r1: from,
                    r2,
                    drawn,
                    reach,
                    tolerance: tolerance * fraction,
                    served: ServedMorphs::Blend,
                }
            }
        }
    }

    pub(super) fn check(&self) -> Result<()> {
        let Self { center, r1, r2, reach, tolerance, .. } = *self;
        ensure!(center.is_finite(), "center", "three finite numbers", center);
        ensure!(r1.is_finite() && r1 >= 0.0, "r1", "a finite radius of at least 0", r1);
        ensure!(r2.is_finite() && r2 >= r1, "r2", format!("a finite radius of at least r1 = {r1}"), r2);
        ensure!(reach.is_finite() && reach >= 0.0, "user_region", "a finite distance from the centre", reach);
        ensure!(tolerance.is_finite() && tolerance > 0.0, "tolerance_px", "a number above 0", tolerance);
        if let ServedMorphs::Cylinder { least, .. } = self.served {
            let is_radius = least <= r2 && (least > 0.0 || r2 == 0.0);
            ensure!(is_radius, "radius", format!("a radius above 0 and up to r2 = {r2}"), least);
        }
        Ok(())
    }

    pub(super) fn on_ground(&self, p: DVec3) -> DVec2 {
        DVec2::new(p.x - self.center.x, p.z - self.center.z)
    }

    /// Rounds the reach up and the tolerance down to the next step; returns both steps and the rounded settings. If the
    /// reach has a bound, so has the rounded reach.
    pub fn stepped(self) -> (Steps, Self) {
        let Self { r1, drawn, reach, tolerance, .. } = self;
        let unit = r1.max(drawn / 16.0);
        let outwards = (2.0 * (reach / unit).log2()).ceil().clamp(-40.0, 40.0);
        let finer = (2.0 * tolerance.log2()).floor().clamp(-80.0, 80.0);
        let farther = unit * (outwards / 2.0).exp2();
        let max_fraction = if self.served == ServedMorphs::Blend { MAX_BLEND_REACH } else { MAX_CYLINDER_REACH };
        let max_reach = max_fraction * r1;
        let reach = if reach <= max_reach { farther.min(max_reach) } else { farther.max(reach) };
        let tolerance = (finer / 2.0).exp2().min(tolerance);
        ([outwards as i32, finer as i32], Self { reach, tolerance, ..self })
    }

    /// Returns the metres by which a vertex placed on a radius may miss it.
    pub(super) fn rounding(&self, precision: Precision) -> f64 {
        (self.center.abs().max_element() + self.r2) * precision.step() * 2.0
    }
}

/// Floating-point type to which the coordinates of new vertices are rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// float32.
    Single,
    /// float64.
    Double,
}

impl Precision {
    /// Rounds a point to this type.
    pub fn round(self, p: DVec3) -> DVec3 {
        match self {
            Self::Single => p.as_vec3().as_dvec3(),
            Self::Double => p,
        }
    }

    fn step(self) -> f64 {
        match self {
            Self::Single => f64::from(f32::EPSILON),
            Self::Double => f64::EPSILON,
        }
    }
}
