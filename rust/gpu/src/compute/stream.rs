//! Processing of arrays of any length in pieces: while the device works on one, the next is uploaded.

use std::collections::VecDeque;
use std::ops::Range;

use nearfar_core::base::{Progress, Result};

use super::memory::{LentBuffer, Results, parallel_copy};
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
    let max_row_bytes = row_bytes.max(size_of::<[f32; 3]>()) as u64;
    let rows = (PIECE_BYTES.min(device.largest_binding()) / max_row_bytes).max(1) as usize;
    let mut in_flight: VecDeque<Piece<'_, '_>> = VecDeque::new();
    progress.expect(points.len() as u64);
    let read = |Piece { results, out, .. }: Piece<'_, '_>| {
        let rows = (out.len() / row_bytes) as u64;
        results.read(progress, |bytes| parallel_copy(out, bytes))?;
        progress.report(rows)
    };
    for (n, (points, out)) in points.chunks(rows).zip(out.chunks_mut(rows * row_bytes)).enumerate() {
        let input = LentBuffer::input(device, size_of_val(points) as u64)?;
        input.fill(bytemuck::cast_slice(points), progress)?;
        let results = Results::new(device, out.len() as u64)?;
        let mut work = Work::new(device);
        encode(&mut work, &input, &results.on_device, n * rows..n * rows + points.len())?;
        results.encode_copy(&mut work.encoder);
        work.submit(progress)?;
        in_flight.push_back(Piece { results, out, _input: input });
        if in_flight.len() == PIECES_AHEAD {
            in_flight.pop_front().map_or(Ok(()), read)?;
        }
    }
    in_flight.into_iter().try_for_each(read)
}

/// Submitted work, and the memory that its results are copied to.
struct Piece<'a, 'b> {
    results: Results<'a>,
    out: &'b mut [u8],
    _input: LentBuffer<'a>,
}
