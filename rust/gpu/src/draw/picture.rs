//! Pictures: layers, which are sets of instances that share a style, in front of a backdrop.

use std::sync::Arc;

use glam::DVec3;
use nearfar_core::base::Buffer;
use nearfar_core::camera::Camera;
use nearfar_core::render::{Channels, Limits, Segment};
use nearfar_core::scene::{Instance, Scene};

use super::style::{Cut, Displacement, Parameters, Style};
use super::window::{Mask, window_limits};
use crate::device::{Device, SAMPLES};
use crate::upload::{EnvTexels, SceneTables, SetTables};

/// A picture to be drawn for a camera.
#[derive(Clone)]
pub(crate) struct Picture {
    /// Layers in drawing order.
    pub layers: Vec<Layer>,
    /// Parameters of the layers' styles and cuts.
    pub parameters: Parameters,
    /// Environment map behind all layers; `None` for the sky.
    pub backdrop: Option<Backdrop>,
    /// Style whose `backdrop_range` gives the displayed distance of the backdrop.
    pub backdrop_style: Style,
    /// World position of the scenes' origin.
    pub origin: DVec3,
    /// Whether four samples may use hardware multisampling, which shades each face once per pixel: for frames, not for
    /// baked maps.
    pub multisampled: bool,
    /// Visible volume of surfaces and map, relative to the scenes' origin; `None` if unlimited, which needs no test.
    pub limits: Option<Limits>,
    /// Whether samples without a triangle are black instead of showing map or sky.
    pub bare: bool,
    /// Drawn pixels; `None` draws all.
    pub mask: Option<Arc<Mask>>,
}

/// Environment map behind all layers.
#[derive(Clone)]
pub(crate) struct Backdrop {
    pub texels: Arc<EnvTexels>,
    /// Objects of its texels, if present.
    pub objects: Option<Buffer<i32>>,
    /// Centre of the map, relative to the scenes' origin.
    pub center: DVec3,
}

impl Picture {
    /// Returns whether the adapter clips a layer's triangles: only at planes, and only undisplaced whole triangles.
    pub fn clips(&self, device: &Device, layer: &Layer) -> bool {
        let only_planes = self.limits.is_some_and(|limits| limits.segment == Segment::WHOLE);
        device.clips && layer.draws_whole_triangles() && only_planes
    }

    /// Returns whether a device draws the frames of two cameras at once: each triangle is submitted once and placed in
    /// both. No style or cut may discard parts of triangles, and both frames must fit into one window.
    pub fn draws_both(&self, device: &Device, cameras: &[Camera], channels: Channels, samples: u32) -> bool {
        let [left, right] = cameras else { return false };
        let (width, height) = (left.width, left.height);
        let (max_pixels, max_side) = window_limits(device, channels);
        device.draws_two_views()
            && (width, height) == (right.width, right.height)
            && !left.is_parallel()
            && !right.is_parallel()
            && self.mask.is_none()
            && self.limits.is_none()
            && (samples != SAMPLES || !device.multisamples)
            && width.max(height) <= max_side
            && 2 * u64::from(width) * u64::from(height) <= max_pixels
            && self.layers.iter().all(Layer::draws_whole_triangles)
    }

    /// Creates a picture of layers without parameters, in front of the sky.
    pub fn plain(layers: Vec<Layer>, origin: DVec3) -> Self {
        Self {
            layers,
            parameters: Parameters::default(),
            backdrop: None,
            backdrop_style: Style::PLAIN,
            origin,
            multisampled: true,
            limits: None,
            bare: false,
            mask: None,
        }
    }
}

/// One of a scene's two instance sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Set {
    Static,
    Moving,
}

/// Instances drawn with one style.
#[derive(Clone)]
pub(crate) struct Layer {
    pub scene: Scene,
    pub tables: Arc<SceneTables>,
    pub set: Set,
    pub style: Style,
    pub cut: Cut,
    /// Bound of the displacement; `None` if unbounded, so that nothing is culled.
    pub displacement: Option<Displacement>,
    /// Whether it hides all earlier layers, because the depth buffer is cleared before it.
    pub covers: bool,
    /// For each instance, whether the picture may show it, if known.
    pub may_show: Option<Arc<[bool]>>,
    /// Faces of the scene from which this one is derived; images have the object and triangle numbers of those.
    pub sources: Option<Arc<Sources>>,
}

/// Source faces and instances of a derived scene.
pub(crate) struct Sources {
    pub scene: Scene,
    /// Instance and face in the source scene; the derived static meshes have indices of this list as object numbers.
    pub faces: Vec<(u32, u32)>,
    /// Numbers of the moving instances in the source scene.
    pub moving: Vec<u32>,
}

impl Layer {
    /// Creates a layer without displacement and cut.
    pub fn plain(scene: Scene, tables: Arc<SceneTables>, set: Set) -> Self {
        Self {
            scene,
            tables,
            set,
            style: Style::PLAIN,
            cut: Cut::NONE,
            displacement: Some(Displacement::NONE),
            covers: false,
            may_show: None,
            sources: None,
        }
    }

    /// Returns whether all triangles are drawn undisplaced, and no parts of them are discarded.
    pub fn draws_whole_triangles(&self) -> bool {
        self.style == Style::PLAIN && self.cut == Cut::NONE && !self.scene.has_cutouts()
    }

    /// Returns the object of a face of the nth instance of the set.
    pub fn object_of(&self, instance: u32, face: u32) -> i32 {
        match self.source(instance, face) {
            Some((scene, instance, face)) => scene.instance(instance).object_of(face),
            None => self.instances()[instance as usize].object_of(face),
        }
    }

    /// Returns the number of a triangle of the nth instance of the set.
    pub fn triangle_of(&self, instance: u32, face: u32) -> i64 {
        let first = match self.set {
            Set::Static => 0,
            Set::Moving => self.scene.standing.instances().len() as u32,
        };
        let (scene, instance, face) = self.source(instance, face).unwrap_or((&self.scene, first + instance, face));
        scene.triangle_offset(instance) + i64::from(face)
    }

    /// Returns the source of a face, if the layer's scene was derived from another.
    fn source(&self, instance: u32, face: u32) -> Option<(&Scene, u32, u32)> {
        let sources = self.sources.as_ref()?;
        let (instance, face) = match self.set {
            Set::Static => sources.faces[self.instances()[instance as usize].object_of(face) as usize],
            Set::Moving => (sources.moving[instance as usize], face),
        };
        Some((&sources.scene, instance, face))
    }

    pub fn instances(&self) -> &[Instance] {
        match self.set {
            Set::Static => self.scene.standing.instances(),
            Set::Moving => self.scene.moving.instances(),
        }
    }

    pub fn set_tables(&self) -> &SetTables {
        match self.set {
            Set::Static => &self.tables.static_set,
            Set::Moving => &self.tables.moving_set,
        }
    }
}
