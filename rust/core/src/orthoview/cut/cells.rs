//! Occupied cells of an octree whose subtrees are added one by one.

use std::collections::HashMap;

use glam::{DVec3, UVec3};

use crate::base::{Result, ensure};

/// Mask of a cell that an unfinished build has not reached. No cell below it has views either.
pub const UNBUILT: u32 = 1 << 29;

/// Mask of a cell that an unfinished build has not reached, though cells below it have views.
pub const PARTIAL: u32 = 1 << 30;

/// Cell grid of a world. Level 0 has the leaves, the last level one cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Minimum corner of leaf (0, 0, 0), metres.
    pub origin: DVec3,
    /// Side of a leaf, metres.
    pub side: f64,
    /// Number of levels.
    pub levels: u32,
    /// Levels per subtree.
    pub subtree: u32,
}

impl Grid {
    /// Returns the side of a level's cells, metres.
    pub fn side_at(&self, level: u32) -> f64 {
        self.side * (1u64 << level) as f64
    }

    /// Returns the minimum corner of a cell, metres.
    pub fn corner(&self, level: u32, place: UVec3) -> DVec3 {
        self.origin + place.as_dvec3() * self.side_at(level)
    }

    /// Returns the number of a level's cells along each axis of a subtree.
    fn cells_per_axis(&self, level: u32) -> usize {
        1 << (self.subtree - level % self.subtree)
    }
}

/// Occupied cells of an octree.
#[derive(Clone, Debug)]
pub struct Cells {
    /// Grid of the octree.
    pub grid: Grid,
    /// Direction masks of each subtree's cells, level by level. Keys are the tier, which is the lowest level divided by
    /// the levels per subtree, and the position.
    subtrees: HashMap<(u32, UVec3), Vec<Box<[u32]>>>,
}

impl Cells {
    /// Creates an index without subtrees.
    pub fn new(grid: Grid) -> Result<Self> {
        let Grid { levels, subtree, .. } = grid;
        let is_valid = (1..=8).contains(&subtree) && (1..=32).contains(&levels);
        let got = format!("{levels} levels, {subtree} per subtree");
        ensure!(is_valid, "levels", "1 to 32 levels, 1 to 8 of them per subtree", got);
        let is_finite = grid.origin.is_finite() && grid.side.is_finite() && grid.side > 0.0;
        let got = format!("corner {}, side {}", grid.origin, grid.side);
        ensure!(is_finite, "cell", "a finite corner and a side above 0", got);
        Ok(Self { grid, subtrees: HashMap::new() })
    }

    /// Adds a subtree: for each of its levels, the lowest first, the direction masks of its cells, z fastest. An empty
    /// list stands for an empty subtree.
    pub fn add(&mut self, tier: u32, place: UVec3, levels: Vec<Box<[u32]>>) -> Result<()> {
        for (level, masks) in (tier * self.grid.subtree..).zip(&levels) {
            let expected = self.grid.cells_per_axis(level).pow(3);
            ensure!(masks.len() == expected, "levels", format!("{expected} cells of level {level}"), masks.len());
        }
        self.subtrees.insert((tier, place), levels);
        Ok(())
    }

    /// Returns the number of known subtrees.
    pub fn subtree_count(&self) -> usize {
        self.subtrees.len()
    }

    /// Returns the tier and the position of the subtree that contains a cell.
    pub fn subtree_of(&self, level: u32, place: UVec3) -> (u32, UVec3) {
        let bits = self.grid.subtree - level % self.grid.subtree;
        (level / self.grid.subtree, place >> bits)
    }

    /// Returns the bit mask of the directions from which a cell has a view, 0 for an empty cell, `UNBUILT` or
    /// `PARTIAL`; `None` if its subtree has not been added.
    pub fn get(&self, level: u32, place: UVec3) -> Option<u32> {
        let key = self.subtree_of(level, place);
        let levels = self.subtrees.get(&key)?;
        let side = self.grid.cells_per_axis(level);
        let Some(masks) = levels.get((level % self.grid.subtree) as usize) else { return Some(0) };
        let [x, y, z] = (place - key.1 * side as u32).to_array().map(|n| n as usize);
        Some(masks[(x * side + y) * side + z])
    }
}
