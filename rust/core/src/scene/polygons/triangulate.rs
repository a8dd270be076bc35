//! Triangulation of polygons by ear clipping with the crate `earcut`, a port of Mapbox's library.

use std::sync::atomic::{AtomicU64, Ordering};

use earcut::Earcut;

use super::junctions::split_at_points;
use super::outlines::Polygons;
use crate::base::mapped::in_ranges;
use crate::base::memory::try_with_capacity;
use crate::base::{Progress, Result};

/// Polygons per task. A task takes milliseconds and reuses its buffers.
const POLYGONS_PER_TASK: usize = 512;

/// Greatest difference between the areas of the triangles and of the rings, relative to the squared extent, that is taken
/// for rounding; a greater one means that rings cross. Sums of 10⁵ corners round to 10⁻¹¹.
const ROUNDING: f64 = 1e-9;

/// Faces of many items, in their order.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Faces {
    /// Corners of the triangles.
    pub faces: Vec<[u32; 3]>,
    /// Item n has the faces `faces[offsets[n]..offsets[n + 1]]`.
    pub offsets: Vec<i64>,
}

/// Triangulates polygons; corners are point numbers, counter-clockwise if y points up.
///
/// Points in the middle of straight sides are corners of triangles, so there are no cracks beside neighbours that have
/// a corner there. Of several points at one position some may be unused, and rings of fewer than three points are
/// ignored. If rings cross, overlap or leave the outer ring, the result is some set of triangles between the points;
/// also returns the number of these polygons.
pub fn triangulate(polygons: &Polygons, progress: &Progress) -> Result<(Faces, u64)> {
    let crossing = AtomicU64::new(0);
    let faces = collect_faces(polygons.len(), progress, Clipper::new, |clipper, polygon, faces| {
        let fills_rings = clipper.clip(polygons, polygon, progress)?;
        crossing.fetch_add(u64::from(!fills_rings), Ordering::Relaxed);
        faces.extend_from_slice(&clipper.triangles);
        Ok(())
    })?;
    Ok((faces, crossing.into_inner()))
}

/// Collects the faces that `add` appends for each of `count` items; each task creates its own scratch object.
pub(super) fn collect_faces<T>(
    count: usize,
    progress: &Progress,
    new_scratch: impl Fn() -> T + Sync,
    add: impl Fn(&mut T, usize, &mut Vec<[u32; 3]>) -> Result<()> + Sync,
) -> Result<Faces> {
    progress.expect(count as u64);
    let parts = in_ranges(count, POLYGONS_PER_TASK, |items| {
        let (mut scratch, mut faces, mut ends) = (new_scratch(), Vec::new(), Vec::with_capacity(items.len()));
        let size = items.len() as u64;
        for item in items {
            progress.check()?;
            add(&mut scratch, item, &mut faces)?;
            ends.push(faces.len() as i64);
        }
        progress.report(size)?;
        Ok((faces, ends))
    })?;
    let face_count = parts.iter().map(|(faces, _)| faces.len()).sum();
    let mut all = Faces { faces: try_with_capacity(face_count)?, offsets: try_with_capacity(count + 1)? };
    all.offsets.push(0);
    for (faces, ends) in parts {
        let start = all.faces.len() as i64;
        all.faces.extend_from_slice(&faces);
        all.offsets.extend(ends.into_iter().map(|end| start + end));
    }
    Ok(all)
}

/// Reusable state that clips the ears of one polygon at a time.
pub(super) struct Clipper {
    earcut: Earcut<f64>,
    local: Vec<[f64; 2]>,
    /// Global point number of each local point.
    numbers: Vec<u32>,
    holes: Vec<u32>,
    corners: Vec<u32>,
    /// Triangles of the polygon clipped last.
    pub(super) triangles: Vec<[u32; 3]>,
}

impl Clipper {
    pub(super) fn new() -> Self {
        let (local, numbers, holes, corners, triangles) = Default::default();
        Self { earcut: Earcut::new(), local, numbers, holes, corners, triangles }
    }

    /// Triangulates a polygon in coordinates relative to its first point, because the large coordinates of national
    /// grids leave few digits for shapes. Returns false if rings cross, overlap or leave the outer one. Fails if the
    /// caller has cancelled.
    pub(super) fn clip(&mut self, polygons: &Polygons, polygon: usize, progress: &Progress) -> Result<bool> {
        self.local.clear();
        self.numbers.clear();
        self.holes.clear();
        self.triangles.clear();
        let mut first = None;
        for (number, ring) in polygons.rings_of(polygon).enumerate() {
            if ring.len() < 3 {
                if number == 0 {
                    return Ok(true);
                }
                continue;
            }
            if number > 0 {
                self.holes.push(self.local.len() as u32);
            }
            let [x, y] = *first.get_or_insert(polygons.points[ring.start]);
            self.local.extend(polygons.points[ring.clone()].iter().map(|point| [point[0] - x, point[1] - y]));
            self.numbers.extend(ring.start as u32..ring.end as u32);
        }
        self.triangulate(progress)?;
        let fills_rings = self.fills_rings();
        let numbers = &self.numbers;
        self.triangles.iter_mut().flatten().for_each(|corner| *corner = numbers[*corner as usize]);
        Ok(fills_rings)
    }

    /// Returns whether the triangles have the area between the outer ring and its holes, and each hole is as large as
    /// the triangles that fill it alone.
    ///
    /// Triangles cover each point as often as the outer ring winds around it, less the windings of the holes. Where this
    /// number is negative a triangle is turned, so that areas differ. But it is 0 and 2 in the halves of a hole that
    /// crosses itself, whose area is the difference of the halves; such a hole is found alone.
    fn fills_rings(&mut self) -> bool {
        let rounding = self.rounding();
        let mut area = 0.0;
        let ends = [&self.holes[1.min(self.holes.len())..], &[self.local.len() as u32]].concat();
        for (&start, end) in self.holes.iter().zip(ends) {
            let hole = &self.local[start as usize..end as usize];
            let hole_area = doubled_ring_area(hole).abs();
            self.earcut.earcut_slice(hole, &[], &mut self.corners);
            let corners = self.corners.as_chunks::<3>().0;
            let filled: f64 = corners.iter().map(|face| doubled_area(face.map(|n| hole[n as usize])).abs()).sum();
            if (filled - hole_area).abs() > rounding {
                return false;
            }
            area -= hole_area;
        }
        let outer_end = self.holes.first().map_or(self.local.len(), |&start| start as usize);
        area += doubled_ring_area(&self.local[..outer_end]).abs();
        (self.doubled_area() - area).abs() <= rounding
    }

    /// Returns the difference of doubled areas that counts as rounding.
    fn rounding(&self) -> f64 {
        let extent = self.local.as_flattened().iter().fold(0.0f64, |greatest, value| greatest.max(value.abs()));
        ROUNDING * extent * extent
    }

    /// Triangulates a ring of at most a few thousand points without interruption. Corners are numbers of its points.
    pub(super) fn clip_ring(&mut self, ring: impl Iterator<Item = [f64; 2]>) {
        self.local.clear();
        self.holes.clear();
        self.triangles.clear();
        self.local.extend(ring);
        // Cannot fail, because this progress is never cancelled.
        _ = self.triangulate(&Progress::new());
    }

    /// Returns twice the area of the triangles of the last ring.
    pub(super) fn doubled_area(&self) -> f64 {
        self.triangles.iter().map(|face| doubled_area(face.map(|corner| self.local[corner as usize]))).sum()
    }

    /// Triangulates the local points.
    fn triangulate(&mut self, progress: &Progress) -> Result<()> {
        self.earcut.earcut_slice(&self.local, &self.holes, &mut self.corners);
        let local = &self.local;
        self.triangles.extend(self.corners.as_chunks::<3>().0.iter().map(|&[a, b, c]| {
            let is_clockwise = doubled_area([a, b, c].map(|corner| local[corner as usize])) < 0.0;
            if is_clockwise { [a, c, b] } else { [a, b, c] }
        }));
        // Number of triangles that use all points of a simple polygon.
        let full_count = (self.local.len() + 2 * self.holes.len()).saturating_sub(2);
        if !self.triangles.is_empty() && self.triangles.len() < full_count {
            split_at_points(local, &self.holes, full_count, &mut self.triangles, progress)?;
        }
        Ok(())
    }
}

/// Returns twice the signed area of a triangle.
fn doubled_area([a, b, c]: [[f64; 2]; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Returns twice the signed area of a ring, positive if counter-clockwise; computed relative to its first point.
pub(super) fn doubled_ring_area(ring: &[[f64; 2]]) -> f64 {
    let Some(&first) = ring.first() else { return 0.0 };
    ring.windows(2).map(|pair| doubled_area([first, pair[0], pair[1]])).sum()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::base::Error;

    fn faces_of(points: &[[f64; 2]], rings: &[i64], polygons: &[i64]) -> Faces {
        triangulate(&Polygons::new(points, rings, polygons).unwrap(), &Progress::new()).unwrap().0
    }

    fn area_of(points: &[[f64; 2]], faces: &[[u32; 3]]) -> f64 {
        faces.iter().map(|face| doubled_area(face.map(|corner| points[corner as usize])) / 2.0).sum()
    }

    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];

    #[test]
    fn holes_are_left_open_for_any_orientation_of_rings() {
        let hole = [[1.0, 1.0], [3.0, 1.0], [3.0, 3.0], [1.0, 3.0]];
        for turns in 0..4 {
            let (mut outer, mut inner) = (SQUARE, hole);
            if turns % 2 == 1 {
                outer.reverse();
            }
            if turns / 2 == 1 {
                inner.reverse();
            }
            let points = [outer, inner].concat();
            let found = faces_of(&points, &[0, 4, 8], &[0, 2]);
            assert_eq!((found.faces.len(), area_of(&points, &found.faces)), (8, 12.0));
            assert!(found.faces.iter().all(|face| area_of(&points, &[*face]) > 0.0));
        }
    }

    #[test]
    fn polygons_stay_in_their_order() {
        let far = SQUARE.map(|[x, y]| [x + 2e6, y - 5e6]);
        let points = [&far[..], &SQUARE[..2], &SQUARE[..3]].concat();
        let found = faces_of(&points, &[0, 4, 6, 9], &[0, 1, 2, 2, 3]);
        assert_eq!(found.offsets, [0, 2, 2, 2, 3]);
        assert_eq!(area_of(&points, &found.faces[..2]), 16.0);
        let mut last = found.faces[2];
        last.sort_unstable();
        assert_eq!(last, [6, 7, 8]);
    }

    #[test]
    fn an_outer_ring_without_points_has_no_triangles() {
        assert_eq!(faces_of(&SQUARE, &[0, 0, 4], &[0, 2]), Faces { faces: vec![], offsets: vec![0, 0] });
        assert_eq!(faces_of(&[[1.0; 2]; 9], &[0, 9], &[0, 1]).faces.len(), 0);
    }

    #[test]
    fn results_do_not_depend_on_tasks() {
        let count = 3 * POLYGONS_PER_TASK + 7;
        let points: Vec<[f64; 2]> = (0..count).flat_map(|n| SQUARE.map(|[x, y]| [x + n as f64, y])).collect();
        let rings: Vec<i64> = (0..=count as i64).map(|n| 4 * n).collect();
        let polygons: Vec<i64> = (0..=count as i64).collect();
        let found = faces_of(&points, &rings, &polygons);
        assert_eq!(found.offsets, (0..=count as i64).map(|n| 2 * n).collect::<Vec<_>>());
        let first = &found.faces[..2];
        let moved = |n: usize| first.iter().map(move |face| face.map(|corner| corner + 4 * n as u32));
        assert!((0..count).flat_map(moved).eq(found.faces.iter().copied()));
    }

    #[test]
    fn the_caller_can_cancel() {
        let progress = Progress::new();
        progress.cancel();
        let polygons = Polygons::new(&SQUARE, &[0, 4], &[0, 1]).unwrap();
        assert_eq!(triangulate(&polygons, &progress), Err(Error::Cancelled));
    }

    proptest! {
        /// Star-shaped rings around one centre are simple and do not touch, so areas follow the shoelace formula.
        #[test]
        fn areas_are_those_of_the_rings(
            outer in proptest::collection::vec(10.0..20.0f64, 3..60),
            inner in proptest::collection::vec(1.0..4.0f64, 3..20),
            x in -1e7..1e7f64,
            backward: bool,
        ) {
            let ring = |radii: &[f64]| -> Vec<[f64; 2]> {
                let angle = |n: usize| std::f64::consts::TAU * n as f64 / radii.len() as f64;
                radii.iter().enumerate().map(|(n, r)| [x + r * angle(n).cos(), r * angle(n).sin()]).collect()
            };
            let (mut outside, hole) = (ring(&outer), ring(&inner));
            if backward {
                outside.reverse();
            }
            let expected = (doubled_ring_area(&outside).abs() - doubled_ring_area(&hole).abs()) / 2.0;
            let points = [&outside[..], &hole[..]].concat();
            let rings = [0, outside.len() as i64, points.len() as i64];
            let found = faces_of(&points, &rings, &[0, 2]);
            prop_assert!((area_of(&points, &found.faces) - expected).abs() <= 1e-9 * expected.abs().max(1.0));
        }

        /// Arbitrary points, with duplicates and crossing rings: no triangle is flipped.
        #[test]
        fn random_rings_are_triangulated(
            points in proptest::collection::vec((0..6i8, 0..6i8), 0..40),
            cut in 0..40usize,
        ) {
            let points: Vec<[f64; 2]> = points.iter().map(|&(x, y)| [f64::from(x), f64::from(y)]).collect();
            let cut = cut.min(points.len()) as i64;
            let found = faces_of(&points, &[0, cut, points.len() as i64], &[0, 2]);
            prop_assert!(found.faces.iter().all(|face| area_of(&points, &[*face]) >= 0.0));
        }
    }
}
