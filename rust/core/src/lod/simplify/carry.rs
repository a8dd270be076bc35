//! Transfer of a base surface's attributes to a coarser surface.
//!
//! For each corner of the coarser surface, a walk over the base's faces finds the nearest point. The walk starts at the
//! face below the middle of the corner's triangle, and moves between faces that share vertices. Vertices with different
//! attributes are distinct, so a walk never crosses a seam, even if the seam lies inside one UV chart.

use glam::{DVec3, Vec3};
use rayon::prelude::*;

use super::surface::check_faces;
use crate::base::memory::{try_copy, try_vec};
use crate::base::{Progress, Result, ensure};
use crate::trace::{Closest, closest};

/// Number of triangles in one task.
const CHUNK: usize = 1024;
/// If the first ring has no nearer face: maximum number of vertices collected around it, and of faces around them that
/// are tested.
const MAX_SECOND_RING: usize = 256;

/// A surface whose faces are connected where they share vertices, which have one position and one set of attributes.
#[derive(Debug)]
pub struct ConnectedSurface<'a> {
    positions: &'a [[f32; 3]],
    faces: &'a [[u32; 3]],
    /// Index in `vertex_faces` of each vertex's first face; the last entry is the length of `vertex_faces`.
    starts: Vec<u32>,
    /// The faces around each vertex.
    vertex_faces: Vec<u32>,
}

/// A point of the base surface.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SurfacePlace {
    /// Face of the base.
    pub face: u32,
    /// Weights of the face's second and third corner.
    pub weights: [f64; 2],
}

impl<'a> ConnectedSurface<'a> {
    /// Connects the faces; fails if a face refers to a missing vertex.
    pub fn new(positions: &'a [[f32; 3]], faces: &'a [[u32; 3]]) -> Result<Self> {
        check_faces(faces, positions.len())?;
        let mut starts = try_vec(0u32, positions.len() + 1)?;
        faces.as_flattened().iter().for_each(|&vertex| starts[vertex as usize + 1] += 1);
        (0..positions.len()).for_each(|vertex| starts[vertex + 1] += starts[vertex]);
        let mut next = try_copy(&starts)?;
        let mut vertex_faces = try_vec(0, 3 * faces.len())?;
        for (number, face) in faces.iter().enumerate() {
            for &vertex in face {
                vertex_faces[next[vertex as usize] as usize] = number as u32;
                next[vertex as usize] += 1;
            }
        }
        Ok(Self { positions, faces, starts, vertex_faces })
    }

    /// Returns the point of a face nearest to the goal.
    fn closest_on_face(&self, face: u32, goal: DVec3) -> Closest {
        closest(self.faces[face as usize].map(|v| Vec3::from_array(self.positions[v as usize]).as_dvec3() - goal))
    }

    fn faces_around(&self, vertex: u32) -> impl Iterator<Item = u32> + '_ {
        let [start, end] = [0, 1].map(|n| self.starts[vertex as usize + n] as usize);
        self.vertex_faces[start..end].iter().copied()
    }

    /// Returns the faces that share a vertex with a face; some repeatedly.
    fn ring(&self, face: u32) -> impl Iterator<Item = u32> + '_ {
        self.faces[face as usize].into_iter().flat_map(|vertex| self.faces_around(vertex))
    }

    /// Collects the vertices of a face's ring, except the face's own vertices.
    fn outline(&self, face: u32, outline: &mut Vec<u32>) {
        outline.clear();
        let own_vertices = self.faces[face as usize];
        let others = self.ring(face).flat_map(|other| self.faces[other as usize]).filter(|v| !own_vertices.contains(v));
        outline.extend(others.take(MAX_SECOND_RING));
        outline.sort_unstable();
        outline.dedup();
    }

    /// Returns the nearest of some faces if it is nearer to the goal than `best`; of equally near faces, the first.
    fn nearest_face(&self, faces: impl Iterator<Item = u32>, goal: DVec3, mut best: Closest) -> Option<(u32, Closest)> {
        let mut nearest = None;
        for face in faces {
            let near = self.closest_on_face(face, goal);
            if near.square < best.square {
                (best, nearest) = (near, Some((face, near)));
            }
        }
        nearest
    }

    /// Walks from a face until no face around it is nearer to the goal.
    fn walk(&self, start: u32, goal: DVec3, outline: &mut Vec<u32>) -> SurfacePlace {
        let (mut face, mut best) = (start, self.closest_on_face(start, goal));
        loop {
            let mut step = self.nearest_face(self.ring(face), goal, best);
            if step.is_none() {
                // The second ring lets the walk cross ridges.
                self.outline(face, outline);
                let second = outline.iter().flat_map(|&vertex| self.faces_around(vertex)).take(MAX_SECOND_RING);
                step = self.nearest_face(second, goal, best);
            }
            let Some(step) = step else { return SurfacePlace { face, weights: [best.u, best.v] } };
            (face, best) = step;
        }
    }

    /// Returns the base's point for each corner of triangles, given in the base's coordinates. `starts` are the faces at
    /// which the walks of each triangle begin.
    pub fn places(
        &self,
        corners: &[[[f32; 3]; 3]],
        starts: &[u32],
        progress: &Progress,
    ) -> Result<Vec<[SurfacePlace; 3]>> {
        let has_starts = starts.len() == corners.len() && starts.iter().all(|&face| (face as usize) < self.faces.len());
        ensure!(has_starts, "starts", format!("a face for each of {} triangles", corners.len()), starts.len());
        progress.expect(corners.len() as u64);
        let mut places = try_vec([SurfacePlace::default(); 3], corners.len())?;
        let chunks = places.par_chunks_mut(CHUNK).zip(corners.par_chunks(CHUNK)).zip(starts.par_chunks(CHUNK));
        chunks.try_for_each(|((places, corners), starts)| {
            let mut outline = Vec::new();
            for ((places, corners), &start) in places.iter_mut().zip(corners).zip(starts) {
                *places = corners.map(|corner| self.walk(start, Vec3::from_array(corner).as_dvec3(), &mut outline));
            }
            progress.report(corners.len() as u64)
        })?;
        Ok(places)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn walks_end_at_the_nearest_point_and_stop_at_seams() {
        // Two strips of 20 squares along x, which meet at z = 1 but have separate vertices there.
        let (mut positions, mut faces) = (vec![], vec![]);
        for strip in 0..2 {
            for x in 0..21 {
                let first = positions.len() as u32;
                positions.push([x as f32, 0.0, strip as f32]);
                positions.push([x as f32, 0.0, strip as f32 + 1.0]);
                if x < 20 {
                    faces.push([first, first + 1, first + 2]);
                    faces.push([first + 2, first + 1, first + 3]);
                }
            }
        }
        let surface = ConnectedSurface::new(&positions, &faces).unwrap();
        let goal = [17.25, 0.5, 1.5];
        let found = surface.places(&[[goal; 3], [goal; 3]], &[0, 40], &Progress::new()).unwrap();
        for (places, z) in found.iter().zip([1.0, 1.5]) {
            for place in places {
                let [a, b, c] = faces[place.face as usize].map(|v| Vec3::from_array(positions[v as usize]).as_dvec3());
                let point = a + (b - a) * place.weights[0] + (c - a) * place.weights[1];
                assert!((point - DVec3::new(17.25, 0.0, z)).length() < 1e-12, "{point}");
            }
        }
        assert!(surface.places(&[[goal; 3]], &[80], &Progress::new()).is_err());
    }
}
