//! Colours and masks of quads.

use glam::DVec3;

use super::cover::{Cover, rectangle};
use super::plane::Plane;
use super::strips::cells;
use super::tile::{Place, SIDE, Tile, WIDE, column_and_row};
use super::world::World;
use crate::camera::direction_from_face;
use crate::render::Surface;
use crate::scene::srgb::srgb_from_linear;
use crate::trace::{Hit, Ray};

/// Positions of a texel's samples.
const SAMPLES: [(f64, f64); 4] = [(0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)];

/// A textured rectangle of a plane.
#[derive(Clone, Debug)]
pub struct Quad {
    /// Plane over the face.
    pub plane: Plane,
    /// Place of the tile on the faces.
    pub place: Place,
    /// Left, top, right and bottom in the tile, from −1 to `SIDE` + 1.
    pub rectangle: [isize; 4],
    /// Columns and rows of cells.
    pub cells: [usize; 2],
    /// sRGB, and the share of the texel that the surface covers as alpha; rows from the top.
    pub texels: Vec<[u8; 4]>,
}

impl Quad {
    /// Returns width and height in texels.
    pub fn size(&self) -> [usize; 2] {
        let [left, top, right, bottom] = self.rectangle;
        [(right - left) as usize, (bottom - top) as usize]
    }

    /// Returns whether some texels are transparent.
    pub fn is_masked(&self) -> bool {
        self.texels.iter().any(|texel| texel[3] < u8::MAX)
    }
}

/// Colour, linear RGB, and share of a texel that its surface covers, 0 to 1.
type Painted = ([f32; 3], f32);

/// Paints a cover of a tile. The mask grows by a texel where the plane lies on or behind what is seen there, so that
/// neighbouring quads overlap and silhouettes do not grow.
pub fn paint(world: &World<'_>, center: DVec3, tile: &Tile, cover: &Cover) -> Quad {
    let mut shown: Vec<Option<Painted>> = vec![None; WIDE * WIDE];
    for (&texel, painted) in cover.texels.iter().zip(surfaces(world, center, tile, cover)) {
        let (column, row) = column_and_row(texel);
        shown[slot(column as isize, row as isize)] = Some(painted);
    }
    let [left, top, right, bottom] = rectangle(&cover.texels).map(|edge| edge as isize);
    let is_behind = |column: isize, row: isize| {
        let w = cover.plane.w(tile.edge_u(column as f64 + 0.5), tile.edge_v(row as f64 + 0.5));
        w > 0.0 && w <= tile.texel(column, row).w * (1.0 + 1e-6)
    };
    // Painted texels, those into which the mask grows, and the others with the mean colour.
    let mean = average(shown.iter().flatten().map(|painted| painted.0)).unwrap_or_default();
    let painted = |column: isize, row: isize| {
        shown[slot(column, row)].map(|painted| (painted, true)).unwrap_or_else(|| {
            let beside =
                average(neighbourhood(column, row).filter_map(|(x, y)| shown[slot(x, y)]).map(|painted| painted.0));
            let is_grown = beside.is_some() && is_behind(column, row);
            ((beside.unwrap_or(mean), f32::from(u8::from(is_grown))), is_grown)
        })
    };
    let mut rectangle = [left, top, right, bottom];
    for row in top - 1..=bottom {
        for column in left - 1..=right {
            if painted(column, row).1 {
                rectangle = [
                    rectangle[0].min(column),
                    rectangle[1].min(row),
                    rectangle[2].max(column + 1),
                    rectangle[3].max(row + 1),
                ];
            }
        }
    }
    let [left, top, right, bottom] = rectangle;
    let inside = (top..bottom).flat_map(|row| (left..right).map(move |column| (column, row)));
    let texels = inside.map(|(column, row)| {
        let (color, alpha) = painted(column, row).0;
        let [r, g, b] = color.map(srgb_from_linear);
        [r, g, b, (alpha * 255.0).round() as u8]
    });
    let cells = cells(&cover.plane, tile, rectangle);
    Quad { plane: cover.plane, place: tile.place, rectangle, cells, texels: texels.collect() }
}

/// Returns the index of a texel in a tile with its apron.
fn slot(column: isize, row: isize) -> usize {
    (row + 1) as usize * WIDE + (column + 1) as usize
}

/// Returns a texel and its neighbours that the tile or its apron has.
fn neighbourhood(column: isize, row: isize) -> impl Iterator<Item = (isize, isize)> {
    let beside = (-1..=1).flat_map(move |dy| (-1..=1).map(move |dx| (column + dx, row + dy)));
    beside.filter(|&(x, y)| (-1..=SIDE as isize).contains(&x) && (-1..=SIDE as isize).contains(&y))
}

fn average(colors: impl Iterator<Item = [f32; 3]>) -> Option<[f32; 3]> {
    let (sum, count) =
        colors.fold(([0.0f32; 3], 0), |(sum, count), color| (std::array::from_fn(|i| sum[i] + color[i]), count + 1));
    (count > 0).then(|| sum.map(|x| x / count as f32))
}

/// Returns the surfaces in a cover's texels: the mean colour of the samples that lie on its plane, or else the colour in
/// the texel's centre, and the share of samples that do not see past the plane. Texels inside a face without a texture
/// take one sample.
fn surfaces(world: &World<'_>, center: DVec3, tile: &Tile, cover: &Cover) -> Vec<Painted> {
    let secant = |x: f64, y: f64| direction_from_face(tile.place.face, tile.edge_u(x), tile.edge_v(y)).length();
    // Width of a texel on a sphere at the distance of the hit.
    let width = |hit: &Hit, secant: f64| (2.0 / tile.size as f64 / secant.powf(1.5) * f64::from(hit.t)) as f32;
    let color = |ray: &Ray, hit: &Hit, width: f32| Surface::of_hit(world.scene, ray, hit).color(world.scene, width);
    let positions = |texel: u16| {
        let (column, row) = column_and_row(texel);
        SAMPLES.map(|(dx, dy)| (column as f64 + dx, row as f64 + dy))
    };
    let mut surfaces = Vec::with_capacity(cover.texels.len());
    let (mut rays, mut sampled) = (Vec::new(), Vec::new());
    for (n, &texel) in cover.texels.iter().enumerate() {
        let (column, row) = column_and_row(texel);
        let (x, y) = (column as f64 + 0.5, row as f64 + 0.5);
        let (ray, hit) = (tile.ray(center, x, y), tile.texel_inside(column, row).hit);
        surfaces.push((color(&ray, &hit, width(&hit, secant(x, y))), 1.0));
        if needs_samples(world, tile, column, row) {
            sampled.push(n);
            rays.extend(positions(texel).map(|(x, y)| tile.ray(center, x, y)));
        }
    }
    let mut hits = vec![Hit::MISS; rays.len()];
    world.trace(&rays, true, &mut hits);
    for ((&n, rays), hits) in sampled.iter().zip(rays.chunks(SAMPLES.len())).zip(hits.chunks(SAMPLES.len())) {
        let number = cover.texels[n];
        let (column, row) = column_and_row(number);
        let texel = tile.texel_inside(column, row);
        let allowed = (texel.greatest - texel.least).max(1e-3 * texel.w);
        let (mut beyond, mut colors) = (0, Vec::with_capacity(SAMPLES.len()));
        for ((ray, hit), (x, y)) in rays.iter().zip(hits).zip(positions(number)) {
            let secant = secant(x, y);
            let w = if hit.is_miss() { 0.0 } else { secant / f64::from(hit.t) };
            let off = w - cover.plane.w(tile.edge_u(x), tile.edge_v(y));
            beyond += usize::from(off < -allowed);
            if off.abs() <= allowed && !hit.is_miss() {
                colors.push(color(ray, hit, 0.5 * width(hit, secant)));
            }
        }
        surfaces[n].0 = average(colors.into_iter()).unwrap_or(surfaces[n].0);
        surfaces[n].1 = 1.0 - beyond as f32 / SAMPLES.len() as f32;
    }
    surfaces
}

/// Returns whether a texel's colour may vary: its neighbours show other faces, or its material has a texture.
fn needs_samples(world: &World<'_>, tile: &Tile, column: usize, row: usize) -> bool {
    let hit = tile.texel_inside(column, row).hit;
    let mesh = &world.scene.instance(hit.instance).mesh;
    let shows_other = |(x, y): (isize, isize)| {
        let other = tile.texel(x, y).hit;
        (other.instance, other.face) != (hit.instance, hit.face)
    };
    world.scene.material_of(mesh, hit.face).textures().next().is_some()
        || neighbourhood(column as isize, row as isize).any(shows_other)
}
