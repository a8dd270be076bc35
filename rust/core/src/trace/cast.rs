//! Ray casting for arrays of world-space rays.

use glam::DVec3;
use rayon::prelude::*;

use super::alpha::AlphaFilter;
use super::dispatch::closest_hits;
use super::ray::{All, Hit, HitFilter, Ray};
use crate::base::{Error, Progress, REACH, Result};
use crate::scene::Scene;

/// Number of rays per task: fixed, so that packets do not depend on the number of threads.
pub(super) const TILE: usize = 4096;

/// Rows of three coordinates, float32 or float64.
#[derive(Clone, Copy, Debug)]
pub enum Points<'a> {
    /// Float32.
    Single(&'a [[f32; 3]]),
    /// Float64.
    Double(&'a [[f64; 3]]),
}

impl Points<'_> {
    /// Number of rows.
    pub fn len(&self) -> usize {
        match self {
            Self::Single(rows) => rows.len(),
            Self::Double(rows) => rows.len(),
        }
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    #[inline(always)]
    pub(super) fn get(&self, row: usize) -> DVec3 {
        match self {
            Self::Single(rows) => glam::Vec3::from_array(rows[row]).as_dvec3(),
            Self::Double(rows) => DVec3::from_array(rows[row]),
        }
    }

    /// Returns the number of invalid rows and the index of the first.
    pub(super) fn find(&self, is_wrong: impl Fn(DVec3) -> bool + Sync) -> Option<(usize, usize)> {
        let tile = |start: usize| {
            let rows = start..(start + TILE).min(self.len());
            let mut wrong = rows.filter(|&row| is_wrong(self.get(row)));
            wrong.next().map(|first| (wrong.count() + 1, first))
        };
        let starts: Vec<usize> = (0..self.len()).step_by(TILE).collect();
        starts.into_par_iter().filter_map(tile).reduce_with(|a, b| (a.0 + b.0, a.1.min(b.1)))
    }
}

/// Hits of rays, one entry per ray.
#[derive(Debug, Default)]
pub struct Hits {
    /// Distance in metres; infinite for a miss.
    pub t_hit: Vec<f32>,
    /// Triangle number in the scene; −1 for a miss.
    pub triangle_index: Vec<i64>,
    /// Object number; −1 for a miss or a face without an object.
    pub object_id: Vec<i32>,
    /// Weights of the second and third corner; NaN for a miss.
    pub barycentric: Vec<[f32; 2]>,
}

/// Returns the nearest hits, within `t_max` metres, of rays from world positions (one for all rays, or one per ray).
/// Directions of any length are normalised. Rays pass through the holes of cut-out materials.
pub fn cast(
    scene: &Scene,
    origins: Points<'_>,
    directions: Points<'_>,
    t_max: f32,
    progress: &Progress,
) -> Result<Hits> {
    let count = directions.len();
    if origins.len() != 1 && origins.len() != count {
        return Err(Error::value("origins", format!("one row, or {count} as directions has"), origins.len()));
    }
    if t_max.is_nan() || t_max <= 0.0 {
        return Err(Error::value("t_max", "a positive number of metres", t_max));
    }
    let out_of_reach = |p: DVec3| !p.is_finite() || (p - scene.origin).abs().max_element() > REACH;
    let reachable = format!("finite coordinates within {REACH:e} m of the scene's origin");
    refuse("origins", &reachable, origins.find(out_of_reach))?;
    refuse("directions", "finite coordinates", directions.find(|d| !d.is_finite()))?;
    refuse("directions", "a length above zero", directions.find(|d| d == DVec3::ZERO))?;
    scene.build(progress)?;
    progress.expect(count as u64);
    let ray = |row: usize| {
        let origin = origins.get(if origins.len() == 1 { 0 } else { row });
        let direction = unit(directions.get(row)).as_vec3();
        Ray { origin: (origin - scene.origin).as_vec3(), direction, t_min: 0.0, t_max }
    };
    trace(scene, count, ray, &AlphaFilter::new(scene, All), progress)
}

pub(super) fn refuse(argument: &'static str, expected: &str, wrong: Option<(usize, usize)>) -> Result<()> {
    match wrong {
        Some((count, first)) => {
            let rows = if count == 1 { "row" } else { "rows" };
            Err(Error::value(argument, expected, format!("{count} {rows} without, the first at index {first}")))
        }
        None => Ok(()),
    }
}

/// Returns the unit direction, also for directions whose squares overflow or underflow.
#[inline(always)]
fn unit(direction: DVec3) -> DVec3 {
    let square = direction.length_squared();
    if (1e-200..1e200).contains(&square) {
        return direction / square.sqrt();
    }
    (direction / direction.abs().max_element()).normalize()
}

fn trace(
    scene: &Scene,
    count: usize,
    ray: impl Fn(usize) -> Ray + Sync,
    filter: &dyn HitFilter,
    progress: &Progress,
) -> Result<Hits> {
    let mut hits = Hits {
        t_hit: vec![0.0; count],
        triangle_index: vec![0; count],
        object_id: vec![0; count],
        barycentric: vec![[0.0; 2]; count],
    };
    let offsets: Vec<i64> = (0..scene.instance_count() as u32).map(|i| scene.triangle_offset(i)).collect();
    let tiles = hits
        .t_hit
        .par_chunks_mut(TILE)
        .zip(hits.triangle_index.par_chunks_mut(TILE))
        .zip(hits.object_id.par_chunks_mut(TILE))
        .zip(hits.barycentric.par_chunks_mut(TILE))
        .enumerate();
    tiles.try_for_each(|(tile, (((t, triangle), object), weights))| {
        let rays: Vec<Ray> = (0..t.len()).map(|i| ray(tile * TILE + i)).collect();
        let mut found = vec![Hit::MISS; rays.len()];
        closest_hits(scene, &rays, filter, &mut found);
        for (i, hit) in found.iter().enumerate() {
            t[i] = hit.t;
            (triangle[i], object[i], weights[i]) = if hit.is_miss() {
                (-1, -1, [f32::NAN; 2])
            } else {
                let triangle = offsets[hit.instance as usize] + i64::from(hit.face);
                (triangle, scene.instance(hit.instance).object_of(hit.face), [hit.u, hit.v])
            };
        }
        progress.report(rays.len() as u64)
    })?;
    Ok(hits)
}
