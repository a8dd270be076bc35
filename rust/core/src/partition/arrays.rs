//! Radii of triangles in plain arrays, and the sets of a partition as index arrays.

use rayon::prelude::*;

use super::classify::{Class, TriangleSet, Zone};
use super::divide::Partition;
use super::radii::{CHUNK, Indexed, Soup, TriangleSource, measure};
use crate::base::memory::try_with_capacity;
use crate::base::{Progress, Real, Result, ensure};

/// Writes the minimum and maximum ρ of each triangle about an axis at (x, z). The error is float64's rounding of the
/// maximum ρ, plus one rounding to the type of the coordinates. Without faces, every three vertices form a triangle.
pub fn triangle_radii<T: Real>(
    vertices: &[[T; 3]],
    faces: Option<&[[u32; 3]]>,
    axis: [f64; 2],
    radii: &mut [[T; 2]],
    progress: &Progress,
) -> Result<()> {
    let [x, z] = axis;
    ensure!(x.is_finite() && z.is_finite(), "center", "three finite numbers", format!("x {x}, z {z}"));
    let expected = faces.map_or(vertices.len() / 3, <[_]>::len);
    let is_whole = radii.len() == expected && (faces.is_some() || vertices.len().is_multiple_of(3));
    ensure!(is_whole, "vertices", "three corners for each triangle", vertices.len());
    progress.expect(expected as u64);
    radii.par_chunks_mut(CHUNK).enumerate().try_for_each(|(chunk, radii)| {
        let range = chunk * CHUNK..chunk * CHUNK + radii.len();
        match faces {
            Some(faces) => {
                check_faces(&faces[range.clone()], vertices.len())?;
                fill(&Indexed { vertices, faces: &faces[range] }, axis, radii)?;
            }
            None => fill(&Soup(&vertices.as_chunks::<3>().0[range]), axis, radii)?,
        }
        progress.report(radii.len() as u64)
    })
}

fn check_faces(faces: &[[u32; 3]], vertex_count: usize) -> Result<()> {
    let max = faces.as_flattened().iter().fold(0, |max, &vertex| max.max(vertex));
    let is_valid = faces.is_empty() || (max as usize) < vertex_count;
    ensure!(is_valid, "faces", format!("vertex indices below {vertex_count}"), max);
    Ok(())
}

#[inline(always)]
fn fill<T: Real>(triangles: &impl TriangleSource<T>, axis: [f64; 2], radii: &mut [[T; 2]]) -> Result<()> {
    measure(
        triangles,
        radii.len(),
        axis,
        |i| i,
        |first, block| radii[first..first + block.len()].copy_from_slice(block),
    );
    // A NaN or infinite corner makes the radii NaN or infinite.
    let are_finite = radii.as_flattened().iter().all(|&radius| radius.is_finite());
    ensure!(are_finite, "vertices", "finite coordinates", "NaN, infinity or numbers whose squares overflow");
    Ok(())
}

impl Partition {
    /// Returns the numbers of the triangles in a set, ascending.
    pub fn triangles(&self, part: TriangleSet, progress: &Progress) -> Result<Vec<i64>> {
        let counts = &self.counts;
        let count = match part {
            TriangleSet::Near => counts.near,
            TriangleSet::Intermediate => counts.intermediate,
            TriangleSet::Far => counts.far,
            TriangleSet::Nsf => counts.nsf,
            TriangleSet::Sf => counts.sf,
        };
        let mut numbers = try_with_capacity(count as usize)?;
        for (instance, class) in self.classes.iter().enumerate() {
            progress.check()?;
            let offset = self.scene.triangle_offset(instance as u32);
            let count = self.scene.instance(instance as u32).mesh.faces.len() as u32;
            let is_in_set = |zone| part.contains(zone, self.is_moving(instance));
            match class {
                Class::Mixed(mixed) => {
                    let mut listed = mixed.faces.iter().zip(&mixed.zones).peekable();
                    if is_in_set(Zone::Far) {
                        let zone_of = |face| listed.next_if(|&(&next, _)| next == face).map_or(Zone::Far, |(_, &z)| z);
                        let zones = (0..count).map(zone_of);
                        let chosen = zones.enumerate().filter(|&(_, zone)| is_in_set(zone));
                        numbers.extend(chosen.map(|(face, _)| offset + face as i64));
                    } else {
                        let chosen = listed.filter(|&(_, &zone)| is_in_set(zone));
                        numbers.extend(chosen.map(|(&face, _)| offset + i64::from(face)));
                    }
                }
                // All faces have the zone of the first.
                _ if is_in_set(self.zone(instance as u32, 0)) => {
                    numbers.extend((0..i64::from(count)).map(|face| offset + face))
                }
                _ => {}
            }
        }
        Ok(numbers)
    }
}
