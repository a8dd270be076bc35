//! Selection of levels tile by tile, eye by eye: each stage passes on only the objects that it could not decide.

use bytemuck::Zeroable;
use rayon::prelude::*;

use super::curves::{Model, SizeQuery};
use super::objects::{COLUMNS, Objects, SelectionCounts, TILE};
use super::rules::{Apparent, Rules, SizeLimit};
use super::sizes::{EyeSizes, OpenSizes};
use super::table::{OBJECTS_PER_TABLE, Tables, UNSURE};
use super::view::{Eye, HIDDEN, Sight};
use crate::base::{Progress, Result};

/// Level of an object that no eye has seen yet.
const UNSEEN: i32 = -1;
/// Columns of an object outside the view.
const HIDDEN_COLUMNS: [f64; COLUMNS] = [f64::NAN, f64::NAN, f64::NAN, f64::NAN, -1.0];
/// Columns of an object with level 0 whose sizes are not computed.
const LEVEL_0_COLUMNS: [f64; COLUMNS] = [f64::NAN, f64::NAN, f64::NAN, 1.0, 0.0];

/// Objects and their results.
struct ObjectTile<'a> {
    /// Index of the first object.
    first: usize,
    objects: Objects<'a>,
    level: &'a mut [i32],
    columns: Option<[&'a mut [f64]; COLUMNS]>,
}

/// Settings and tables that all tiles share.
struct Selection<'a> {
    models: &'a [Model<'a>],
    /// Size above which each model has level 0, steradians.
    limits: Vec<f64>,
    /// `None` if there are too few objects for tables.
    tables: Option<Tables>,
    sight: EyeSizes<'a>,
    rules: Rules,
}

/// Buffers of one thread for a tile.
#[derive(Zeroable)]
struct TileScratch {
    sight: Sight,
    open: OpenObjects,
}

/// Classes of objects for an eye, in the order in which they are counted.
const CULLED: u8 = 0;
const SETTLED: u8 = 1;
const ONE_LEVEL: u8 = 2;
const LARGE: u8 = 3;
const OPEN: u8 = 4;

/// Data of a tile's objects, and packed data of the objects whose level is still open.
#[derive(Zeroable)]
struct OpenObjects {
    /// Per object: the size above which it has level 0, and its class.
    limit: [f64; TILE],
    class: [u8; TILE],
    /// Per open object: its index in the tile, its sizes, and the level from the table.
    sizes: OpenSizes,
    table_levels: [u8; TILE],
}

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
    let mut columns = columns.map(|columns| columns.map(|column| column.chunks_mut(TILE)));
    let tiles = to.chunks_mut(TILE).enumerate().map(|(number, level)| {
        let first = number * TILE;
        let columns = columns.as_mut().map(|all| all.each_mut().map(|column| column.next().unwrap_or_default()));
        ObjectTile { first, objects: objects.part(first..first + level.len()), level, columns }
    });
    let tiles: Vec<_> = tiles.collect();
    let select_tile = |scratch: &mut Box<TileScratch>, tile: ObjectTile<'_>| {
        progress.check().and_then(|()| selection.tile(scratch, tile))
    };
    let counts = tiles.into_par_iter().map_init(|| Box::new(TileScratch::zeroed()), select_tile);
    counts.try_reduce(SelectionCounts::default, |one, other| Ok(one.plus(other)))
}

impl Selection<'_> {
    fn tile(&self, scratch: &mut TileScratch, mut tile: ObjectTile<'_>) -> Result<SelectionCounts> {
        let TileScratch { sight, open } = scratch;
        tile.objects.check(self.models, tile.first)?;
        self.limit(&tile.objects, open);
        let mut counts = SelectionCounts::default();
        tile.level.fill(if self.sight.eyes.is_empty() { 0 } else { UNSEEN });
        if let Some(columns) = &mut tile.columns {
            let values = if self.sight.eyes.is_empty() { LEVEL_0_COLUMNS } else { HIDDEN_COLUMNS };
            columns.iter_mut().zip(values).for_each(|(column, value)| column.fill(value));
        }
        let limit = if self.rules.limit == SizeLimit::Seen { self.rules.reference } else { f64::INFINITY };
        for (number, eye) in self.sight.eyes.iter().enumerate() {
            let Objects { centers, radii, .. } = tile.objects;
            eye.view.see(centers, radii, tile.first, self.rules.cull, sight)?;
            let asked = sort(sight, &mut tile, open, &mut counts);
            self.sight.see(number, &tile.objects, sight, &mut open.sizes, asked, limit);
            counts.lens += if self.sight.is_bent() { asked as u64 } else { 0 };
            self.levels(open, asked, &mut tile, &mut counts);
        }
        Ok(counts)
    }

    /// Looks up the models' limits.
    #[inline(never)]
    fn limit(&self, objects: &Objects<'_>, open: &mut OpenObjects) {
        for (&model, to) in objects.model.iter().zip(&mut open.limit) {
            *to = self.limits[model as usize];
        }
    }

    fn levels(&self, open: &mut OpenObjects, asked: usize, tile: &mut ObjectTile<'_>, counts: &mut SelectionCounts) {
        let Some(tables) = &self.tables else {
            counts.formula += asked as u64;
            for k in 0..asked {
                self.ask(open, k, None, tile);
            }
            return;
        };
        let OpenObjects { sizes, table_levels, .. } = open;
        tables.look_up(tile.objects.model, &sizes.place[..asked], &sizes.sigma, &sizes.read, table_levels);
        let previous = tile.objects.previous.filter(|_| self.rules.hysteresis > 0.0);
        for k in 0..asked {
            let n = usize::from(open.sizes.place[k]);
            let table_level = open.table_levels[k];
            // Hysteresis applies only to levels coarser than the previous one.
            let is_held =
                previous.is_some_and(|previous| previous[n] != UNSEEN && i32::from(table_level) > previous[n]);
            let is_sure = table_level < UNSURE && !is_held;
            counts.formula += u64::from(!is_sure);
            counts.table += u64::from(is_sure);
            if !is_sure || tile.columns.is_some() {
                self.ask(open, k, Some((table_level, is_sure)), tile);
                continue;
            }
            let (best, level) = (&mut tile.level[n], i32::from(table_level));
            *best = if (*best == UNSEEN) | (level < *best) { level } else { *best };
        }
    }

    /// Finds one object's level by curves, or only its columns if the table gave a certain level.
    #[inline(never)]
    fn ask(&self, open: &OpenObjects, k: usize, table_level: Option<(u8, bool)>, tile: &mut ObjectTile<'_>) {
        let rules = &self.rules;
        let n = usize::from(open.sizes.place[k]);
        let model = &self.models[tile.objects.model[n] as usize];
        let (sigma, seen) = (open.sizes.sigma[k], open.sizes.seen[k]);
        let query = SizeQuery { sigma, seen, read: open.sizes.read[k], threshold: rules.line.value(sigma) };
        let previous = tile.objects.previous.and_then(|previous| usize::try_from(previous[n]).ok());
        let level = match (table_level, previous.filter(|_| rules.hysteresis > 0.0)) {
            (Some((table_level, true)), _) => usize::from(table_level),
            (_, Some(previous)) => model.level_with_hysteresis(previous, &query, rules),
            (Some((table_level, false)), None) => model.coarsest(usize::from(table_level & !UNSURE), &query),
            (None, None) => model.coarsest(model.curves.len(), &query),
        };
        let best = &mut tile.level[n];
        let is_finer = *best == UNSEEN || (level as i32) < *best;
        if let Some(columns) = &mut tile.columns {
            let fading = model.fading_level(level, &query, rules);
            columns[4][n] = if *best == UNSEEN { fading } else { columns[4][n].min(fading) };
            if is_finer {
                let values = [sigma, seen, query.threshold, model.score(level, query.read)];
                columns.iter_mut().zip(values).for_each(|(column, value)| column[n] = value);
            }
        }
        if is_finer {
            *best = level as i32;
        }
    }
}

/// Decides objects that need no curve. Returns the number of open objects.
#[inline(never)]
fn sort(sight: &Sight, tile: &mut ObjectTile<'_>, open: &mut OpenObjects, counts: &mut SelectionCounts) -> usize {
    let count = tile.level.len();
    let (sigma, limit, class) = (&sight.sigma[..count], &open.limit[..count], &mut open.class[..count]);
    for n in 0..count {
        let class_of_size = if sigma[n] > limit[n] { LARGE } else { OPEN };
        let class_of_size = if limit[n] == f64::NEG_INFINITY { ONE_LEVEL } else { class_of_size };
        let class_in_view = if tile.level[n] == 0 { SETTLED } else { class_of_size };
        class[n] = if sigma[n] == HIDDEN { CULLED } else { class_in_view };
    }
    let count_of = |counted: u8| u64::from(class.iter().map(|&class| u16::from(class == counted)).sum::<u16>());
    counts.culled += count_of(CULLED);
    counts.settled += count_of(SETTLED);
    counts.one_level += count_of(ONE_LEVEL);
    counts.large += count_of(LARGE);
    for (level, &class) in tile.level.iter_mut().zip(&*class) {
        *level = if (class == ONE_LEVEL) | (class == LARGE) { 0 } else { *level };
    }
    if let Some(columns) = &mut tile.columns {
        for (n, &class) in class.iter().enumerate().filter(|(_, class)| matches!(**class, ONE_LEVEL | LARGE)) {
            columns.iter_mut().zip(LEVEL_0_COLUMNS).for_each(|(column, value)| column[n] = value);
            columns[0][n] = if class == LARGE { sigma[n] } else { f64::NAN };
        }
    }
    let mut asked = 0;
    for (n, &class) in class.iter().enumerate() {
        // Always written, counted only if open: a branch would be mispredicted half of the time.
        open.sizes.place[asked % TILE] = n as u16;
        asked += usize::from(class == OPEN);
    }
    counts.asked += asked as u64;
    asked
}
