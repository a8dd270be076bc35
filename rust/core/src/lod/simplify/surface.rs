//! Connectivity of a surface: equal vertices, and pieces of faces that share vertices.

use std::collections::HashMap;

use crate::base::memory::{room_for_values, try_list, try_vec, try_with_capacity};
use crate::base::{Error, Progress, Result, ensure};

/// Rows or faces between two checks for cancellation.
const ROWS_PER_CHECK: usize = 1 << 16;

/// Returns, for each row of `width` bytes, the first row equal to it.
pub fn first_alike(rows: &[u8], width: usize, progress: &Progress) -> Result<Vec<u32>> {
    let is_whole = width > 0 && rows.len().is_multiple_of(width) && rows.len() / width <= u32::MAX as usize;
    ensure!(is_whole, "rows", format!("fewer than 2^32 rows of {width} bytes"), rows.len());
    // The map, up to half of whose entries stay unused, and the result.
    room_for_values::<[(&[u8], u32); 3]>(rows.len() / width)?;
    let mut first: HashMap<&[u8], u32> = HashMap::with_capacity(rows.len() / width);
    let mut alike = Vec::with_capacity(rows.len() / width);
    for (number, row) in rows.chunks_exact(width).enumerate() {
        if number % ROWS_PER_CHECK == 0 {
            progress.check()?;
        }
        alike.push(*first.entry(row).or_insert(number as u32));
    }
    Ok(alike)
}

/// Returns the number of each face's piece. A piece is a set of faces that are connected by shared vertices; pieces are
/// numbered in the order of their first faces.
pub fn pieces(faces: &[[u32; 3]], vertex_count: usize, progress: &Progress) -> Result<Vec<u32>> {
    check_faces(faces, vertex_count)?;
    let mut parent = try_list(0..vertex_count as u32)?;
    fn root(parent: &mut [u32], mut vertex: u32) -> u32 {
        while parent[vertex as usize] != vertex {
            // Path halving: each vertex on the path is linked to its grandparent, so that paths stay short.
            parent[vertex as usize] = parent[parent[vertex as usize] as usize];
            vertex = parent[vertex as usize];
        }
        vertex
    }
    for tile in faces.chunks(ROWS_PER_CHECK) {
        progress.check()?;
        for face in tile {
            let [a, b, c] = face.map(|vertex| root(&mut parent, vertex));
            let least = a.min(b).min(c);
            [a, b, c].into_iter().for_each(|vertex| parent[vertex as usize] = least);
        }
    }
    let mut numbers = try_vec(u32::MAX, vertex_count)?;
    let mut count = 0;
    let mut piece = |face: &[u32; 3]| {
        let number = &mut numbers[root(&mut parent, face[0]) as usize];
        if *number == u32::MAX {
            *number = count;
            count += 1;
        }
        *number
    };
    let mut face_pieces = try_with_capacity(faces.len())?;
    for tile in faces.chunks(ROWS_PER_CHECK) {
        progress.check()?;
        face_pieces.extend(tile.iter().map(&mut piece));
    }
    Ok(face_pieces)
}

/// Fails if a face refers to a vertex that does not exist.
pub(super) fn check_faces(faces: &[[u32; 3]], vertex_count: usize) -> Result<()> {
    match faces.as_flattened().iter().find(|&&vertex| vertex as usize >= vertex_count) {
        Some(vertex) => Err(Error::value("faces", format!("vertex numbers below {vertex_count}"), vertex)),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_mapped_to_their_first_equal_row() {
        assert_eq!(first_alike(&[1, 2, 3, 4, 1, 2, 3, 4], 2, &Progress::new()), Ok(vec![0, 1, 0, 1]));
        assert_eq!(first_alike(&[], 4, &Progress::new()), Ok(vec![]));
        assert!(
            first_alike(&[1, 2, 3], 2, &Progress::new()).is_err() && first_alike(&[], 0, &Progress::new()).is_err()
        );
    }

    #[test]
    fn faces_that_share_a_vertex_are_one_piece() {
        let faces = [[6, 7, 8], [0, 1, 2], [3, 4, 5], [2, 3, 9]];
        assert_eq!(pieces(&faces, 10, &Progress::new()), Ok(vec![0, 1, 1, 1]));
        assert!(pieces(&faces, 9, &Progress::new()).is_err());
        assert_eq!(pieces(&[], 0, &Progress::new()), Ok(vec![]));
    }
}
