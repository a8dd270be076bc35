//! Frustum culling of boxes, and draw calls of the visible instances and face runs.

use std::collections::{BTreeMap, HashMap};
use std::ops::Range;
use std::sync::Arc;

use glam::{DVec3, DVec4, Vec3};
use nearfar_core::base::Aabb;
use nearfar_core::camera::Camera;
use nearfar_core::render::Limits;
use nearfar_core::scene::Instance;

use super::style::Displacement;
use super::view::Axes;
use super::window::{Mask, Window};
use crate::upload::{CHUNK, InstanceParts, Page};

/// Half-spaces that bound a view: normal and offset, relative to the scene's origin.
#[derive(Clone)]
pub(crate) struct Frustum {
    planes: Vec<DVec4>,
    /// Whether the window is the whole picture.
    is_whole_picture: bool,
    /// Frustum of the second view, if two are drawn at once.
    second_view: Option<Box<Frustum>>,
    /// Mask of the picture, and its camera relative to the scene's origin.
    mask: Option<(Arc<Mask>, Camera)>,
}

impl Frustum {
    /// Creates the frustum of a camera's window, bounded by the limits, for displaced points; eye and limits are
    /// relative to the scene's origin.
    pub fn new(camera: &Camera, window: &Window, eye: DVec3, limits: &Limits, displacement: &Displacement) -> Self {
        let Displacement { shift, slack } = *displacement;
        let (eye, far) = (eye - shift, f64::from(limits.segment.t_max));
        let Axes { right, up, ahead, fov } = Axes::new(camera);
        let fov = window.part_of(camera, &fov);
        let sides = [(right, fov.left, 1.0), (right, fov.right, -1.0), (up, fov.down, 1.0), (up, fov.up, -1.0)];
        let plane = |normal: DVec3, distance: f64| {
            let normal = normal.normalize();
            normal.extend(-normal.dot(eye) - distance + slack)
        };
        let parallel = camera.is_parallel();
        let mut planes: Vec<DVec4> = sides
            .into_iter()
            .map(|(axis, bound, sign)| match parallel {
                true => plane(sign * axis, sign * bound),
                false => plane(sign * (axis - bound * ahead), 0.0),
            })
            .collect();
        planes.push(plane(ahead, 0.0));
        if far.is_finite() {
            planes.push(plane(-ahead, -far));
        }
        planes.extend(limits.planes().iter().map(|plane| {
            let normal = plane.truncate();
            normal.extend(plane.w + normal.dot(shift) + slack * normal.length())
        }));
        let is_whole_picture = (window.width, window.height) == (camera.width, camera.height);
        Self { planes, is_whole_picture, second_view: None, mask: None }
    }

    /// Returns the union with another frustum.
    pub fn union(self, other: Self) -> Self {
        Self { second_view: Some(Box::new(other)), ..self }
    }

    /// Returns the frustum restricted to the drawn pixels of a mask; the camera is relative to the scene's origin.
    pub fn with_mask(self, mask: &Arc<Mask>, camera: Camera) -> Self {
        Self { mask: Some((Arc::clone(mask), camera)), ..self }
    }

    /// Returns false if no point of a box is visible.
    #[inline]
    pub fn sees(&self, bounds: &Aabb) -> bool {
        if bounds.is_empty() {
            return false;
        }
        let (low, high) = (bounds.min, bounds.max);
        let inside = self.planes.iter().all(|plane| {
            let pick = |i: usize| if plane[i] > 0.0 { high[i] } else { low[i] };
            let farthest = Vec3::new(pick(0), pick(1), pick(2)).as_dvec3();
            // The slack exceeds the corner's rounding error, so that nothing at the edge is lost.
            let slack = 1e-6 * farthest.abs().max_element();
            plane.truncate().dot(farthest) + plane.w + slack >= 0.0
        });
        inside && self.is_drawn(bounds) || self.second_view.as_ref().is_some_and(|view| view.sees(bounds))
    }

    /// Like `sees`, for a box that is known to pass the half-spaces of the whole picture.
    #[inline]
    pub fn sees_inside_picture(&self, bounds: &Aabb) -> bool {
        if self.is_whole_picture { self.is_drawn(bounds) } else { self.sees(bounds) }
    }

    /// Returns false if no drawn pixel of the mask shows a box.
    fn is_drawn(&self, bounds: &Aabb) -> bool {
        let Some((mask, camera)) = &self.mask else { return true };
        mask.pyramid.as_ref().is_none_or(|pyramid| pyramid.sees(camera, bounds))
    }
}

/// Draw call: vertices of a part, and the records that place them, as numbers within their set or batch.
pub(super) struct DrawCall {
    pub vertices: Range<u32>,
    pub records: Vec<u32>,
}

/// Returns draw calls, each with its page, for the instances of a set and the chunks of their faces that pass a
/// frustum, or for all if there is none. `may_show` flags the instances that are known to pass the half-spaces of the
/// whole picture; the others are skipped. Calls are in order of the first appearance of their part.
pub(super) fn visible_calls(
    instances: &[Instance],
    instance_parts: &[InstanceParts],
    frustum: Option<&Frustum>,
    may_show: Option<&[bool]>,
) -> Vec<(Arc<Page>, DrawCall)> {
    let sees = |bounds: &Aabb| frustum.is_none_or(|frustum| frustum.sees(bounds));
    let shows = |n: usize, bounds: &Aabb| match may_show {
        Some(flags) => flags[n] && frustum.is_none_or(|frustum| frustum.sees_inside_picture(bounds)),
        None => sees(bounds),
    };
    let mut calls: Vec<(Arc<Page>, DrawCall)> = Vec::new();
    // A part of one chunk is drawn with one call for all its placements, which may be many.
    let mut call_of_part: HashMap<(u64, u32), usize> = HashMap::new();
    for (n, (instance, InstanceParts { first_record, parts })) in instances.iter().zip(instance_parts).enumerate() {
        if instance.mesh.faces.is_empty() || !shows(n, &instance.bounds) {
            continue;
        }
        for (record, part) in (*first_record..).zip(parts.iter()) {
            let end = 3 * part.face_count;
            if part.chunks.len() == 1 {
                let call = *call_of_part.entry((part.page.number, part.words[1])).or_insert_with(|| {
                    calls.push((Arc::clone(&part.page), DrawCall { vertices: 0..end, records: Vec::new() }));
                    calls.len() - 1
                });
                calls[call].1.records.push(record);
                continue;
            }
            let mut run: Option<Range<u32>> = None;
            let call = |vertices| (Arc::clone(&part.page), DrawCall { vertices, records: vec![record] });
            for (chunk, bounds) in part.chunks.iter().enumerate() {
                let bounds = if instance.in_place { *bounds } else { bounds.transformed(&instance.to_scene) };
                if !sees(&bounds) {
                    continue;
                }
                let start = (3 * chunk * CHUNK) as u32;
                let stop = end.min(start + (3 * CHUNK) as u32);
                match &mut run {
                    Some(run) if run.end == start => run.end = stop,
                    _ => calls.extend(run.replace(start..stop).map(call)),
                }
            }
            calls.extend(run.map(call));
        }
    }
    calls
}

/// Selects the calls of a range of records, page by page; their record numbers become relative to the range.
pub(super) fn calls_within(calls: &[(Arc<Page>, DrawCall)], range: &Range<u32>) -> Vec<(Arc<Page>, Vec<DrawCall>)> {
    let mut pages: BTreeMap<u64, (Arc<Page>, Vec<DrawCall>)> = BTreeMap::new();
    for (page, call) in calls {
        let records: Vec<u32> = call.records.iter().filter(|r| range.contains(r)).map(|r| r - range.start).collect();
        if !records.is_empty() {
            let call = DrawCall { vertices: call.vertices.clone(), records };
            pages.entry(page.number).or_insert_with(|| (Arc::clone(page), Vec::new())).1.push(call);
        }
    }
    pages.into_values().collect()
}

#[cfg(test)]
mod tests {
    use glam::DQuat;
    use nearfar_core::camera::{Fov, Projection};
    use nearfar_core::render::Segment;

    use super::*;

    #[test]
    fn boxes_that_project_into_the_image_are_visible() {
        let fov = Fov { left: -0.7, right: 1.1, down: -0.9, up: 0.4 };
        for projection in [Projection::Perspective(fov), Projection::Orthographic(fov), Projection::CubeFace(1)] {
            let turn = DQuat::from_rotation_y(2.0) * DQuat::from_rotation_x(-0.5);
            let camera = Camera::new(DVec3::new(3.0, 1.0, 2.0), turn, projection, 16, 16).unwrap();
            let window = Window { column: 0, row: 0, width: 16, height: 16 };
            let limited = |t_max, planes: &[[f64; 4]]| {
                let limits = Limits::new(Segment { t_min: 0.0, t_max }, planes).unwrap();
                Frustum::new(&camera, &window, camera.position, &limits, &Displacement::NONE)
            };
            let frustum = limited(f32::INFINITY, &[]);
            let near = limited(4.0, &[]);
            // Only points above y = 1 pass.
            let above = limited(f32::INFINITY, &[[0.0, 2.0, 0.0, -2.0]]);
            let (mut seen, mut unseen, mut culled) = (0, 0, 0);
            for n in 0..4000u64 {
                let draw = |axis: u64| nearfar_core::base::random::uniform(7, n, axis) * 12.0 - 6.0;
                let point = DVec3::new(draw(0), draw(1), draw(2));
                let spot = Aabb { min: point.as_vec3(), max: point.as_vec3() };
                let inside = camera.project(point).is_some_and(|at| {
                    at.truncate().cmpge(glam::DVec2::ZERO).all() && at.truncate().cmple(glam::DVec2::splat(16.0)).all()
                });
                assert!(!inside || frustum.sees(&spot), "{projection:?} {point}");
                let close = (point - camera.position).length() < 4.0;
                assert!(!(inside && close) || near.sees(&spot), "{projection:?} {point}");
                assert_eq!(
                    above.sees(&spot),
                    frustum.sees(&spot) && point.as_vec3().y >= 1.0,
                    "{projection:?} {point}"
                );
                culled += u32::from(frustum.sees(&spot) && !near.sees(&spot));
                seen += u32::from(inside);
                unseen += u32::from(!frustum.sees(&spot));
            }
            assert!(seen > 50 && unseen > 500 && culled > 20, "{projection:?} {seen} {unseen} {culled}");
        }
    }
}
