//! Base colour (factor × texture × vertex colour), emission and alpha holes of a point on a surface.

use super::material::{Alpha, Material};
use super::mesh::Mesh;
use super::srgb::linear_from_srgb;
use super::texture::Texture;
use super::world::Scene;
use crate::base::by_number;

/// Returns the mip level for a footprint on the surface (metres) and a texture density there (texels per metre): log₂
/// of the number of texels across the footprint.
///
/// The footprint's width is the ray's width, perpendicular to its direction, divided by √cos of the angle between
/// normal and ray. This is the geometric mean of the ellipse's axes, a compromise between blur and flicker on streets.
#[inline]
pub fn texture_level(footprint: f32, density: f32) -> f32 {
    (footprint * density).log2()
}

/// Returns the texels per metre on a face: the square root of the ratio of its area in texels to its area in the
/// scene. Both areas are computed doubled.
#[inline]
pub fn texel_density(texture: &Texture, uvs: [[f32; 2]; 3], doubled_area: f32) -> f32 {
    let [a, b, c] = uvs;
    let (b, c) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let texels = (b[0] * c[1] - b[1] * c[0]).abs() * texture.width as f32 * texture.height as f32;
    (texels / doubled_area).sqrt()
}

/// Interpolates at barycentric weights (u, v) of the second and third corner.
#[inline]
fn interpolate<const N: usize>([a, b, c]: [[f32; N]; 3], (u, v): (f32, f32)) -> [f32; N] {
    std::array::from_fn(|i| a[i] + (b[i] - a[i]) * u + (c[i] - a[i]) * v)
}

/// A point on a face of a mesh, with the footprint of the ray that hits it.
#[derive(Clone, Copy, Debug)]
pub struct Spot<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// Number of the face.
    pub face: u32,
    /// Weights of the face's second and third corner.
    pub at: (f32, f32),
    /// Width of the footprint on the surface, metres.
    pub footprint: f32,
    /// Twice the area of the placed face, square metres.
    pub doubled_area: f32,
}

impl Scene {
    /// Returns the material of a face of a mesh; the default material if the face has none.
    #[inline]
    pub fn material_of(&self, mesh: &Mesh, face: u32) -> Material {
        by_number(&self.materials, mesh.materials.get(face)).copied().unwrap_or_default()
    }

    /// Returns whether any material has an alpha cutoff, so that rays need `trace::AlphaFilter`.
    pub fn has_cutouts(&self) -> bool {
        self.materials.iter().any(|material| material.alpha != Alpha::Opaque)
    }

    /// Returns the linear base colour of a material at a spot: factor × texture × vertex colour.
    #[inline]
    pub fn albedo(&self, material: &Material, spot: &Spot<'_>) -> [f32; 3] {
        let [r, g, b, _] = material.base_color;
        let mut albedo = [r, g, b];
        if let Some(colors) = spot.mesh.corner_values(spot.face, &spot.mesh.colors) {
            let linear = linear_from_srgb();
            let color =
                interpolate(colors.map(|[r, g, b, _]| [r, g, b].map(|code| linear[usize::from(code)])), spot.at);
            (0..3).for_each(|i| albedo[i] *= color[i]);
        }
        if let Some(color) = self.texture_color(material.texture, spot, material.alpha != Alpha::Opaque) {
            (0..3).for_each(|i| albedo[i] *= color[i]);
        }
        albedo
    }

    /// Returns the linear RGB emission at a spot: factor × texture. Not inlined, to keep other materials fast.
    #[inline(never)]
    pub fn emission(&self, material: &Material, spot: &Spot<'_>) -> [f32; 3] {
        let color = self.texture_color(material.emission_texture, spot, false).unwrap_or([1.0; 3]);
        std::array::from_fn(|i| material.emission[i] * color[i])
    }

    /// Returns the linear RGB of a texture; `None` without texture or texture coordinates.
    #[inline(always)]
    fn texture_color(&self, texture: Option<u32>, spot: &Spot<'_>, cutout: bool) -> Option<[f32; 3]> {
        let (texture, uvs) = (&self.textures[texture? as usize], spot.mesh.corner_values(spot.face, &spot.mesh.uvs)?);
        let level = texture_level(spot.footprint, texel_density(texture, uvs, spot.doubled_area));
        Some(texture.color(interpolate(uvs, spot.at), level, cutout))
    }

    /// Returns whether a face's material has an alpha cutoff, so that `is_solid` may be false somewhere on it.
    #[inline]
    pub fn may_have_hole(&self, mesh: &Mesh, face: u32) -> bool {
        matches!(self.material_of(mesh, face).alpha, Alpha::Mask { .. })
    }

    /// Returns false if a cut-out material leaves a hole at weights (u, v) of a face. The texture is sampled at level
    /// 0, so a hole has the same shape at every distance.
    pub fn is_solid(&self, mesh: &Mesh, face: u32, weights: (f32, f32)) -> bool {
        let material = self.material_of(mesh, face);
        let Alpha::Mask { cutoff } = material.alpha else { return true };
        let mut alpha = material.base_color[3];
        if let Some(colors) = mesh.corner_values(face, &mesh.colors) {
            alpha *= interpolate(colors.map(|color| [f32::from(color[3]) / 255.0]), weights)[0];
        }
        if let (Some(texture), Some(uvs)) = (material.texture, mesh.corner_values(face, &mesh.uvs)) {
            alpha *= self.textures[texture as usize].alpha(interpolate(uvs, weights));
        }
        alpha >= cutoff
    }
}
