//! Linear memory for texels: a texture array that shaders index by texel number. It holds environment maps, and the mip
//! levels of textures in linear light, beside tables of materials and textures.
//!
//! Buffer bindings are limited to 128 MiB on some adapters; a texture array is limited only to many gigabytes, and
//! images of any size are stored in it without packing.

use half::f16;
use nearfar_core::base::memory::try_with_capacity;
use nearfar_core::base::{Progress, Result};
use nearfar_core::cubemap::EnvironmentMap;
use nearfar_core::scene::srgb::linear_from_srgb;
use nearfar_core::scene::{Alpha, Material, Scene, Texture};
use rayon::prelude::*;
use wgpu::{
    BufferUsages, Extent3d, TexelCopyBufferLayout, TextureAspect, TextureDescriptor, TextureDimension, TextureFormat,
    TextureUsages, TextureView, TextureViewDescriptor, TextureViewDimension,
};

use crate::device::{Counter, Device};

/// Numbered texels of one format.
pub(crate) struct Texels {
    texture: wgpu::Texture,
    pub view: TextureView,
    /// Base-2 logarithm of the texels per row, and of the rows per layer.
    pub shift: u32,
    bytes: u32,
}

impl Texels {
    /// Allocates a number of texels of `bytes` each, at least one.
    pub fn new(device: &Device, label: &str, format: TextureFormat, bytes: u32, count: u64) -> Result<Self> {
        // OpenGL has no texture views, so a texture of one layer cannot be used as an array there.
        let min_layers = if device.report().backend == "gl" { 2 } else { 1 };
        let side = (count.max(1).div_ceil(min_layers) as f64).sqrt().ceil() as u64;
        let shift = side.next_power_of_two().ilog2().min(device.limits.max_texture_dimension_2d.ilog2());
        let rows = count.max(1).div_ceil(1 << shift);
        let layers = rows.div_ceil(1 << shift).max(min_layers);
        if layers > u64::from(device.limits.max_texture_array_layers) || count > u64::from(u32::MAX) {
            let message = "texels are more than it addresses; try smaller textures, or backend='cpu'";
            return Err(device.error(format!("{count} {message}")));
        }
        // wgpu takes a square texture of six layers for a cube map on OpenGL.
        let depth_or_array_layers = if layers == 6 { 7 } else { layers as u32 };
        let height = if layers > 1 { 1 << shift } else { rows as u32 };
        let size = Extent3d { width: 1 << shift, height, depth_or_array_layers };
        let texture = device.texture(
            &TextureDescriptor {
                label: Some(label),
                size,
                mip_level_count: 1,
                sample_count: 1,
                dimension: TextureDimension::D2,
                format,
                usage: TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_DST,
                view_formats: &[],
            },
            u64::from(size.width) * u64::from(size.height) * u64::from(depth_or_array_layers) * u64::from(bytes),
        )?;
        let view = texture.create_view(&TextureViewDescriptor {
            dimension: Some(TextureViewDimension::D2Array),
            ..TextureViewDescriptor::default()
        });
        Ok(Self { texture, view, shift, bytes })
    }

    /// Writes texels from number `first` on, which must be the first of a row.
    pub fn write(&self, device: &Device, first: u64, data: &[u8]) {
        let row = 1u64 << self.shift;
        debug_assert_eq!(first % row, 0);
        let mut next = first;
        let mut remaining = data;
        while !remaining.is_empty() {
            let texels = remaining.len() as u64 / u64::from(self.bytes);
            let y = (next >> self.shift) & (row - 1);
            // The remaining whole rows of the layer, or else the beginning of one row.
            let rows = (texels >> self.shift).min(row - y);
            let (width, height) = if rows > 0 { (row, rows) } else { (texels, 1) };
            let layer = (next >> (2 * self.shift)) as u32;
            let size = (width * height * u64::from(self.bytes)) as usize;
            let target = wgpu::TexelCopyTextureInfo {
                texture: &self.texture,
                mip_level: 0,
                origin: wgpu::Origin3d { x: 0, y: y as u32, z: layer },
                aspect: TextureAspect::All,
            };
            let layout = TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(width as u32 * self.bytes),
                rows_per_image: None,
            };
            let extent = Extent3d { width: width as u32, height: height as u32, depth_or_array_layers: 1 };
            device.with_queue(|queue| queue.write_texture(target, &remaining[..size], layout, extent));
            remaining = &remaining[size..];
            next += width * height;
        }
        device.count(Counter::UploadedBytes, data.len() as u64);
    }
}

/// An environment map on the device; texels are numbered as in the map.
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
        let ranges = map.and_then(|map| map.range.as_ref());
        let count = ranges.map_or(0, |ranges| ranges.len() as u64);
        let range = Texels::new(device, "map's range", TextureFormat::R32Float, 4, count)?;
        if let Some(map) = map {
            // Some rows at a time, because a full copy would double the memory of a large map.
            let rows = 1usize << color.shift.max(20);
            for (n, part) in map.color.chunks(rows).enumerate() {
                let halves: Vec<[f16; 4]> = part.par_iter().map(|&rgb| half_rgba(rgb)).collect();
                color.write(device, (n * rows) as u64, bytemuck::cast_slice(&halves));
            }
        }
        if let Some(ranges) = ranges {
            range.write(device, 0, bytemuck::cast_slice(&ranges[..]));
        }
        Ok(Self { size, color, range, has_range: ranges.is_some() })
    }
}

/// Converts linear light to half floats, clamped to their maximum finite value.
fn half_rgba([r, g, b]: [f32; 3]) -> [f16; 4] {
    let half = |x: f32| f16::from_f32(x.min(65504.0));
    [half(r), half(g), half(b), f16::ONE]
}

/// Words of a material and of a texture in their tables.
const MATERIAL_WORDS: usize = 12;
const TEXTURE_WORDS: usize = 8;
/// Texture number of a material without a texture.
const NONE: u32 = u32::MAX;

pub(crate) struct MaterialTable {
    pub materials: wgpu::Buffer,
    pub textures: wgpu::Buffer,
    pub texels: Texels,
    /// Whether some material has a texture.
    pub textured: bool,
    /// Whether some material emits light or is unlit.
    pub glowing: bool,
}

impl MaterialTable {
    pub fn new(device: &Device, scene: &Scene) -> Result<Self> {
        // The last material is for faces without one.
        let materials: Vec<_> = scene.materials.iter().chain([&Material::default()]).map(material_words).collect();
        let has_cutouts = scene.has_cutouts();
        let mut used = vec![false; scene.textures.len()];
        scene.materials.iter().flat_map(Material::textures).for_each(|texture| used[texture as usize] = true);
        let mut table: Vec<[u32; TEXTURE_WORDS]> = Vec::new();
        let mut count = 0u64;
        for (texture, &used) in scene.textures.iter().zip(&used) {
            let size = if used { texture.texel_count() } else { 0 };
            let finest_size = u64::from(texture.width) * u64::from(texture.height);
            let coarse = count + finest_size;
            let cutout = if has_cutouts { count + size } else { coarse };
            let [first, coarse, cutout] = [count, coarse, cutout].map(|number| number as u32);
            let [across, down] = texture.sampler.wrap.map(|wrap| wrap as u32);
            let nearest = u32::from(texture.sampler.nearest);
            table.push([first, coarse, cutout, texture.width, texture.height, across, down, nearest]);
            count += size + if used && has_cutouts { size - finest_size } else { 0 };
        }
        let texels = Texels::new(device, "texels", TextureFormat::Rgba16Uint, 8, count)?;
        let mut all: Vec<[u16; 4]> = try_with_capacity(count as usize)?;
        scene.build_levels(&Progress::watching_memory(true))?;
        for (texture, _) in scene.textures.iter().zip(&used).filter(|(_, used)| **used) {
            push_finest(texture, &mut all);
            push_coarser(texture, false, &mut all);
            if has_cutouts {
                push_coarser(texture, true, &mut all);
            }
        }
        texels.write(device, 0, bytemuck::cast_slice(&all));
        Ok(Self {
            materials: device.filled_buffer("materials", &materials, BufferUsages::STORAGE)?,
            textures: device.filled_buffer("textures", &table, BufferUsages::STORAGE)?,
            texels,
            textured: used.contains(&true),
            glowing: scene.materials.iter().any(|material| material.emits() || material.unlit),
        })
    }
}

fn material_words(material: &Material) -> [u32; MATERIAL_WORDS] {
    let [r, g, b, a] = material.base_color.map(f32::to_bits);
    let cutoff = match material.alpha {
        Alpha::Opaque => -1.0f32,
        Alpha::Mask { cutoff } => cutoff.max(0.0),
    };
    let [red, green, blue] = material.emission.map(f32::to_bits);
    let [texture, emission_texture] = [material.texture, material.emission_texture].map(|t| t.unwrap_or(NONE));
    [r, g, b, a, red, green, blue, u32::from(material.unlit), texture, cutoff.to_bits(), emission_texture, 0]
}

/// Appends level 0 in steps of 1/65535 of linear light, with its alpha. The rounding error is at most a fortieth of the
/// step between the darkest sRGB codes.
fn push_finest(texture: &Texture, all: &mut Vec<[u16; 4]>) {
    let linear = linear_from_srgb().map(|x| (x * 65535.0 + 0.5) as u16);
    let texel = |&[r, g, b, a]: &[u8; 4]| {
        [linear[usize::from(r)], linear[usize::from(g)], linear[usize::from(b)], u16::from(a) * 257]
    };
    all.par_extend(texture.texels.par_iter().map(texel));
}

fn push_coarser(texture: &Texture, cutout: bool, all: &mut Vec<[u16; 4]>) {
    for level in texture.coarser(cutout) {
        all.extend(level.texels.iter().map(|&[r, g, b]| [r, g, b, u16::MAX]));
    }
}
