//! Which level of each object is enough (Liebisch 2021, Sec. 4.3–4.5), for many objects and few eyes.
//!
//! The view first, then sizes, then the lens for those that are left, then a table of levels, then curves.

mod curves;
mod table;
mod tile;
mod view;

use std::ops::AddAssign;

use glam::DVec3;
use rayon::prelude::*;

use crate::base::{Error, Result};
use crate::lens::RadialLens;
pub use curves::{Model, Parameters};
use table::Tables;
use tile::{Room, Tile};
pub use view::View;

/// Objects of one task: what is known of them stays in a near cache.
const TILE: usize = 1 << 9;

/// f(σ) = level + rise · σ.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// At σ = 0.
    pub level: f64,
    /// A steradian.
    pub rise: f64,
}

/// What is enough.
#[derive(Clone, Copy, Debug)]
pub struct Rules {
    /// The least score over the solid angle.
    pub line: Line,
    /// Solid angle above which level 0 is used.
    pub reference: f64,
    /// Whether what is out of view gets no level.
    pub cull: bool,
    /// By how much better than the least score a level must be to follow a finer one.
    pub hysteresis: f64,
    /// Over which share of the way between levels they are blended; 0 for not at all.
    pub fade: f64,
}

/// A lens as eyes look through it.
#[derive(Clone, Copy, Debug)]
pub struct Glass<'a> {
    /// The lens.
    pub lens: &'a RadialLens,
    /// Tangent of half the horizontal field of view, the larger side of it.
    pub tan_omega: f64,
    /// Whether its inverse is Newton's, else the table's.
    pub exact: bool,
}

/// How fine an eye sees: the least angle at e degrees from its gaze is slope · e + limit (Guenter et al. 2012, Eq. 1).
#[derive(Clone, Copy, Debug)]
pub struct Acuity {
    /// Where it looks, in the world, of length 1.
    pub gaze: DVec3,
    /// Degrees a degree.
    pub slope: f64,
    /// Degrees.
    pub limit: f64,
    /// Degrees of the least angle that is drawn, at least `limit`.
    pub best: f64,
}

/// An eye.
#[derive(Clone, Copy, Debug)]
pub struct Eye {
    /// Its pose and view.
    pub view: View,
    /// How fine it sees, where that counts.
    pub acuity: Option<Acuity>,
}

/// Objects, as many of each.
#[derive(Clone, Copy, Debug)]
pub struct Objects<'a> {
    /// Numbers of their models.
    pub model: &'a [i64],
    /// Middles of their bounding spheres.
    pub centers: &'a [[f64; 3]],
    /// Their radii.
    pub radii: &'a [f64],
    /// Levels of the frame before, −1 for none.
    pub previous: Option<&'a [i32]>,
}

/// Numbers beside the level: σ, the size that is seen, f, the score, and the level as it fades over.
pub const COLUMNS: usize = 5;

/// What was done, of all eyes together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Not in view.
    pub culled: u64,
    /// In view, with one level.
    pub one_level: u64,
    /// At level 0 already by another eye.
    pub settled: u64,
    /// Larger than curves are asked for.
    pub large: u64,
    /// Left to be asked for.
    pub asked: u64,
    /// Of those: sizes through the lens.
    pub lens: u64,
    /// Levels from a table.
    pub table: u64,
    /// Levels from curves.
    pub formula: u64,
}

impl AddAssign for Counts {
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

/// All that tiles share.
struct Selection<'a> {
    models: &'a [Model<'a>],
    /// Of each model: the size above which it is not asked.
    limits: Vec<f64>,
    /// `None` where objects are too few for them.
    tables: Option<Tables>,
    eyes: &'a [Eye],
    glass: Option<Glass<'a>>,
    rules: Rules,
}

/// Writes the level of each object, the finest that any eye asks for, −1 for none, and where wanted the numbers of
/// COLUMNS. Without `eyes` all levels are 0.
pub fn select(
    models: &[Model<'_>],
    objects: &Objects<'_>,
    eyes: &[Eye],
    glass: Option<Glass<'_>>,
    rules: &Rules,
    to: &mut [i32],
    columns: Option<[&mut [f64]; COLUMNS]>,
) -> Result<Counts> {
    models.iter().enumerate().try_for_each(|(number, model)| model.check(number))?;
    let limits = models.iter().map(|model| model.limit(rules.reference)).collect();
    let are_many = models.len() * table::WORTH <= to.len() && !eyes.is_empty();
    let tables = if are_many { Tables::new(models, rules) } else { None };
    let selection = Selection { models, limits, tables, eyes, glass, rules: *rules };
    let tiles = tiles(objects, to, columns);
    let one = |room: &mut Room, tile: Tile<'_>| selection.tile(room, tile);
    let add = |mut one: Counts, other: Counts| {
        one += other;
        Ok(one)
    };
    tiles
        .into_par_iter()
        .map_init(Room::default, one)
        .try_fold(Counts::default, |sum, counts| add(sum, counts?))
        .try_reduce(Counts::default, add)
}

/// Objects and their results, some at a time.
fn tiles<'a>(objects: &Objects<'a>, to: &'a mut [i32], columns: Option<[&'a mut [f64]; COLUMNS]>) -> Vec<Tile<'a>> {
    let mut columns = columns.map(|columns| columns.map(|column| column.chunks_mut(TILE)));
    let mut tiles = Vec::with_capacity(to.len().div_ceil(TILE));
    for (number, level) in to.chunks_mut(TILE).enumerate() {
        let first = number * TILE;
        let range = first..first + level.len();
        tiles.push(Tile {
            first,
            objects: Objects {
                model: &objects.model[range.clone()],
                centers: &objects.centers[range.clone()],
                radii: &objects.radii[range.clone()],
                previous: objects.previous.map(|previous| &previous[range.clone()]),
            },
            level,
            columns: columns.as_mut().map(|columns| columns.each_mut().map(|column| column.next().unwrap_or_default())),
        });
    }
    tiles
}

/// A number of a model, or of a level, that is none.
fn refused(argument: &'static str, least: i64, most: usize, got: i64, index: usize) -> Error {
    if most == 0 {
        return Error::value(argument, "no objects where there are no models", format!("{got} at index {index}"));
    }
    let expected = format!("whole numbers from {least} to {}", most - 1);
    Error::value(argument, expected, format!("{got} at index {index}"))
}
