//! Visible volume: a segment of each ray, and clip planes.

use glam::{DVec3, DVec4};

use crate::base::{Result, ensure};

/// Maximum number of planes, which GPUs limit.
pub const MAX_PLANES: usize = 8;

/// Segment of each pixel's ray in which surfaces are visible, in metres from the camera or, for parallel rays, from
/// the image plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Start, metres.
    pub t_min: f32,
    /// End, metres; may be infinite.
    pub t_max: f32,
}

impl Segment {
    /// The whole ray.
    pub const WHOLE: Self = Self { t_min: 0.0, t_max: f32::INFINITY };
    /// An empty segment.
    pub const EMPTY: Self = Self { t_min: 1.0, t_max: 0.0 };
}

/// Limits of the visible volume.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Segment of each ray.
    pub segment: Segment,
    /// Half-spaces n·x + d ≥ 0, as (n, d); the first `count` of them.
    planes: [DVec4; MAX_PLANES],
    count: usize,
}

impl Limits {
    /// No limits.
    pub const NONE: Self = Self { segment: Segment::WHOLE, planes: [DVec4::ZERO; MAX_PLANES], count: 0 };

    /// Creates limits from a segment of each ray, and half-spaces (n, d) that keep points x with n·x + d ≥ 0.
    pub fn new(segment: Segment, planes: &[[f64; 4]]) -> Result<Self> {
        let expected = format!("at most {MAX_PLANES} half-spaces, of which a box takes six");
        ensure!(planes.len() <= MAX_PLANES, "clip", expected, planes.len());
        let mut limits = Self { segment, count: planes.len(), ..Self::NONE };
        for (slot, numbers) in limits.planes.iter_mut().zip(planes) {
            let plane = DVec4::from_array(*numbers);
            let is_half_space = plane.is_finite() && plane.truncate() != DVec3::ZERO;
            let expected = "four finite numbers (n, d) with n ≠ 0 for each half-space";
            ensure!(is_half_space, "clip", expected, format!("{numbers:?}"));
            *slot = plane;
        }
        Ok(limits)
    }

    /// Returns the half-spaces.
    pub fn planes(&self) -> &[DVec4] {
        &self.planes[..self.count]
    }

    /// Returns whether nothing is clipped.
    pub fn is_none(&self) -> bool {
        self.segment == Segment::WHOLE && self.count == 0
    }

    /// Returns the limits for positions relative to an origin.
    pub fn relative_to(&self, origin: DVec3) -> Self {
        let mut limits = *self;
        for plane in &mut limits.planes[..self.count] {
            plane.w += plane.truncate().dot(origin);
        }
        limits
    }

    /// Returns the visible segment of a ray.
    #[inline]
    pub fn clip_ray(&self, start: DVec3, direction: DVec3) -> Segment {
        if self.count == 0 {
            return self.segment;
        }
        let (mut start_t, mut end_t) = (f64::from(self.segment.t_min), f64::from(self.segment.t_max));
        for plane in self.planes() {
            let (height, slope) = (plane.truncate().dot(start) + plane.w, plane.truncate().dot(direction));
            if slope > 0.0 {
                start_t = start_t.max(-height / slope);
            } else if slope < 0.0 {
                end_t = end_t.min(-height / slope);
            } else if height < 0.0 {
                return Segment::EMPTY;
            }
        }
        if start_t <= end_t { Segment { t_min: start_t as f32, t_max: end_t as f32 } } else { Segment::EMPTY }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_are_cut_where_they_pass_planes() {
        let planes = [[0.0, 0.0, -1.0, -2.0], [0.0, 0.0, 2.0, 16.0]];
        let limits = Limits::new(Segment { t_min: 0.5, t_max: 7.0 }, &planes).unwrap();
        // Points between z = −2 and z = −8 are visible.
        assert_eq!(limits.clip_ray(DVec3::ZERO, DVec3::NEG_Z), Segment { t_min: 2.0, t_max: 7.0 });
        assert_eq!(limits.clip_ray(DVec3::new(0.0, 0.0, -10.0), DVec3::Z), Segment { t_min: 2.0, t_max: 7.0 });
        assert_eq!(limits.clip_ray(DVec3::new(0.0, 0.0, -10.0), DVec3::NEG_Z), Segment::EMPTY);
        assert_eq!(limits.clip_ray(DVec3::new(0.0, 0.0, -5.0), DVec3::X), limits.segment);
        assert_eq!(limits.clip_ray(DVec3::new(0.0, 0.0, 5.0), DVec3::X), Segment::EMPTY);
        let moved = limits.relative_to(DVec3::new(3.0, 9.0, -10.0));
        let segment = moved.clip_ray(DVec3::new(-3.0, -9.0, 10.0), DVec3::NEG_Z);
        assert_eq!(segment, limits.clip_ray(DVec3::ZERO, DVec3::NEG_Z));
    }

    #[test]
    fn wrong_planes_are_refused() {
        let is_refused = |planes: &[[f64; 4]]| Limits::new(Segment::WHOLE, planes).is_err();
        assert!(is_refused(&[[1.0; 4]; 9]) && is_refused(&[[0.0, 0.0, 0.0, 1.0]]) && is_refused(&[[f64::NAN; 4]]));
        assert!(Limits::new(Segment::WHOLE, &[[1.0; 4]; 8]).is_ok() && Limits::NONE.is_none());
    }
}
