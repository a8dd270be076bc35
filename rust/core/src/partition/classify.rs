//! Zones of triangles, classes of instances by their boxes, and the named sets of a partition.

use rayon::prelude::*;

use super::radii::{Indexed, Soup, TriangleSource, measure, placed_triangles};
use crate::base::mapped::mapped;
use crate::base::memory::room_for;
use crate::base::{Aabb, Progress, Result};
use crate::scene::Instance;

/// Number of faces in one task.
const CHUNK: usize = 1 << 15;
/// Twice the relative error of a radius rounded to float32. A class that follows from a box with this margin agrees
/// with the radii of all triangles in it.
const MARGIN: f64 = 1.0 / (1u64 << 23) as f64;

/// Zone of a triangle, and whether it crosses r₂.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Zone {
    /// Minimum ρ ≤ r₁, and the whole triangle within r₂.
    Near,
    /// Minimum ρ ≤ r₁, and a part beyond r₂.
    NearStraddling,
    /// r₁ < minimum ρ ≤ r₂, and the whole triangle within r₂.
    Intermediate,
    /// r₁ < minimum ρ ≤ r₂, and a part beyond r₂.
    IntermediateStraddling,
    /// The whole triangle beyond r₂.
    Far,
}

impl Zone {
    /// Returns whether minimum ρ ≤ r₁.
    pub fn is_near(self) -> bool {
        matches!(self, Self::Near | Self::NearStraddling)
    }

    /// Returns whether the triangle lies on both sides of r₂.
    pub fn is_straddling(self) -> bool {
        matches!(self, Self::NearStraddling | Self::IntermediateStraddling)
    }
}

/// Zones of an instance's triangles.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Class {
    /// All are [`Zone::Near`].
    Near,
    /// All are [`Zone::Intermediate`].
    Intermediate,
    /// All are [`Zone::Far`].
    Far,
    /// The zones differ, or the box did not decide them.
    Mixed(Mixed),
}

/// Zones of the triangles of an instance whose box does not decide its class.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Mixed {
    /// Faces that are not far, ascending; all other faces are far.
    pub faces: Vec<u32>,
    /// Zone of each of these faces.
    pub zones: Vec<Zone>,
    /// Number of faces whose radii were computed; the coordinates of all others proved that they are far.
    pub measured: u32,
}

/// A selection of an instance's faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChosenFaces<'a> {
    /// All faces.
    All,
    /// These faces, ascending.
    Some(&'a [u32]),
}

/// A named set of a partition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TriangleSet {
    /// Triangles with minimum ρ ≤ r₁.
    Near,
    /// Triangles with r₁ < minimum ρ ≤ r₂.
    Intermediate,
    /// Triangles with minimum ρ > r₂.
    Far,
    /// Triangles drawn as geometry: near, intermediate and all moving ones.
    Nsf,
    /// Baked triangles: static ones that reach beyond r₂.
    Sf,
}

impl TriangleSet {
    pub(super) fn contains(self, zone: Zone, moving: bool) -> bool {
        match self {
            Self::Near => zone.is_near(),
            Self::Intermediate => !zone.is_near() && zone != Zone::Far,
            Self::Far => zone == Zone::Far,
            Self::Nsf => moving || zone != Zone::Far,
            Self::Sf => !moving && (zone == Zone::Far || zone.is_straddling()),
        }
    }
}

/// Both radii about an axis, and thresholds on coordinates that make most triangles' radii unnecessary.
pub(super) struct Ruler {
    axis: [f64; 2],
    r1: f64,
    r2: f64,
    /// Points with x or z below `low` or above `high` lie beyond r₂ by more than any rounding.
    low: [f32; 2],
    high: [f32; 2],
}

impl Ruler {
    pub fn new(axis: [f64; 2], r1: f64, r2: f64) -> Self {
        let reach = r2 * (1.0 + MARGIN) + f64::from(f32::MIN_POSITIVE);
        // One float32 step outwards covers the rounding to float32.
        let low = axis.map(|center| ((center - reach) as f32).next_down());
        let high = axis.map(|center| ((center + reach) as f32).next_up());
        Self { axis, r1, r2, low, high }
    }

    /// Fails if memory does not suffice to classify all instances at the same time: a code per vertex and, per face, a
    /// candidate and twice a number and a zone.
    pub fn room_for<'a>(&self, instances: impl Iterator<Item = &'a Instance>) -> Result<()> {
        let is_open = |instance: &&Instance| self.class_of_box(&secure_bounds(instance)).is_none();
        let bytes = |instance: &Instance| 14 * instance.mesh.faces.len() + instance.mesh.positions.len();
        room_for(instances.filter(is_open).map(bytes).sum::<usize>() as u64)
    }

    /// Returns the class of an instance, from its box if that suffices, otherwise from its triangles.
    pub fn classify(&self, instance: &Instance, progress: &Progress) -> Result<Class> {
        let Some(class) = self.class_of_box(&secure_bounds(instance)) else {
            return self.face_zones(instance, progress).map(Class::Mixed);
        };
        progress.report(instance.mesh.faces.len() as u64)?;
        Ok(class)
    }

    fn class_of_box(&self, bounds: &Aabb) -> Option<Class> {
        if bounds.is_empty() {
            return Some(Class::Far);
        }
        let [min, max] = radii_of_box(bounds, self.axis);
        let (min, max) = (min * (1.0 - MARGIN), max * (1.0 + MARGIN));
        if min > self.r2 {
            Some(Class::Far)
        } else if max <= self.r1 {
            Some(Class::Near)
        } else if min > self.r1 && max <= self.r2 {
            Some(Class::Intermediate)
        } else {
            None
        }
    }

    /// Returns the zones of an instance's faces that are not far.
    fn face_zones(&self, instance: &Instance, progress: &Progress) -> Result<Mixed> {
        let mesh = &instance.mesh;
        // One byte per vertex, so that faces need not load coordinates.
        let positions: &[[f32; 3]] = if instance.in_place { &mesh.positions } else { &[] };
        let codes = mapped(positions, |position| self.outcode(position), progress)?;
        let chunks = mesh.faces.par_chunks(CHUNK).enumerate().map(|(chunk, faces)| {
            let first = (chunk * CHUNK) as u32;
            let mixed = if instance.in_place {
                let triangles = Indexed { vertices: &mesh.positions, faces };
                self.zones(first, &triangles, &candidates(&codes, faces))
            } else {
                let corners = placed_triangles(instance, first..first + faces.len() as u32);
                let candidates = (0..).zip(&corners).filter(|(_, corners)| !self.is_far(corners)).map(|(face, _)| face);
                self.zones(first, &Soup(&corners), &candidates.collect::<Vec<_>>())
            };
            progress.report(faces.len() as u64).map(|()| mixed)
        });
        let mut all = Mixed::default();
        for chunk in chunks.collect::<Result<Vec<_>>>()? {
            all.faces.extend(chunk.faces);
            all.zones.extend(chunk.zones);
            all.measured += chunk.measured;
        }
        Ok(all)
    }

    /// Finds the zones of a chunk's candidates; the chunk starts at face `first`.
    fn zones(&self, first: u32, triangles: &impl TriangleSource<f32>, candidates: &[u32]) -> Mixed {
        let mut mixed = Mixed { measured: candidates.len() as u32, ..Mixed::default() };
        let add_block = |start: usize, radii: &[[f32; 2]]| {
            for (&candidate, &radii) in candidates[start..].iter().zip(radii) {
                if let Some(zone) = self.zone(radii) {
                    mixed.faces.push(first + candidate);
                    mixed.zones.push(zone);
                }
            }
        };
        measure(triangles, candidates.len(), self.axis, |i| candidates[i] as usize, add_block);
        mixed
    }

    /// Returns a bit for each side of the square around r₂ that a point lies beyond (Cohen and Sutherland's outcode).
    #[inline(always)]
    fn outcode(&self, [x, _, z]: &[f32; 3]) -> u8 {
        u8::from(*x < self.low[0])
            | u8::from(*x > self.high[0]) << 1
            | u8::from(*z < self.low[1]) << 2
            | u8::from(*z > self.high[1]) << 3
    }

    fn is_far(&self, [a, b, c]: &[[f32; 3]; 3]) -> bool {
        self.outcode(a) & self.outcode(b) & self.outcode(c) != 0
    }

    /// Returns the zone for radii in the precision of the geometry; `None` for far.
    pub fn zone(&self, radii: [f32; 2]) -> Option<Zone> {
        let [min, max] = radii.map(f64::from);
        match (min <= self.r1, min <= self.r2, max > self.r2) {
            (true, _, false) => Some(Zone::Near),
            (true, _, true) => Some(Zone::NearStraddling),
            (false, true, false) => Some(Zone::Intermediate),
            (false, true, true) => Some(Zone::IntermediateStraddling),
            (false, false, _) => None,
        }
    }
}

/// Returns the box of an instance. The box of a placed mesh is widened by one float32 step, because its corners may be
/// rounded differently.
pub(super) fn secure_bounds(instance: &Instance) -> Aabb {
    let Aabb { min, max } = instance.bounds;
    if instance.in_place || instance.bounds.is_empty() {
        return instance.bounds;
    }
    Aabb { min: min.map(f32::next_down), max: max.map(f32::next_up) }
}

/// Returns the faces of a chunk whose outcodes do not prove that they are far.
fn candidates(codes: &[u8], faces: &[[u32; 3]]) -> Vec<u32> {
    let mut candidates = vec![0; faces.len()];
    let mut count = 0;
    for (number, &[a, b, c]) in (0..).zip(faces) {
        candidates[count] = number;
        count += usize::from(codes[a as usize] & codes[b as usize] & codes[c as usize] == 0);
    }
    candidates.truncate(count);
    candidates
}

/// Returns whether all triangles of a box lie farther from the axis than a radius, by more than any rounding.
pub(super) fn lies_beyond(bounds: &Aabb, axis: [f64; 2], radius: f64) -> bool {
    bounds.is_empty() || radii_of_box(bounds, axis)[0] * (1.0 - MARGIN) > radius
}

/// Returns the minimum and maximum ρ of a box.
pub(super) fn radii_of_box(bounds: &Aabb, axis: [f64; 2]) -> [f64; 2] {
    let (min, max) = (bounds.min.as_dvec3(), bounds.max.as_dvec3());
    let below = [axis[0] - min.x, axis[1] - min.z];
    let above = [max.x - axis[0], max.z - axis[1]];
    let outside = [0, 1].map(|k| (-below[k]).max(-above[k]).max(0.0));
    let across = [0, 1].map(|k| below[k].abs().max(above[k].abs()));
    [outside[0].hypot(outside[1]), across[0].hypot(across[1])]
}
