//! From boxes to classes, and from triangles to zones.

use rayon::prelude::*;

use super::radii::measure;
use super::{Class, Mixed, Zone};
use crate::base::{Progress, Result};
use crate::scene::{Aabb, Instance};

/// Faces of one task.
const TILE: usize = 1 << 15;
/// Twice the relative error of a radius rounded to float32: what a box decides with this margin, every triangle in it agrees with.
const MARGIN: f64 = 1.0 / (1u64 << 23) as f64;

/// Both radii about an axis, with the thresholds that spare most of the work.
pub(super) struct Ruler {
    axis: [f64; 2],
    r1: f64,
    r2: f64,
    /// Coordinates (x, z) below `low` or above `high` are beyond r₂ by more than any rounding.
    low: [f32; 2],
    high: [f32; 2],
}

impl Ruler {
    pub fn new(axis: [f64; 2], r1: f64, r2: f64) -> Self {
        let reach = r2 * (1.0 + MARGIN) + f64::from(f32::MIN_POSITIVE);
        // One step outwards makes the rounding to float32 harmless.
        let low = axis.map(|center| ((center - reach) as f32).next_down());
        let high = axis.map(|center| ((center + reach) as f32).next_up());
        Self { axis, r1, r2, low, high }
    }

    /// The class of an instance: by its box where that suffices, else by its triangles.
    pub fn classify(&self, instance: &Instance, progress: &Progress) -> Result<Class> {
        let class = match self.class_of_box(&instance.bounds) {
            Some(class) => class,
            None => return self.mixed(instance, progress).map(Class::Mixed),
        };
        progress.report(instance.mesh.faces.len() as u64)?;
        Ok(class)
    }

    fn class_of_box(&self, bounds: &Aabb) -> Option<Class> {
        if bounds.is_empty() {
            return Some(Class::Far);
        }
        let [least, greatest] = radii_of_box(bounds, self.axis);
        let (least, greatest) = (least * (1.0 - MARGIN), greatest * (1.0 + MARGIN));
        if least > self.r2 {
            Some(Class::Far)
        } else if greatest <= self.r1 {
            Some(Class::Near)
        } else if least > self.r1 && greatest <= self.r2 {
            Some(Class::Intermediate)
        } else {
            None
        }
    }

    fn mixed(&self, instance: &Instance, progress: &Progress) -> Result<Mixed> {
        let tiles = instance
            .mesh
            .faces
            .par_chunks(TILE)
            .enumerate()
            .map(|(tile, faces)| {
                let mixed = self.tile(instance, (tile * TILE) as u32, faces);
                progress.report(faces.len() as u64).map(|()| mixed)
            })
            .collect::<Result<Vec<_>>>()?;
        let mut all = Mixed::default();
        for tile in tiles {
            all.faces.extend(tile.faces);
            all.zones.extend(tile.zones);
            all.measured += tile.measured;
        }
        Ok(all)
    }

    fn tile(&self, instance: &Instance, first: u32, faces: &[[u32; 3]]) -> Mixed {
        let candidates = if instance.in_place {
            let positions = &instance.mesh.positions[..];
            self.candidates(first, faces, |_, face| face.map(|vertex| positions[vertex as usize]))
        } else {
            self.candidates(first, faces, |number, _| instance.corners(number).map(|corner| corner.to_array()))
        };
        let mut mixed = Mixed { measured: candidates.len() as u32, ..Mixed::default() };
        let take = |i: usize, radii: [f64; 2]| {
            if let Some(zone) = self.zone(radii) {
                mixed.faces.push(candidates[i]);
                mixed.zones.push(zone);
            }
        };
        measure(candidates.len(), self.axis, |i| ground(instance, candidates[i]), take);
        mixed
    }

    /// Faces of a tile that their coordinates alone do not show to be far.
    #[inline(always)]
    fn candidates(&self, first: u32, faces: &[[u32; 3]], corners: impl Fn(u32, [u32; 3]) -> [[f32; 3]; 3]) -> Vec<u32> {
        let mut candidates = vec![0; faces.len()];
        let mut count = 0;
        for (number, &face) in (first..).zip(faces) {
            candidates[count] = number;
            let [a, b, c] = corners(number, face);
            let is_far = [0, 2].iter().zip(self.low.iter().zip(&self.high)).any(|(&k, (&low, &high))| {
                (a[k] < low) & (b[k] < low) & (c[k] < low) | (a[k] > high) & (b[k] > high) & (c[k] > high)
            });
            count += usize::from(!is_far);
        }
        candidates.truncate(count);
        candidates
    }

    /// Zone by radii that `radii_of` gave; none for far.
    pub fn zone(&self, radii: [f64; 2]) -> Option<Zone> {
        // Rounded once to the precision of the geometry, as everywhere.
        let [least, greatest] = radii.map(|radius| f64::from(radius as f32));
        match (least <= self.r1, least <= self.r2, greatest > self.r2) {
            (true, _, false) => Some(Zone::Near),
            (true, _, true) => Some(Zone::NearStraddling),
            (false, true, false) => Some(Zone::Intermediate),
            (false, true, true) => Some(Zone::IntermediateStraddling),
            (false, false, _) => None,
        }
    }
}

/// (x, z) of a face's corners where they stand.
#[inline(always)]
pub(super) fn ground(instance: &Instance, face: u32) -> [[f32; 2]; 3] {
    instance.corners(face).map(|corner| [corner.x, corner.z])
}

/// Least and greatest ρ of a box.
pub(super) fn radii_of_box(bounds: &Aabb, axis: [f64; 2]) -> [f64; 2] {
    let (min, max) = (bounds.min.as_dvec3(), bounds.max.as_dvec3());
    let below = [axis[0] - min.x, axis[1] - min.z];
    let above = [max.x - axis[0], max.z - axis[1]];
    let outside = [0, 1].map(|k| (-below[k]).max(-above[k]).max(0.0));
    let across = [0, 1].map(|k| below[k].abs().max(above[k].abs()));
    [outside[0].hypot(outside[1]), across[0].hypot(across[1])]
}
