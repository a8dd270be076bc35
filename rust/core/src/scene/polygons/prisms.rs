//! Walls, roofs and floors of extruded outlines.

use std::sync::atomic::{AtomicU64, Ordering};

use super::outlines::Polygons;
use super::triangulate::{Clipper, Faces, collect_faces, doubled_ring_area};
use crate::base::{Error, Progress, Result, ensure};

/// Returns the faces of upright prisms over polygons: walls, roof and, where `has_floor`, floor. They are
/// counter-clockwise from outside if x points east, y north and heights up.
///
/// Corner n is point n at the lower end, corner `points + n` the same point at the upper end. Also returns the number of
/// polygons whose rings cross, overlap or leave the outer one.
pub fn prisms(polygons: &Polygons, has_floor: &[bool], progress: &Progress) -> Result<(Faces, u64)> {
    let count = polygons.points.len();
    ensure!(has_floor.len() == polygons.len(), "has_floor", format!("{} flags", polygons.len()), has_floor.len());
    let Some(count) = u32::try_from(count).ok().filter(|count| *count <= u32::MAX / 2) else {
        return Err(Error::value("points", "fewer than 2^31", count));
    };
    let crossing = AtomicU64::new(0);
    let faces = collect_faces(polygons.len(), progress, Clipper::new, |clipper, polygon, faces| {
        for (number, ring) in polygons.rings_of(polygon).enumerate() {
            if ring.len() < 3 {
                continue;
            }
            // Outer rings run counter-clockwise from above, holes clockwise.
            let is_turned = (doubled_ring_area(&polygons.points[ring.clone()]) > 0.0) == (number > 0);
            let (start, end) = (ring.start as u32, ring.end as u32);
            for here in start..end {
                let next = if here + 1 == end { start } else { here + 1 };
                let (a, b) = if is_turned { (next, here) } else { (here, next) };
                faces.extend([[a, b, b + count], [a, b + count, a + count]]);
            }
        }
        let fills_rings = clipper.clip(polygons, polygon, progress)?;
        crossing.fetch_add(u64::from(!fills_rings), Ordering::Relaxed);
        faces.extend(clipper.triangles.iter().map(|face| face.map(|corner| corner + count)));
        if has_floor[polygon] {
            faces.extend(clipper.triangles.iter().map(|&[a, b, c]| [a, c, b]));
        }
        Ok(())
    })?;
    Ok((faces, crossing.into_inner()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns six times the enclosed volume (divergence theorem), positive for counter-clockwise faces.
    fn volume(points: &[[f64; 2]], height: f64, faces: &[[u32; 3]]) -> f64 {
        let corner = |number: u32| {
            let [x, y] = points[number as usize % points.len()];
            [x, y, if (number as usize) < points.len() { 0.0 } else { height }]
        };
        let part = |face: &[u32; 3]| {
            let [a, b, c] = face.map(corner);
            let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
            a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2]
        };
        faces.iter().map(part).sum()
    }

    const OUTER: [[f64; 2]; 4] = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    const HOLE: [[f64; 2]; 4] = [[1.0, 1.0], [3.0, 1.0], [3.0, 3.0], [1.0, 3.0]];

    #[test]
    fn prisms_are_closed_for_any_orientation_of_rings() {
        for turns in 0..4 {
            let (mut outer, mut hole) = (OUTER, HOLE);
            if turns % 2 == 1 {
                outer.reverse();
            }
            if turns / 2 == 1 {
                hole.reverse();
            }
            let points = [outer, hole].concat();
            let polygons = Polygons::new(&points, &[0, 4, 8], &[0, 2]).unwrap();
            let (closed, crossing) = prisms(&polygons, &[true], &Progress::new()).unwrap();
            assert_eq!(crossing, 0);
            assert_eq!((closed.faces.len(), volume(&points, 5.0, &closed.faces)), (16 + 8 + 8, 360.0));
            let mut edges: Vec<[u32; 2]> =
                closed.faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
            edges.sort_unstable();
            assert!(edges.windows(2).all(|pair| pair[0] != pair[1]));
            assert!(edges.iter().all(|&[a, b]| edges.binary_search(&[b, a]).is_ok()));
            assert_eq!(prisms(&polygons, &[false], &Progress::new()).unwrap().0.faces, closed.faces[..24]);
        }
    }

    #[test]
    fn degenerate_rings_have_no_walls() {
        let polygons = Polygons::new(&OUTER, &[0, 2, 4], &[0, 1, 2]).unwrap();
        let found = prisms(&polygons, &[true, true], &Progress::new()).unwrap();
        assert_eq!(found, (Faces { faces: vec![], offsets: vec![0, 0, 0] }, 0));
    }

    #[test]
    fn there_is_a_flag_for_each_polygon() {
        let polygons = Polygons::new(&OUTER, &[0, 4], &[0, 1]).unwrap();
        assert!(matches!(prisms(&polygons, &[], &Progress::new()), Err(Error::Value { argument: "has_floor", .. })));
    }
}
