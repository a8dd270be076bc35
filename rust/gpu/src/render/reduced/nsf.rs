//! NSF triangles as two meshes: one that the morph does not move, and one that it bends, whose triangles are split
//! finely enough. Moving instances are placed by transforms; between the radii, their long edges are split.

use std::sync::{Arc, Mutex};

use glam::DAffine3;
use nearfar_core::base::memory::{try_concat, try_extend};
use nearfar_core::base::{Progress, Result};
use nearfar_core::morph::Morph;
use nearfar_core::partition::Partition;
use nearfar_core::scene::{Instance, InstanceSet, Scene};
use nearfar_core::tessellate::{Precision, Rule, ServedMorphs, Settings, Steps, bent_from, needs_split, split_scene};

use crate::device::lock;
use crate::draw::Sources;

/// Maximum number of cached splits, so that a user who walks to and fro between two steps of distance reuses both.
const MAX_SPLITS: usize = 3;

/// NSF of a reduced scene: its near, intermediate and moving triangles.
pub(super) struct Nsf {
    /// Triangles with all corners inside the radius.
    fixed: Geometry,
    /// All other triangles, unsplit.
    bending: Geometry,
    /// All static triangles, gathered when first needed: by a morph with smaller radii or a strength below 1, which bends
    /// triangles inside r₁, too.
    all: Mutex<Option<Geometry>>,
    /// Cached splits, the last used at the end.
    splits: Mutex<Vec<(SplitKey, StaticParts)>>,
    /// Split moving instances in their last poses.
    split_movers: Mutex<Option<SplitMovers>>,
    /// An empty static set, for layers of moving objects.
    no_instances: Arc<InstanceSet>,
    radii: [f64; 2],
}

/// Triangles to draw, and their source faces.
#[derive(Clone)]
pub(super) struct Geometry {
    /// A scene with one static mesh.
    pub scene: Scene,
    pub sources: Arc<Sources>,
}

/// Static triangles of NSF, divided by whether the morph bends them.
#[derive(Clone)]
pub(super) struct StaticParts {
    /// Triangles that the morph bends.
    pub bent: Geometry,
    /// Triangles that the morph does not move.
    pub fixed: Option<Geometry>,
    /// Rule for splitting moving objects: that of `bent`, but without its limit at r₂, because moving objects are also
    /// drawn beyond it. `None` if nothing is split.
    pub moving_rule: Option<Arc<Rule>>,
}

/// Moving objects as they are drawn.
pub(super) struct Moving {
    /// Instances placed by transforms.
    pub placed: Geometry,
    /// Instances split in their current poses.
    pub split: Option<Geometry>,
}

struct SplitMovers {
    rule: Arc<Rule>,
    poses: Vec<(u32, DAffine3)>,
    geometry: Geometry,
}

/// Cache key of a split. Reach and tolerance are rounded to steps, so that the key stays the same while users move
/// their heads.
#[derive(Clone, Copy, Debug, PartialEq)]
struct SplitKey {
    steps: Steps,
    served: ServedMorphs,
    radii: [f64; 2],
}

impl Nsf {
    /// Gathers the triangles of NSF; those inside `radius` are `fixed`, and the others `bending`.
    pub fn gather(partition: &Partition, radius: f64, progress: &Progress) -> Result<Self> {
        let scene = &partition.scene;
        let [fixed, bending] = partition.nsf_inside(radius)?;
        Ok(Self {
            fixed: Geometry::new(scene, fixed, progress)?,
            bending: Geometry::new(scene, bending, progress)?,
            all: Mutex::default(),
            splits: Mutex::default(),
            split_movers: Mutex::default(),
            no_instances: Arc::default(),
            radii: [partition.r1, partition.r2],
        })
    }

    /// Returns the triangles of a morph that bends from the radius `from` on, unsplit.
    pub fn unsplit(&self, from: f64, progress: &Progress) -> Result<StaticParts> {
        if from < self.radii[0] {
            return Ok(StaticParts { bent: self.all_triangles(progress)?, fixed: None, moving_rule: None });
        }
        Ok(StaticParts { bent: self.bending.clone(), fixed: Some(self.fixed.clone()), moving_rule: None })
    }

    /// Returns the triangles of a morph, split for a tolerance in radians. The split also serves other users at about
    /// the same distance from the centre.
    pub fn split(&self, morph: &Morph, tolerance: f64, progress: &Progress) -> Result<StaticParts> {
        let reach = (morph.user - morph.center).length();
        let (steps, settings) = Settings::from_morph(morph, self.radii[1], reach, tolerance).stepped();
        let key = SplitKey { steps, served: settings.served, radii: [settings.r1, settings.r2] };
        if let Some(parts) = self.cached_split(&key) {
            return Ok(parts);
        }
        // No lock is held while triangles are split in parallel: a thread that waits inside rayon may run another
        // frame, which needs the same lock.
        let rule = Rule::new(&settings, Precision::Single)?;
        let moving_rule = Rule::new(&Settings { drawn: f64::INFINITY, ..settings }, Precision::Single)?;
        let StaticParts { bent, fixed, .. } = self.unsplit(bent_from(morph), progress)?;
        let parts = StaticParts { bent: bent.split(&rule, progress)?, fixed, moving_rule: Some(Arc::new(moving_rule)) };
        let mut splits = lock(&self.splits);
        if splits.len() == MAX_SPLITS {
            splits.remove(0);
        }
        splits.push((key, parts.clone()));
        Ok(parts)
    }

    fn all_triangles(&self, progress: &Progress) -> Result<Geometry> {
        if let Some(all) = lock(&self.all).clone() {
            return Ok(all);
        }
        let [fixed, bending] = [&self.fixed.sources, &self.bending.sources];
        let all = Geometry::new(&fixed.scene, try_concat(&[&fixed.faces, &bending.faces])?, progress)?;
        Ok(lock(&self.all).get_or_insert(all).clone())
    }

    /// Returns a cached split, and marks it as the last used.
    fn cached_split(&self, key: &SplitKey) -> Option<StaticParts> {
        let mut splits = lock(&self.splits);
        let index = splits.iter().position(|(other, _)| other == key)?;
        splits[index..].rotate_left(1);
        splits.last().map(|(_, parts)| parts.clone())
    }

    /// Returns the moving objects in a pose of the scene; `rule` decides which edges are too long.
    pub fn moving(&self, scene: &Scene, rule: Option<&Arc<Rule>>, progress: &Progress) -> Result<Moving> {
        let all = (scene.standing.instances().len() as u32..).zip(scene.moving.instances());
        let is_long = |instance: &Instance| rule.is_some_and(|rule| needs_split(instance, rule));
        let (long, short): (Vec<_>, Vec<_>) = all.partition(|(_, instance)| is_long(instance));
        let placed = Scene {
            standing: Arc::clone(&self.no_instances),
            moving: Arc::new(InstanceSet::new(short.iter().map(|(_, instance)| (*instance).clone()).collect())),
            ..scene.clone()
        };
        let moving = short.iter().map(|(number, _)| *number).collect();
        let sources = Arc::new(Sources { scene: scene.clone(), faces: Vec::new(), moving });
        let split = match rule {
            Some(rule) if !long.is_empty() => Some(self.split_moving(scene, rule, &long, progress)?),
            _ => None,
        };
        Ok(Moving { placed: Geometry { scene: placed, sources }, split })
    }

    /// Returns moving instances as static geometry, split in their current poses.
    fn split_moving(
        &self,
        scene: &Scene,
        rule: &Arc<Rule>,
        long: &[(u32, &Instance)],
        progress: &Progress,
    ) -> Result<Geometry> {
        let poses: Vec<(u32, DAffine3)> = long.iter().map(|(number, instance)| (*number, instance.to_scene)).collect();
        let is_same = |split: &&SplitMovers| Arc::ptr_eq(&split.rule, rule) && split.poses == poses;
        if let Some(split) = lock(&self.split_movers).as_ref().filter(is_same) {
            return Ok(split.geometry.clone());
        }
        let mut faces = Vec::new();
        for &(number, instance) in long {
            try_extend(&mut faces, (0..instance.mesh.faces.len() as u32).map(|face| (number, face)))?;
        }
        let geometry = Geometry::new(scene, faces, progress)?.split(rule, progress)?;
        *lock(&self.split_movers) = Some(SplitMovers { rule: Arc::clone(rule), poses, geometry: geometry.clone() });
        Ok(geometry)
    }
}

impl Geometry {
    pub fn triangle_count(&self) -> u64 {
        self.scene.triangle_count() as u64
    }

    fn split(self, rule: &Rule, progress: &Progress) -> Result<Self> {
        Ok(Self { scene: split_scene(&self.scene, rule, |_| true, progress)?.0, ..self })
    }

    fn new(scene: &Scene, faces: Vec<(u32, u32)>, progress: &Progress) -> Result<Self> {
        let mesh = scene.gathered(&faces, progress)?;
        let instance = Instance::new(Arc::new(mesh), DAffine3::IDENTITY, None)?;
        let (materials, textures) = (Arc::clone(&scene.materials), Arc::clone(&scene.textures));
        let gathered = Scene::new(scene.origin, vec![instance], Vec::new(), materials, textures)?;
        Ok(Self { scene: gathered, sources: Arc::new(Sources { scene: scene.clone(), faces, moving: Vec::new() }) })
    }
}
