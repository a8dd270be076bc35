//! Kernels on arrays of any length: look-up of a cube map's ranges along many directions, and morph of float32 points.
//! Arrays are processed in pieces: while the device works on one, the next is uploaded.

use std::collections::VecDeque;
use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use nearfar_core::base::{Error, Progress, Result};
use nearfar_core::cubemap::CubeFaces;
use nearfar_core::morph::{Kind, Morph};
use wgpu::BufferUsages;

use super::memory::{PooledBuffer, Results, parallel_copy};
use super::programs::{Program, Work, groups};
use crate::device::Device;

/// Bytes of a piece: large enough that the cost of a call is small, small enough that several pieces are in flight.
const PIECE_BYTES: u64 = 1 << 24;
/// Pieces in flight.
const MAX_IN_FLIGHT: usize = 2;

/// Runs a kernel on an array of any length, piece by piece. `encode` encodes the kernel for one piece, given the input,
/// the results and the range of the piece's rows. Rows consist of 4-byte words.
fn run_in_pieces<'a>(
    device: &'a Device,
    points: &[[f32; 3]],
    (out, row_bytes): (&mut [u8], usize),
    progress: &Progress,
    mut encode: impl FnMut(&mut Work<'a>, &PooledBuffer<'_>, &PooledBuffer<'_>, Range<usize>) -> Result<()>,
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
        let input = PooledBuffer::input(device, size_of_val(points) as u64)?;
        input.fill(bytemuck::cast_slice(points), progress)?;
        let results = Results::new(device, out.len() as u64)?;
        let mut work = Work::new(device);
        encode(&mut work, &input, &results.on_device, n * rows..n * rows + points.len())?;
        results.encode_copy(&mut work.encoder);
        work.submit(progress)?;
        in_flight.push_back(Piece { results, out, _input: input });
        if in_flight.len() == MAX_IN_FLIGHT {
            in_flight.pop_front().map_or(Ok(()), read)?;
        }
    }
    in_flight.into_iter().try_for_each(read)
}

/// Submitted work, and the memory that its results are copied to.
struct Piece<'a, 'b> {
    results: Results<'a>,
    out: &'b mut [u8],
    _input: PooledBuffer<'a>,
}

/// Selection among the texels around a direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filter {
    /// The texel that the direction hits.
    Nearest,
    /// Minimum of the texels that the seamless bilinear filter would mix.
    Min,
    /// Maximum of the same texels.
    Max,
}

/// Maximum number of values per texel: software drivers end loops after 65,535 iterations.
const MAX_CHANNELS: usize = 1 << 12;

/// The uniform block `Lookup` of `compute_lookup.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct LookupBlock {
    map: [u32; 4],
    rows: [u32; 4],
}

/// Writes the map's values along directions of any length; the error names the first direction that is zero or not
/// finite.
pub fn lookup(
    device: &Device,
    map: CubeFaces<'_, f32>,
    directions: &[[f32; 3]],
    filter: Filter,
    out: &mut [f32],
    progress: &Progress,
) -> Result<()> {
    device.check()?;
    check(device, &map, directions.len(), out.len())?;
    if out.is_empty() {
        return Ok(());
    }
    let program = Program {
        text: &[
            include_str!("../shaders/scene.wgsl"),
            include_str!("../shaders/one_view.wgsl"),
            include_str!("../shaders/cube.wgsl"),
            include_str!("../shaders/compute_lookup.wgsl"),
        ],
        entry: "lookup_values",
        constants: &[("FILTER", filter as u32)],
        group: 2,
    };
    let faces = PooledBuffer::input(device, size_of_val(map.values) as u64)?;
    faces.fill(bytemuck::cast_slice(map.values), progress)?;
    let invalid = Results::new(device, 4)?;
    let out = (bytemuck::cast_slice_mut(out), 4 * map.channels);
    run_in_pieces(device, directions, out, progress, |work, input, results, rows| {
        if rows.start == 0 {
            work.encoder.clear_buffer(&invalid.on_device, 0, Some(4));
        }
        let block = LookupBlock {
            map: [map.size, map.channels as u32, 0, 0],
            // Directions are numbered from the end, so that the first invalid one has the largest number.
            rows: [rows.len() as u32, (directions.len() - rows.start) as u32, 0, 0],
        };
        let uniform = device.filled_buffer("lookup", &[block], BufferUsages::UNIFORM)?;
        let resources = [
            (0, uniform.as_entire_binding()),
            (1, faces.binding()),
            (2, input.binding()),
            (3, results.binding()),
            (4, invalid.on_device.binding()),
        ];
        work.run(&program, &resources, groups(rows.len() as u32))?;
        if rows.end == directions.len() {
            invalid.encode_copy(&mut work.encoder);
        }
        Ok(())
    })?;
    match invalid.read_word(progress)? as usize {
        0 => Ok(()),
        count_to_end => {
            let index = directions.len() - count_to_end;
            let got = format!("zero, infinity or NaN at index {index}");
            Err(Error::value("directions", "finite vectors other than zero", got))
        }
    }
}

fn check(device: &Device, map: &CubeFaces<'_, f32>, directions: usize, out: usize) -> Result<()> {
    if out != directions * map.channels {
        return Err(Error::value("out", format!("{} values", directions * map.channels), out));
    }
    if map.channels > MAX_CHANNELS {
        return Err(Error::value("faces", format!("up to {MAX_CHANNELS} values of a texel"), map.channels));
    }
    if u32::try_from(directions).is_err() {
        return Err(Error::value("directions", "fewer than 2³²", directions));
    }
    let (bytes, max_bytes) = (size_of_val(map.values) as u64, device.largest_binding());
    if bytes > max_bytes {
        let message = format!("faces of {bytes} bytes, {max_bytes} can be read at a time; use nearfar.cube_lookup");
        return Err(device.error(message));
    }
    Ok(())
}

/// The uniform block `Morph` of `compute_morph.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct MorphBlock {
    center_high: [f32; 4],
    center_low: [f32; 4],
    offset: [f32; 4],
    radii: [f32; 4],
    count: [u32; 4],
}

/// Writes the morphed points.
pub fn morph(
    device: &Device,
    morph: &Morph,
    points: &[[f32; 3]],
    displayed: &mut [[f32; 3]],
    progress: &Progress,
) -> Result<()> {
    device.check()?;
    let program = Program {
        text: &[
            include_str!("../shaders/morph.wgsl"),
            include_str!("../shaders/world.wgsl"),
            include_str!("../shaders/compute_morph.wgsl"),
        ],
        entry: "morph_points",
        constants: &[("KEEPS_RHO", u32::from(morph.kind == Kind::Cylinder))],
        group: 0,
    };
    let out = (bytemuck::cast_slice_mut(displayed), size_of::<[f32; 3]>());
    run_in_pieces(device, points, out, progress, |work, input, results, rows| {
        let block = morph_block(morph, rows.len());
        let uniform = device.filled_buffer("morph", &[block], BufferUsages::UNIFORM)?;
        let resources = [(0, uniform.as_entire_binding()), (1, input.binding()), (2, results.binding())];
        work.run(&program, &resources, groups(rows.len() as u32))
    })
}

fn morph_block(morph: &Morph, points: usize) -> MorphBlock {
    // The centre is the sum of two float32 vectors; one alone would be off by up to a metre at 10⁷ m.
    let high = morph.center.as_vec3();
    let low = (morph.center - high.as_dvec3()).as_vec3();
    // `zones_of` of `world.wgsl` in float64. If both radii are 0, nothing is near: w is 0, and all points move.
    let slope = if morph.r2 > 0.0 { 1.0 / (morph.r2 - morph.r1) } else { 0.0 };
    let fixed_radius = if morph.r2 > 0.0 && morph.strength == 1.0 { morph.r1 } else { -1.0 };
    MorphBlock {
        center_high: high.extend(morph.strength as f32).to_array(),
        center_low: low.extend(0.0).to_array(),
        offset: (morph.user - morph.center).as_vec3().extend(0.0).to_array(),
        radii: [fixed_radius, morph.r2, slope, 0.0].map(|x| x as f32),
        count: [points as u32, 0, 0, 0],
    }
}
