//! Level selection for many objects, tile by tile.

use rayon::prelude::*;

use super::curves::Model;
use super::objects::{COLUMNS, Objects, SelectionCounts, TILE};
use super::rules::{Apparent, Rules};
use super::sizes::EyeSizes;
use super::table::{OBJECTS_PER_TABLE, Tables};
use super::tile::{ObjectTile, Selection, TileScratch};
use super::view::Eye;
use crate::base::{Progress, Result};

/// Writes the level of each object: the finest level that any eye needs, −1 for none. If requested it also writes the
/// numbers of COLUMNS. Without `eyes` all levels are 0.
#[expect(clippy::too_many_arguments, reason = "what a selection weighs, and where it goes")]
pub fn select(
    models: &[Model<'_>],
    objects: &Objects<'_>,
    eyes: &[Eye],
    apparent: Apparent<'_>,
    rules: &Rules,
    to: &mut [i32],
    columns: Option<[&mut [f64]; COLUMNS]>,
    progress: &Progress,
) -> Result<SelectionCounts> {
    models.iter().enumerate().try_for_each(|(number, model)| model.check(number))?;
    let limits = models.iter().map(|model| model.limit(rules)).collect();
    let are_many = models.len() * OBJECTS_PER_TABLE <= to.len() && !eyes.is_empty();
    let sight = EyeSizes::new(models, eyes, apparent);
    let tables = if are_many { Tables::new(models, rules) } else { None };
    let selection = Selection { models, limits, tables, sight, rules: *rules };
    let tiles = tiles(objects, to, columns);
    let one = |room: &mut TileScratch, tile: ObjectTile<'_>| progress.check().and_then(|()| selection.tile(room, tile));
    let add = |mut one: SelectionCounts, other: SelectionCounts| {
        one += other;
        Ok(one)
    };
    tiles
        .into_par_iter()
        .map_init(TileScratch::default, one)
        .try_fold(SelectionCounts::default, |sum, counts| add(sum, counts?))
        .try_reduce(SelectionCounts::default, add)
}

/// Splits objects and their results into tiles.
fn tiles<'a>(
    objects: &Objects<'a>,
    to: &'a mut [i32],
    columns: Option<[&'a mut [f64]; COLUMNS]>,
) -> Vec<ObjectTile<'a>> {
    let mut columns = columns.map(|columns| columns.map(|column| column.chunks_mut(TILE)));
    let mut tiles = Vec::with_capacity(to.len().div_ceil(TILE));
    for (number, level) in to.chunks_mut(TILE).enumerate() {
        let first = number * TILE;
        tiles.push(ObjectTile {
            first,
            objects: objects.part(first..first + level.len()),
            level,
            columns: columns.as_mut().map(|columns| columns.each_mut().map(|column| column.next().unwrap_or_default())),
        });
    }
    tiles
}
