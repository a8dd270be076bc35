//! Layers, and whether one shows a point.

use std::sync::Arc;

use glam::DVec3;

use super::paint::Quad;
use super::plane::{Bound, Plane};
use super::tile::{Place, SIDE, Texel};
use super::world::World;
use crate::camera::{along_face, direction_from_face, face_from_direction};

/// A layer shows a surface well enough if its texels there cover at most this many times the area of the new ones.
const MAX_AREA_RATIO: f64 = 4.0;
/// Owner of a texel that the layer does not show.
const NOBODY: u16 = u16::MAX;

/// A texel's surface as seen from a centre.
pub struct Patch {
    point: DVec3,
    normal: DVec3,
    /// Area of surface in the texel, square metres.
    area: f64,
}

impl Patch {
    /// Returns the surface that a texel of a layer shows at a position on a face.
    pub fn new(center: DVec3, face: u8, (u, v): (f64, f64), texel: &Texel, size: usize) -> Self {
        let (direction, normal) = (direction_from_face(face, u, v), texel.plane.normal(face));
        let point = direction / texel.w;
        Self { point: center + point, normal, area: area(point, direction.length(), normal, size) }
    }

    /// Returns whether the texel is not much coarser than that of a map of `size` texels with another centre.
    pub fn is_as_fine_as_from(&self, center: DVec3, size: usize) -> bool {
        let to_point = self.point - center;
        let outward = to_point.abs().max_element();
        self.area <= MAX_AREA_RATIO * area(to_point, to_point.length() / outward, self.normal, size)
    }

    /// Returns a point whose texel's area counts as none, so that any layer near it shows it well enough.
    pub fn of_point(point: DVec3) -> Self {
        Self { point, normal: DVec3::ZERO, area: f64::INFINITY }
    }
}

/// Returns the area of surface that a texel shows: its solid angle (2/size)²/sec³, times the square of the distance, by
/// the cosine between ray and normal.
fn area(point: DVec3, secant: f64, normal: DVec3, size: usize) -> f64 {
    let (square, distance) = (point.length_squared(), point.length());
    let cosine = (normal.dot(point) / distance).abs().max(1e-6);
    (2.0 / size as f64).powi(2) / secant.powi(3) * square / cosine
}

/// Planes of a tile and the plane that shows each texel.
struct LayerTile {
    owners: Vec<u16>,
    planes: Vec<Plane>,
}

/// Planes of a layer's quads by texel.
pub struct Layer {
    /// Centre relative to the scene's origin.
    pub center: DVec3,
    bound: Bound,
    size: usize,
    tiles: Vec<Option<LayerTile>>,
}

/// Returns the number of tiles across a face.
pub fn tiles_across(size: usize) -> usize {
    size.div_ceil(SIDE)
}

/// Returns the place of a tile by its number.
pub fn place(number: usize, size: usize) -> Place {
    let across = tiles_across(size);
    let (face, rest) = (number / across.pow(2), number % across.pow(2));
    Place { face: face as u8, left: rest % across * SIDE, top: rest / across * SIDE }
}

/// Returns the number of the tile at a place.
fn tile_number(place: &Place, size: usize) -> usize {
    let across = tiles_across(size);
    (usize::from(place.face) * across + place.top / SIDE) * across + place.left / SIDE
}

impl LayerTile {
    fn new(quads: &[Arc<Quad>]) -> Self {
        let mut owners = vec![NOBODY; SIDE * SIDE];
        for (number, quad) in quads.iter().enumerate() {
            for &texel in &quad.own {
                owners[usize::from(texel)] = number as u16;
            }
        }
        Self { owners, planes: quads.iter().map(|quad| quad.plane).collect() }
    }
}

impl Layer {
    /// Creates a layer from its quads, in the order of their tiles.
    pub fn new(world: &World<'_>, center: DVec3, size: usize, quads: &[Arc<Quad>]) -> Self {
        let mut tiles: Vec<Option<LayerTile>> = Vec::new();
        tiles.resize_with(6 * tiles_across(size).pow(2), || None);
        for quads in quads.chunk_by(|a, b| a.place == b.place) {
            tiles[tile_number(&quads[0].place, size)] = Some(LayerTile::new(quads));
        }
        Self { center, bound: world.bound(center), size, tiles }
    }

    /// Returns whether one of the four texels around a point's direction shows the point within the error bound, and
    /// not much more coarsely than the patch.
    pub fn shows(&self, patch: &Patch) -> bool {
        let to_point = patch.point - self.center;
        let (face, u, v) = face_from_direction(to_point);
        let outward = along_face(face, to_point).2;
        let distance = to_point.length();
        if outward <= 0.0 {
            return false;
        }
        let secant = distance / outward;
        if patch.area.is_finite() && area(to_point, secant, patch.normal, self.size) > MAX_AREA_RATIO * patch.area {
            return false;
        }
        let [nearest, farthest] = self.bound.distances(to_point / distance, distance);
        let (least, greatest) = (secant / farthest * (1.0 - 1e-6), secant / nearest * (1.0 + 1e-6));
        let last = self.size as f64 - 1.0;
        let (x, y) = ((u + 1.0) * 0.5 * self.size as f64 - 0.5, (v + 1.0) * 0.5 * self.size as f64 - 0.5);
        [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].into_iter().any(|(dx, dy)| {
            let (column, row) =
                ((x.floor() + dx).clamp(0.0, last) as usize, (y.floor() + dy).clamp(0.0, last) as usize);
            self.plane(face, column, row).is_some_and(|plane| (least..=greatest).contains(&plane.w(u, v)))
        })
    }

    fn plane(&self, face: u8, column: usize, row: usize) -> Option<&Plane> {
        let tile = self.tiles[tile_number(&Place { face, left: column, top: row }, self.size)].as_ref()?;
        tile.planes.get(usize::from(tile.owners[row % SIDE * SIDE + column % SIDE]))
    }
}
