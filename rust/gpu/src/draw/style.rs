//! Styles and cuts: shader snippets of a technique, and their parameters.

use std::hash::{Hash, Hasher};

use glam::DVec3;

/// Parameters of a technique in a pass's uniform block.
pub(crate) type Parameters = [[f32; 4]; 4];

/// WGSL that is compiled together with the shaders of `draw`, and its selected variant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Snippet {
    /// Identity of the text.
    pub name: &'static str,
    pub text: &'static str,
    /// Value of the override `STYLE` or `CUT`.
    pub variant: u32,
}

impl PartialEq for Snippet {
    fn eq(&self, other: &Self) -> bool {
        (self.name, self.variant) == (other.name, other.variant)
    }
}

impl Eq for Snippet {}

impl Hash for Snippet {
    fn hash<H: Hasher>(&self, state: &mut H) {
        (self.name, self.variant).hash(state);
    }
}

/// Displacement of points. The snippet defines `displayed` (the displayed position of a point), `displayed_range` (the
/// displayed distance of a surface) and `backdrop_range` (the displayed distance of the environment map), by the
/// override `STYLE`: see `plain.wgsl`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Style(pub Snippet);

impl Style {
    /// No displacement.
    pub const PLAIN: Self = Self(Snippet { name: "plain", text: include_str!("../shaders/plain.wgsl"), variant: 0 });
}

/// Filter of fragments. The snippet defines `cut_vector` (a vertex vector, interpolated for `is_kept`) and `is_kept`
/// (whether a fragment is drawn), by the override `CUT`: see `whole.wgsl`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Cut {
    pub snippet: Snippet,
    /// Whether `is_kept` reads the face's normal.
    pub face_normals: bool,
}

impl Cut {
    /// Keeps all fragments.
    pub const NONE: Self = Self {
        snippet: Snippet { name: "whole", text: include_str!("../shaders/whole.wgsl"), variant: 0 },
        face_normals: false,
    };
}

/// Bound of the displacement of points, for culling by boxes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Displacement {
    /// Common shift of all points.
    pub shift: DVec3,
    /// Maximum additional displacement in any direction, metres.
    pub slack: f64,
}

impl Displacement {
    /// No displacement.
    pub const NONE: Self = Self { shift: DVec3::ZERO, slack: 0.0 };
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::{DAffine3, DQuat, DVec3};
    use nearfar_core::base::FaceMap;
    use nearfar_core::base::Progress;
    use nearfar_core::camera::{Camera, Fov, Projection};
    use nearfar_core::render::{Channels, Frame};
    use nearfar_core::scene::{Instance, Mesh, Scene};

    use super::*;
    use crate::device::{Device, adapters, device};
    use crate::draw::{Job, Layer, Picture, Set};
    use crate::upload::Residents;

    /// A technique unknown to `draw`: all points are moved, and those to the left of the eye are cut.
    const MOVED: Style = Style(Snippet {
        name: "moved",
        text: "fn displayed(p: vec3<f32>) -> vec3<f32> { return p + view.parameters[0].xyz; }
               fn displayed_range(direction: vec3<f32>, range: f32) -> f32 { return range; }
               fn backdrop_range(direction: vec3<f32>, range: f32) -> f32 { return range; }",
        variant: 0,
    });
    const RIGHT: Cut = Cut {
        snippet: Snippet {
            name: "right",
            text: "fn cut_vector(p: vec3<f32>) -> vec3<f32> { return p; }
                   fn is_kept(vector: vec3<f32>, from_eye: vec3<f32>, normal: vec3<f32>) -> bool {
                       return from_eye.x >= 0.0;
                   }",
            variant: 0,
        },
        face_normals: false,
    };
    const SHIFT: DVec3 = DVec3::new(0.5, 0.25, -1.0);

    fn scene() -> Scene {
        let positions = vec![[-2.0f32, -2.0, -4.0], [3.0, -1.0, -6.0], [0.0, 2.0, -5.0]];
        let (objects, materials) = (FaceMap::Uniform(0), FaceMap::Uniform(-1));
        let mesh = Mesh::new(positions.into(), vec![[0, 1, 2]].into(), None, None, objects, materials).unwrap();
        let instance = Instance::new(Arc::new(mesh), DAffine3::IDENTITY, None).unwrap();
        Scene::new(DVec3::ZERO, vec![instance], Vec::new(), Arc::default(), Arc::default()).unwrap()
    }

    fn draw(device: &Arc<Device>, eye: DVec3, change: impl FnOnce(Layer) -> Layer) -> Frame {
        let scene = scene();
        let tables = device.state::<Residents>().scene(device, &scene).unwrap();
        let mut picture = Picture::plain(vec![change(Layer::plain(scene, tables, Set::Static))], DVec3::ZERO);
        picture.parameters[0] = SHIFT.as_vec3().extend(0.0).to_array();
        let fov = Fov { left: -1.0, right: 1.0, down: -1.0, up: 1.0 };
        let camera = Camera::new(eye, DQuat::IDENTITY, Projection::Perspective(fov), 32, 32).unwrap();
        let channels = Channels { range: true, ..Channels::default() };
        let job = Job::begin(device, picture, &[camera], channels, 1, &Progress::new()).unwrap();
        job.finish(&Progress::new()).unwrap().swap_remove(0)
    }

    #[test]
    fn a_technique_brings_its_style_and_cut_along() {
        for name in ["vulkan", "gl", "metal", "dx12"] {
            if !adapters().unwrap().iter().any(|report| report.backend == name && report.refusal_reason.is_empty()) {
                continue;
            }
            let device = device(Some(name)).unwrap();
            let displacement = Some(Displacement { shift: SHIFT, slack: 0.0 });
            let truth = draw(&device, -SHIFT, |layer| layer).range;
            let moved = draw(&device, DVec3::ZERO, |layer| Layer { style: MOVED, displacement, ..layer }).range;
            assert!(truth.iter().any(|range| range.is_finite()));
            assert!(truth.iter().zip(&moved).all(|(a, b)| a == b || (a - b).abs() < 1e-5), "{name}");
            let cut =
                draw(&device, DVec3::ZERO, |layer| Layer { style: MOVED, displacement, cut: RIGHT, ..layer }).range;
            let expected = |n: usize| if n % 32 < 16 { f32::INFINITY } else { moved[n] };
            assert!((0..moved.len()).all(|n| cut[n] == expected(n)), "{name}");
        }
    }
}
