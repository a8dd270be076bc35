//! Probes: positions of users in the region, with the distances that each sees.

use glam::DVec3;
use rayon::prelude::*;

use super::layer::{Layer, Patch};
use super::world::World;
use crate::base::memory::try_vec;
use crate::base::{Progress, Result};
use crate::cubemap::{direction_from_texel, texel_from_direction};
use crate::trace::{Hit, Ray};

/// Relative error of a stored distance within which a point counts as seen: a probe's texels are coarse.
const TOLERANCE: f64 = 0.02;
/// Rays in a task.
const TASK: usize = 4096;

/// A user's position with a cube map of distances to the nearest surface; those to far surfaces are negative.
pub struct Probe {
    /// Position relative to the scene's origin.
    pub position: DVec3,
    size: u32,
    distances: Vec<f32>,
}

impl Probe {
    /// Traces a probe's map of 6 `size` × `size` texels.
    pub fn trace(world: &World<'_>, position: DVec3, size: u32, progress: &Progress) -> Result<Self> {
        let mut distances = try_vec(0.0f32, 6 * (size as usize).pow(2))?;
        distances.par_chunks_mut(TASK).enumerate().try_for_each(|(task, distances)| {
            let ray = |n: usize| Ray {
                origin: position.as_vec3(),
                direction: direction_from_texel((task * TASK + n) as u32, size).normalize().as_vec3(),
                t_min: 0.0,
                t_max: f32::INFINITY,
            };
            let rays: Vec<Ray> = (0..distances.len()).map(ray).collect();
            let mut hits = vec![Hit::MISS; rays.len()];
            world.trace(&rays, false, &mut hits);
            for (distance, hit) in distances.iter_mut().zip(&hits) {
                *distance = if world.note(hit) { -hit.t } else { hit.t };
            }
            progress.check()
        })?;
        Ok(Self { position, size, distances })
    }

    /// Returns whether nothing hides a point, as far as the map tells.
    pub fn sees(&self, point: DVec3) -> bool {
        let to_point = point - self.position;
        let stored = self.distances[texel_from_direction(to_point, self.size) as usize];
        to_point.length() <= f64::from(stored.abs()) * (1.0 + TOLERANCE)
    }

    /// Returns the number of texels whose far surface no layer shows.
    pub fn missing(&self, layers: &[Layer], progress: &Progress) -> Result<usize> {
        let count = |task: usize, distances: &[f32]| {
            let is_missing = |&(n, &distance): &(usize, &f32)| {
                let direction = direction_from_texel((task * TASK + n) as u32, self.size).normalize();
                let patch = Patch::of_point(self.position - direction * f64::from(distance));
                distance < 0.0 && !layers.iter().any(|layer| layer.shows(&patch))
            };
            progress.check().map(|()| distances.iter().enumerate().filter(is_missing).count())
        };
        self.distances.par_chunks(TASK).enumerate().map(|(task, distances)| count(task, distances)).sum()
    }

    /// Returns the width of the map's faces, texels.
    pub fn width(&self) -> u32 {
        self.size
    }

    /// Returns the number of texels.
    pub fn texels(&self) -> usize {
        self.distances.len()
    }
}
