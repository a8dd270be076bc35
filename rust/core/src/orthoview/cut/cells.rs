//! The cells of a tree in which something is, by the subtrees that are known so far.

use std::collections::HashMap;

use glam::{DVec3, UVec3};

use crate::base::{Error, Result};

/// Cells of a world. Level 0 has the leaves, the last level one cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Least corner of leaf (0, 0, 0), metres.
    pub origin: DVec3,
    /// Side of a leaf, metres.
    pub side: f64,
    /// Number of levels.
    pub levels: u32,
    /// Levels of a subtree.
    pub subtree: u32,
}

impl Grid {
    /// Side of a level's cells, metres.
    pub fn side_at(&self, level: u32) -> f64 {
        self.side * (1u64 << level) as f64
    }

    /// Least corner of a cell, metres.
    pub fn corner(&self, level: u32, place: UVec3) -> DVec3 {
        self.origin + place.as_dvec3() * self.side_at(level)
    }

    /// Number of cells of a level along each axis of a subtree.
    fn side_of_shard(&self, level: u32) -> usize {
        1 << (self.subtree - level % self.subtree)
    }
}

/// Whether a subtree is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Known {
    /// The directions, by their bits, from which a cell shows something; 0 for a cell in which nothing is.
    Cell(u32),
    /// The subtree with this cell has not been added.
    Not,
}

/// The cells of a tree in which something is.
#[derive(Clone, Debug)]
pub struct Cells {
    /// The tree's cells.
    pub grid: Grid,
    /// By tier and place: for each level of the subtree the bits of its cells' directions.
    subtrees: HashMap<(u32, UVec3), Vec<Box<[u32]>>>,
}

impl Cells {
    /// No subtree is known.
    pub fn new(grid: Grid) -> Result<Self> {
        if !(1..=8).contains(&grid.subtree) || !(1..=32).contains(&grid.levels) {
            let got = format!("{} levels, {} of a subtree", grid.levels, grid.subtree);
            return Err(Error::value("levels", "1 to 32, and 1 to 8 of a subtree", got));
        }
        if !grid.origin.is_finite() || !grid.side.is_finite() || grid.side <= 0.0 {
            return Err(Error::value("cell", "a finite corner and a side above 0", format!("{grid:?}")));
        }
        Ok(Self { grid, subtrees: HashMap::new() })
    }

    /// Adds a subtree: for each of its levels, the lowest one first, the bits of the directions from which its cells show
    /// something, z fastest. No levels stand for a subtree in which nothing is.
    pub fn add(&mut self, tier: u32, place: UVec3, levels: Vec<Box<[u32]>>) -> Result<()> {
        for (level, masks) in (tier * self.grid.subtree..).zip(&levels) {
            let expected = self.grid.side_of_shard(level).pow(3);
            if masks.len() != expected {
                return Err(Error::value("levels", format!("{expected} cells of level {level}"), masks.len()));
            }
        }
        self.subtrees.insert((tier, place), levels);
        Ok(())
    }

    /// Number of subtrees that are known.
    pub fn known(&self) -> usize {
        self.subtrees.len()
    }

    /// The tier and the place of the subtree that has a cell.
    pub fn subtree_of(&self, level: u32, place: UVec3) -> (u32, UVec3) {
        let bits = self.grid.subtree - level % self.grid.subtree;
        (level / self.grid.subtree, place >> bits)
    }

    /// The directions from which a cell shows something, as far as it is known.
    pub fn at(&self, level: u32, place: UVec3) -> Known {
        let key = self.subtree_of(level, place);
        let Some(levels) = self.subtrees.get(&key) else { return Known::Not };
        let side = self.grid.side_of_shard(level);
        let Some(masks) = levels.get((level % self.grid.subtree) as usize) else { return Known::Cell(0) };
        let within = place - key.1 * side as u32;
        let [x, y, z] = within.to_array().map(|n| n as usize);
        Known::Cell(masks[(x * side + y) * side + z])
    }
}
