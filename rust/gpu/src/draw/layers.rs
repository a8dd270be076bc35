//! Layers: sets of instances, each shown in one way.

use std::sync::Arc;

use nearfar_core::scene::{Instance, Scene};

use super::style::{Cut, Displacement, Style};
use crate::upload::{RECORD_WORDS, SceneTables, SetTables};

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
    /// The scene with the instances.
    pub scene: Scene,
    /// The scene on the device.
    pub tables: Arc<SceneTables>,
    /// The half of its instances that is drawn.
    pub set: Set,
    /// Where their points are shown.
    pub style: Style,
    /// Which of their fragments are drawn.
    pub cut: Cut,
    /// How far from their places they are shown; none where that has no bound, so that nothing is culled.
    pub displacement: Option<Displacement>,
    /// It hides all layers before it: the depth buffer is cleared.
    pub covers: bool,
    /// For each of its instances whether the picture may show it, where that is known.
    pub seen: Option<Arc<[bool]>>,
    /// Faces of another scene that the layer's faces were made from: images hold their objects and triangles.
    pub sources: Option<Arc<Sources>>,
}

/// Faces and instances that a scene was made from.
pub(crate) struct Sources {
    /// The scene that they belong to.
    pub scene: Scene,
    /// Instance and face; objects of the standing meshes are places in this list.
    pub faces: Vec<(u32, u32)>,
    /// Numbers of the moving instances.
    pub moving: Vec<u32>,
}

impl Layer {
    /// Instances that are shown where they are, with all their fragments.
    pub fn plain(scene: Scene, tables: Arc<SceneTables>, set: Set) -> Self {
        Self {
            scene,
            tables,
            set,
            style: Style::PLAIN,
            cut: Cut::NONE,
            displacement: Some(Displacement::NONE),
            covers: false,
            seen: None,
            sources: None,
        }
    }

    /// For each record of the set, its instance and first face.
    pub fn record_faces(&self) -> &[(u32, u32)] {
        &self.set_tables().record_faces
    }

    /// A record of the set.
    pub fn record(&self, record: u32) -> [u32; RECORD_WORDS] {
        self.set_tables().record(self.instances(), record as usize)
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

    /// The face that one was made from, where the layer's scene was made from another.
    fn source(&self, instance: u32, face: u32) -> Option<(&Scene, u32, u32)> {
        let sources = self.sources.as_ref()?;
        let (instance, face) = match self.set {
            Set::Standing => sources.faces[self.instances()[instance as usize].object_of(face) as usize],
            Set::Moving => (sources.moving[instance as usize], face),
        };
        Some((&sources.scene, instance, face))
    }

    /// The set's instances.
    pub fn instances(&self) -> &[Instance] {
        match self.set {
            Set::Standing => self.scene.standing.instances(),
            Set::Moving => self.scene.moving.instances(),
        }
    }

    /// The set on the device.
    pub fn set_tables(&self) -> &SetTables {
        match self.set {
            Set::Standing => &self.tables.standing,
            Set::Moving => &self.tables.moving,
        }
    }
}
