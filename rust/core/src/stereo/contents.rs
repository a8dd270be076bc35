//! What a scene has in the three views of a rig: whether there is anything to draw, and how many triangles.

use glam::{DQuat, DVec3, DVec4};
use rayon::prelude::*;

use super::head::{Axes, Head};
use super::rig::{Eye, Rig, Side, corners};
use crate::base::{Aabb, Progress, Result};
use crate::scene::{Instance, Scene};
use crate::trace::touches;

/// Faces of one task.
const TILE: usize = 1 << 16;

/// Triangles that reach into the part of space that a view draws.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Triangles {
    /// Of the left eye, the right eye and the third camera.
    pub views: [u64; 3],
    /// Those that all three draw.
    pub thrice: u64,
    /// Those of each eye's whole view, which plain stereo draws.
    pub plain: [u64; 2],
}

impl Rig {
    /// Whether a scene has surfaces that the eyes draw, and surfaces that the third camera draws; true may be a false
    /// alarm, because boxes of geometry are tested against the box of the eyes' views.
    pub fn reaches(&self, scene: &Scene, head: &Head, progress: &Progress) -> Result<[bool; 2]> {
        scene.build(progress)?;
        let axes = Axes::new(self, scene, head);
        let end = self.planes().end.min(head.far);
        let mut region = Aabb::EMPTY;
        for side in Side::BOTH {
            for (corner, depth) in corners(&self.eye(side).fov).into_iter().flat_map(|c| [(c, head.near), (c, end)]) {
                let eye = self.eye(side);
                let way = eye.orientation * corner.extend(-1.0);
                let from = self.middle() + eye.position;
                let at = from + way * ((depth + eye.position.z) / -way.z);
                region.extend(axes.place(at).as_vec3());
            }
        }
        let beyond = axes.slab(head.near.max(self.planes().end - self.overlap()), head.far);
        Ok([touches(scene, &region), !is_outside(&scene.bounds(), &beyond)])
    }

    /// Counts the triangles of each view, one by one; false alarms are those outside of a view's edge but of none of its
    /// sides.
    pub fn triangles(&self, scene: &Scene, head: &Head, progress: &Progress) -> Result<Triangles> {
        let axes = Axes::new(self, scene, head);
        let planes = self.planes();
        let eyes = Side::BOTH
            .map(|side| axes.view(&Eye { position: self.middle() + self.eye(side).position, ..*self.eye(side) }));
        let behind = self.middle() + DVec3::new(0.0, 0.0, self.setback());
        let center = axes.view(&Eye { fov: self.center_fov(), position: behind, orientation: DQuat::IDENTITY });
        let whole = axes.slab(head.near, head.far);
        let near = axes.slab(head.near, head.far.min(planes.end));
        let far = axes.slab(head.near.max(planes.end - self.overlap()), head.far);
        let count = |corners: [DVec3; 3]| -> Triangles {
            let misses =
                |planes: &[DVec4]| planes.iter().any(|p| corners.iter().all(|c| p.truncate().dot(*c) + p.w < 0.0));
            let sides = eyes.each_ref().map(|view| !misses(view));
            let [before, all] = [&near, &whole].map(|slab| !misses(slab));
            let seen = [sides[0] && before, sides[1] && before, !misses(&far) && !misses(&center)];
            Triangles {
                views: seen.map(u64::from),
                thrice: u64::from(seen == [true; 3]),
                plain: sides.map(|side| u64::from(side && all)),
            }
        };
        progress.expect(scene.triangle_count() as u64);
        let tiles: Vec<(&Instance, u32, u32)> = scene.instances().flat_map(tiles_of).collect();
        let counted = tiles.into_par_iter().map(|(instance, first, end)| {
            let corners = |face| instance.corners(face).map(|corner| corner.as_dvec3());
            let sum = (first..end).map(|face| count(corners(face))).fold(Triangles::default(), Triangles::plus);
            progress.report(u64::from(end - first))?;
            Ok(sum)
        });
        counted.try_reduce(Triangles::default, |a, b| Ok(a.plus(b)))
    }
}

impl Triangles {
    fn plus(self, other: Self) -> Self {
        Self {
            views: std::array::from_fn(|n| self.views[n] + other.views[n]),
            thrice: self.thrice + other.thrice,
            plain: std::array::from_fn(|n| self.plain[n] + other.plain[n]),
        }
    }
}

/// Ranges of an instance's faces.
fn tiles_of(instance: &Instance) -> impl Iterator<Item = (&Instance, u32, u32)> {
    let count = instance.mesh.faces.len();
    (0..count).step_by(TILE).map(move |first| (instance, first as u32, (first + TILE).min(count) as u32))
}

/// Whether a box lies wholly outside one of some half-spaces; an empty one does.
fn is_outside(bounds: &Aabb, planes: &[DVec4]) -> bool {
    let (low, high) = (bounds.min.as_dvec3(), bounds.max.as_dvec3());
    bounds.is_empty()
        || planes.iter().any(|plane| {
            let n = plane.truncate();
            let farthest = DVec3::select(n.cmpgt(DVec3::ZERO), high, low);
            n.dot(farthest) + plane.w < 0.0
        })
}
