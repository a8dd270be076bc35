//! Near geometry as triangles to be traced: a fixed part, and parts that are morphed for each user.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use glam::{DAffine3, DVec3};

use super::pieces::{NearPart, NearPiece, Split};
use crate::base::memory::{try_append, try_extend};
use crate::base::{Progress, Result};
use crate::bend::on_ground;
use crate::morph::Morph;
use crate::partition::Partition;
use crate::scene::Scene;
use crate::tessellate::{Settings, Steps, bent_from};

/// Number of cached splits per part (static, moving), so that a user who walks back and forth between two steps of the
/// distance finds both.
const MAX_SPLITS: usize = 3;

/// Cache key of a split: steps of reach and tolerance, radii, and poses of moving objects (`None` for static parts).
#[derive(Clone, Debug, PartialEq)]
struct SplitKey {
    steps: Option<Steps>,
    radii: [f64; 2],
    poses: Option<Vec<DAffine3>>,
}

/// A split, the morph that it was last shown with, and the morphed near part.
type LastMorphed = (Arc<Split>, Morph, NearPart);

/// Near geometry of a reduced scene.
#[derive(Debug, Default)]
pub(super) struct NearGeometry {
    /// Static triangles with all corners inside r₁, which move only if the morph's radii or strength shrink.
    fixed: Option<NearPart>,
    /// r₁ and r₂ of the reduction, metres.
    radii: [f64; 2],
    /// All other static triangles: instance and face.
    bending: Vec<(u32, u32)>,
    /// Cached splits, the most recently used at the end.
    splits: Mutex<Vec<(SplitKey, Arc<Split>)>>,
    /// The static and moving part morphed last, because a user who stands still may request frames with other poses.
    last: Mutex<Vec<LastMorphed>>,
}

/// Near geometry as one user sees it.
pub(super) struct Morphed {
    /// Instance 0 holds the fixed pieces, instance 1 the morphed static pieces, instance 2 the moving ones.
    pub scene: Scene,
    pieces: [Arc<Vec<NearPiece>>; 3],
    /// Number of vertices that user and centre see in opposite directions.
    pub opposed: u64,
    /// Whether the tolerance is an upper bound.
    pub bounded: bool,
}

impl NearGeometry {
    /// Copies the triangles inside r₁ and lists the others.
    pub fn gather(partition: &Partition, progress: &Progress) -> Result<Self> {
        // Triangles with an edge between two points of r₁ are split, because triangles beyond may need the edge split.
        let [fixed, bending] = partition.nsf_inside(partition.r1)?;
        let fixed = NearPart::fixed(fixed, &partition.scene)?;
        fixed.instance.mesh.build_bvh(progress)?;
        let radii = [partition.r1, partition.r2];
        Ok(Self { fixed: Some(fixed), radii, bending, ..Self::default() })
    }

    /// Returns the size of the copies, bytes.
    pub fn bytes(&self) -> usize {
        let fixed = self.fixed.as_ref().map_or(0, |part| {
            size_of_val(&part.pieces[..]) + part.pieces.len() * 12 + part.instance.mesh.positions.len() * 12
        });
        fixed + size_of_val(&self.bending[..])
    }

    /// Returns near geometry as a user sees it, with all moving objects. For a user who stands still, only parts that
    /// moved are morphed again.
    pub fn morphed(
        &self,
        scene: &Scene,
        morph: &Morph,
        tolerance: Option<f64>,
        progress: &Progress,
    ) -> Result<Morphed> {
        let bends_all = bent_from(morph) < self.radii[0];
        let static_sources = || {
            let fixed = self.fixed.iter().filter(|_| bends_all).flat_map(|fixed| fixed.pieces.iter());
            let mut sources = Vec::new();
            try_extend(&mut sources, fixed.map(|piece| (piece.instance, piece.face)))?;
            try_append(&mut sources, &self.bending)?;
            Ok(sources)
        };
        let moving_sources = || {
            let first = scene.standing.instances().len();
            let instances = scene.moving.instances().iter().enumerate();
            let faces = instances.flat_map(|(number, instance)| {
                (0..instance.mesh.faces.len() as u32).map(move |face| ((first + number) as u32, face))
            });
            let mut sources = Vec::new();
            try_extend(&mut sources, faces)?;
            Ok(sources)
        };
        let fixed = match &self.fixed {
            Some(fixed) if !bends_all => fixed.clone(),
            _ => NearPart::fixed(vec![], scene)?,
        };
        let poses = scene.moving.instances().iter().map(|instance| instance.to_scene).collect();
        let static_split = self.split(static_sources, None, scene, morph, tolerance, progress)?;
        let moving_split = self.split(moving_sources, Some(poses), scene, morph, tolerance, progress)?;
        let static_part = self.morphed_part(&static_split, morph, progress)?;
        let moving_part = self.morphed_part(&moving_split, morph, progress)?;
        let opposed = static_part.opposed + moving_part.opposed;
        let bounded = static_part.bounded && moving_part.bounded;
        let parts = [fixed, static_part, moving_part];
        let instances = parts.iter().map(|part| part.instance.clone()).collect();
        let scene = Scene::new(scene.origin, instances, Vec::new(), Arc::default(), Arc::default())?;
        scene.build(progress)?;
        Ok(Morphed { scene, pieces: parts.map(|part| part.pieces), opposed, bounded })
    }

    /// Returns the split of some triangles, shared by all users at about the same distance from the centre. `poses`
    /// are given for moving objects.
    fn split(
        &self,
        sources: impl Fn() -> Result<Vec<(u32, u32)>>,
        poses: Option<Vec<DAffine3>>,
        scene: &Scene,
        morph: &Morph,
        tolerance: Option<f64>,
        progress: &Progress,
    ) -> Result<Arc<Split>> {
        let settings = tolerance.map(|tolerance| {
            let reach = (morph.user - morph.center).length();
            Settings::from_morph(morph, self.radii[1], reach, tolerance).stepped()
        });
        let steps = settings.map(|(steps, _)| steps);
        let key = SplitKey { steps, radii: [bent_from(morph), morph.r2], poses };
        let mut splits = self.splits();
        if let Some(index) = splits.iter().position(|(known, _)| *known == key) {
            splits[index..].rotate_left(1);
            return Ok(Arc::clone(&splits[splits.len() - 1].1));
        }
        drop(splits);
        let (is_moving, radius) = (key.poses.is_some(), self.radii[1]);
        let is_within = |point: DVec3| on_ground(point - morph.center).length() <= radius;
        // Moving objects are drawn beyond the near part, too.
        let drawn = |settings: Settings| if is_moving { f64::INFINITY } else { settings.drawn };
        let settings = settings.map(|(_, settings)| Settings { drawn: drawn(settings), ..settings });
        let split = Arc::new(Split::new(&sources()?, scene, settings, is_moving, is_within, progress)?);
        let mut splits = self.splits();
        if splits.len() >= 2 * MAX_SPLITS {
            splits.remove(0);
        }
        splits.push((key, Arc::clone(&split)));
        Ok(split)
    }

    /// Returns a split as a user sees it, from the cache if possible.
    fn morphed_part(&self, split: &Arc<Split>, morph: &Morph, progress: &Progress) -> Result<NearPart> {
        let is_same = |(known, known_morph, _): &&LastMorphed| Arc::ptr_eq(known, split) && known_morph == morph;
        if let Some((_, _, part)) = self.last().iter().find(is_same) {
            return Ok(part.clone());
        }
        let part = split.morphed(morph, progress)?;
        let mut last = self.last();
        last.retain(|(known, ..)| !Arc::ptr_eq(known, split));
        if last.len() == 2 {
            last.remove(0);
        }
        last.push((Arc::clone(split), *morph, part.clone()));
        Ok(part)
    }

    /// No lock may be held during parallel work: a thread that waits inside rayon may run the task of another frame.
    fn splits(&self) -> MutexGuard<'_, Vec<(SplitKey, Arc<Split>)>> {
        self.splits.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn last(&self) -> MutexGuard<'_, Vec<LastMorphed>> {
        self.last.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Morphed {
    /// Returns the piece of a hit on `scene`.
    #[inline]
    pub fn piece(&self, instance: u32, face: u32) -> &NearPiece {
        &self.pieces[instance as usize][face as usize]
    }

    /// Returns the number of traced triangles.
    pub fn triangle_count(&self) -> u64 {
        self.pieces.iter().map(|pieces| pieces.len() as u64).sum()
    }

    /// Returns the number of traced triangles that move.
    pub fn moving_triangles(&self) -> u64 {
        self.pieces[2].len() as u64
    }
}
