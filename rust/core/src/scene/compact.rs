//! Extraction of faces, with only the vertices that they use.
//!
//! Vertices are grouped in pages of 64, with one bit per vertex. Successive faces use nearby vertices, so most corners
//! are on the same page as the previous corner, and only the short list of page visits is sorted.

use rayon::prelude::*;

use super::mesh::{CHUNK, Mesh, gather};
use crate::base::mapped::set_bits;
use crate::base::memory::{try_concat, try_vec, try_with_capacity};
use crate::base::sort::sort_by_key;
use crate::base::{Progress, Result};

/// Base-2 logarithm of the number of vertices in a page.
const PAGE_BITS: u32 = 6;

impl Mesh {
    /// Returns a mesh of the given faces, in their order. It shares the vertex arrays unless most vertices would be
    /// unused.
    pub fn selected(&self, chosen: &[u32], progress: &Progress) -> Result<Self> {
        self.part(chosen, chosen.len() * 3 >= self.positions.len(), progress)
    }

    /// Returns a mesh of the given faces, in their order. Vertices keep their order; unused ones are dropped.
    pub(super) fn compacted(&self, chosen: &[u32], progress: &Progress) -> Result<Self> {
        self.part(chosen, false, progress)
    }

    fn part(&self, chosen: &[u32], shares_vertices: bool, progress: &Progress) -> Result<Self> {
        let faces = gather(&self.faces, chosen, progress)?;
        let objects = self.objects.selected(chosen, progress)?;
        let materials = self.materials.selected(chosen, progress)?;
        if shares_vertices {
            return Ok(self.with_faces(faces, objects, materials));
        }
        let pages = Pages::new(&faces, progress)?;
        let faces = pages.renumbered(&faces, progress)?;
        self.with_vertices(&pages.vertices()?, faces, objects, materials, progress)
    }
}

/// Set of used vertices, as bit masks of ascending pages.
struct Pages {
    numbers: Vec<u32>,
    /// Bit mask of the used vertices of each page.
    bits: Vec<u64>,
    /// Number of used vertices in earlier pages.
    offsets: Vec<u32>,
    count: usize,
}

impl Pages {
    fn new(faces: &[[u32; 3]], progress: &Progress) -> Result<Self> {
        let chunks = faces.par_chunks(CHUNK).map(|chunk| progress.check().map(|()| page_masks(chunk)));
        let mut visits = try_concat(&chunks.collect::<Result<Vec<_>>>()?)?;
        sort_by_key(&mut visits, |&(page, _)| page, progress)?;
        let mut pages = Self { numbers: vec![], bits: vec![], offsets: vec![], count: 0 };
        for same in visits.chunk_by(|a, b| a.0 == b.0) {
            let bits = same.iter().fold(0, |all, &(_, bits)| all | bits);
            pages.numbers.push(same[0].0);
            pages.bits.push(bits);
            pages.offsets.push(pages.count as u32);
            pages.count += bits.count_ones() as usize;
        }
        Ok(pages)
    }

    /// Returns the used vertices, ascending.
    fn vertices(&self) -> Result<Vec<u32>> {
        let mut vertices = try_with_capacity(self.count)?;
        for (page, &bits) in self.numbers.iter().zip(&self.bits) {
            vertices.extend(set_bits(bits).map(|bit| page << PAGE_BITS | bit));
        }
        Ok(vertices)
    }

    /// Returns the faces with vertices renumbered to their positions among the used ones.
    fn renumbered(&self, faces: &[[u32; 3]], progress: &Progress) -> Result<Vec<[u32; 3]>> {
        let renumber_chunk = |chunk: &[[u32; 3]], renumbered: &mut [[u32; 3]]| {
            // Indices of the last two pages that corners were on.
            let (mut current, mut previous) = (0, 0);
            let mut renumber = |vertex: u32| {
                let page = vertex >> PAGE_BITS;
                if self.numbers[current] != page {
                    std::mem::swap(&mut current, &mut previous);
                    if self.numbers[current] != page {
                        // The list has the page of every corner.
                        current = self.numbers.partition_point(|&number| number < page);
                    }
                }
                let lower_bits = self.bits[current] & ((1 << (vertex & ((1 << PAGE_BITS) - 1))) - 1);
                self.offsets[current] + lower_bits.count_ones()
            };
            renumbered.iter_mut().zip(chunk).for_each(|(renumbered, face)| *renumbered = face.map(&mut renumber));
            progress.check()
        };
        let mut renumbered = try_vec([0; 3], faces.len())?;
        match faces.len() {
            0..=CHUNK => renumber_chunk(faces, &mut renumbered)?,
            _ => faces
                .par_chunks(CHUNK)
                .zip(renumbered.par_chunks_mut(CHUNK))
                .try_for_each(|(a, b)| renumber_chunk(a, b))?,
        }
        Ok(renumbered)
    }
}

/// Returns the pages that faces visit and the bit masks of their vertices; a page may occur several times.
fn page_masks(faces: &[[u32; 3]]) -> Vec<(u32, u64)> {
    let mut visits: Vec<(u32, u64)> = Vec::new();
    // The last two pages stay open, because successive corners often alternate between two.
    let mut open = [(u32::MAX, 0u64); 2];
    for &vertex in faces.as_flattened() {
        let (page, bit) = (vertex >> PAGE_BITS, 1 << (vertex & ((1 << PAGE_BITS) - 1)));
        if open[0].0 != page {
            open.swap(0, 1);
            if open[0].0 != page {
                visits.push(open[0]);
                open[0] = (page, 0);
            }
        }
        open[0].1 |= bit;
    }
    visits.extend(open);
    // No real page has the sentinel number: there are fewer pages than u32 values.
    visits.retain(|&(page, _)| page != u32::MAX);
    visits
}

#[cfg(test)]
mod tests {
    use proptest::collection::vec;
    use proptest::prelude::*;

    use super::*;
    use crate::base::FaceMap;

    fn mesh(vertices: u32, faces: &[[u32; 3]]) -> Mesh {
        let positions: Vec<[f32; 3]> = (0..vertices).map(|v| [v as f32, -(v as f32), (v % 7) as f32]).collect();
        let uvs: Vec<[f32; 2]> = (0..vertices).map(|v| [v as f32, 0.5]).collect();
        let objects = FaceMap::PerFace((0..faces.len() as i32).collect());
        Mesh::new(positions.into(), faces.to_vec().into(), Some(uvs.into()), None, objects, FaceMap::Uniform(0))
            .unwrap()
    }

    proptest! {
        #[test]
        fn compacting_keeps_corners_and_the_order_of_faces_and_vertices(
            faces in vec([0u32..900, 0u32..900, 0u32..900], 1..80),
            keep in vec(any::<bool>(), 80),
        ) {
            let whole = mesh(900, &faces);
            let chosen: Vec<u32> = (0..faces.len() as u32).filter(|&face| keep[face as usize]).collect();
            let part = whole.compacted(&chosen, &Progress::new()).unwrap();
            let mut used: Vec<u32> = chosen.iter().flat_map(|&face| faces[face as usize]).collect();
            used.sort_unstable();
            used.dedup();
            prop_assert_eq!(part.positions.len(), used.len());
            prop_assert_eq!(part.faces.len(), chosen.len());
            for (new, &old) in chosen.iter().enumerate() {
                prop_assert_eq!(part.corners(new as u32), whole.corners(old));
                prop_assert_eq!(part.objects.get(new as u32), old as i32);
            }
            for (new, &old) in used.iter().enumerate() {
                prop_assert_eq!(part.uvs.as_ref().unwrap()[new], [old as f32, 0.5]);
            }
            prop_assert_eq!(part.bounds(), whole.selected(&chosen, &Progress::new()).unwrap().bounds());
        }
    }

    #[test]
    fn many_chunks_are_compacted_as_one() {
        let count = 2 * CHUNK as u32 + 5;
        let faces: Vec<[u32; 3]> = (0..count).map(|face| [face, face + 1, (face * 7) % count]).collect();
        let whole = mesh(count + 2, &faces);
        let chosen: Vec<u32> = (0..count).filter(|face| face % 3 > 0).collect();
        let part = whole.compacted(&chosen, &Progress::new()).unwrap();
        assert!(chosen.iter().zip(0..).all(|(&old, new)| part.corners(new) == whole.corners(old)));
    }
}
