//! Consecutive numbers for the vertices that some faces of a mesh use.

use crate::base::mapped::{set_bits, starts};

/// Numbers of the used vertices of a mesh, in ascending order. A bit per vertex and a count per 64 vertices take a
/// fraction of the memory of a table with an entry per vertex.
#[derive(Debug, Default)]
pub(super) struct Numbering {
    /// Vertex of the first bit, a multiple of 64.
    start: u32,
    /// One bit per vertex.
    used: Vec<u64>,
    /// Number of used vertices before each word.
    before: Vec<u32>,
}

impl Numbering {
    pub fn new(faces: &[[u32; 3]]) -> Self {
        let corners = faces.as_flattened();
        let (Some(&min_vertex), Some(&max_vertex)) = (corners.iter().min(), corners.iter().max()) else {
            return Self::default();
        };
        let start = min_vertex & !63;
        let mut used = vec![0u64; ((max_vertex - start) / 64) as usize + 1];
        for corner in corners {
            used[((corner - start) / 64) as usize] |= 1 << (corner % 64);
        }
        let before = starts(used.iter().map(|word| word.count_ones() as usize)).map(|count| count as u32);
        Self { start, before: before.collect(), used }
    }

    /// Returns the number of a used vertex.
    #[inline]
    pub fn number(&self, vertex: u32) -> u32 {
        let word = ((vertex - self.start) / 64) as usize;
        self.before[word] + (self.used[word] & ((1 << (vertex % 64)) - 1)).count_ones()
    }

    /// Returns the used vertices, ascending.
    pub fn vertices(&self) -> impl Iterator<Item = u32> + '_ {
        let words = self.used.iter().zip((self.start..).step_by(64));
        words.flat_map(|(&word, first)| set_bits(word).map(move |bit| first + bit))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn used_vertices_are_numbered_in_their_order() {
        let faces = [[70, 200, 64], [1000, 127, 128], [70, 200, 999]];
        let numbering = Numbering::new(&faces);
        let vertices: Vec<u32> = numbering.vertices().collect();
        assert_eq!(vertices, [64, 70, 127, 128, 200, 999, 1000]);
        assert!(vertices.iter().enumerate().all(|(number, &vertex)| numbering.number(vertex) == number as u32));
        assert_eq!(Numbering::new(&[]).vertices().count(), 0);
    }
}
