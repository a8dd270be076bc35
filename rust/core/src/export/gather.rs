//! Quantised vertices and faces of a primitive.
//!
//! Normals are stored as octahedral coordinates of 8 bits (Meyer, Süßmuth, Sußner, Stamminger, Greiner: On
//! floating-point normal vectors, 2010).

use std::sync::LazyLock;

use glam::{DVec3, I64Vec3, Vec3};

use super::faces::{Frame, Key, Piece};
use super::grid::Grid;
use super::numbering::Numbering;
use super::surfaces::Surfaces;
use crate::base::{Progress, Result};
use crate::scene::flipped;
use crate::scene::srgb::linear_from_srgb;

/// Maximum angle in degrees between a normal and its decoded value. It is largest at the corners of a cell of the
/// octahedral grid, which are at most 1.273° from the decoded centre of their cell.
pub const NORMAL_ERROR_DEG: f64 = 1.28;

const NORMAL_BITS: i32 = 8;

const WHITE: [u16; 4] = [u16::MAX; 4];

/// Linear 16-bit values of the 256 sRGB codes. They are at least 20 apart, so a reader recovers all codes.
static LINEAR: LazyLock<[u16; 256]> =
    LazyLock::new(|| linear_from_srgb().map(|linear| (f64::from(linear) * 65535.0).round() as u16));

/// A primitive with quantised vertices.
pub(super) struct Primitive {
    pub grid: Grid,
    /// Positions as grid points.
    pub positions: Vec<[i32; 3]>,
    /// Octahedral coordinates as the OCTAHEDRAL filter stores them.
    pub normals: Option<Vec<[i8; 4]>>,
    /// Texture coordinates, v downwards, as points of the grid next to them.
    pub uvs: Option<(Vec<[i32; 2]>, Grid)>,
    /// Linear colours.
    pub colors: Option<Vec<[u16; 4]>>,
    pub faces: Vec<[u32; 3]>,
    /// Number of faces that are left out because they have no area on the grid.
    pub dropped: usize,
}

/// Quantises the faces of pieces to one primitive.
pub(super) fn gather(
    key: Key,
    pieces: &[Piece<'_>],
    grid: Grid,
    surfaces: &Surfaces,
    progress: &Progress,
) -> Result<Primitive> {
    let (positions, normals, uvs, colors, faces) = (vec![], vec![], vec![], vec![], vec![]);
    let mut gatherer = Gatherer { key, grid, positions, normals, uvs, colors, faces, dropped: 0 };
    for piece in pieces {
        progress.check()?;
        gatherer.add(piece);
    }
    Ok(gatherer.finish(surfaces))
}

struct Gatherer {
    key: Key,
    grid: Grid,
    positions: Vec<[i32; 3]>,
    /// Unit normals, zero for vertices without one; the fourth number is 0.
    normals: Vec<[f32; 4]>,
    uvs: Vec<[f32; 2]>,
    colors: Vec<[u16; 4]>,
    faces: Vec<[u32; 3]>,
    dropped: usize,
}

impl Gatherer {
    fn add(&mut self, piece: &Piece<'_>) {
        let is_flipped = matches!(piece.frame, Frame::Own { flipped: true });
        let faces: Vec<[u32; 3]> = piece.faces.iter().map(|&face| piece.mesh.faces[face as usize]).collect();
        let numbering = Numbering::new(&faces);
        let first = self.positions.len() as u32;
        self.add_vertices(piece, &numbering);
        self.faces.reserve(faces.len());
        for face in faces {
            let face = face.map(|vertex| first + numbering.number(vertex));
            self.add_face(if is_flipped { flipped(&face) } else { face });
        }
    }

    fn add_vertices(&mut self, piece: &Piece<'_>, numbering: &Numbering) {
        let mesh = piece.mesh;
        let grid = self.grid;
        let placement = match piece.frame {
            Frame::Scene(instance) if !instance.in_place => Some(instance),
            _ => None,
        };
        self.positions.extend(numbering.vertices().map(|vertex| {
            let raw = Vec3::from_array(mesh.positions[vertex as usize]).as_dvec3();
            let point = placement.map_or(raw, |instance| instance.to_scene.transform_point3(raw));
            point.to_array().map(|x| grid.round(x))
        }));
        if let Some(normals) = mesh.normals.as_deref().filter(|_| self.key.lit) {
            // Normals are transformed by the inverse transpose of the placement's matrix.
            let matrix = placement.map(|instance| instance.to_object.matrix3.transpose());
            self.normals.extend(numbering.vertices().map(|vertex| {
                let raw = Vec3::from_array(normals[vertex as usize]).as_dvec3();
                let normal = matrix.map_or(raw, |matrix| matrix * raw);
                normal.normalize_or_zero().as_vec3().extend(0.0).to_array()
            }));
        }
        if let Some(uvs) = mesh.uvs.as_deref().filter(|_| self.key.textured) {
            self.uvs.extend(numbering.vertices().map(|vertex| uvs[vertex as usize]));
        }
        if let Some(colors) = mesh.colors.as_deref().filter(|_| self.key.colored) {
            let linear = &*LINEAR;
            let quantize = |[r, g, b, a]: [u8; 4]| {
                let [r, g, b] = [r, g, b].map(|code| linear[usize::from(code)]);
                [r, g, b, u16::from(a) * 257]
            };
            self.colors.extend(numbering.vertices().map(|vertex| quantize(colors[vertex as usize])));
        }
    }

    /// Adds a face unless it has no area.
    fn add_face(&mut self, face: [u32; 3]) {
        let [a, b, c] = face.map(|vertex| I64Vec3::from_array(self.positions[vertex as usize].map(i64::from)));
        // Exact, because edges have at most 25 bits.
        let normal = (b - a).cross(c - a);
        if normal == I64Vec3::ZERO {
            self.dropped += 1;
            return;
        }
        let face = if self.key.lit { self.orient(face, normal.as_dvec3().normalize()) } else { face };
        self.faces.push(face);
    }

    /// Orders the corners of a face counter-clockwise as seen from the side of its normals, and gives corners without a
    /// normal the face's normal. Input files order corners inconsistently. nearfar lights a face on the side of its
    /// normals, glTF viewers on the side from which its corners are counter-clockwise.
    fn orient(&mut self, face: [u32; 3], mut face_normal: DVec3) -> [u32; 3] {
        let normal = |&[x, y, z, _]: &[f32; 4]| Vec3::new(x, y, z);
        let normals = face.map(|vertex| normal(&self.normals[vertex as usize]));
        let sum: Vec3 = normals.iter().sum();
        let mut oriented = face;
        if sum.as_dvec3().dot(face_normal) < 0.0 {
            (oriented, face_normal) = (flipped(&face), -face_normal);
        }
        if !normals.contains(&Vec3::ZERO) {
            return oriented;
        }
        let face_normal = face_normal.as_vec3().extend(0.0).to_array();
        oriented.map(|vertex| {
            if normal(&self.normals[vertex as usize]) == Vec3::ZERO {
                self.copy_vertex(vertex, face_normal)
            } else {
                vertex
            }
        })
    }

    /// Copies a vertex with another normal.
    fn copy_vertex(&mut self, vertex: u32, normal: [f32; 4]) -> u32 {
        let row = vertex as usize;
        self.positions.push(self.positions[row]);
        self.normals.push(normal);
        if self.key.textured {
            self.uvs.push(self.uvs[row]);
        }
        if self.key.colored {
            self.colors.push(self.colors[row]);
        }
        self.positions.len() as u32 - 1
    }

    fn finish(self, surfaces: &Surfaces) -> Primitive {
        let Self { key, grid, positions, normals, uvs, colors, faces, dropped } = self;
        let normals = key.lit.then(|| meshopt::encode_filter_oct(&normals, NORMAL_BITS));
        let uvs = key.textured.then(|| quantize_uvs(&uvs, key.material, surfaces));
        // White changes nothing, so colours that are all white are left out.
        let colors = Some(colors).filter(|colors| colors.iter().any(|&color| color != WHITE));
        Primitive { grid, positions, normals, uvs, colors, faces, dropped }
    }
}

/// Rounds texture coordinates to a material's grid, v downwards. Like `Texture`, it reads non-finite coordinates as 0.
fn quantize_uvs(uvs: &[[f32; 2]], material: i32, surfaces: &Surfaces) -> (Vec<[i32; 2]>, Grid) {
    let finite = |x: f64| if x.is_finite() { x } else { 0.0 };
    let downwards = |&[u, v]: &[f32; 2]| [finite(f64::from(u)), finite(1.0 - f64::from(v))];
    let reach = uvs.iter().flat_map(downwards).fold(0.0, |reach: f64, x| reach.max(x.abs()));
    let grid = surfaces.uv_grid(material, reach);
    (uvs.iter().map(|uv| downwards(uv).map(|x| grid.round(x))).collect(), grid)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::uniform;
    use crate::scene::srgb::srgb_from_linear;

    #[test]
    fn colors_are_restored() {
        assert!((0..=255u8).all(|code| srgb_from_linear(f32::from(LINEAR[usize::from(code)]) / 65535.0) == code));
    }

    #[test]
    fn normals_are_within_their_bound() {
        // Random directions, and directions near the axes, where octahedral cells differ most.
        let random = |i: u64| {
            let (z, turn) = (2.0 * uniform(1, 0, i) - 1.0, std::f64::consts::TAU * uniform(1, 1, i));
            let across = (1.0 - z * z).sqrt();
            DVec3::new(across * turn.cos(), across * turn.sin(), z)
        };
        let near_axis = |i: u64| (DVec3::AXES[(i % 3) as usize] + 0.05 * random(i)).normalize();
        let directions: Vec<DVec3> = (0..300_000).map(random).chain((0..30_000).map(near_axis)).collect();
        let rows: Vec<[f32; 4]> = directions.iter().map(|n| n.as_vec3().extend(0.0).to_array()).collect();
        let mut stored: Vec<[i8; 4]> = meshopt::encode_filter_oct(&rows, NORMAL_BITS);
        meshopt::decode_filter_oct(&mut stored);
        let angle = |(&[x, y, z, _], exact): (&[i8; 4], &DVec3)| {
            DVec3::new(f64::from(x), f64::from(y), f64::from(z)).angle_between(*exact).to_degrees()
        };
        let worst = stored.iter().zip(&directions).map(angle).fold(0.0, f64::max);
        assert!(worst <= NORMAL_ERROR_DEG && worst > 0.75 * NORMAL_ERROR_DEG, "{worst}");
    }
}
