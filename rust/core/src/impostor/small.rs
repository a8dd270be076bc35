//! Near triangles that are visible but so small that the probes' rays may miss them.

use rayon::prelude::*;

use super::probe::Probe;
use super::world::World;
use crate::base::memory::room_for_values;
use crate::base::{Progress, Result};
use crate::trace::{AcceptAll, AlphaFilter, Ray, any_hits};

/// Width, in texels of a probe, from which on some ray hits a triangle.
const WIDE: f64 = 3.0;
/// Share of a ray in front of a triangle that may lie behind its neighbours.
const MARGIN: f64 = 1e-4;
/// Triangles in a task.
const TASK: usize = 256;
/// Rays that are traced together.
const BLOCK: usize = 8;

/// Notes the small near triangles whose middle a probe sees. A scan has thousands of triangles between two rays, and
/// without those that no ray hit it would be full of holes.
pub fn note_small(world: &World<'_>, probes: &[Probe], progress: &Progress) -> Result<()> {
    let standing = world.scene.instance_count() as u32;
    let still = world.partition.nsf().take_while(|&(instance, _)| instance < standing);
    room_for_values::<(u32, u32)>(world.partition.counts.nsf as usize)?;
    let triangles: Vec<_> = still.filter(|&(instance, face)| !world.is_noted(instance, face)).collect();
    let texel = 2.0 / probes.iter().map(Probe::width).max().map_or(1.0, f64::from);
    progress.expect(triangles.len() as u64);
    triangles.par_chunks(TASK).try_for_each(|triangles| {
        for &(instance, face) in triangles {
            let [a, b, c] = world.scene.instance(instance).corners(face);
            let middle = (a + b + c) / 3.0;
            let farthest = (middle.as_dvec3() - world.eye).length() + world.reach;
            let width = f64::from((b - a).cross(c - a).length()).sqrt() / farthest;
            let is_visible = |probes: &[Probe]| {
                let ray = |probe: &Probe| {
                    let origin = probe.position.as_vec3();
                    let (direction, length) = (middle - origin).normalize_and_length();
                    Ray { origin, direction, t_min: 0.0, t_max: length * (1.0 - MARGIN as f32) }
                };
                let rays: Vec<Ray> = probes.iter().map(ray).collect();
                let mut is_hidden = vec![false; rays.len()];
                any_hits(world.scene, &rays, &AlphaFilter::new(world.scene, AcceptAll), &mut is_hidden);
                is_hidden.contains(&false)
            };
            if width < WIDE * texel && probes.chunks(BLOCK).any(is_visible) {
                world.insert(instance, face);
            }
        }
        progress.report(triangles.len() as u64)
    })
}
