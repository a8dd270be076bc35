//! Environment maps: colour around a point and, if requested, range and objects.

use glam::{DVec3, Vec3};

use super::faces::{CubeFaces, texel_from_direction};
use super::lookup::Taps;
use crate::base::{Buffer, Result, ensure};

/// A cube map of the surroundings of a point. Channels that were not requested are absent.
#[derive(Clone, Debug)]
pub struct EnvironmentMap {
    /// Width of a face, texels.
    pub size: u32,
    /// Linear RGB of each texel.
    pub color: Buffer<[f32; 3]>,
    /// Distance from the centre in metres; infinite where there is no surface.
    pub range: Option<Buffer<f32>>,
    /// Object number; −1 where there is no surface.
    pub object_id: Option<Buffer<i32>>,
}

impl EnvironmentMap {
    /// Creates a map; checks that each channel fills six faces.
    pub fn new(
        size: u32,
        color: Buffer<[f32; 3]>,
        range: Option<Buffer<f32>>,
        object_id: Option<Buffer<i32>>,
    ) -> Result<Self> {
        CubeFaces::new(color.as_flattened(), size, 3)?;
        if let Some(range) = &range {
            CubeFaces::new(range, size, 1)?;
        }
        let texels = color.len();
        let id_count = object_id.as_ref().map_or(texels, |ids| ids.len());
        ensure!(id_count == texels, "object_id", format!("{texels} numbers"), id_count);
        Ok(Self { size, color, range, object_id })
    }

    /// Returns the linear RGB in a direction.
    #[inline]
    pub fn color(&self, direction: Vec3) -> [f32; 3] {
        let taps = Taps::new(direction.as_dvec3(), self.size);
        let mut sum = DVec3::ZERO;
        for (texel, weight) in taps.texel.into_iter().zip(taps.weight) {
            sum += weight * Vec3::from_array(self.color[texel as usize]).as_dvec3();
        }
        sum.as_vec3().to_array()
    }

    /// Returns range and object number of the texel that a direction hits; ∞ and −1 if the map lacks the channel.
    pub fn surface(&self, direction: Vec3) -> (f32, i32) {
        let texel = texel_from_direction(direction.as_dvec3(), self.size) as usize;
        let range = self.range.as_ref().map_or(f32::INFINITY, |range| range[texel]);
        let object = self.object_id.as_ref().map_or(-1, |object| object[texel]);
        (range, object)
    }

    /// Returns the maximum range of the texels around a direction; points beyond are hidden. ∞ without ranges.
    pub fn farthest(&self, direction: Vec3) -> f32 {
        let Some(range) = &self.range else { return f32::INFINITY };
        let taps = Taps::new(direction.as_dvec3(), self.size);
        taps.texel.iter().fold(0.0, |farthest: f32, &texel| farthest.max(range[texel as usize]))
    }
}
