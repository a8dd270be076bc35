//! The morph of one point.

use glam::{DVec2, DVec3};

use crate::base::{Error, Result};

/// Rule for the distance at which a point is shown along its morphed direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// At the blend of its distances from the user and from the centre (2022).
    Blend,
    /// Where that direction leaves the vertical cylinder on which the point lies (CloVR).
    Cylinder,
}

/// A morph for one position of the user.
#[derive(Clone, Copy, Debug)]
pub struct Morph {
    /// The user's eye U.
    pub user: DVec3,
    /// The centre O, on the axis of both cylinders.
    pub center: DVec3,
    /// Points with ρ ≤ r₁ stay (CloVR: Rₙ).
    pub r1: f64,
    /// Points with ρ ≥ r₂ are shown in the direction that the centre sees them in (CloVR: R).
    pub r2: f64,
    /// Rule for the distance along the direction.
    pub kind: Kind,
    /// U − O.
    pub(super) offset: DVec3,
}

/// Morphed position of a point, with the weight that led to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Morphed {
    /// The point Q that is shown.
    pub point: DVec3,
    /// Weight w of the user's view: 1 inside r₁, 0 beyond r₂.
    pub weight: f64,
    /// User and centre see the point in opposite directions, so that their blend has none: the user's was taken.
    /// It happens only where the user has left the near cylinder.
    pub opposed: bool,
}

/// A blend of two unit vectors below this length has fewer than four digits left.
const OPPOSED: f64 = 1e-12;

impl Morph {
    /// Checks 0 ≤ r₁ < r₂ and that everything is finite. `Kind::Cylinder` also takes r₁ = r₂ = 0: w is 0 everywhere.
    pub fn new(user: DVec3, center: DVec3, r1: f64, r2: f64, kind: Kind) -> Result<Self> {
        for (argument, value) in [("user", user), ("center", center)] {
            if !value.is_finite() {
                return Err(Error::value(argument, "three finite numbers", value));
            }
        }
        if !(r1.is_finite() && r1 >= 0.0) {
            return Err(Error::value("r1", "a finite radius of at least 0", r1));
        }
        let nothing_is_near = kind == Kind::Cylinder && r1 == 0.0 && r2 == 0.0;
        if !(r2.is_finite() && r2 > r1 || nothing_is_near) {
            return Err(Error::value("r2", format!("a finite radius greater than r1 = {r1}"), r2));
        }
        Ok(Self { user, center, r1, r2, kind, offset: user - center })
    }

    /// Morphed position Q of a point.
    pub fn apply(&self, point: DVec3) -> DVec3 {
        self.examine(point).point
    }

    /// The weight w of the user's view at distance ρ from the axis.
    #[inline]
    pub fn weight(&self, rho: f64) -> f64 {
        if self.r2 == 0.0 {
            return 0.0;
        }
        ((self.r2 - rho) / (self.r2 - self.r1)).clamp(0.0, 1.0)
    }

    /// Morphed position of a point, with its weight and whether its directions were opposed.
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
        // Eq. 2: the distance at which the point is shown.
        let blended = weight * from_user.length() + (1.0 - weight) * from_center.length();
        let distance = match self.kind {
            Kind::Blend => blended,
            Kind::Cylinder => leave_cylinder(self.offset, direction, rho).unwrap_or(blended),
        };
        Morphed { point: self.center + (self.offset + distance * direction), weight, opposed }
    }

    /// Distance along a unit direction at which the user is shown what the centre sees in that direction, at this
    /// distance from it and beyond r₂ (w = 0).
    pub fn far_distance(&self, direction: DVec3, from_center: f64) -> f64 {
        if self.kind == Kind::Blend || !from_center.is_finite() {
            return from_center;
        }
        let rho = from_center * DVec2::new(direction.x, direction.z).length();
        leave_cylinder(self.offset, direction, rho).unwrap_or(from_center)
    }
}

/// Eq. 1: the direction of w d_U + (1−w) d_O. A point at the eye itself has none from there and takes the centre's.
fn blended_direction(from_user: DVec3, from_center: DVec3, weight: f64) -> (DVec3, bool) {
    let (seen_by_user, seen_by_center) = (from_user.normalize_or_zero(), from_center.normalize_or_zero());
    let blend = weight * seen_by_user + (1.0 - weight) * seen_by_center;
    let length = blend.length();
    if length > OPPOSED {
        return (blend / length, false);
    }
    (seen_by_user, seen_by_user != DVec3::ZERO)
}

/// Distance from `start` (relative to the axis) along a unit direction to where it leaves the cylinder of radius ρ;
/// none where it starts outside or never leaves. The larger root of a t² + 2 b t + c in the form that does not cancel.
fn leave_cylinder(start: DVec3, direction: DVec3, rho: f64) -> Option<f64> {
    let (start, direction) = (DVec2::new(start.x, start.z), DVec2::new(direction.x, direction.z));
    let start_rho = start.length();
    if rho <= start_rho || direction == DVec2::ZERO {
        return None;
    }
    let a = direction.length_squared();
    let b = direction.dot(start);
    let c = (start_rho - rho) * (start_rho + rho);
    // c < 0 inside the cylinder, so that the discriminant is not negative.
    let q = (b * b - a * c).sqrt();
    Some(if b > 0.0 { -c / (b + q) } else { (q - b) / a })
}
