//! Ray casting for arrays of world-space rays.

use glam::DVec3;
use rayon::prelude::*;

use super::dispatch::closest_hits;
use super::ray::{AcceptAll, AlphaFilter, Hit, Ray};
use crate::base::memory::try_vec;
use crate::base::{Error, MAX_COORDINATE, Progress, Result, ensure};
use crate::scene::Scene;

/// Number of rays per task: fixed, so that packets do not depend on the number of threads.
pub(super) const CHUNK: usize = 4096;

/// Rows of three coordinates, float32 or float64.
#[derive(Clone, Copy, Debug)]
pub enum Points<'a> {
    /// Float32.
    Single(&'a [[f32; 3]]),
    /// Float64.
    Double(&'a [[f64; 3]]),
}

impl Points<'_> {
    pub(super) fn len(&self) -> usize {
        match self {
            Self::Single(rows) => rows.len(),
            Self::Double(rows) => rows.len(),
        }
    }

    #[inline(always)]
    pub(super) fn get(&self, row: usize) -> DVec3 {
        match self {
            Self::Single(rows) => glam::Vec3::from_array(rows[row]).as_dvec3(),
            Self::Double(rows) => DVec3::from_array(rows[row]),
        }
    }

    /// Fails if rows are invalid; the error states their number and the index of the first.
    fn check(&self, argument: &'static str, expected: &str, is_valid: impl Fn(DVec3) -> bool + Sync) -> Result<()> {
        let count_and_first = |start: usize| {
            let rows = start..(start + CHUNK).min(self.len());
            let mut invalid = rows.filter(|&row| !is_valid(self.get(row)));
            invalid.next().map(|first| (invalid.count() + 1, first))
        };
        let starts: Vec<usize> = (0..self.len()).step_by(CHUNK).collect();
        let invalid = starts.into_par_iter().filter_map(count_and_first).reduce_with(|a, b| (a.0 + b.0, a.1.min(b.1)));
        invalid.map_or(Ok(()), |(count, first)| {
            let rows = if count == 1 { "row" } else { "rows" };
            Err(Error::value(argument, expected, format!("{count} {rows} without, the first at index {first}")))
        })
    }

    /// Fails for a position too far from the scene's origin for float32 rays; see `MAX_COORDINATE`.
    pub(super) fn check_positions(&self, argument: &'static str, scene: &Scene) -> Result<()> {
        let is_near = |p: DVec3| p.is_finite() && (p - scene.origin).abs().max_element() <= MAX_COORDINATE;
        self.check(argument, &format!("finite coordinates within {MAX_COORDINATE:e} m of the scene's origin"), is_near)
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
    let is_paired = origins.len() == 1 || origins.len() == count;
    ensure!(is_paired, "origins", format!("one row, or one for each of {count} directions"), origins.len());
    ensure!(t_max > 0.0, "t_max", "a positive number of metres", t_max);
    origins.check_positions("origins", scene)?;
    directions.check("directions", "finite coordinates", DVec3::is_finite)?;
    directions.check("directions", "a length above zero", |d| d != DVec3::ZERO)?;
    scene.build(progress)?;
    progress.expect(count as u64);
    let ray = |row: usize| {
        let origin = origins.get(if origins.len() == 1 { 0 } else { row });
        let direction = unit(directions.get(row)).as_vec3();
        Ray { origin: (origin - scene.origin).as_vec3(), direction, t_min: 0.0, t_max }
    };
    let filter = AlphaFilter::new(scene, AcceptAll);
    let mut hits = Hits {
        t_hit: try_vec(0.0, count)?,
        triangle_index: try_vec(0, count)?,
        object_id: try_vec(0, count)?,
        barycentric: try_vec([0.0; 2], count)?,
    };
    let chunks = hits
        .t_hit
        .par_chunks_mut(CHUNK)
        .zip(hits.triangle_index.par_chunks_mut(CHUNK))
        .zip(hits.object_id.par_chunks_mut(CHUNK))
        .zip(hits.barycentric.par_chunks_mut(CHUNK))
        .enumerate();
    chunks.try_for_each(|(chunk, (((t, triangle), object), weights))| {
        let rays: Vec<Ray> = (0..t.len()).map(|i| ray(chunk * CHUNK + i)).collect();
        let mut nearest = vec![Hit::MISS; rays.len()];
        closest_hits(scene, &rays, &filter, &mut nearest);
        for (i, hit) in nearest.iter().enumerate() {
            t[i] = hit.t;
            (triangle[i], object[i], weights[i]) = if hit.is_miss() {
                (-1, -1, [f32::NAN; 2])
            } else {
                let triangle = scene.triangle_offset(hit.instance) + i64::from(hit.face);
                (triangle, scene.instance(hit.instance).object_of(hit.face), [hit.u, hit.v])
            };
        }
        progress.report(rays.len() as u64)
    })?;
    Ok(hits)
}

/// Normalises a direction, even if its square overflows or underflows.
#[inline(always)]
fn unit(direction: DVec3) -> DVec3 {
    let square = direction.length_squared();
    if (1e-200..1e200).contains(&square) {
        return direction / square.sqrt();
    }
    (direction / direction.abs().max_element()).normalize()
}
