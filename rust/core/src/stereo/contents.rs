//! Contents of the three views of a rig: instances, whether there is anything to draw, and triangle counts.

use glam::{DQuat, DVec3, DVec4};
use rayon::prelude::*;

use super::error::Axis;
use super::head::{Axes, Head};
use super::rig::{Eye, Rig, Side, corners};
use crate::base::{Aabb, Progress, Result};
use crate::camera::Fov;
use crate::scene::{Instance, Scene};
use crate::trace::touches;

/// Faces per task.
const CHUNK: usize = 1 << 16;
/// Instances per task.
const BOXES: usize = 1 << 12;

/// Instances that reach into the volume that a view draws.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Contents {
    /// Bit mask per instance of the views that may show it: 1 left eye, 2 right eye, 4 third camera.
    pub instances: Vec<u8>,
    /// Whether an eye may have surfaces before the plane.
    pub near: bool,
    /// Whether the third camera may have surfaces to draw.
    pub far: bool,
}

/// Triangles that reach into the volume that a view draws.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Triangles {
    /// Triangles drawn by the left eye, the right eye and the third camera.
    pub views: [u64; 3],
    /// Triangles drawn by all three.
    pub thrice: u64,
    /// Triangles in each eye's whole view, which plain stereo draws.
    pub plain: [u64; 2],
}

/// Half-spaces of the three views.
struct Views {
    eyes: [[DVec4; 4]; 2],
    center: [DVec4; 4],
    /// Depth slab that the eyes draw.
    near: Vec<DVec4>,
    /// Depth slab that the third camera draws.
    far: Vec<DVec4>,
}

impl Views {
    /// Creates the views, widened by a margin in pixels on each side.
    fn new(rig: &Rig, axes: &Axes, head: &Head, margin: f64) -> Self {
        let widened_view = |eye: Eye, size| axes.view(&Eye { fov: widen(&eye.fov, size, margin), ..eye });
        let eyes = Side::BOTH.map(|side| {
            let eye = rig.eye(side);
            widened_view(Eye { position: rig.middle + eye.position, ..*eye }, rig.size)
        });
        let behind = rig.middle + DVec3::new(0.0, 0.0, rig.setback);
        let center = Eye { fov: rig.center_fov, position: behind, orientation: DQuat::IDENTITY };
        let end = rig.planes.end;
        Self {
            eyes,
            center: widened_view(center, rig.center_size),
            near: axes.slab(head.near, head.far.min(end)),
            far: axes.slab(head.near.max(end - rig.overlap()), head.far),
        }
    }

    /// Returns whether an item lies between the sides of each eye's view; `overlaps` tests it against half-spaces.
    fn is_in_eyes(&self, overlaps: impl Fn(&[DVec4]) -> bool) -> [bool; 2] {
        self.eyes.each_ref().map(|sides| overlaps(sides))
    }

    /// Returns whether the left eye, the right eye and the third camera draw an item.
    fn views_that_draw(&self, sides: [bool; 2], overlaps: impl Fn(&[DVec4]) -> bool) -> [bool; 3] {
        let near = (sides[0] || sides[1]) && overlaps(&self.near);
        [sides[0] && near, sides[1] && near, overlaps(&self.far) && overlaps(&self.center)]
    }

    /// Returns the bit mask of the views that may draw something in a box.
    fn mask(&self, low: DVec3, high: DVec3) -> u8 {
        let overlaps = |planes: &[DVec4]| !is_outside(low, high, planes);
        let drawn = self.views_that_draw(self.is_in_eyes(overlaps), overlaps);
        drawn.iter().enumerate().map(|(n, &drawn)| u8::from(drawn) << n).sum()
    }
}

impl Rig {
    /// Finds the instances of each view in one pass over their boxes. With `traced`, a search tree also tests whether
    /// triangles lie before the plane in the eyes' region. All results are conservative.
    pub fn contents(&self, scene: &Scene, head: &Head, traced: bool, progress: &Progress) -> Result<Contents> {
        let axes = Axes::new(self, scene.origin, head);
        let margin = self.margin()?;
        let views = Views::new(self, &axes, head, margin);
        let boxes: Vec<&Instance> = scene.instances().collect();
        let mask = |instance: &&Instance| {
            let bounds = &instance.bounds;
            if bounds.is_empty() { 0 } else { views.mask(bounds.min.as_dvec3(), bounds.max.as_dvec3()) }
        };
        let instances: Vec<u8> = boxes.par_iter().with_min_len(BOXES).map(mask).collect();
        let has = |bits: u8| instances.iter().any(|views| views & bits != 0);
        let (mut near, far) = (has(3), has(4));
        if near && traced {
            scene.build(progress)?;
            near = touches(scene, &self.region_before(&axes, head, margin));
        }
        Ok(Contents { instances, near, far })
    }

    /// Counts the views that may draw each box, as `contents` does for instances. Corners are relative to the world's
    /// origin.
    pub fn draws(&self, boxes: &[[[f64; 3]; 2]], head: &Head, progress: &Progress) -> Result<Vec<u8>> {
        let views = Views::new(self, &Axes::new(self, DVec3::ZERO, head), head, self.margin()?);
        let count = |&[low, high]: &[[f64; 3]; 2]| views.mask(low.into(), high.into()).count_ones() as u8;
        progress.check()?;
        Ok(boxes.par_iter().with_min_len(BOXES).map(count).collect())
    }

    /// Returns the maximum distance in pixels of surfaces from their position, by pixel jitter and by the displacement
    /// in the zone.
    fn margin(&self) -> Result<f64> {
        let planes = self.planes;
        Ok(1.0 + if planes.begin < planes.end { self.max_error(planes.end, Axis::Both)? } else { 0.0 })
    }

    /// Returns the box around the volumes of both eyes, relative to the scene's origin.
    fn region_before(&self, axes: &Axes, head: &Head, margin: f64) -> Aabb {
        let end = self.planes.end.min(head.far);
        let mut region = Aabb::EMPTY;
        for side in Side::BOTH {
            let eye = self.eye(side);
            let fov = widen(&eye.fov, self.size, margin);
            for (corner, depth) in corners(&fov).into_iter().flat_map(|c| [(c, head.near), (c, end)]) {
                let direction = eye.orientation * corner.extend(-1.0);
                let distance = (depth + eye.position.z) / -direction.z;
                region.extend(axes.to_scene(self.middle + eye.position + direction * distance).as_vec3());
            }
        }
        region
    }

    /// Counts the triangles of each view one by one. The test is conservative: a triangle outside a view counts unless
    /// it lies outside a single side.
    pub fn triangles(&self, scene: &Scene, head: &Head, progress: &Progress) -> Result<Triangles> {
        let axes = Axes::new(self, scene.origin, head);
        let views = Views::new(self, &axes, head, 0.0);
        let whole = axes.slab(head.near, head.far);
        let count = |corners: [DVec3; 3]| -> Triangles {
            let overlaps =
                |planes: &[DVec4]| !planes.iter().any(|p| corners.iter().all(|c| p.truncate().dot(*c) + p.w < 0.0));
            let sides = views.is_in_eyes(overlaps);
            let drawn = views.views_that_draw(sides, overlaps);
            let all = overlaps(&whole);
            Triangles {
                views: drawn.map(u64::from),
                thrice: u64::from(drawn == [true; 3]),
                plain: sides.map(|side| u64::from(side && all)),
            }
        };
        progress.expect(scene.triangle_count() as u64);
        let chunks: Vec<(&Instance, u32, u32)> = scene.instances().flat_map(chunks_of).collect();
        let counted = chunks.into_par_iter().map(|(instance, first, end)| {
            let corners = |face| instance.corners(face).map(|corner| corner.as_dvec3());
            let sum = (first..end).map(|face| count(corners(face))).fold(Triangles::default(), Triangles::plus);
            progress.report(u64::from(end - first))?;
            Ok(sum)
        });
        counted.try_reduce(Triangles::default, |a, b| Ok(a.plus(b)))
    }
}

/// Widens a field of view by a margin in pixels on each side.
fn widen(fov: &Fov, (width, height): (u32, u32), margin: f64) -> Fov {
    let x = margin * (fov.right - fov.left) / f64::from(width);
    let y = margin * (fov.up - fov.down) / f64::from(height);
    Fov { left: fov.left - x, right: fov.right + x, down: fov.down - y, up: fov.up + y }
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

/// Splits an instance's faces into ranges.
fn chunks_of(instance: &Instance) -> impl Iterator<Item = (&Instance, u32, u32)> {
    let count = instance.mesh.faces.len();
    (0..count).step_by(CHUNK).map(move |first| (instance, first as u32, (first + CHUNK).min(count) as u32))
}

/// Returns whether a box lies entirely outside one of some half-spaces.
fn is_outside(low: DVec3, high: DVec3, planes: &[DVec4]) -> bool {
    planes.iter().any(|plane| {
        let n = plane.truncate();
        let farthest = DVec3::select(n.cmpgt(DVec3::ZERO), high, low);
        // Covers the corner's rounding error, so that nothing at the edge is lost.
        let slack = 1e-6 * farthest.abs().max_element() * n.length();
        n.dot(farthest) + plane.w + slack < 0.0
    })
}
