//! Environment map as texels: colour, and range if the map has it. Texels are numbered as in the map.

use half::f16;
use nearfar_core::base::Result;
use nearfar_core::cubemap::EnvironmentMap;
use rayon::prelude::*;
use wgpu::TextureFormat;

use super::Texels;
use super::materials::half_rgba;
use crate::device::Device;

/// An environment map on the device.
pub(crate) struct EnvTexels {
    pub size: u32,
    pub color: Texels,
    /// Ranges; one placeholder texel if the map has none.
    pub range: Texels,
    pub has_range: bool,
}

impl EnvTexels {
    pub fn new(device: &Device, map: Option<&EnvironmentMap>) -> Result<Self> {
        let (size, count) = map.map_or((0, 0), |map| (map.size, map.color.len() as u64));
        let color = Texels::new(device, "map's colour", TextureFormat::Rgba16Float, 8, count)?;
        let range = map.and_then(|map| map.range.as_ref());
        let texels =
            Texels::new(device, "map's range", TextureFormat::R32Float, 4, range.map_or(0, |r| r.len() as u64))?;
        if let Some(map) = map {
            // A few rows at a time: a full copy would double the memory of a large map.
            let rows = 1usize << color.shift.max(20);
            for (n, part) in map.color.chunks(rows).enumerate() {
                let halves: Vec<[f16; 4]> = part.par_iter().map(|&rgb| half_rgba(rgb)).collect();
                color.write(device, (n * rows) as u64, bytemuck::cast_slice(&halves));
            }
        }
        if let Some(range) = range {
            texels.write(device, 0, bytemuck::cast_slice(&range[..]));
        }
        Ok(Self { size, color, range: texels, has_range: range.is_some() })
    }
}
