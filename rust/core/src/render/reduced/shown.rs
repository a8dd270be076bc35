//! Near geometry as triangles to be traced: a fixed part, and parts that are morphed for each frame.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use glam::{DAffine3, DVec3, Vec3};
use rayon::prelude::*;

use crate::base::{FaceMap, Progress, Result};
use crate::morph::Morph;
use crate::partition::Partition;
use crate::scene::{Instance, Mesh, Scene};
use crate::tessellate::{self, Precision, Rule, Settings};

/// A piece of a scene's face, given by the positions of its three corners on the face.
#[derive(Clone, Copy, Debug)]
pub(super) struct NearPiece {
    pub instance: u32,
    pub face: u32,
    /// Weights of the face's second and third corner at the piece's corners.
    corners: [[f32; 2]; 3],
}

/// The corners of a whole face.
const WHOLE: [[f32; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

impl NearPiece {
    /// Converts weights on the piece to weights on the face. For a whole face they are equal, bit for bit.
    #[inline]
    pub fn on_face(&self, u: f32, v: f32) -> (f32, f32) {
        let [a, b, c] = self.corners;
        let mix = |i: usize| a[i] + u * (b[i] - a[i]) + v * (c[i] - a[i]);
        (mix(0), mix(1))
    }
}

/// Pieces and the mesh that is traced, face by face.
#[derive(Clone, Debug)]
struct NearPart {
    pieces: Arc<Vec<NearPiece>>,
    instance: Instance,
}

/// Morphed geometry for one user.
#[derive(Clone, Debug)]
struct Bending {
    part: NearPart,
    /// Vertices that user and centre see in opposite directions.
    opposed: u64,
    /// Whether the tolerance is an upper bound.
    bounded: bool,
}

/// Inputs of the morphed static part: the user's position and the tolerance in radians.
type Cause = (DVec3, Option<f64>);

/// Near geometry of a reduced scene.
#[derive(Debug, Default)]
pub(super) struct NearGeometry {
    /// Static triangles with all corners inside r₁, which no morph moves.
    fixed: Option<NearPart>,
    /// The other static triangles: instance and face.
    bending: Vec<(u32, u32)>,
    /// The last morphed static part. It is kept because a user who stands still may request frames with other poses of
    /// moving objects.
    last: Mutex<Option<(Cause, Bending)>>,
}

/// Near geometry as one user sees it.
pub(super) struct Shown {
    /// Instance 0 holds the fixed pieces, instance 1 the morphed static pieces, instance 2 the moving ones.
    pub scene: Scene,
    pieces: [Arc<Vec<NearPiece>>; 3],
    /// Vertices that user and centre see in opposite directions.
    pub opposed: u64,
    /// Whether the tolerance is an upper bound.
    pub bounded: bool,
}

impl NearGeometry {
    /// Copies the triangles inside r₁ and lists the others.
    pub fn gather(partition: &Partition, progress: &Progress) -> Result<Self> {
        let scene = partition.scene();
        // Edges between two points of r₁ are split for the triangles beyond them, so the triangles within must be split
        // as well.
        let [fixed, bending] = partition.nsf_inside(partition.r1());
        let pieces = fixed.into_iter().map(|(instance, face)| NearPiece { instance, face, corners: WHOLE }).collect();
        let corners = |piece: &NearPiece| scene.instance(piece.instance).corners(piece.face);
        let fixed = NearPart::new(pieces, corners)?;
        fixed.instance.mesh.build_bvh(progress)?;
        Ok(Self { fixed: Some(fixed), bending, last: Mutex::default() })
    }

    /// Size of the copies, bytes.
    pub fn bytes(&self) -> usize {
        let fixed = self.fixed.as_ref().map_or(0, |part| part.pieces.len() * (size_of::<NearPiece>() + 9 * 4 + 3 * 4));
        fixed + size_of_val(&self.bending[..])
    }

    /// Near geometry as a user sees it, with all moving objects. For a user who stands still, only moving parts are
    /// morphed again.
    pub fn morphed(&self, scene: &Scene, morph: &Morph, tolerance: Option<f64>, progress: &Progress) -> Result<Shown> {
        let standing = self.standing(scene, morph, tolerance, progress)?;
        let first = scene.standing.instances().len();
        let faces = scene.moving.instances().iter().enumerate().flat_map(|(number, instance)| {
            (0..instance.mesh.faces.len() as u32).map(move |face| ((first + number) as u32, face))
        });
        let moving = Bending::new(faces.collect(), true, scene, morph, tolerance, progress)?;
        let fixed = match &self.fixed {
            Some(fixed) => fixed.clone(),
            None => NearPart::new(Vec::new(), |_| Default::default())?,
        };
        let (opposed, bounded) = (standing.opposed + moving.opposed, standing.bounded);
        let parts = [fixed, standing.part, moving.part];
        let instances = parts.iter().map(|part| part.instance.clone()).collect();
        let scene = Scene::new(scene.origin, instances, Vec::new(), Arc::default(), Arc::default())?;
        scene.build(progress)?;
        Ok(Shown { scene, pieces: parts.map(|part| part.pieces), opposed, bounded })
    }

    fn standing(&self, scene: &Scene, morph: &Morph, tolerance: Option<f64>, progress: &Progress) -> Result<Bending> {
        let cause = (morph.user, tolerance);
        if let Some((known, bending)) = &*self.last()
            && *known == cause
        {
            return Ok(bending.clone());
        }
        let bending = Bending::new(self.bending.clone(), false, scene, morph, tolerance, progress)?;
        bending.part.instance.mesh.build_bvh(progress)?;
        *self.last() = Some((cause, bending.clone()));
        Ok(bending)
    }

    /// The lock is never held while work is shared out: a thread that waits inside rayon may run the task of another
    /// frame.
    fn last(&self) -> MutexGuard<'_, Option<(Cause, Bending)>> {
        self.last.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Bending {
    fn new(
        sources: Vec<(u32, u32)>,
        moving: bool,
        scene: &Scene,
        morph: &Morph,
        tolerance: Option<f64>,
        progress: &Progress,
    ) -> Result<Self> {
        progress.check()?;
        let rule = tolerance.map(|tolerance| rule_of(morph, tolerance)).transpose()?;
        let split = |whole: tessellate::Piece| {
            let Some(rule) = &rule else { return Ok(vec![whole]) };
            let unseen =
                |corners: &[DVec3; 3]| tessellate::Piece::is_thin(corners) || (!moving && rule.is_beyond(corners));
            whole.split(rule, Precision::Double, unseen, |_| progress.check())
        };
        let triangles = sources.into_par_iter().map(|(instance, face)| {
            let corners = scene.instance(instance).corners(face).map(|corner| corner.as_dvec3());
            let place = |piece: tessellate::Piece| {
                let corners = piece.weights.map(|[_, u, v]| [u as f32, v as f32]);
                (NearPiece { instance, face, corners }, piece.corners)
            };
            Ok(split(tessellate::Piece::whole(corners))?.into_iter().map(place).collect())
        });
        let triangles: Vec<Vec<(NearPiece, [DVec3; 3])>> = triangles.collect::<Result<_>>()?;
        let triangles: Vec<(NearPiece, [DVec3; 3])> = triangles.into_iter().flatten().collect();
        progress.check()?;
        let morphed = |corner: DVec3| {
            let shown = morph.examine(corner);
            (shown.point.as_vec3(), u64::from(shown.opposed))
        };
        let corners: Vec<[(Vec3, u64); 3]> = triangles.par_iter().map(|(_, corners)| corners.map(morphed)).collect();
        let opposed = corners.iter().flatten().map(|(_, opposed)| opposed).sum();
        let mut shown = corners.into_iter().map(|corners| corners.map(|(point, _)| point));
        let pieces = triangles.into_iter().map(|(piece, _)| piece).collect();
        Ok(Self {
            part: NearPart::new(pieces, |_| shown.next().unwrap_or_default())?,
            opposed,
            bounded: rule.is_some_and(|rule| rule.holds()),
        })
    }
}

/// The rule that splits edges for one user. It holds for all users at the same distance from the centre.
fn rule_of(morph: &Morph, tolerance: f64) -> Result<Rule> {
    let settings = Settings {
        center: morph.center,
        r1: morph.r1,
        r2: morph.r2,
        reach: (morph.user - morph.center).length(),
        tolerance,
        kind: morph.kind,
    };
    Rule::new(&settings, Precision::Double)
}

impl NearPart {
    fn new(pieces: Vec<NearPiece>, mut corners: impl FnMut(&NearPiece) -> [Vec3; 3]) -> Result<Self> {
        let positions: Vec<[f32; 3]> = pieces.iter().flat_map(|piece| corners(piece).map(|p| p.to_array())).collect();
        let faces = (0..pieces.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let (objects, materials) = (FaceMap::Uniform(-1), FaceMap::Uniform(-1));
        let mesh = Mesh::new(positions.into(), faces, None, None, objects, materials)?;
        let instance = Instance::new(Arc::new(mesh), DAffine3::IDENTITY, None)?;
        Ok(Self { pieces: Arc::new(pieces), instance })
    }
}

impl Shown {
    /// The piece that a hit on `scene` belongs to.
    #[inline]
    pub fn piece(&self, instance: u32, face: u32) -> &NearPiece {
        &self.pieces[instance as usize][face as usize]
    }

    /// Whether an instance holds pieces that no morph moves.
    #[inline]
    pub fn is_fixed(instance: u32) -> bool {
        instance == 0
    }

    /// Number of traced triangles.
    pub fn triangle_count(&self) -> u64 {
        self.pieces.iter().map(|pieces| pieces.len() as u64).sum()
    }

    /// Number of traced triangles that move.
    pub fn moving_triangles(&self) -> u64 {
        self.pieces[2].len() as u64
    }
}
