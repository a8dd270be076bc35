//! Triangulation of polygons in space: faces of OBJ, PLY and OFF files.

use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;

use super::outlines::check_offsets;
use super::triangulate::{Clipper, Faces, collect_faces};
use crate::base::{Progress, Result, ensure};

/// Maximum area, relative to the polygon's, of a triangle that counts as one without area: rounding errors give such an
/// area to collinear points.
const ROUNDING: f64 = 1e-9;

/// Maximum number of corners of a polygon whose ears are clipped. Clipping cannot be interrupted, and takes cubic time
/// if the outline crosses itself.
const MAX_CLIPPED: usize = 1 << 13;

/// Numbers of polygons that are drawn as fans although these do not cover them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Fans {
    /// Polygons of more than 8,192 corners.
    pub large: u64,
    /// Polygons whose outline crosses itself.
    pub crossing: u64,
}

impl Fans {
    /// Counts a polygon.
    pub(in crate::scene) fn count(&mut self, reason: Unclipped) {
        self.large += u64::from(reason == Unclipped::Large);
        self.crossing += u64::from(reason == Unclipped::Crossing);
    }
}

/// Reasons why a polygon cannot be clipped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::scene) enum Unclipped {
    /// More than 8,192 corners.
    Large,
    /// The outline crosses itself.
    Crossing,
    /// All points lie on a line.
    Flat,
}

/// Triangulates polygons between `points`: polygon p has the corners `corners[offsets[p]..offsets[p + 1]]`.
///
/// Returns triangles of corner numbers, oriented like their polygons. Polygons of fewer than three corners have none.
/// A corner in the middle of a straight side belongs to triangles with an area; of several corners at one position some
/// may be unused. A polygon becomes a fan if it crosses itself, has no area or more than 8,192 corners, or if a corner
/// is not finite or names no point.
pub fn triangulate_faces(
    points: &[[f64; 3]],
    corners: &[u32],
    offsets: &[i64],
    progress: &Progress,
) -> Result<(Faces, Fans)> {
    ensure!(corners.len() <= u32::MAX as usize, "corners", "fewer than 2^32", corners.len());
    check_offsets("offsets", offsets, corners.len())?;
    let [large, crossing] = [AtomicU64::new(0), AtomicU64::new(0)];
    let faces = collect_faces(offsets.len() - 1, progress, FaceClipper::default, |clipper, polygon, faces| {
        let [start, end] = [offsets[polygon], offsets[polygon + 1]].map(|offset| offset as u32);
        let position = |corner: &u32| points.get(*corner as usize).map_or(DVec3::NAN, |&point| point.into());
        let ring = corners[start as usize..end as usize].iter().map(position);
        let triangles = if fan_covers(ring.clone()) { None } else { Some(clipper.clip(ring)) };
        match triangles {
            Some(Ok(triangles)) => {
                faces.extend(triangles.iter().map(|face| face.map(|corner| start + corner)));
                return Ok(());
            }
            Some(Err(Unclipped::Large)) => _ = large.fetch_add(1, Ordering::Relaxed),
            Some(Err(Unclipped::Crossing)) => _ = crossing.fetch_add(1, Ordering::Relaxed),
            Some(Err(Unclipped::Flat)) | None => {}
        }
        faces.extend((start + 2..end).map(|corner| [start, corner - 1, corner]));
        Ok(())
    })?;
    Ok((faces, Fans { large: large.into_inner(), crossing: crossing.into_inner() }))
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
    /// Returns a polygon's triangles as numbers of its points.
    pub(in crate::scene) fn clip(
        &mut self,
        points: impl Iterator<Item = DVec3>,
    ) -> std::result::Result<&[[u32; 3]], Unclipped> {
        self.local.clear();
        let mut first = None;
        self.local.extend(points.map(|point| point - *first.get_or_insert(point)));
        if self.local.len() > MAX_CLIPPED {
            return Err(Unclipped::Large);
        }
        let crosses = || self.local.windows(2).map(|pair| pair[0].cross(pair[1]));
        let normal: DVec3 = crosses().sum();
        let Some(axis) = normal.try_normalize() else {
            let is_flat = crosses().all(|cross| cross == DVec3::ZERO);
            return Err(if is_flat { Unclipped::Flat } else { Unclipped::Crossing });
        };
        let (u, v) = axis.any_orthonormal_pair();
        self.planar.clip_ring(self.local.iter().map(|point| [point.dot(u), point.dot(v)]));
        let has_area = (self.planar.doubled_area() - normal.length()).abs() <= ROUNDING * normal.length();
        if has_area { Ok(self.planar.triangles.as_slice()) } else { Err(Unclipped::Crossing) }
    }
}

/// Returns whether the fan from a polygon's first point covers the polygon with triangles that have an area, none of
/// them turned against Newell's normal. Also true for points that are not finite.
///
/// Polygons that are too large to be clipped may have triangles without area: the first triangles of a regular polygon
/// have less area than the rounding error.
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
        let limit = ROUNDING * normal.length_squared();
        let is_wrong = before.dot(normal) <= limit || after.dot(normal) <= limit;
        return !is_wrong;
    }
    let local = others.map(|point| point - first);
    let fan = || local.clone().zip(local.clone().skip(1)).map(|(a, b)| a.cross(b));
    let (normal, corners) = fan().fold((DVec3::ZERO, 2), |(sum, corners), cross| (sum + cross, corners + 1));
    let rounding = if corners > MAX_CLIPPED { -ROUNDING } else { ROUNDING };
    let limit = rounding * normal.length_squared();
    !fan().any(|cross| cross.dot(normal) <= limit)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Returns the triangles' areas along a normal, and the length of the sum of their area vectors.
    fn areas(points: &[[f64; 3]], normal: DVec3) -> (Vec<f64>, f64) {
        let corners: Vec<u32> = (0..points.len() as u32).collect();
        let (found, _) = triangulate_faces(points, &corners, &[0, points.len() as i64], &Progress::new()).unwrap();
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
        let (found, fans) = triangulate_faces(&points, &corners, &[0, 4, 6, 10, 14, 18, 22], &Progress::new()).unwrap();
        let fan = |start: u32| [[start, start + 1, start + 2], [start, start + 2, start + 3]];
        assert_eq!(found.faces, [fan(0), fan(6), fan(10), fan(14), fan(18)].concat());
        assert_eq!(found.offsets, [0, 2, 2, 4, 6, 8, 10]);
        assert_eq!(fans, Fans { large: 0, crossing: 1 });
    }

    #[test]
    fn large_concave_polygons_are_counted() {
        let count = MAX_CLIPPED + 2;
        let spike = |n: usize| [n as f64, if n.is_multiple_of(2) { 1.0 } else { 0.5 }, 0.0];
        // A corner so far below the spikes that no edge to it crosses them.
        let mut points = vec![spike(0), [4000.0, -1e6, 0.0]];
        points.extend((1..count - 1).rev().map(spike));
        let corners: Vec<u32> = (0..count as u32).collect();
        let fans_of = |end: usize| {
            let offsets = [0, end as i64, count as i64];
            triangulate_faces(&points, &corners, &offsets, &Progress::new()).unwrap().1
        };
        assert_eq!(fans_of(0), Fans { large: 1, crossing: 0 });
        assert_eq!(fans_of(MAX_CLIPPED), Fans::default());
    }

    #[test]
    fn large_convex_polygons_are_not_counted() {
        for count in [3000, 5000, 9000] {
            let step = std::f64::consts::TAU / f64::from(count);
            let corner = |n: u32| [(step * f64::from(n)).cos(), (step * f64::from(n)).sin(), 0.0];
            let points: Vec<[f64; 3]> = (0..count).map(corner).collect();
            let corners: Vec<u32> = (0..count).collect();
            let (found, fans) = triangulate_faces(&points, &corners, &[0, i64::from(count)], &Progress::new()).unwrap();
            assert_eq!((found.faces.len() as u32, fans), (count - 2, Fans::default()));
            let (signed, _) = areas(&points, DVec3::Z);
            let expected = f64::from(count) / 2.0 * step.sin();
            assert!(signed.iter().all(|&area| area > 0.0) && (signed.iter().sum::<f64>() - expected).abs() < 1e-12);
        }
    }

    /// Triangulates a square with corners on its sides, from every first corner: each triangle has an area, and there
    /// is no T-junction.
    #[test]
    fn corners_on_straight_sides_are_kept() {
        let square: [[f64; 3]; 9] = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [3.0, 0.0, 0.0],
            [4.0, 0.0, 0.0],
            [4.0, 2.0, 0.0],
            [4.0, 4.0, 0.0],
            [2.0, 4.0, 0.0],
            [0.0, 4.0, 0.0],
            [0.0, 1.0, 0.0],
        ];
        let rotation = glam::DQuat::from_euler(glam::EulerRot::XYZ, 0.3, 1.1, 2.0);
        for (first, is_turned) in (0..9).flat_map(|first| [(first, false), (first, true)]) {
            let mut points = square;
            points.rotate_left(first);
            if is_turned {
                points = points.map(|point| (rotation * DVec3::from(point)).to_array());
            }
            let corners: Vec<u32> = (0..9).collect();
            let (found, fans) = triangulate_faces(&points, &corners, &[0, 9], &Progress::new()).unwrap();
            assert_eq!((found.faces.len(), fans), (7, Fans::default()));
            let (signed, _) = areas(&points, if is_turned { rotation * DVec3::Z } else { DVec3::Z });
            assert!((signed.iter().sum::<f64>() - 16.0).abs() < 1e-12);
            // After the rotation, corners are collinear only up to rounding, so triangles may be that thin.
            assert!(is_turned || signed.iter().all(|&area| area > 0.1), "{first} {signed:?}");
            // Each side of the outline is an edge of one triangle, and each other edge of two.
            let edge = |face: &[u32; 3], n: usize| [face[n], face[(n + 1) % 3]];
            let edges: Vec<[u32; 2]> = found.faces.iter().flat_map(|face| [0, 1, 2].map(|n| edge(face, n))).collect();
            for &[a, b] in &edges {
                let is_side = b == (a + 1) % 9;
                assert_eq!(edges.iter().filter(|&&other| other == [b, a]).count(), usize::from(!is_side));
            }
            assert_eq!(edges.iter().filter(|&&[a, b]| b == (a + 1) % 9).count(), 9);
        }
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
