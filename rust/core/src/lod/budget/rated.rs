//! Models prepared for the budget: levels with curves, and the inverse differences of their triangle counts.

use super::super::select::Model;
use crate::base::{Error, Result};

/// Curves of a model, and the triangle counts of all its levels, level 0 first.
#[derive(Clone, Copy, Debug)]
pub struct RatedModel<'a> {
    /// Curves, sizes and pixels.
    pub model: Model<'a>,
    /// Triangle count of each level: one entry more than curves, never increasing.
    pub triangles: &'a [i64],
}

/// Selectable levels of a model: level 0 and those with curves, finest first.
#[derive(Clone, Debug)]
pub(super) struct Ladder {
    /// Number of each level in the model.
    pub level: Vec<i32>,
    pub triangles: Vec<u64>,
    /// Triangles added by each step; step n leads from level n + 1 to level n.
    pub added: Vec<u64>,
    /// a, b, ln c and d of each level but the first.
    pub curves: Vec<[f64; 4]>,
    /// Row by row for each coarser level k: 1/(triangles of j − triangles of k) for the finer levels j < k; +∞ for
    /// equal counts.
    pub per_triangle: Vec<f64>,
    /// Minimum and maximum size at which curves are read.
    pub range: [f64; 2],
}

impl Ladder {
    pub fn new(rated: &RatedModel<'_>, number: usize) -> Result<Self> {
        let RatedModel { model, triangles } = rated;
        model.check(number)?;
        let mut ladder = Self {
            level: vec![0],
            triangles: vec![triangles[0] as u64],
            added: Vec::new(),
            curves: Vec::new(),
            per_triangle: Vec::new(),
            range: [model.range[0], model.greatest()],
        };
        for (n, &[a, b, c, d]) in model.curves.iter().enumerate() {
            if [a, b, c, d].iter().any(|value| value.is_nan()) {
                continue;
            }
            let coarser = triangles[n + 1] as u64;
            for &finer in &ladder.triangles {
                let difference = finer.checked_sub(coarser).ok_or_else(|| {
                    let expected = format!("no more triangles in coarser levels of model {number}");
                    Error::value("models", expected, format!("{coarser} after {finer}"))
                })?;
                ladder.per_triangle.push(1.0 / difference as f64);
            }
            ladder.added.push(ladder.triangles[ladder.triangles.len() - 1] - coarser);
            ladder.level.push(n as i32 + 1);
            ladder.triangles.push(coarser);
            ladder.curves.push([a, b, c.ln(), d]);
        }
        Ok(ladder)
    }

    /// Returns the number of steps from one level to the next finer one.
    pub fn steps(&self) -> usize {
        self.curves.len()
    }

    /// Returns 1/(triangles of `finer` − triangles of `coarser`).
    pub fn inverse(&self, coarser: usize, finer: usize) -> f64 {
        self.per_triangle[coarser * (coarser - 1) / 2 + finer]
    }
}
