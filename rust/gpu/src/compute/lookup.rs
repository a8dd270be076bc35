//! Look-up of a cube map's ranges along many directions.

use bytemuck::{Pod, Zeroable};
use nearfar_core::base::{Error, Progress, Result};
use nearfar_core::cubemap::MAX_SIZE;
use wgpu::BufferUsages;

use super::memory::{LentBuffer, Results};
use super::programs::{Program, groups};
use super::stream::stream;
use crate::device::Device;

/// Selection among the texels around a direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filter {
    /// The texel that the direction hits.
    Nearest,
    /// Minimum of the texels that the seamless bilinear filter would mix.
    Min,
    /// Maximum of these texels.
    Max,
}

/// Six faces of `size`² texels of `channels` values each.
#[derive(Clone, Copy, Debug)]
pub struct CubeMap<'a> {
    /// Values of all texels.
    pub values: &'a [f32],
    /// Texels across a face.
    pub size: u32,
    /// Values per texel.
    pub channels: u32,
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

/// Writes the map's values along directions of any length; fails at the first that is zero or not finite.
pub fn lookup(
    device: &Device,
    map: CubeMap<'_>,
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
        entry: match filter {
            Filter::Nearest => "lookup_nearest",
            Filter::Min => "lookup_least",
            Filter::Max => "lookup_greatest",
        },
        constants: &[],
        group: 2,
    };
    let faces = LentBuffer::input(device, size_of_val(map.values) as u64)?;
    faces.fill(bytemuck::cast_slice(map.values), progress)?;
    let wrong = Results::new(device, 4)?;
    let out = (bytemuck::cast_slice_mut(out), 4 * map.channels as usize);
    let mut cleared = false;
    stream(device, directions, out, progress, |work, input, results, rows| {
        if !std::mem::replace(&mut cleared, true) {
            work.encoder.clear_buffer(&wrong.on_device, 0, Some(4));
        }
        let block = LookupBlock {
            map: [map.size, map.channels, 0, 0],
            // Counted from the end, so that the largest number is that of the first invalid direction.
            rows: [rows.len() as u32, (directions.len() - rows.start) as u32, 0, 0],
        };
        let uniform = device.filled_buffer("lookup", bytemuck::cast_slice(&[block]), BufferUsages::UNIFORM)?;
        let resources = [
            (0, uniform.as_entire_binding()),
            (1, faces.binding()),
            (2, input.binding()),
            (3, results.binding()),
            (4, wrong.on_device.binding()),
        ];
        work.run(&program, &resources, groups(rows.len() as u32))?;
        if rows.end == directions.len() {
            wrong.bring(&mut work.encoder);
        }
        Ok(())
    })?;
    let last = wrong.read(progress, |bytes| bytes.first_chunk().copied().map_or(0, u32::from_ne_bytes))?;
    match last {
        0 => Ok(()),
        last => {
            let index = directions.len() - last as usize;
            Err(Error::value(
                "directions",
                "finite vectors other than zero",
                format!("something else at index {index}"),
            ))
        }
    }
}

fn check(device: &Device, map: &CubeMap<'_>, directions: usize, room: usize) -> Result<()> {
    if !(1..=MAX_SIZE).contains(&map.size) {
        return Err(Error::value("faces", format!("1 to {MAX_SIZE} texels across a face"), map.size));
    }
    let (size, channels) = (map.size as usize, map.channels as usize);
    if map.values.len() != 6 * size * size * channels || room != directions * channels {
        return Err(Error::value("faces", format!("{} values", 6 * size * size * channels), map.values.len()));
    }
    if channels > MAX_CHANNELS {
        return Err(Error::value("faces", format!("up to {MAX_CHANNELS} values of a texel"), channels));
    }
    if u32::try_from(directions).is_err() {
        return Err(Error::value("directions", "fewer than 2³²", directions));
    }
    let (bytes, most) = (size_of_val(map.values) as u64, device.largest_binding());
    if bytes > most {
        let label = device.report().label();
        return Err(Error::Device(format!(
            "{label}: faces of {bytes} bytes, {most} can be read at a time; use nearfar.cube_lookup"
        )));
    }
    Ok(())
}
