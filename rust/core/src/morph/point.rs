//! Morph of a single point.

use glam::{DVec2, DVec3};

use crate::base::{Result, ensure};

/// Rule for the distance at which a point is shown along its morphed direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Blend of its distances from the user and from the centre (2022).
    Blend,
    /// Distance at which the direction leaves the vertical cylinder through the point (CloVR).
    Cylinder,
}

/// The morph for one user position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Morph {
    /// The user's eye U.
    pub user: DVec3,
    /// The centre O, on the axis of both cylinders.
    pub center: DVec3,
    /// r₁: points with ρ ≤ r₁ are not moved (CloVR: Rₙ).
    pub r1: f64,
    /// r₂: points with ρ ≥ r₂ are shown in the direction in which the centre sees them (CloVR: R).
    pub r2: f64,
    /// Rule for the distance along the direction.
    pub kind: Kind,
    /// s: factor of the weight of the user's view. Below 1, points within r₁ move, too.
    pub strength: f64,
    /// U − O.
    pub(super) offset: DVec3,
}

/// Morphed position of a point, and the weight used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Morphed {
    /// The position Q at which the point is shown.
    pub point: DVec3,
    /// Weight w of the user's view: the strength inside r₁, 0 beyond r₂.
    pub weight: f64,
    /// Whether user and centre see the point in opposite directions. The blend then has no direction, and the user's is
    /// used. This happens only to users outside the near cylinder, and between U and O at a strength of ½.
    pub opposed: bool,
}

/// Minimum length of a usable blend of two unit vectors; shorter blends have fewer than four correct digits.
const MIN_BLEND_LENGTH: f64 = 1e-12;

impl Morph {
    /// Checks 0 ≤ r₁ < r₂ and that all numbers are finite. r₁ = r₂ = 0 means w = 0 everywhere.
    pub fn new(user: DVec3, center: DVec3, r1: f64, r2: f64, kind: Kind) -> Result<Self> {
        for (argument, value) in [("user", user), ("center", center)] {
            ensure!(value.is_finite(), argument, "three finite numbers", value);
        }
        ensure!(r1.is_finite() && r1 >= 0.0, "r1", "a finite radius of at least 0", r1);
        let nothing_is_near = r1 == 0.0 && r2 == 0.0;
        let is_valid = r2.is_finite() && r2 > r1 || nothing_is_near;
        ensure!(is_valid, "r2", format!("a finite radius greater than r1 = {r1}"), r2);
        Ok(Self { user, center, r1, r2, kind, strength: 1.0, offset: user - center })
    }

    /// Returns the morph with another strength, 0 to 1. At 0, nothing is near: w = 0 everywhere.
    pub fn with_strength(self, strength: f64) -> Result<Self> {
        ensure!((0.0..=1.0).contains(&strength), "strength", "a number from 0 to 1", strength);
        let [r1, r2] = if strength == 0.0 { [0.0; 2] } else { [self.r1, self.r2] };
        Ok(Self { strength, r1, r2, ..self })
    }

    /// Returns the morphed position Q of a point.
    pub fn apply(&self, point: DVec3) -> DVec3 {
        self.examine(point).point
    }

    /// Returns the weight w of the user's view at distance ρ from the axis.
    #[inline]
    pub fn weight(&self, rho: f64) -> f64 {
        if self.r2 == 0.0 {
            return 0.0;
        }
        self.strength * ((self.r2 - rho) / (self.r2 - self.r1)).clamp(0.0, 1.0)
    }

    /// Returns the morphed position of a point, its weight, and whether its directions were opposed.
    pub fn examine(&self, point: DVec3) -> Morphed {
        let from_center = point - self.center;
        let rho = DVec2::new(from_center.x, from_center.z).length();
        let weight = self.weight(rho);
        if weight == 1.0 || self.offset == DVec3::ZERO {
            return Morphed { point, weight, opposed: false };
        }
        if weight == 0.0 && self.kind == Kind::Blend {
            return Morphed { point: point + self.offset, weight, opposed: false };
        }
        let from_user = from_center - self.offset;
        let (direction, opposed) = blended_direction(from_user, from_center, weight);
        // Eq. 2: the blended distance.
        let blended = weight * from_user.length() + (1.0 - weight) * from_center.length();
        let distance = match self.kind {
            Kind::Blend => blended,
            Kind::Cylinder => leave_cylinder(self.offset, direction, rho).unwrap_or(blended),
        };
        Morphed { point: self.center + (self.offset + distance * direction), weight, opposed }
    }

    /// Returns the distance from the user, along a unit direction, at which a point beyond r₂ (w = 0) is shown. The
    /// centre sees the point in the same direction at distance `from_center`.
    pub fn far_distance(&self, direction: DVec3, from_center: f64) -> f64 {
        if self.kind == Kind::Blend || !from_center.is_finite() {
            return from_center;
        }
        let rho = from_center * DVec2::new(direction.x, direction.z).length();
        leave_cylinder(self.offset, direction, rho).unwrap_or(from_center)
    }
}

/// Returns the direction of w d_U + (1−w) d_O (Eq. 1), and whether d_U and d_O are opposed. For a point at the user's
/// eye, d_U is undefined and d_O is used.
fn blended_direction(from_user: DVec3, from_center: DVec3, weight: f64) -> (DVec3, bool) {
    let (seen_by_user, seen_by_center) = (from_user.normalize_or_zero(), from_center.normalize_or_zero());
    let blend = weight * seen_by_user + (1.0 - weight) * seen_by_center;
    let length = blend.length();
    if length > MIN_BLEND_LENGTH {
        return (blend / length, false);
    }
    (seen_by_user, seen_by_user != DVec3::ZERO)
}

/// Returns the distance from `start` (relative to the axis) along a unit direction to the exit from the cylinder of
/// radius ρ; `None` if the start lies outside or the direction is vertical. It is the larger root of a t² + 2 b t + c,
/// computed without cancellation.
fn leave_cylinder(start: DVec3, direction: DVec3, rho: f64) -> Option<f64> {
    let (start, direction) = (DVec2::new(start.x, start.z), DVec2::new(direction.x, direction.z));
    let start_rho = start.length();
    if rho <= start_rho || direction == DVec2::ZERO {
        return None;
    }
    let a = direction.length_squared();
    let b = direction.dot(start);
    let c = (start_rho - rho) * (start_rho + rho);
    // Inside the cylinder c < 0, so the discriminant is not negative.
    let q = (b * b - a * c).sqrt();
    Some(if b > 0.0 { -c / (b + q) } else { (q - b) / a })
}
