//! Kernels of a picture, and calls that draw its pieces: nearest first in a few batches, grouped by page within each
//! batch.

use std::ops::Range;

use nearfar_core::base::Result;
use nearfar_core::orthoview::splat::{BORDER, HEAD, LANE_BITS, MIN_COSINE, Piece, SQUARED_RADIUS};
use wgpu::BindingResource;

use crate::compute::programs::{Program, Work};
use crate::draw::shading_constants;

/// Fractions of a picture's splats, as powers of ½, after which the farthest depths of tiles are updated.
const BATCHES: [u32; 5] = [4, 3, 2, 1, 0];

/// A call for some pieces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Call {
    pub pieces: Range<u32>,
    /// Page of their views.
    pub page: u32,
    /// Whether it begins a batch.
    pub begins_batch: bool,
}

/// Returns the calls for pieces in order of distance, and sorts the pieces by page within their batches; `page_of`
/// returns the page of a view.
pub(super) fn calls(pieces: &mut [Piece], page_of: impl Fn(u32) -> u32) -> Vec<Call> {
    let mut calls = Vec::new();
    for batch in batches(pieces) {
        let batch_pieces = &mut pieces[batch.start as usize..batch.end as usize];
        batch_pieces.sort_by_key(|piece| page_of(piece.view));
        let mut first = batch.start;
        for group in batch_pieces.chunk_by(|a, b| page_of(a.view) == page_of(b.view)) {
            let end = first + group.len() as u32;
            calls.push(Call { pieces: first..end, page: page_of(group[0].view), begins_batch: first == batch.start });
            first = end;
        }
    }
    calls
}

/// Divides pieces into batches at the fractions of the splats; the last batch has the rest.
fn batches(pieces: &[Piece]) -> Vec<Range<u32>> {
    let total: u64 = pieces.iter().map(|piece| u64::from(piece.count)).sum();
    let (mut batches, mut drawn, mut start) = (Vec::new(), 0, 0);
    let mut ends = BATCHES.iter().map(|power| total >> power).peekable();
    for (number, piece) in (1..).zip(pieces) {
        drawn += u64::from(piece.count);
        if ends.next_if(|end| drawn >= *end).is_some() {
            while ends.next_if(|end| drawn >= *end).is_some() {}
            batches.push(start..number);
            start = number;
        }
    }
    if (start as usize) < pieces.len() {
        batches.push(start..pieces.len() as u32);
    }
    batches
}

const LIGHT: &str = include_str!("../shaders/light.wgsl");
const SPLAT: &str = include_str!("../shaders/splat.wgsl");
const WORDS: &str = include_str!("../shaders/splat_words.wgsl");
const PAGE: &str = include_str!("../shaders/splat_page.wgsl");
const PAGES: &str = include_str!("../shaders/splat_pages.wgsl");
const DRAW: &str = include_str!("../shaders/splat_draw.wgsl");
const KEY_64: &str = include_str!("../shaders/splat_key64.wgsl");
const KEY_32: &str = include_str!("../shaders/splat_key32.wgsl");
const TILES: &str = include_str!("../shaders/splat_tiles.wgsl");
const RESOLVE: &str = include_str!("../shaders/splat_resolve.wgsl");

#[derive(Clone, Copy)]
pub(super) enum Kernel {
    /// Draws pieces of views in one page.
    Draw,
    /// Computes the farthest depth order of each tile.
    Tiles,
    /// Converts keys to colours.
    Resolve,
}

/// Kernels of a picture.
pub(super) struct Kernels {
    /// Whether rays are parallel.
    pub is_parallel: bool,
    /// Whether 64-bit atomics are used.
    pub is_long: bool,
}

impl Kernels {
    /// Encodes a kernel; resources come with their binding numbers.
    pub fn run(
        &self,
        work: &mut Work<'_>,
        kernel: Kernel,
        resources: &[(u32, BindingResource<'_>)],
        groups: [u32; 2],
    ) -> Result<()> {
        let numbers = numbers();
        let key = if self.is_long { KEY_64 } else { KEY_32 };
        let (entry, text) = match kernel {
            Kernel::Draw => ("splat_draw", [&numbers, SPLAT, PAGE, WORDS, key, DRAW].concat()),
            Kernel::Tiles => ("splat_tiles", [&numbers, SPLAT, TILES].concat()),
            Kernel::Resolve => {
                ("splat_resolve", [&numbers, &shading_constants()[..], LIGHT, SPLAT, PAGES, WORDS, RESOLVE].concat())
            }
        };
        let constants = [("PARALLEL", u32::from(self.is_parallel)), ("LONG", u32::from(self.is_long))];
        work.run(&Program { text: &[&text], entry, constants: &constants, group: 0 }, resources, groups)
    }
}

/// Returns the constants that shaders share with the processor's kernels.
fn numbers() -> String {
    let epsilon = f32::EPSILON;
    format!(
        "const HEAD: u32 = {HEAD}u;\nconst LANE_BITS: u32 = {LANE_BITS}u;\nconst SQUARED_RADIUS: f32 = {SQUARED_RADIUS:?};\n\
         const BORDER: f32 = {BORDER:?};\nconst MIN_COSINE: f32 = {MIN_COSINE:?};\n\
         const EPSILON: f32 = {epsilon:?};\nconst MAX: f32 = 0x1.fffffep+127f;\n"
    )
}

#[cfg(test)]
mod tests {
    use bytemuck::Zeroable;

    use super::*;

    fn pieces(counts: &[u32]) -> Vec<Piece> {
        (0..).zip(counts).map(|(view, &count)| Piece { count, view, ..Piece::zeroed() }).collect()
    }

    #[test]
    fn batches_partition_the_pieces_and_grow() {
        assert_eq!(batches(&pieces(&[64; 32])), [0..2, 2..4, 4..8, 8..16, 16..32]);
        assert_eq!(batches(&pieces(&[1000, 1, 1])), [0..1, 1..3]);
        // Pieces of split splats may have a count of 0.
        assert_eq!(batches(&pieces(&[5, 0, 0])), [0..1, 1..3]);
        assert_eq!(batches(&pieces(&[0, 0])), [0..1, 1..2]);
        assert_eq!(batches(&[]), Vec::<Range<u32>>::new());
    }

    #[test]
    fn calls_have_one_page_each_and_stay_in_their_batches() {
        let mut own = pieces(&[64; 32]);
        let found = calls(&mut own, |view| view % 3 / 2);
        let all: Vec<u32> = found.iter().flat_map(|call| call.pieces.clone()).collect();
        assert_eq!(all, (0..32).collect::<Vec<_>>());
        for call in &found {
            assert!(call.pieces.clone().all(|n| own[n as usize].view % 3 / 2 == call.page));
        }
        let begins: Vec<u32> = found.iter().filter(|call| call.begins_batch).map(|call| call.pieces.start).collect();
        assert_eq!(begins, [0, 2, 4, 8, 16]);
        let mut seen: Vec<u32> = own[16..].iter().map(|piece| piece.view).collect();
        seen.sort_unstable();
        assert_eq!(seen, (16..32).collect::<Vec<_>>());
    }
}
