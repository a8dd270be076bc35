//! Objects whose levels are chosen, and counts of the stages that settled them.

use std::ops::AddAssign;

/// Objects of one task: their numbers stay in a near cache.
pub(super) const TILE: usize = 1 << 9;

/// Arrays of objects, one entry for each.
#[derive(Clone, Copy, Debug)]
pub struct Objects<'a> {
    /// Number of each one's model.
    pub model: &'a [i64],
    /// Centres of their bounding spheres.
    pub centers: &'a [[f64; 3]],
    /// Radii of their bounding spheres, metres.
    pub radii: &'a [f64],
    /// Levels in the previous frame, −1 for none.
    pub previous: Option<&'a [i32]>,
}

/// Columns beside the level: σ, the σ′ that the eye sees, f, the score, and the fading level.
pub const COLUMNS: usize = 5;

/// Objects by the stage that settled them, of all eyes together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SelectionCounts {
    /// Not in view.
    pub culled: u64,
    /// In view, with one level.
    pub one_level: u64,
    /// At level 0 already by another eye.
    pub settled: u64,
    /// Above the size up to which curves are used.
    pub large: u64,
    /// Sent to curves or tables.
    pub asked: u64,
    /// Of those: sizes through the lens.
    pub lens: u64,
    /// Levels from a table.
    pub table: u64,
    /// Levels from curves.
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
