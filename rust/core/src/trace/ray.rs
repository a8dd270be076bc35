//! Rays, hits, and hit filters.

use glam::Vec3;

use crate::scene::Scene;

/// A segment of a ray in scene space. The direction may have any length, and parameters `t` are multiples of it.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Start relative to the scene's origin; coordinates are at most `base::MAX_COORDINATE`.
    pub origin: Vec3,
    /// Direction, finite and not zero.
    pub direction: Vec3,
    /// Minimum parameter of a hit.
    pub t_min: f32,
    /// Maximum parameter of a hit.
    pub t_max: f32,
}

impl Ray {
    /// A ray with an empty segment, which hits nothing.
    pub const EMPTY: Self = Self { origin: Vec3::ZERO, direction: Vec3::NEG_Z, t_min: 1.0, t_max: 0.0 };
}

/// Intersection of a ray with a triangle: the point is (1−u−v) a + u b + v c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Parameter along the ray; infinite for a miss.
    pub t: f32,
    /// Weight of the second corner.
    pub u: f32,
    /// Weight of the third corner.
    pub v: f32,
    /// Instance in the scene; `u32::MAX` for a miss.
    pub instance: u32,
    /// Face in the instance's mesh.
    pub face: u32,
}

impl Hit {
    /// Value for a ray without a hit.
    pub const MISS: Self = Self { t: f32::INFINITY, u: 0.0, v: 0.0, instance: u32::MAX, face: u32::MAX };

    /// Returns whether nothing was hit.
    pub fn is_miss(&self) -> bool {
        self.instance == u32::MAX
    }

    /// Returns whether this hit is nearer. Ties go to the lower (instance, face), so the result depends neither on the
    /// tree nor on the order of visits.
    pub(super) fn is_before(&self, other: &Self) -> bool {
        self.t < other.t || (self.t == other.t && (self.instance, self.face) < (other.instance, other.face))
    }
}

/// Hits on a face that count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaceHits {
    /// No hit counts.
    None,
    /// Hits that `HitFilter::accepts` accepts.
    Accepted,
    /// Every hit counts.
    All,
}

/// Filter of intersections, for cut-out materials and for pixels split at a radius.
///
/// The kernels take a trait object, because they call it only for triangles that a ray crosses before its best hit, and
/// because a copy of the kernels for each filter would take half of the crate's compile time.
pub trait HitFilter: Sync {
    /// Returns the hits on a face that count. Called before `accepts`, once for many rays.
    fn face_hits(&self, _instance: u32, _face: u32) -> FaceHits {
        FaceHits::Accepted
    }

    /// Returns whether a hit counts; called only for faces with `FaceHits::Accepted`.
    fn accepts(&self, _ray: &Ray, _candidate: &Hit) -> bool {
        true
    }
}

/// Filter that accepts every intersection.
pub struct AcceptAll;

impl HitFilter for AcceptAll {
    fn face_hits(&self, _instance: u32, _face: u32) -> FaceHits {
        FaceHits::All
    }
}

/// Filter that rejects hits in the holes of cut-out materials; `inner` decides about all other hits.
pub struct AlphaFilter<'a, F> {
    /// The scene; `None` if no material has holes.
    cutouts: Option<&'a Scene>,
    inner: F,
}

impl<'a, F: HitFilter> AlphaFilter<'a, F> {
    /// Creates a filter for hits on a scene.
    pub fn new(scene: &'a Scene, inner: F) -> Self {
        Self { cutouts: scene.has_cutouts().then_some(scene), inner }
    }
}

impl<F: HitFilter> HitFilter for AlphaFilter<'_, F> {
    fn face_hits(&self, instance: u32, face: u32) -> FaceHits {
        let hits = self.inner.face_hits(instance, face);
        match self.cutouts {
            Some(scene) if hits == FaceHits::All && scene.may_have_hole(&scene.instance(instance).mesh, face) => {
                FaceHits::Accepted
            }
            _ => hits,
        }
    }

    fn accepts(&self, ray: &Ray, candidate: &Hit) -> bool {
        let is_solid = self.cutouts.is_none_or(|scene| {
            scene.is_solid(&scene.instance(candidate.instance).mesh, candidate.face, (candidate.u, candidate.v))
        });
        is_solid && self.inner.accepts(ray, candidate)
    }
}
