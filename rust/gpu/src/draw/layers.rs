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

/// What a scene's faces were made from. Its moving instances are the other scene's.
pub(crate) struct Sources {
    /// Whose faces they were.
    pub scene: Scene,
    /// Instance and face; objects of the standing meshes are places in this list.
    pub faces: Vec<(u32, u32)>,
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
        let own = &self.instances()[instance as usize];
        match (&self.names, self.set) {
            (Names::Of(sources), Set::Standing) => {
                let (instance, face) = sources.faces[own.object_of(face) as usize];
                sources.scene.instance(instance).object_of(face)
            }
            _ => own.object_of(face),
        }
    }

    /// Number of a triangle of the nth instance of the set.
    pub fn triangle_of(&self, instance: u32, face: u32) -> i64 {
        match (&self.names, self.set) {
            (Names::Of(sources), Set::Standing) => {
                let (instance, face) = sources.faces[self.instances()[instance as usize].object_of(face) as usize];
                sources.scene.triangle_offset(instance) + i64::from(face)
            }
            (Names::Of(sources), Set::Moving) => {
                sources.scene.standing.triangle_count() + self.scene.moving.offset(instance as usize) + i64::from(face)
            }
            (Names::Own, Set::Standing) => self.scene.standing.offset(instance as usize) + i64::from(face),
            (Names::Own, Set::Moving) => {
                self.scene.standing.triangle_count() + self.scene.moving.offset(instance as usize) + i64::from(face)
            }
        }
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
}
