//! Distance rule, which gives the distance from which a level's pixels are fine enough; and the lift of directions.

use glam::DVec3;

use crate::base::{Error, Result, ensure};
use crate::camera::Camera;
use crate::lod::Acuity;

/// Gaze point and acuity of a viewer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gaze {
    /// Gaze point in the picture, pixels.
    pub pixel: [f64; 2],
    /// Increase of the smallest visible angle per degree from the gaze, degrees.
    pub slope: f64,
    /// Smallest visible angle at the gaze, degrees.
    pub limit: f64,
}

/// Distance rule of levels: a level's pixels are fine enough at distances of at least its `start`.
///
/// Distances are *apparent*: they grow with the angle from the gaze, because acuity falls. An apparent distance is the
/// distance from the eye divided by `Acuity::scale`. The pixel width of parallel rays does not depend on distance, so
/// their apparent distances are all 1.
#[derive(Clone, Copy, Debug)]
pub struct Rule {
    eye: DVec3,
    is_parallel: bool,
    /// `start` of level 0.
    pub reach: f64,
    /// Width of the band beyond a level's `start` in which its splats gradually replace finer ones, relative to
    /// `start`; `None` draws whole cells.
    pub band: Option<f64>,
    acuity: Option<Acuity>,
}

impl Rule {
    /// Creates the rule of a viewer: `pitch` is the pixel width of a leaf's views in metres, `error` the maximum width
    /// of a view's pixels in pixels of the picture.
    pub fn new(camera: &Camera, pitch: f64, error: f64, band: Option<f64>, gaze: Option<&Gaze>) -> Result<Self> {
        for (name, value) in [("pitch", pitch), ("error_px", error)] {
            ensure!(value.is_finite() && value > 0.0, name, "a finite number above 0", value);
        }
        if let Some(width) = band.filter(|width| !(*width > 0.0 && *width <= 1.0)) {
            return Err(Error::value("band", "a number above 0, at most 1", width));
        }
        let is_parallel = camera.is_parallel();
        ensure!(gaze.is_none() || !is_parallel, "gaze", "a camera with perspective, or None", "parallel rays");
        let acuity = gaze.map(|gaze| Acuity {
            gaze: camera.ray(gaze.pixel[0], gaze.pixel[1]).1.normalize(),
            slope: gaze.slope,
            limit: gaze.limit,
            best: camera.pixel_size().atan().to_degrees().max(gaze.limit),
        });
        let reach = pitch / (camera.pixel_size() * error);
        Ok(Self { eye: camera.position, is_parallel, reach, band, acuity })
    }

    /// Returns the apparent distance from which a level's pixels are fine enough.
    pub fn start(&self, level: u32) -> f64 {
        self.reach * (1u64 << level) as f64
    }

    /// Returns the apparent distance of a point.
    pub fn apparent(&self, place: DVec3) -> f64 {
        if self.is_parallel {
            return 1.0;
        }
        let offset = place - self.eye;
        offset.length() / self.acuity.map_or(1.0, |acuity| acuity.scale(offset, 0.0))
    }

    /// Returns the distance of a cube's nearest point from the eye, metres.
    pub fn distance(&self, corner: DVec3, side: f64) -> f64 {
        (self.eye - self.eye.clamp(corner, corner + side)).length()
    }

    /// Returns bounds of the apparent distances of a cube's points. Its sphere bounds their angles from the gaze.
    pub fn bounds(&self, corner: DVec3, side: f64) -> [f64; 2] {
        if self.is_parallel {
            return [1.0; 2];
        }
        let center = corner + side / 2.0 - self.eye;
        let nearest = self.distance(corner, side);
        let farthest = (center.abs() + side / 2.0).length();
        let Some(acuity) = self.acuity else { return [nearest, farthest] };
        let sine = side * 3f64.sqrt() / 2.0 / center.length();
        if sine < 1.0 {
            let half = sine.asin();
            [nearest / acuity.scale(center, half), farthest / acuity.scale(center, -half)]
        } else {
            [nearest, farthest / acuity.scale(-acuity.gaze, 0.0)]
        }
    }
}

/// Sine of the angle from straight down within which a direction has no defined azimuth.
const MIN_SINE: f64 = 1e-9;

/// An angle by which directions are raised towards +y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lift {
    sine: f64,
    cosine: f64,
}

impl Lift {
    /// Creates a lift from an angle in degrees, 0 to 90.
    pub fn new(degrees: f64) -> Result<Self> {
        ensure!((0.0..=90.0).contains(&degrees), "lift_deg", "a number from 0 to 90", degrees);
        let (sine, cosine) = degrees.to_radians().sin_cos();
        Ok(Self { sine, cosine })
    }

    /// Rotates a unit vector by the angle towards +y, at most to +y. A vector straight down has no azimuth and stays.
    pub fn raised(self, unit: DVec3) -> DVec3 {
        let horizontal = unit.x.hypot(unit.z);
        if self.sine == 0.0 || (horizontal < MIN_SINE && unit.y < 0.0) {
            return unit;
        }
        let raised = horizontal * self.cosine - unit.y * self.sine;
        if raised <= 0.0 {
            return DVec3::Y;
        }
        let y = unit.y * self.cosine + horizontal * self.sine;
        DVec3::new(unit.x / horizontal * raised, y, unit.z / horizontal * raised)
    }
}
