//! Materials on the device: tables of materials and textures, and all mip levels as texels of linear light.

use nearfar_core::base::{Error, Result};
use nearfar_core::scene::srgb::linear_from_srgb;
use nearfar_core::scene::{Alpha, Material, Scene, Texture};
use rayon::prelude::*;
use wgpu::{BufferUsages, TextureFormat};

use super::texels::Texels;
use crate::device::Device;

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
            let size = if used { levels_size(texture) } else { 0 };
            let finest_size = u64::from(texture.width) * u64::from(texture.height);
            let coarse = count + finest_size;
            let cutout = if has_cutouts { count + size } else { coarse };
            table.push([count as u32, coarse as u32, cutout as u32, texture.width, texture.height, 0, 0, 0]);
            count += size + if used && has_cutouts { size - finest_size } else { 0 };
        }
        let texels = Texels::new(device, "texels", TextureFormat::Rgba16Uint, 8, count)?;
        let mut all: Vec<[u16; 4]> = Vec::new();
        let bytes = count * size_of::<[u16; 4]>() as u64;
        all.try_reserve_exact(count as usize).map_err(|_| Error::Memory { bytes })?;
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

/// Returns the texels of a texture with all its levels.
fn levels_size(texture: &Texture) -> u64 {
    let (mut width, mut height) = (u64::from(texture.width), u64::from(texture.height));
    let mut sum = width * height;
    while width > 1 || height > 1 {
        (width, height) = ((width / 2).max(1), (height / 2).max(1));
        sum += width * height;
    }
    sum
}

/// Appends level 0 in steps of 1/65535 of linear light, with its alpha: a fortieth of the step between the darkest
/// codes.
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
