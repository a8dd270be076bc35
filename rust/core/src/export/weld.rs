//! Welding of equal vertices, and reordering of faces and vertices for compression and drawing speed.
//!
//! The order of faces is meshoptimizer's: Kapoulkine, after Forsyth: Linear-speed vertex cache optimisation, 2006.

use meshopt::{VertexStream, generate_vertex_remap_multi, optimize_vertex_cache_in_place};

use super::gather::Primitive;

/// Marks vertices that no face uses.
const UNUSED: u32 = u32::MAX;

/// A primitive with distinct vertices in the order of their first use, and its corners.
#[derive(Clone, Debug)]
pub(super) struct Welded {
    pub primitive: Primitive,
    /// Vertex number of each corner.
    pub corners: Vec<u32>,
}

/// Welds a primitive; `None` if it has no faces.
pub(super) fn weld(mut primitive: Primitive) -> Option<Welded> {
    if primitive.faces.is_empty() {
        return None;
    }
    let mut corners: Vec<u32> = std::mem::take(&mut primitive.faces).into_flattened();
    let (count, numbers) = alike(&primitive, &corners);
    let mut vertices = vec![UNUSED; count];
    for (vertex, &number) in numbers.iter().enumerate().filter(|&(_, &number)| number != UNUSED) {
        vertices[number as usize] = vertex as u32;
    }
    corners.iter_mut().for_each(|corner| *corner = numbers[*corner as usize]);
    optimize_vertex_cache_in_place(&mut corners, count);
    let mut order = by_first_use(&mut corners, count);
    order.iter_mut().for_each(|number| *number = vertices[*number as usize]);
    reorder(&mut primitive, &order);
    Some(Welded { primitive, corners })
}

/// Returns the number of distinct vertices that corners use, and the number of each vertex among them.
fn alike(primitive: &Primitive, corners: &[u32]) -> (usize, Vec<u32>) {
    let mut streams = vec![VertexStream::new(primitive.positions.as_ptr())];
    streams.extend(primitive.normals.as_ref().map(|normals| VertexStream::new(normals.as_ptr())));
    streams.extend(primitive.uvs.as_ref().map(|(uvs, _)| VertexStream::new(uvs.as_ptr())));
    streams.extend(primitive.colors.as_ref().map(|colors| VertexStream::new(colors.as_ptr())));
    generate_vertex_remap_multi(primitive.positions.len(), &streams, Some(corners))
}

/// Reorders the vertices.
fn reorder(primitive: &mut Primitive, order: &[u32]) {
    fn rows<T: Copy>(values: &mut Vec<T>, order: &[u32]) {
        *values = order.iter().map(|&vertex| values[vertex as usize]).collect();
    }
    rows(&mut primitive.positions, order);
    primitive.normals.iter_mut().for_each(|normals| rows(normals, order));
    primitive.uvs.iter_mut().for_each(|(uvs, _)| rows(uvs, order));
    primitive.colors.iter_mut().for_each(|colors| rows(colors, order));
}

/// Renumbers corners in the order of their first use; returns the old numbers in this order.
fn by_first_use(corners: &mut [u32], count: usize) -> Vec<u32> {
    let mut numbers = vec![UNUSED; count];
    let mut order = Vec::with_capacity(count);
    for corner in corners {
        let number = &mut numbers[*corner as usize];
        if *number == UNUSED {
            *number = order.len() as u32;
            order.push(*corner);
        }
        *corner = *number;
    }
    order
}
