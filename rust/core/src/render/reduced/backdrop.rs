//! What is seen where no near geometry is: the environment map, or the sky where nothing is far.

use glam::{DVec3, Vec3};

use super::super::frame::Sample;
use super::super::shade::background;
use super::super::surface::Surface;
use crate::cubemap::EnvironmentMap;
use crate::morph::Morph;
use crate::scene::Scene;
use crate::trace::Ray;

/// Share of its range by which a fragment may lie behind the map before it counts as hidden: the error of a half float,
/// and of a range that was taken half a texel away on a surface at 45 degrees in a map of 512 texels.
const BIAS: f32 = 4e-3;

#[derive(Clone, Copy)]
pub(super) struct Backdrop<'a> {
    pub map: Option<&'a EnvironmentMap>,
    /// The centre O, relative to the scene's origin.
    pub center: DVec3,
    /// How far away the user is shown what the map holds; without one, as far as it is from O.
    pub morph: Option<Morph>,
}

impl Backdrop<'_> {
    pub fn color(&self, direction: Vec3) -> [f32; 3] {
        self.map.map_or_else(|| background(direction), |map| map.color(direction))
    }

    /// Channels of a far pixel. The map shows what O sees in this direction, so that with a range its point is known.
    pub fn sample(&self, direction: Vec3) -> Sample {
        let Some(map) = self.map else { return Sample::default() };
        let (range, object_id) = map.surface(direction);
        let mut sample = Sample { range: self.displayed(direction, range), object_id, ..Sample::default() };
        if range.is_finite() {
            sample.position = (self.center + direction.as_dvec3() * f64::from(range)).as_vec3().to_array();
        }
        sample
    }

    /// Ends a ray where the map hides all that is farther; without ranges it hides nothing.
    pub fn shorten(&self, ray: &mut Ray) {
        if let Some(map) = self.map.filter(|map| map.range.is_some()) {
            let hidden_beyond = self.displayed(ray.direction, map.farthest(ray.direction));
            ray.t_max = ray.t_max.min(hidden_beyond * (1.0 + BIAS));
        }
    }

    /// |Q−U| of what O sees at a range.
    fn displayed(&self, direction: Vec3, range: f32) -> f32 {
        self.morph.map_or(range, |morph| morph.far_distance(direction.as_dvec3(), f64::from(range)) as f32)
    }
}

/// Channels of a near pixel: its unmorphed surface, and how far away it is shown.
pub(super) fn sample_of(surface: &Surface, scene: &Scene, range: f32) -> Sample {
    Sample {
        range,
        object_id: surface.object_id(scene),
        face_id: surface.face_id(scene),
        position: surface.point.to_array(),
        normal: surface.normal.to_array(),
    }
}
