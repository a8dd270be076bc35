//! Triangulation of polygons in space: faces of OBJ, PLY and OFF files.

use glam::DVec3;

use super::outlines::check_offsets;
use super::triangulate::{Clipper, Faces, by_polygon};
use crate::base::{Progress, Result, ensure};

/// Area, relative to the polygon's, that rounding errors of collinear points cause.
const ROUNDING: f64 = 1e-9;

/// Greatest number of corners of a polygon that is clipped. Clipping one cannot be interrupted, and takes cubic time
/// if the outline crosses itself.
const MAX_CLIPPED: usize = 1 << 13;

/// Triangulates polygons between `points`: polygon p has the corners `corners[offsets[p]..offsets[p + 1]]`.
///
/// Returns triangles of corner numbers, oriented like their polygons. Polygons of fewer than three corners have none.
/// Polygons that cross themselves, have no area or more than 8,192 corners, with coordinates that are not finite or with corners that are no
/// points, become fans.
pub fn triangulate_faces(points: &[[f64; 3]], corners: &[u32], offsets: &[i64], progress: &Progress) -> Result<Faces> {
    ensure!(corners.len() <= u32::MAX as usize, "corners", "fewer than 2^32", corners.len());
    check_offsets("offsets", offsets, corners.len())?;
    by_polygon(offsets.len() - 1, progress, FaceClipper::default, |clipper, polygon, faces| {
        let [start, end] = [offsets[polygon], offsets[polygon + 1]].map(|offset| offset as u32);
        let position = |corner: &u32| points.get(*corner as usize).map_or(DVec3::NAN, |&point| point.into());
        let ring = corners[start as usize..end as usize].iter().map(position);
        let triangles = if fan_covers(ring.clone()) { None } else { clipper.clip(ring) };
        match triangles {
            Some(triangles) => faces.extend(triangles.iter().map(|face| face.map(|corner| start + corner))),
            None => faces.extend((start + 2..end).map(|corner| [start, corner - 1, corner])),
        }
    })
}

/// Reusable state that triangulates one polygon at a time.
pub(in crate::scene) struct FaceClipper {
    planar: Clipper,
    /// Points relative to the first one.
    local: Vec<DVec3>,
}

impl Default for FaceClipper {
    fn default() -> Self {
        Self { planar: Clipper::new(), local: Vec::new() }
    }
}

impl FaceClipper {
    /// Returns a polygon's triangles as numbers of its points; `None` if it has no area or crosses itself, so that no
    /// triangles have its area.
    pub(in crate::scene) fn clip(&mut self, points: impl Iterator<Item = DVec3>) -> Option<&[[u32; 3]]> {
        self.local.clear();
        let mut first = None;
        self.local.extend(points.map(|point| point - *first.get_or_insert(point)));
        if self.local.len() > MAX_CLIPPED {
            return None;
        }
        let normal: DVec3 = self.local.windows(2).map(|pair| pair[0].cross(pair[1])).sum();
        let (u, v) = normal.try_normalize()?.any_orthonormal_pair();
        self.planar.clip_ring(self.local.iter().map(|point| [point.dot(u), point.dot(v)]));
        let has_area = (self.planar.doubled_area() - normal.length()).abs() <= ROUNDING * normal.length();
        has_area.then_some(self.planar.triangles.as_slice())
    }
}

/// Returns whether a fan from a polygon's first point covers it: no triangle is turned against Newell's normal. True for
/// points that are not finite.
pub(in crate::scene) fn fan_covers(points: impl Iterator<Item = DVec3> + Clone) -> bool {
    let mut others = points;
    let Some(first) = others.next() else { return true };
    let mut next = others.clone();
    // Most faces are triangles or quads.
    let (Some(b), Some(c), Some(d)) = (next.next(), next.next(), next.next()) else { return true };
    if next.next().is_none() {
        let (to_b, to_c, to_d) = (b - first, c - first, d - first);
        let (before, after) = (to_b.cross(to_c), to_c.cross(to_d));
        let normal = before + after;
        let limit = -ROUNDING * normal.length_squared();
        let is_turned = before.dot(normal) < limit || after.dot(normal) < limit;
        return !is_turned;
    }
    let local = others.map(|point| point - first);
    let fan = || local.clone().zip(local.clone().skip(1)).map(|(a, b)| a.cross(b));
    let normal: DVec3 = fan().sum();
    let limit = -ROUNDING * normal.length_squared();
    !fan().any(|cross| cross.dot(normal) < limit)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Returns the triangles' areas along a normal, and the length of the sum of their area vectors.
    fn areas(points: &[[f64; 3]], normal: DVec3) -> (Vec<f64>, f64) {
        let corners: Vec<u32> = (0..points.len() as u32).collect();
        let found = triangulate_faces(points, &corners, &[0, points.len() as i64], &Progress::new()).unwrap();
        let vectors = found.faces.iter().map(|face| {
            let [a, b, c] = face.map(|corner| DVec3::from(points[corner as usize]));
            (b - a).cross(c - a) / 2.0
        });
        let vectors: Vec<DVec3> = vectors.collect();
        (vectors.iter().map(|vector| vector.dot(normal)).collect(), vectors.iter().sum::<DVec3>().length())
    }

    #[test]
    fn a_dart_has_its_area_from_every_first_corner() {
        // An arrowhead of area 1, slightly bent.
        for height in [0.0, 0.01] {
            let dart = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.0, 2.0, 0.0], [1.0, 1.0, height]];
            for first in 0..4 {
                let mut points = dart;
                points.rotate_left(first);
                let (signed, sum) = areas(&points, DVec3::Z);
                assert_eq!(signed.len(), 2);
                assert!(signed.iter().all(|&area| area > 0.0), "{first} {signed:?}");
                assert!((signed.iter().sum::<f64>() - 1.0).abs() < 1e-12 && (sum - 1.0).abs() < 1e-3);
                points.reverse();
                assert!((areas(&points, -DVec3::Z).0.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn convex_and_unusable_polygons_are_fans() {
        let points =
            [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [f64::NAN, 0.0, 0.0], [-0.5, 3.0, 0.0]];
        // Two corners; then a missing number, a missing point, no area, and crossing edges.
        let corners = [0, 1, 2, 3, 0, 1, 0, 1, 4, 3, 0, 1, 2, 9, 0, 0, 0, 0, 0, 1, 5, 2];
        let found = triangulate_faces(&points, &corners, &[0, 4, 6, 10, 14, 18, 22], &Progress::new()).unwrap();
        let fan = |start: u32| [[start, start + 1, start + 2], [start, start + 2, start + 3]];
        assert_eq!(found.faces, [fan(0), fan(6), fan(10), fan(14), fan(18)].concat());
        assert_eq!(found.offsets, [0, 2, 2, 4, 6, 8, 10]);
    }

    proptest! {
        /// Star-shaped polygons in any plane: triangles are not turned, and their areas follow the shoelace formula.
        #[test]
        fn areas_are_those_of_the_polygons(
            radii in proptest::collection::vec(1.0..9.0f64, 4..40),
            (tilt, turn) in (0.0..3.0f64, 0.0..6.0f64),
            first in 0..40usize,
        ) {
            let rotation = glam::DQuat::from_euler(glam::EulerRot::XYZ, tilt, turn, 1.0);
            let step = std::f64::consts::TAU / radii.len() as f64;
            let ring = radii.iter().enumerate().map(|(n, &r)| {
                let (y, x) = (step * n as f64).sin_cos();
                (rotation * DVec3::new(r * x, r * y, 50.0)).to_array()
            });
            let mut points: Vec<[f64; 3]> = ring.collect();
            points.rotate_left(first % radii.len());
            let pairs = radii.iter().zip(radii.iter().cycle().skip(1));
            let expected = pairs.map(|(a, b)| a * b * step.sin() / 2.0).sum::<f64>();
            let (signed, _) = areas(&points, rotation * DVec3::Z);
            prop_assert!(signed.iter().all(|&area| area > -1e-9 * expected));
            prop_assert!((signed.iter().sum::<f64>() - expected).abs() < 1e-9 * expected);
        }
    }
}
