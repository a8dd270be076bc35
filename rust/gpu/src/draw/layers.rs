//! Layers: sets of instances that share a style.

use std::sync::Arc;

use nearfar_core::scene::{Instance, Scene};

use super::style::{Cut, Displacement, Style};
use crate::upload::{SceneTables, SetTables};

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
    /// Whether it hides all earlier layers: the depth buffer is cleared.
    pub covers: bool,
    /// Flag per instance whether the picture may show it, if known.
    pub may_show: Option<Arc<[bool]>>,
    /// Source faces in another scene, whose objects and triangles appear in images.
    pub sources: Option<Arc<Sources>>,
}

/// Source faces and instances of a derived scene.
pub(crate) struct Sources {
    pub scene: Scene,
    /// Instance and face; object numbers of the static meshes are indices of this list.
    pub faces: Vec<(u32, u32)>,
    /// Numbers of the moving instances.
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
