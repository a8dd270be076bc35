//! Square tiles of a layer's cube faces.

use glam::DVec3;

use super::plane::Plane;
use crate::camera::direction_from_face;
use crate::trace::{Hit, Ray};

/// Width of a tile, texels.
pub const SIDE: usize = 64;
/// Texels around a tile that are traced as well, for masks that grow.
pub const APRON: usize = 1;
/// Width of a tile with its apron, texels.
pub const WIDE: usize = SIDE + 2 * APRON;

/// Returns column and row of a texel by its number, `row * SIDE + column`.
pub fn column_and_row(texel: u16) -> (usize, usize) {
    (usize::from(texel) % SIDE, usize::from(texel) / SIDE)
}

/// Far surface in the centre of a texel, or the nearest other surface.
#[derive(Clone, Copy, Debug)]
pub struct Texel {
    /// The far surface, or a miss.
    pub hit: Hit,
    /// Plane of the surface.
    pub plane: Plane,
    /// Inverse depth of the far surface, or of a near one where no far surface follows it; 0 for the sky.
    pub w: f64,
    /// Least and greatest inverse depth at which the texel may be shown.
    pub least: f64,
    /// See `least`.
    pub greatest: f64,
    /// Whether the layer has to show this texel.
    pub kept: bool,
}

impl Texel {
    const SKY: Self = Self { hit: Hit::MISS, plane: Plane([0.0; 3]), w: 0.0, least: 0.0, greatest: 0.0, kept: false };
}

/// Place of a tile on the faces of a cube.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Face.
    pub face: u8,
    /// First column.
    pub left: usize,
    /// First row.
    pub top: usize,
}

/// A tile with its apron.
pub struct Tile {
    /// Place on the faces.
    pub place: Place,
    /// Width of a face, texels.
    pub size: usize,
    /// Texels with the apron, row by row.
    pub texels: Vec<Texel>,
}

impl Tile {
    /// Creates a tile that shows nothing.
    pub fn blank(place: Place, size: usize) -> Self {
        Self { place, size, texels: vec![Texel::SKY; WIDE * WIDE] }
    }

    /// Returns the position on the face of a texel's centre by its index with the apron.
    pub fn position(&self, slot: usize) -> (f64, f64) {
        let (column, row) = ((slot % WIDE) as f64 - 1.0, (slot / WIDE) as f64 - 1.0);
        (self.edge_u(column + 0.5), self.edge_v(row + 0.5))
    }

    /// Returns the ray from the centre through a position in the tile, in texels from its left and upper edge.
    pub fn ray(&self, center: DVec3, x: f64, y: f64) -> Ray {
        let direction = direction_from_face(self.place.face, self.edge_u(x), self.edge_v(y)).normalize();
        Ray { origin: center.as_vec3(), direction: direction.as_vec3(), t_min: 0.0, t_max: f32::INFINITY }
    }

    /// Returns a texel of the tile; its apron has column and row −1 and `SIDE`.
    #[inline]
    pub fn texel(&self, column: isize, row: isize) -> &Texel {
        &self.texels[(row + 1) as usize * WIDE + (column + 1) as usize]
    }

    /// Returns a texel of the tile.
    #[inline]
    pub fn texel_inside(&self, column: usize, row: usize) -> &Texel {
        &self.texels[(row + APRON) * WIDE + column + APRON]
    }

    /// Returns the position on the face of a column's centre.
    #[inline]
    pub fn u(&self, column: usize) -> f64 {
        self.edge_u(column as f64 + 0.5)
    }

    /// Returns the position on the face of a row's centre.
    #[inline]
    pub fn v(&self, row: usize) -> f64 {
        self.edge_v(row as f64 + 0.5)
    }

    /// Returns the position on the face of a distance in texels from the tile's left edge.
    #[inline]
    pub fn edge_u(&self, x: f64) -> f64 {
        (self.place.left as f64 + x) * 2.0 / self.size as f64 - 1.0
    }

    /// Returns the position on the face of a distance in texels from the tile's upper edge.
    #[inline]
    pub fn edge_v(&self, y: f64) -> f64 {
        (self.place.top as f64 + y) * 2.0 / self.size as f64 - 1.0
    }
}
