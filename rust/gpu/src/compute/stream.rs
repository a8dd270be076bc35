//! Processing of arrays of any length in pieces: while the device works on one, the next is uploaded.

use std::collections::VecDeque;
use std::ops::Range;

use nearfar_core::base::{Progress, Result};

use super::memory::{LentBuffer, Results, copy};
use super::programs::Work;
use crate::device::Device;

/// Bytes of a piece: large enough that the cost of a call is small, small enough that several pieces are in flight.
const PIECE_BYTES: u64 = 1 << 24;
/// Pieces in flight.
const PIECES_AHEAD: usize = 2;

/// Runs rows through a kernel: `encode` gets work, input, results, and the piece's rows. Rows are 4-byte words.
pub(super) fn stream<'a>(
    device: &'a Device,
    points: &[[f32; 3]],
    (out, row_bytes): (&mut [u8], usize),
    progress: &Progress,
    mut encode: impl FnMut(&mut Work<'a>, &LentBuffer<'_>, &LentBuffer<'_>, Range<usize>) -> Result<()>,
) -> Result<()> {
    let widest = row_bytes.max(size_of::<[f32; 3]>()) as u64;
    let rows = (PIECE_BYTES.min(device.largest_binding()) / widest).max(1) as usize;
    let mut under_way: VecDeque<Piece<'_, '_>> = VecDeque::new();
    progress.expect(points.len() as u64);
    for (n, (from, to)) in points.chunks(rows).zip(out.chunks_mut(rows * row_bytes)).enumerate() {
        let input = LentBuffer::input(device, size_of_val(from) as u64)?;
        input.fill(bytemuck::cast_slice(from), progress)?;
        let results = Results::new(device, to.len() as u64)?;
        let mut work = Work::new(device);
        encode(&mut work, &input, &results.on_device, n * rows..n * rows + from.len())?;
        results.bring(&mut work.encoder);
        work.submit(progress)?;
        under_way.push_back(Piece { results, to, _input: input });
        if under_way.len() == PIECES_AHEAD
            && let Some(first) = under_way.pop_front()
        {
            first.end(progress, row_bytes)?;
        }
    }
    under_way.into_iter().try_for_each(|piece| piece.end(progress, row_bytes))
}

struct Piece<'a, 'b> {
    results: Results<'a>,
    to: &'b mut [u8],
    _input: LentBuffer<'a>,
}

impl Piece<'_, '_> {
    fn end(self, progress: &Progress, row_bytes: usize) -> Result<()> {
        let Self { results, to, .. } = self;
        let rows = (to.len() / row_bytes) as u64;
        results.read(progress, |bytes| copy(to, bytes))?;
        progress.report(rows)
    }
}
