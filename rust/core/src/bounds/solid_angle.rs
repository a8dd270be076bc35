//! Solid angles of spheres.

use std::f64::consts::PI;

use glam::DVec3;
use rayon::prelude::*;

use crate::base::{Progress, Result, ensure};

/// Number of spheres in one task.
const CHUNK: usize = 1 << 12;

/// Direction and apparent size of a sphere.
#[derive(Clone, Copy, Debug)]
pub struct SphereView {
    /// Unit vector from the eye to the centre.
    pub direction: DVec3,
    /// Sine of half the subtended angle.
    pub sine: f64,
    /// Cosine of half the subtended angle.
    pub cosine: f64,
}

impl SphereView {
    /// Creates the view of a sphere; `None` if the eye is in or on it. `offset` points from the eye to the centre.
    pub fn new(offset: DVec3, radius: f64) -> Option<Self> {
        // Scaled, because squares of lengths above 10¹⁵⁴ overflow and below 10⁻¹⁵⁴ underflow.
        let scale = offset.abs().max_element().max(radius);
        if scale == 0.0 {
            return None;
        }
        let (offset, radius) = (offset / scale, radius / scale);
        let distance = offset.length();
        let sine = radius / distance;
        (distance > radius).then(|| Self {
            direction: offset / distance,
            sine,
            cosine: ((1.0 - sine) * (1.0 + sine)).sqrt(),
        })
    }

    /// Returns the solid angle 2π (1 − cos μ) in steradians, with μ half the subtended angle, without cancellation.
    pub fn solid_angle(&self) -> f64 {
        2.0 * PI * (self.sine * self.sine / (1.0 + self.cosine))
    }
}

/// Checks spheres and calls `compute` for each chunk of centres, radii and results.
pub fn each_chunk(
    centers: &[[f64; 3]],
    radii: &[f64],
    eye: DVec3,
    results: &mut [f64],
    compute: impl Fn(&[[f64; 3]], &[f64], &mut [f64]) -> Result<()> + Sync,
) -> Result<()> {
    let chunks = centers.par_chunks(CHUNK).zip(radii.par_chunks(CHUNK)).zip(results.par_chunks_mut(CHUNK)).enumerate();
    chunks.try_for_each(|(number, ((centers, radii), results))| {
        check_spheres(centers, radii, eye, number * CHUNK)?;
        compute(centers, radii, results)
    })
}

/// Fails for spheres that are not finite or not at a finite distance; `first` is the first index, for the message.
pub fn check_spheres(centers: &[[f64; 3]], radii: &[f64], eye: DVec3, first: usize) -> Result<()> {
    for (n, (center, &radius)) in centers.iter().zip(radii).enumerate() {
        let index = first + n;
        let is_finite = (DVec3::from_array(*center) - eye).is_finite();
        let expected = "finite numbers, at finite distances from the eye";
        ensure!(is_finite, "centers", expected, format!("{center:?} at index {index}"));
        let is_radius = radius >= 0.0 && radius.is_finite();
        ensure!(is_radius, "radii", "finite numbers of at least 0", format!("{radius} at index {index}"));
    }
    Ok(())
}

/// Writes solid angles in steradians; 4π if the eye is in or on the sphere.
pub fn solid_angles(
    centers: &[[f64; 3]],
    radii: &[f64],
    eye: DVec3,
    to: &mut [f64],
    progress: &Progress,
) -> Result<()> {
    each_chunk(centers, radii, eye, to, |centers, radii, to| {
        for ((center, &radius), to) in centers.iter().zip(radii).zip(to) {
            let view = SphereView::new(DVec3::from_array(*center) - eye, radius);
            *to = view.map_or(4.0 * PI, |view| view.solid_angle());
        }
        progress.check()
    })
}
