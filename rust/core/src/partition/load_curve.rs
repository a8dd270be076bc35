//! Number of triangles that stay geometry as a function of r₂, and the maximum r₂ for a budget.

use glam::DVec3;
use rayon::prelude::*;

use super::radii::{CHUNK, axis_in, measure_faces};
use crate::base::mapped::pieces;
use crate::base::memory::try_vec;
use crate::base::sort::sort_by_key;
use crate::base::{Error, Progress, Result, ensure};
use crate::scene::Scene;

/// Minimum ρ of every static triangle, sorted once; a query is then a binary search.
#[derive(Clone, Debug)]
pub struct LoadCurve {
    /// Bits of float32 numbers. They sort like the numbers, because none is negative.
    sorted: Vec<u32>,
    /// Number of moving triangles, which stay geometry for any r₂.
    pub moving: i64,
}

impl LoadCurve {
    /// Measures and sorts all static triangles about a centre in world coordinates.
    pub fn new(scene: &Scene, center: DVec3, progress: &Progress) -> Result<Self> {
        let axis = axis_in(scene, center)?;
        let mut rhos = try_vec(0u32, scene.standing.triangle_count() as usize)?;
        progress.expect(2 * rhos.len() as u64);
        let instances = scene.standing.instances();
        let slots = pieces(&mut rhos, instances.iter().map(|instance| instance.mesh.faces.len()));
        instances.par_iter().zip(slots).try_for_each(|(instance, rhos)| {
            rhos.par_chunks_mut(CHUNK).enumerate().try_for_each(|(chunk, rhos)| {
                let faces = chunk * CHUNK..chunk * CHUNK + rhos.len();
                measure_faces(instance, faces, axis, |start, radii| {
                    rhos[start..].iter_mut().zip(radii).for_each(|(rho, radii)| *rho = radii[0].to_bits());
                });
                progress.report(rhos.len() as u64)
            })
        })?;
        sort_by_key(&mut rhos, |&bits| bits, progress)?;
        progress.report(rhos.len() as u64)?;
        Ok(Self { sorted: rhos, moving: scene.moving.triangle_count() })
    }

    /// Returns the number of triangles in the scene.
    pub fn total(&self) -> i64 {
        self.sorted.len() as i64 + self.moving
    }

    /// Returns `count` for each radius.
    pub fn counts(&self, radii: &[f64], progress: &Progress) -> Result<Vec<i64>> {
        try_map_rows(radii, |&r2| self.count(r2), progress)
    }

    /// Returns `radius` for each budget.
    pub fn radii(&self, budgets: &[i64], progress: &Progress) -> Result<Vec<f64>> {
        try_map_rows(budgets, |&budget| self.radius(budget), progress)
    }

    /// Returns the number of triangles that stay geometry at r₂, as in `Partition`. Fails for NaN or r₂ < 0.
    pub fn count(&self, r2: f64) -> Result<i64> {
        ensure!(r2 >= 0.0, "r2", "a radius of at least 0", r2);
        Ok(self.sorted.partition_point(|&bits| f64::from(f32::from_bits(bits)) <= r2) as i64 + self.moving)
    }

    /// Returns the maximum r₂ at which at most `budget` triangles stay geometry; infinite if the whole scene fits.
    pub fn radius(&self, budget: i64) -> Result<f64> {
        if budget >= self.total() {
            return Ok(f64::INFINITY);
        }
        let first_too_many =
            usize::try_from(budget.saturating_sub(self.moving)).ok().map(|index| f32::from_bits(self.sorted[index]));
        match first_too_many {
            Some(rho) if rho > 0.0 => Ok(f64::from(rho).next_down()),
            _ => {
                let at_axis = self.sorted.partition_point(|&bits| bits == 0) as i64 + self.moving;
                let expected = format!("at least {at_axis}: the triangles that move or lie on the axis");
                Err(Error::value("budget", expected, budget))
            }
        }
    }
}

/// Maps rows in parallel. Returns the error of the first row that fails, for any number of threads.
fn try_map_rows<A: Sync, B: Clone + Default + Send>(
    rows: &[A],
    map: impl Fn(&A) -> Result<B> + Sync,
    progress: &Progress,
) -> Result<Vec<B>> {
    let mut values = try_vec(B::default(), rows.len())?;
    let chunks = rows.par_chunks(CHUNK).zip(values.par_chunks_mut(CHUNK)).map(|(rows, values)| {
        progress.check()?;
        values.iter_mut().zip(rows).try_for_each(|(value, row)| map(row).map(|mapped| *value = mapped))
    });
    chunks.collect::<Vec<Result<()>>>().into_iter().collect::<Result<()>>()?;
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_of_several_invalid_rows_is_named() {
        let curve = LoadCurve { sorted: vec![1.0f32.to_bits(); 3], moving: 2 };
        let mut radii = vec![0.5; 3 * CHUNK];
        (radii[CHUNK - 1], radii[2 * CHUNK]) = (-1.0, -2.0);
        let mut budgets = vec![9; 3 * CHUNK];
        (budgets[CHUNK - 1], budgets[2 * CHUNK]) = (-1, -2);
        for _ in 0..100 {
            assert_eq!(curve.counts(&radii, &Progress::new()), curve.count(-1.0).map(|_| Vec::new()));
            assert_eq!(curve.radii(&budgets, &Progress::new()), curve.radius(-1).map(|_| Vec::new()));
        }
        assert_eq!(curve.counts(&[0.5, 1.0], &Progress::new()), Ok(vec![2, 5]));
    }
}
