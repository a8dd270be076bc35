//! Selection of levels, chunk by chunk and eye by eye. Each stage passes on the objects that it cannot decide.

use bytemuck::Zeroable;
use rayon::prelude::*;

use super::curves::{Model, SizeQuery};
use super::objects::{CHUNK, COLUMNS, Objects, SelectionCounts};
use super::rules::{Apparent, Rules, SizeLimit};
use super::sizes::{EyeSizes, OpenSizes};
use super::table::{OBJECTS_PER_TABLE, Tables, UNSURE};
use super::view::{Eye, HIDDEN, Sight};
use crate::base::{Progress, Result};

/// Level of an object that is in no eye's view so far.
const NO_LEVEL: i32 = -1;
/// Columns of an object outside the view.
const HIDDEN_COLUMNS: [f64; COLUMNS] = [f64::NAN, f64::NAN, f64::NAN, f64::NAN, -1.0];
/// Columns of an object with level 0 whose sizes are not computed.
const LEVEL_0_COLUMNS: [f64; COLUMNS] = [f64::NAN, f64::NAN, f64::NAN, 1.0, 0.0];

/// Objects of a chunk, and their results.
struct ObjectChunk<'a> {
    /// Index of the first object.
    first: usize,
    objects: Objects<'a>,
    level: &'a mut [i32],
    columns: Option<[&'a mut [f64]; COLUMNS]>,
}

/// Settings and tables that all chunks share.
struct Selection<'a> {
    models: &'a [Model<'a>],
    /// Size σ above which each model has level 0, steradians.
    limits: Vec<f64>,
    /// `None` if there are too few objects for tables.
    tables: Option<Tables>,
    eye_sizes: EyeSizes<'a>,
    rules: Rules,
}

/// Buffers of one thread for a chunk.
#[derive(Zeroable)]
struct ChunkScratch {
    sight: Sight,
    open: OpenObjects,
}

/// Classes of objects, for one eye.
const CULLED: u8 = 0;
const SETTLED: u8 = 1;
const ONE_LEVEL: u8 = 2;
const LARGE: u8 = 3;
const OPEN: u8 = 4;

/// Data of a chunk's objects, and of its open objects in consecutive entries.
#[derive(Zeroable)]
struct OpenObjects {
    /// For each object: σ above which it has level 0.
    limit: [f64; CHUNK],
    /// For each object: its class.
    class: [u8; CHUNK],
    /// For each open object: its index in the chunk and its sizes.
    sizes: OpenSizes,
    /// For each open object: the level from the table.
    table_levels: [u8; CHUNK],
}

/// Writes the level of each object, the finest level that any eye needs, −1 outside all views; and the numbers of
/// COLUMNS if requested. Without `eyes` all levels are 0.
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
    let eye_sizes = EyeSizes::new(models, eyes, apparent);
    let tables = if are_many { Tables::new(models, rules) } else { None };
    let selection = Selection { models, limits, tables, eye_sizes, rules: *rules };
    let mut columns = columns.map(|columns| columns.map(|column| column.chunks_mut(CHUNK)));
    let chunks = to.chunks_mut(CHUNK).enumerate().map(|(number, level)| {
        let first = number * CHUNK;
        let columns = columns.as_mut().map(|all| all.each_mut().map(|column| column.next().unwrap_or_default()));
        ObjectChunk { first, objects: objects.part(first..first + level.len()), level, columns }
    });
    let chunks: Vec<_> = chunks.collect();
    let select_chunk = |scratch: &mut Box<ChunkScratch>, chunk: ObjectChunk<'_>| {
        progress.check().and_then(|()| selection.chunk(scratch, chunk))
    };
    let counts = chunks.into_par_iter().map_init(|| Box::new(ChunkScratch::zeroed()), select_chunk);
    counts.try_reduce(SelectionCounts::default, |one, other| Ok(one.plus(other)))
}

impl Selection<'_> {
    fn chunk(&self, scratch: &mut ChunkScratch, mut chunk: ObjectChunk<'_>) -> Result<SelectionCounts> {
        let ChunkScratch { sight, open } = scratch;
        chunk.objects.check(self.models, chunk.first)?;
        self.limit(&chunk.objects, open);
        let mut counts = SelectionCounts::default();
        chunk.level.fill(if self.eye_sizes.eyes.is_empty() { 0 } else { NO_LEVEL });
        if let Some(columns) = &mut chunk.columns {
            let values = if self.eye_sizes.eyes.is_empty() { LEVEL_0_COLUMNS } else { HIDDEN_COLUMNS };
            columns.iter_mut().zip(values).for_each(|(column, value)| column.fill(value));
        }
        let limit = if self.rules.limit == SizeLimit::Seen { self.rules.reference } else { f64::INFINITY };
        for (number, eye) in self.eye_sizes.eyes.iter().enumerate() {
            let Objects { centers, radii, .. } = chunk.objects;
            eye.view.see(centers, radii, chunk.first, self.rules.cull, sight)?;
            let open_count = classify(sight, &mut chunk, open, &mut counts);
            self.eye_sizes.write_sizes(number, &chunk.objects, sight, &mut open.sizes, open_count, limit);
            counts.lens += if self.eye_sizes.changes_sizes() { open_count as u64 } else { 0 };
            self.levels(open, open_count, &mut chunk, &mut counts);
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

    fn levels(&self, open: &mut OpenObjects, count: usize, chunk: &mut ObjectChunk<'_>, counts: &mut SelectionCounts) {
        let Some(tables) = &self.tables else {
            counts.formula += count as u64;
            for k in 0..count {
                self.use_curves(open, k, None, chunk);
            }
            return;
        };
        let OpenObjects { sizes, table_levels, .. } = open;
        tables.look_up(chunk.objects.model, &sizes.place[..count], &sizes.sigma, &sizes.curve_size, table_levels);
        let previous = chunk.objects.previous.filter(|_| self.rules.hysteresis > 0.0);
        for k in 0..count {
            let n = usize::from(open.sizes.place[k]);
            let table_level = open.table_levels[k];
            // Hysteresis affects only levels coarser than the previous one.
            let is_held =
                previous.is_some_and(|previous| previous[n] != NO_LEVEL && i32::from(table_level) > previous[n]);
            let is_sure = table_level < UNSURE && !is_held;
            counts.formula += u64::from(!is_sure);
            counts.table += u64::from(is_sure);
            if !is_sure || chunk.columns.is_some() {
                self.use_curves(open, k, Some((table_level, is_sure)), chunk);
                continue;
            }
            let (best, level) = (&mut chunk.level[n], i32::from(table_level));
            *best = if (*best == NO_LEVEL) | (level < *best) { level } else { *best };
        }
    }

    /// Finds an object's level by curves, unless the table gave a sure level, and writes its columns.
    #[inline(never)]
    fn use_curves(&self, open: &OpenObjects, k: usize, table_level: Option<(u8, bool)>, chunk: &mut ObjectChunk<'_>) {
        let rules = &self.rules;
        let n = usize::from(open.sizes.place[k]);
        let model = &self.models[chunk.objects.model[n] as usize];
        let OpenSizes { sigma, displayed, curve_size, .. } = &open.sizes;
        let (sigma, displayed, curve_size) = (sigma[k], displayed[k], curve_size[k]);
        let query = SizeQuery { sigma, displayed, curve_size, threshold: rules.line.value(sigma) };
        let previous = chunk.objects.previous.and_then(|previous| usize::try_from(previous[n]).ok());
        let level = match (table_level, previous.filter(|_| rules.hysteresis > 0.0)) {
            (Some((table_level, true)), _) => usize::from(table_level),
            (_, Some(previous)) => model.level_with_hysteresis(previous, &query, rules),
            (Some((table_level, false)), None) => model.coarsest(usize::from(table_level & !UNSURE), &query),
            (None, None) => model.coarsest(model.curves.len(), &query),
        };
        let best = &mut chunk.level[n];
        let is_finer = *best == NO_LEVEL || (level as i32) < *best;
        if let Some(columns) = &mut chunk.columns {
            let fading = model.fading_level(level, &query, rules);
            columns[4][n] = if *best == NO_LEVEL { fading } else { columns[4][n].min(fading) };
            if is_finer {
                let values = [sigma, displayed, query.threshold, model.score(level, curve_size)];
                columns.iter_mut().zip(values).for_each(|(column, value)| column[n] = value);
            }
        }
        if is_finer {
            *best = level as i32;
        }
    }
}

/// Classifies the objects and decides those that need no curve. Returns the number of open objects.
#[inline(never)]
fn classify(sight: &Sight, chunk: &mut ObjectChunk<'_>, open: &mut OpenObjects, counts: &mut SelectionCounts) -> usize {
    let count = chunk.level.len();
    let (sigma, limit, class) = (&sight.sigma[..count], &open.limit[..count], &mut open.class[..count]);
    for n in 0..count {
        let class_of_size = if sigma[n] > limit[n] { LARGE } else { OPEN };
        let class_of_size = if limit[n] == f64::NEG_INFINITY { ONE_LEVEL } else { class_of_size };
        let class_in_view = if chunk.level[n] == 0 { SETTLED } else { class_of_size };
        class[n] = if sigma[n] == HIDDEN { CULLED } else { class_in_view };
    }
    let count_of = |counted: u8| u64::from(class.iter().map(|&class| u16::from(class == counted)).sum::<u16>());
    counts.culled += count_of(CULLED);
    counts.settled += count_of(SETTLED);
    counts.one_level += count_of(ONE_LEVEL);
    counts.large += count_of(LARGE);
    for (level, &class) in chunk.level.iter_mut().zip(&*class) {
        *level = if (class == ONE_LEVEL) | (class == LARGE) { 0 } else { *level };
    }
    if let Some(columns) = &mut chunk.columns {
        for (n, &class) in class.iter().enumerate().filter(|(_, class)| matches!(**class, ONE_LEVEL | LARGE)) {
            columns.iter_mut().zip(LEVEL_0_COLUMNS).for_each(|(column, value)| column[n] = value);
            columns[0][n] = if class == LARGE { sigma[n] } else { f64::NAN };
        }
    }
    let mut open_count = 0;
    for (n, &class) in class.iter().enumerate() {
        // Every index is written but counted only if open, because a branch would be mispredicted half of the time.
        open.sizes.place[open_count % CHUNK] = n as u16;
        open_count += usize::from(class == OPEN);
    }
    counts.asked += open_count as u64;
    open_count
}
