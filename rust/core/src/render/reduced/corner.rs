//! Bent ray through one corner of a tile.

use glam::{Vec3, Vec4};

use crate::base::Aabb;
use crate::bend::{RayCurve, Stretch};

/// Maximum number of legs between the radii; rays that need more are bent one by one.
pub(super) const MAX_LEGS: usize = 128;
/// Minimum number of legs. All corners have these legs' bends, so that they can be compared.
pub(super) const MIN_LEGS: usize = 4;
/// Tolerance of the search for a bend's offset, relative to the maximum offset. The resulting error is about its
/// square, float32's resolution.
const OFFSET_PRECISION: f64 = 1e-4;

/// Bends of a ray between the radii, at equal steps along it. Each chord between two bends meets the tolerance.
pub(super) struct Corner {
    pub direction: Vec3,
    offset_direction: Vec3,
    first_distance: f32,
    distance_step: f32,
    /// Number of legs, a power of two.
    pub legs: usize,
    /// Offset of each bend across the ray, metres; there is one more bend than legs.
    offsets: Box<[f32]>,
    /// Bounding box of all bends, relative to the user.
    pub bounds: Aabb,
}

impl Corner {
    /// Bends the ray to a tolerance in radians; `None` for users outside r₁, for vertical rays, and if `MAX_LEGS` legs
    /// do not meet the tolerance.
    pub fn new(curve: &RayCurve<'_>, tolerance: f64) -> Option<Self> {
        // A ray of a user inside r₁ is straight up to r₁ and bends between r₁ and r₂.
        let [inside, stretch] = curve.stretches()[..] else { return None };
        if !inside.is_straight || stretch.is_straight || curve.end().is_none() {
            return None;
        }
        let (mut offsets, mut legs) = ([0.0; MAX_LEGS + 1], 1);
        offsets[1] = curve.ray_distance;
        while legs < MIN_LEGS || exceeds_tolerance(curve, &stretch, &offsets[..=legs], tolerance) {
            if legs == MAX_LEGS {
                return None;
            }
            halve(curve, &stretch, &mut offsets, legs);
            legs *= 2;
        }
        let offsets = offsets[..=legs].iter().map(|&y| y as f32).collect();
        let mut corner = Self {
            direction: curve.direction.as_vec3(),
            offset_direction: curve.offset_direction.as_vec3(),
            first_distance: stretch.from as f32,
            distance_step: ((stretch.to - stretch.from) / legs as f64) as f32,
            legs,
            offsets,
            bounds: Aabb::EMPTY,
        };
        for k in 0..=legs {
            corner.bounds.extend(corner.bend_position(k));
        }
        Some(corner)
    }

    /// Returns the position of this corner's k-th bend, relative to the user.
    fn bend_position(&self, k: usize) -> Vec3 {
        self.direction * (self.first_distance + self.distance_step * k as f32) + self.offset_direction * self.offsets[k]
    }

    /// Returns the positions of the first and the last bend, relative to the user.
    pub fn ends(&self) -> [Vec3; 2] {
        [self.bend_position(0), self.bend_position(self.legs)]
    }

    /// Returns the k-th of `legs` + 1 bends, with `legs` at least the corner's own number: the offset from the ray to
    /// the curve, and the distance along the ray.
    #[inline]
    pub fn bend(&self, k: usize, legs: usize) -> Vec4 {
        // Both are powers of two.
        let finer = legs.trailing_zeros() - self.legs.trailing_zeros();
        let index = k >> finer;
        let before = self.offsets[index];
        let remainder = k - (index << finer);
        if remainder == 0 {
            return (self.offset_direction * before).extend(self.first_distance + self.distance_step * index as f32);
        }
        let fraction = remainder as f32 / (1u32 << finer) as f32;
        let y = before + (self.offsets[index + 1] - before) * fraction;
        (self.offset_direction * y).extend(self.first_distance + self.distance_step * (index as f32 + fraction))
    }
}

/// Returns the distance along the ray of the k-th of `legs` equal steps; k may be fractional.
fn step_distance(stretch: &Stretch, k: f64, legs: usize) -> f64 {
    stretch.from + (stretch.to - stretch.from) * k / legs as f64
}

/// Returns whether a chord misses the curve by more than the tolerance, at its middle or between middle and ends. A
/// winding curve crosses its chords, so one point is not enough.
fn exceeds_tolerance(curve: &RayCurve<'_>, stretch: &Stretch, offsets: &[f64], tolerance: f64) -> bool {
    let legs = offsets.len() - 1;
    let miss = |k: usize, t: f64| {
        curve.miss(step_distance(stretch, k as f64 + t, legs), offsets[k] + (offsets[k + 1] - offsets[k]) * t)
    };
    [0.5, 0.2, 0.8].into_iter().any(|t| (0..legs).any(|k| miss(k, t) > tolerance))
}

/// Inserts a bend between each pair of neighbours.
fn halve(curve: &RayCurve<'_>, stretch: &Stretch, offsets: &mut [f64; MAX_LEGS + 1], legs: usize) {
    // In reverse, so that values are read before they are overwritten.
    for k in (0..legs).rev() {
        let (a, b) = (offsets[k], offsets[k + 1]);
        // The cubic through four neighbours is a better first guess than the chord.
        let inner = k > 0 && k + 1 < legs;
        let bulge = if inner { (a + b - offsets[k - 1] - offsets[k + 2]) / 16.0 } else { 0.0 };
        offsets[2 * k + 2] = b;
        offsets[2 * k + 1] =
            curve.search(step_distance(stretch, k as f64 + 0.5, legs), 0.5 * (a + b) + bulge, OFFSET_PRECISION);
    }
}
