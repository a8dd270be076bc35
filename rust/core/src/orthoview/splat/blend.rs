//! Blending of levels: in a band of distances from a level's start on, some of its splats are drawn, and splats of
//! finer levels replace the others.
//!
//! A pixel of a view is *coarse enough* if its surface is at a distance of at least start · (1 + band · h), where h is
//! a hash of the pixel's position from 0 to 1. So the fraction of such pixels grows from 0 to 1 over the band. A pixel
//! is *covered* if the pixel above it, in its parent's view from the same direction, is coarse enough or covered.
//! Pixels that are coarse enough and not covered are drawn. The surfaces of a view's first layer decide this for its
//! second layer, too.

use std::collections::{HashMap, HashSet};

use glam::{DVec3, IVec3, UVec3};
use rayon::prelude::*;

use super::splats::{BLOCK, Block, Splats};
use crate::base::memory::room_for;
use crate::base::{Result, random};
use crate::orthoview::cut::Rule;

/// A view of a cut.
#[derive(Clone, Debug)]
pub struct Placed<'a> {
    /// Level and position of the cell.
    pub cell: (u32, UVec3),
    /// Number of the direction.
    pub direction: u8,
    /// Whether finer cells replace some of its splats.
    pub is_partial: bool,
    /// Its layers, at least one.
    pub layers: Vec<&'a Splats>,
}

/// Bit masks of a view's pixels, by blocks in rows.
type Bits = Vec<u64>;

/// Returns the splats to draw of each layer of each view; `None` if all are drawn.
pub fn blended(views: &[Placed<'_>], rule: &Rule) -> Result<Vec<Vec<Option<Splats>>>> {
    let mut selections: Vec<Vec<Option<Splats>>> = views.iter().map(|view| vec![None; view.layers.len()]).collect();
    let Some(band) = rule.band else { return Ok(selections) };
    let partial = partial_cells(views);
    let is_selected = |view: &Placed<'_>| view.is_partial || partial.contains(&parent_of(view.cell));
    // All selections: a growing vector takes up to twice its length, and the masks take less than the splats.
    let layers = views.iter().filter(|view| is_selected(view)).flat_map(|view| &view.layers);
    room_for(3 * layers.map(|layer| layer.bytes() as u64).sum::<u64>())?;
    let mut coarse_pixels: HashMap<(u32, UVec3, u8), Bits> = HashMap::new();
    let top = views.iter().map(|view| view.cell.0).max().unwrap_or(0);
    for level in (0..=top).rev() {
        let select_view = |(number, view): (usize, &Placed<'_>)| {
            let parent = parent_of(view.cell);
            if view.cell.0 != level || !is_selected(view) {
                return None;
            }
            let has_parent = partial.contains(&parent);
            let selector = PixelSelector::new(view, rule, band, has_parent);
            let pixels = selector.select(coarse_pixels.get(&(parent.0, parent.1, view.direction)));
            let pitch = selector.blocks_per_row;
            let select_splats = |layer: &&Splats| Some(layer.select(|block| pixels.drawn[block_number(block, pitch)]));
            Some((number, view.layers.iter().map(select_splats).collect(), pixels.coarse))
        };
        let selected: Vec<(usize, Vec<_>, Bits)> = views.par_iter().enumerate().filter_map(select_view).collect();
        for (number, layers, coarse) in selected {
            let view = &views[number];
            selections[number] = layers;
            if view.is_partial {
                coarse_pixels.insert((view.cell.0, view.cell.1, view.direction), coarse);
            }
        }
    }
    Ok(selections)
}

/// Estimates from the distances of the blocks' centres how many splats are drawn.
pub fn expected(views: &[Placed<'_>], rule: &Rule) -> f64 {
    let partial = partial_cells(views);
    let count_in_view = |view: &Placed<'_>| -> f64 {
        let all_splats = || view.layers.iter().map(|layer| layer.count() as f64).sum();
        let has_parent = partial.contains(&parent_of(view.cell));
        let Some(band) = rule.band.filter(|_| view.is_partial || has_parent) else { return all_splats() };
        let fraction = |distance: f64, level: u32| ((distance / rule.start(level) - 1.0) / band).clamp(0.0, 1.0);
        let count_in_block = |layer: &Splats, block: &Block| {
            let middle = |axis: usize| f64::from(block.extent.low[axis] + block.extent.high[axis]) / 2.0;
            let distance = rule.apparent(layer.place(middle(0), middle(1), middle(2)));
            let coarse = if view.is_partial { fraction(distance, view.cell.0) } else { 1.0 };
            let covered = if has_parent { fraction(distance, view.cell.0 + 1) } else { 0.0 };
            f64::from(block.shown.count_ones()) * (coarse - covered).max(0.0)
        };
        view.layers.iter().flat_map(|layer| layer.blocks.iter().map(move |block| count_in_block(layer, block))).sum()
    };
    // Summed in the order of the views, so that the sum does not depend on the number of threads.
    views.par_iter().map(count_in_view).collect::<Vec<f64>>().iter().sum()
}

fn partial_cells(views: &[Placed<'_>]) -> HashSet<(u32, UVec3)> {
    views.iter().filter(|view| view.is_partial).map(|view| view.cell).collect()
}

fn parent_of((level, place): (u32, UVec3)) -> (u32, UVec3) {
    (level + 1, place / 2)
}

/// Returns the number of a block, counted row by row.
fn block_number(block: &Block, blocks_per_row: usize) -> usize {
    let [column, row] = block.corner.map(usize::from);
    row / BLOCK * blocks_per_row + column / BLOCK
}

/// Returns a hash, from 0 to 1, of the position of a pixel.
#[inline(always)]
fn hash((level, place): (u32, UVec3), direction: u8, pixel: usize) -> f64 {
    let [x, y, z] = place.to_array().map(u64::from);
    random::uniform(u64::from(level) << 8 | u64::from(direction), x | y << 21 | z << 42, pixel as u64)
}

/// Selected pixels of a view.
struct SelectedPixels {
    drawn: Bits,
    /// Pixels that are coarse enough or covered.
    coarse: Bits,
}

/// Selection of the pixels of one view.
struct PixelSelector<'a> {
    view: &'a Placed<'a>,
    first: &'a Splats,
    rule: &'a Rule,
    band: f64,
    blocks_per_row: usize,
    /// Whether the parent is partially drawn.
    has_parent: bool,
    /// First column and row in the parent's picture of twice its size.
    offset: [usize; 2],
    /// Centre of the first pixel, half a depth step before the front; and the vectors of a column, a row and a step.
    start: DVec3,
    steps: [DVec3; 3],
}

impl<'a> PixelSelector<'a> {
    fn new(view: &'a Placed<'a>, rule: &'a Rule, band: f64, has_parent: bool) -> Self {
        let first = view.layers[0];
        let octant = IVec3::from_array((view.cell.1 % 2).to_array().map(|n| n as i32));
        let (column, row) = first.frame.place(octant, first.format.size);
        let blocks_per_row = first.format.size.div_ceil(BLOCK);
        let (start, steps) = (first.place(0.5, 0.5, -0.5), first.steps());
        Self { view, first, rule, band, blocks_per_row, has_parent, offset: [column, row], start, steps }
    }

    /// Selects pixels. `parent` marks the pixels of the parent's view from the same direction that are coarse enough or
    /// covered. Without that view, the distances of this view's surfaces decide whether pixels are covered.
    fn select(&self, parent: Option<&Bits>) -> SelectedPixels {
        let count = self.blocks_per_row * self.blocks_per_row;
        let mut selected = SelectedPixels { drawn: vec![0; count], coarse: vec![0; count] };
        for block in &self.first.blocks {
            let texels = &self.first.texels[block.first as usize..];
            let (mut shown, mut coarse, mut covered) = (block.shown, 0u64, 0u64);
            for texel in texels.iter().take(block.shown.count_ones() as usize) {
                let bit = shown.trailing_zeros();
                let [column, row] = [bit as usize % BLOCK, bit as usize / BLOCK];
                let pixel = [usize::from(block.corner[0]) + column, usize::from(block.corner[1]) + row];
                let distance = self.apparent(pixel, texel.depth());
                covered |= u64::from(self.has_parent && self.is_covered(pixel, distance, parent)) << bit;
                coarse |= u64::from(!self.view.is_partial || self.is_coarse(self.view.cell, pixel, distance)) << bit;
                shown &= shown - 1;
            }
            let number = block_number(block, self.blocks_per_row);
            (selected.drawn[number], selected.coarse[number]) = (coarse & !covered, coarse | covered);
        }
        selected
    }

    fn apparent(&self, [column, row]: [usize; 2], depth: u16) -> f64 {
        let [by_column, by_row, by_depth] = self.steps;
        self.rule.apparent(self.start + by_column * column as f64 + by_row * row as f64 + by_depth * f64::from(depth))
    }

    fn is_coarse(&self, cell: (u32, UVec3), [column, row]: [usize; 2], distance: f64) -> bool {
        let pixel = row * self.first.format.size + column;
        distance >= self.rule.start(cell.0) * (1.0 + self.band * hash(cell, self.view.direction, pixel))
    }

    fn is_covered(&self, pixel: [usize; 2], distance: f64, parent: Option<&Bits>) -> bool {
        let [column, row] = [0, 1].map(|axis| (self.offset[axis] + pixel[axis]) / 2);
        let Some(bits) = parent else { return self.is_coarse(parent_of(self.view.cell), [column, row], distance) };
        bits[row / BLOCK * self.blocks_per_row + column / BLOCK] >> (BLOCK * (row % BLOCK) + column % BLOCK) & 1 == 1
    }
}
