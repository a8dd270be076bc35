//! Objects whose levels are chosen, and the number of objects that each stage decided.

use std::ops::Range;

use super::curves::Model;
use crate::base::{Error, Result, ensure};

/// Number of objects in one task; their data fits into a fast cache.
pub(crate) const CHUNK: usize = 1 << 9;

/// Arrays of objects, with one entry per object.
#[derive(Clone, Copy, Debug)]
pub struct Objects<'a> {
    /// Index of the object's model.
    pub model: &'a [i64],
    /// Centres of the bounding spheres.
    pub centers: &'a [[f64; 3]],
    /// Radii of the bounding spheres, metres.
    pub radii: &'a [f64],
    /// Levels in the previous frame; −1 for none.
    pub previous: Option<&'a [i32]>,
}

impl<'a> Objects<'a> {
    /// Fails for invalid model numbers and levels; `first` is the index of the first object.
    #[inline(never)]
    pub(crate) fn check(&self, models: &[Model<'_>], first: usize) -> Result<()> {
        let count = models.len() as i64;
        if let Some(n) = self.model.iter().position(|&model| model < 0 || model >= count) {
            let numbers = || format!("whole numbers from 0 to {}", count - 1);
            let expected = if count == 0 { "no objects without models".to_owned() } else { numbers() };
            return Err(Error::value("model_index", expected, format!("{} at index {}", self.model[n], first + n)));
        }
        let Some(previous) = self.previous else { return Ok(()) };
        for (n, (&level, &model)) in previous.iter().zip(self.model).enumerate() {
            let coarsest = models[model as usize].curves.len();
            let is_level = (-1..=coarsest as i64).contains(&level.into());
            let got = || format!("{level} at index {}", first + n);
            ensure!(is_level, "previous", format!("whole numbers from -1 to {coarsest}"), got());
        }
        Ok(())
    }

    /// Returns some of the objects.
    pub(crate) fn part(&self, range: Range<usize>) -> Objects<'a> {
        Objects {
            model: &self.model[range.clone()],
            centers: &self.centers[range.clone()],
            radii: &self.radii[range.clone()],
            previous: self.previous.map(|previous| &previous[range]),
        }
    }
}

/// Number of results beside the level: σ, the displayed size σ′, f, the score, and the fractional level.
pub const COLUMNS: usize = 5;

/// Number of objects by the stage that decided their level, summed over all eyes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SelectionCounts {
    /// Outside the view.
    pub culled: u64,
    /// In view, with one level only.
    pub one_level: u64,
    /// Already at level 0 because of another eye.
    pub settled: u64,
    /// Larger than the size above which the level is 0.
    pub large: u64,
    /// Decided by a table or by curves.
    pub asked: u64,
    /// Sized through the lens, part of `asked`.
    pub lens: u64,
    /// Decided by a table, part of `asked`.
    pub table: u64,
    /// Decided by curves, part of `asked`.
    pub formula: u64,
}

impl SelectionCounts {
    /// Returns the sum of two counts.
    pub(crate) fn plus(self, other: Self) -> Self {
        Self {
            culled: self.culled + other.culled,
            one_level: self.one_level + other.one_level,
            settled: self.settled + other.settled,
            large: self.large + other.large,
            asked: self.asked + other.asked,
            lens: self.lens + other.lens,
            table: self.table + other.table,
            formula: self.formula + other.formula,
        }
    }
}
