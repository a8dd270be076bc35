//! Near triangles as two meshes: those that no morph changes, and those that it bends, split finely enough for it.

use std::sync::{Arc, Mutex, PoisonError};

use glam::{DAffine3, DVec3, Vec3};
use nearfar_core::base::{Progress, Result};
use nearfar_core::morph::Kind;
use nearfar_core::partition::Partition;
use nearfar_core::scene::{Instance, InstanceSet, Scene};
use nearfar_core::tessellate::{Precision, Rule, Settings, split_scene};

use crate::draw::Sources;

/// Splits that are kept: a user who walks to and fro across a step finds both.
const KEPT: usize = 3;
/// Share of r₁ within which a user's error has a bound (0.6, less what triangles may pass r₁ by).
const BOUNDED: f64 = 0.59;
/// Share of r₂ by which points may miss the radius and be taken for points of it: more than any rule that splits does.
const ON_RADIUS: f64 = 1.0 / 8192.0;

/// Near geometry of a reduced scene.
pub(super) struct Near {
    /// All corners inside the radius.
    pub fixed: Geometry,
    /// The others, as they are in the scene.
    bending: Geometry,
    /// The others after splitting, the last used at the end.
    split: Mutex<Vec<(Cause, Geometry)>>,
    /// What stands in for standing geometry in layers of moving objects.
    pub nothing: Arc<InstanceSet>,
    center: DVec3,
    radii: [f64; 2],
}

/// Triangles to be drawn and what they were made from.
#[derive(Clone)]
pub(super) struct Geometry {
    /// One standing mesh.
    pub scene: Scene,
    pub sources: Arc<Sources>,
    /// The morph of its vertices is as good as the tolerance says.
    pub bounded: bool,
}

/// What a split follows from: reach and tolerance in steps of √2, so that it stays while users move their heads.
type Cause = (i32, i32, Kind);

impl Near {
    /// Sorts the near triangles by whether they lie inside a radius.
    pub fn gather(partition: &Partition, radius: f64) -> Result<Self> {
        let scene = partition.scene();
        let center = partition.center() - scene.origin;
        let standing = scene.standing.instances().len() as u32;
        let least = radius - partition.r2() * ON_RADIUS;
        let inside = |&(instance, face): &(u32, u32)| {
            let rho = |p: Vec3| (f64::from(p.x) - center.x).hypot(f64::from(p.z) - center.z);
            scene.instance(instance).corners(face).into_iter().all(|corner| rho(corner) < least)
        };
        let nsf = partition.nsf().take_while(|&(instance, _)| instance < standing);
        let (fixed, bending): (Vec<_>, Vec<_>) = nsf.partition(inside);
        Ok(Self {
            fixed: Geometry::of(scene, fixed)?,
            bending: Geometry::of(scene, bending)?,
            split: Mutex::default(),
            nothing: Arc::default(),
            center,
            radii: [partition.r1(), partition.r2()],
        })
    }

    /// What the morph bends, as it is.
    pub fn unsplit(&self) -> Geometry {
        Geometry { bounded: false, ..self.bending.clone() }
    }

    /// What the morph bends, split for a user this far from the centre and a tolerance in radians.
    pub fn split(&self, reach: f64, tolerance: f64, kind: Kind, progress: &Progress) -> Result<Geometry> {
        let [r1, r2] = self.radii;
        // The next step outwards, and the next finer tolerance.
        let unit = r1.max(r2 / 16.0);
        let steps = (2.0 * (reach / unit).log2()).ceil().clamp(-40.0, 40.0);
        let finer = (2.0 * tolerance.log2()).floor().clamp(-80.0, 80.0);
        let cause = (steps as i32, finer as i32, kind);
        let mut known = self.split.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = known.iter().position(|(other, _)| *other == cause) {
            let entry = known.remove(found);
            known.push(entry);
            return Ok(known[known.len() - 1].1.clone());
        }
        let outwards = unit * (steps / 2.0).exp2();
        let reach = if reach <= BOUNDED * r1 { outwards.min(BOUNDED * r1) } else { outwards.max(reach) };
        let settings =
            Settings { center: self.center, r1, r2, reach, tolerance: (finer / 2.0).exp2().min(tolerance), kind };
        let rule = Rule::new(&settings, Precision::Single)?;
        let (scene, _) = split_scene(&self.bending.scene, &rule, progress)?;
        let geometry = Geometry { scene, sources: Arc::clone(&self.bending.sources), bounded: rule.holds() };
        if known.len() == KEPT {
            known.remove(0);
        }
        known.push((cause, geometry.clone()));
        Ok(geometry)
    }

    /// Triangles that stand and are drawn.
    pub fn triangle_count(&self, bending: &Geometry) -> u64 {
        (self.fixed.scene.triangle_count() + bending.scene.triangle_count()) as u64
    }
}

impl Geometry {
    fn of(scene: &Scene, faces: Vec<(u32, u32)>) -> Result<Self> {
        let mesh = scene.gathered(&faces)?;
        let instance = Instance::new(Arc::new(mesh), DAffine3::IDENTITY, None)?;
        let (materials, textures) = (Arc::clone(&scene.materials), Arc::clone(&scene.textures));
        let own = Scene::new(scene.origin, vec![instance], Vec::new(), materials, textures)?;
        Ok(Self { scene: own, sources: Arc::new(Sources { scene: scene.clone(), faces }), bounded: true })
    }
}
