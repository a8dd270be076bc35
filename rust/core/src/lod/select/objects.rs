//! Objects whose levels are chosen, and the number of objects that each stage decided.

use std::ops::AddAssign;

/// Number of objects in one task; their data stays in a fast cache.
pub(super) const TILE: usize = 1 << 9;

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

/// Number of columns beside the level: σ, the σ′ that the eye sees, f, the score, and the fading level.
pub const COLUMNS: usize = 5;

/// Number of objects by the stage that decided their level, summed over all eyes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SelectionCounts {
    /// Outside the view.
    pub culled: u64,
    /// In view, with one level only.
    pub one_level: u64,
    /// At level 0 already because of another eye.
    pub settled: u64,
    /// Larger than the size up to which curves are used.
    pub large: u64,
    /// Looked up in curves or tables.
    pub asked: u64,
    /// Of `asked`: sizes computed through the lens.
    pub lens: u64,
    /// Of `asked`: levels from a table.
    pub table: u64,
    /// Of `asked`: levels from curves.
    pub formula: u64,
}

impl AddAssign for SelectionCounts {
    fn add_assign(&mut self, other: Self) {
        self.culled += other.culled;
        self.one_level += other.one_level;
        self.settled += other.settled;
        self.large += other.large;
        self.asked += other.asked;
        self.lens += other.lens;
        self.table += other.table;
        self.formula += other.formula;
    }
}
