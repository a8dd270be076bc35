//! What a picture is made of: sets of instances, each shown in one way.

use std::sync::Arc;

use glam::DVec3;
use nearfar_core::base::Buffer;
use nearfar_core::scene::{Instance, Scene};

use crate::upload::{EnvTexels, RECORD_WORDS, SceneTables};

/// How points are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Kind {
    /// Where they are.
    AsItIs,
    /// Morphed by the blend of 2022.
    Blend,
    /// Morphed by CloVR's cylinder.
    Cylinder,
    /// Where the centre sees them: moved by the user's offset.
    FromCenter,
    /// The same, but as far away as they are shown by CloVR's cylinder.
    FromCenterOnCylinder,
}

/// Which fragments are drawn, by their distance from the centre's axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Split {
    /// All.
    Whole,
    /// Those within the radius.
    Within,
    /// Those beyond it.
    Beyond,
    /// Those beyond it, and as much within as two texels of a map reach.
    Overlapping,
}

/// Half of a scene's instances.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Set {
    /// Those that never move.
    Standing,
    /// Those that are posed anew.
    Moving,
}

/// Instances that are drawn in one way.
#[derive(Clone)]
pub(crate) struct Layer {
    /// Whose instances.
    pub scene: Scene,
    /// The same on the device.
    pub tables: Arc<SceneTables>,
    /// Which of them.
    pub set: Set,
    /// How they are shown.
    pub kind: Kind,
    /// Which of their fragments.
    pub split: Split,
    /// What the map's range hides is left out.
    pub hidden: bool,
    /// Nothing drawn before it hides it: depth begins anew.
    pub covers: bool,
    /// What its faces are called.
    pub names: Names,
}

/// Numbers of objects and triangles.
#[derive(Clone)]
pub(crate) enum Names {
    /// As the layer's scene has them.
    Own,
    /// Of faces made from those of another scene.
    Of(Arc<Sources>),
}

/// What a scene was made from.
pub(crate) struct Sources {
    /// Whose faces and instances they were.
    pub scene: Scene,
    /// Instance and face; objects of the standing meshes are places in this list.
    pub faces: Vec<(u32, u32)>,
    /// Numbers of the moving instances.
    pub moving: Vec<u32>,
}

impl Layer {
    /// For each record of the set, its instance and first face.
    pub fn sources(&self) -> &[(u32, u32)] {
        match self.set {
            Set::Standing => &self.tables.standing.sources,
            Set::Moving => &self.tables.moving.sources,
        }
    }

    /// A record of the set.
    pub fn record(&self, record: u32) -> [u32; RECORD_WORDS] {
        let set = match self.set {
            Set::Standing => &self.tables.standing,
            Set::Moving => &self.tables.moving,
        };
        set.record(self.instances(), record as usize)
    }

    /// Object of a face of the nth instance of the set.
    pub fn object_of(&self, instance: u32, face: u32) -> i32 {
        match self.source(instance, face) {
            Some((scene, instance, face)) => scene.instance(instance).object_of(face),
            None => self.instances()[instance as usize].object_of(face),
        }
    }

    /// Number of a triangle of the nth instance of the set.
    pub fn triangle_of(&self, instance: u32, face: u32) -> i64 {
        let first = match self.set {
            Set::Standing => 0,
            Set::Moving => self.scene.standing.instances().len() as u32,
        };
        let (scene, instance, face) = self.source(instance, face).unwrap_or((&self.scene, first + instance, face));
        scene.triangle_offset(instance) + i64::from(face)
    }

    /// Whose face it was, where the layer's scene was made from another.
    fn source(&self, instance: u32, face: u32) -> Option<(&Scene, u32, u32)> {
        let Names::Of(sources) = &self.names else { return None };
        let (instance, face) = match self.set {
            Set::Standing => sources.faces[self.instances()[instance as usize].object_of(face) as usize],
            Set::Moving => (sources.moving[instance as usize], face),
        };
        Some((&sources.scene, instance, face))
    }

    fn instances(&self) -> &[Instance] {
        match self.set {
            Set::Standing => self.scene.standing.instances(),
            Set::Moving => self.scene.moving.instances(),
        }
    }
}

/// A picture to be taken from any camera.
#[derive(Clone)]
pub(crate) struct Picture {
    /// In order of drawing.
    pub layers: Vec<Layer>,
    /// What is seen where nothing is drawn; the sky without a map.
    pub map: Option<Arc<EnvTexels>>,
    /// Objects of the map's texels, where it has them.
    pub far_objects: Option<Buffer<i32>>,
    /// The centre O relative to the scenes' origin.
    pub center: DVec3,
    /// r₁, r₂ and the radius where pixels are split.
    pub radii: [f64; 3],
    /// World position of the scenes' origin.
    pub origin: DVec3,
    /// Tangent of two texels, for `Split::Overlapping`.
    pub two_texels: f64,
    /// How far pixels without geometry are shown: as points of this kind.
    pub missed: Kind,
    /// Four samples may be the adapter's own, with each face shaded once: for frames, not for maps, which last.
    pub multisampled: bool,
}
