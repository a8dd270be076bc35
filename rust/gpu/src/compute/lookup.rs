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
        entry: if filter == Filter::Nearest { "lookup_nearest" } else { "lookup_extreme" },
        constants: &[("IS_MAX", u32::from(filter == Filter::Max))],
        group: 2,
    };
    let faces = LentBuffer::input(device, size_of_val(map.values) as u64)?;
    faces.fill(bytemuck::cast_slice(map.values), progress)?;
    let invalid = Results::new(device, 4)?;
    let out = (bytemuck::cast_slice_mut(out), 4 * map.channels as usize);
    stream(device, directions, out, progress, |work, input, results, rows| {
        if rows.start == 0 {
            work.encoder.clear_buffer(&invalid.on_device, 0, Some(4));
        }
        let block = LookupBlock {
            map: [map.size, map.channels, 0, 0],
            // Counter from the end, so that the largest number is that of the first invalid direction.
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
            let got = format!("something else at index {index}");
            Err(Error::value("directions", "finite vectors other than zero", got))
        }
    }
}

fn check(device: &Device, map: &CubeMap<'_>, directions: usize, out: usize) -> Result<()> {
    if !(1..=MAX_SIZE).contains(&map.size) {
        return Err(Error::value("faces", format!("1 to {MAX_SIZE} texels across a face"), map.size));
    }
    let channels = map.channels as usize;
    let count = 6 * (map.size as usize).pow(2) * channels;
    if map.values.len() != count || out != directions * channels {
        return Err(Error::value("faces", format!("{count} values"), map.values.len()));
    }
    if channels > MAX_CHANNELS {
        return Err(Error::value("faces", format!("up to {MAX_CHANNELS} values of a texel"), channels));
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
