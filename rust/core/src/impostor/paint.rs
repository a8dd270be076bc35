//! Colours and masks of quads.

use glam::DVec3;

use super::cover::{Cover, rectangle};
use super::plane::Plane;
use super::tile::{Place, SIDE, Tile, World};
use crate::camera::direction_from_face;
use crate::render::Surface;
use crate::scene::srgb::srgb_from_linear;
use crate::trace::{Hit, Ray};

/// Positions of a texel's samples.
const SAMPLES: [(f64, f64); 4] = [(0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)];
const WIDE: usize = SIDE + 2;

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
    /// sRGB and alpha (0 or 255), rows from the top.
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
        self.texels.iter().any(|texel| texel[3] == 0)
    }
}

/// State of a texel of a quad.
#[derive(Clone, Copy, PartialEq)]
enum State {
    Outside,
    Grown,
    Shown,
}

/// Paints a cover of a tile. The mask grows by a texel where the plane lies on or behind what is seen there, so that
/// neighbouring quads overlap and silhouettes do not grow.
pub fn paint(world: &World<'_>, center: DVec3, tile: &Tile, cover: &Cover) -> Quad {
    let mut states = [State::Outside; WIDE * WIDE];
    let slot = |column: isize, row: isize| (row + 1) as usize * WIDE + (column + 1) as usize;
    for &texel in &cover.texels {
        states[slot((usize::from(texel) % SIDE) as isize, (usize::from(texel) / SIDE) as isize)] = State::Shown;
    }
    let [left, top, right, bottom] = rectangle(&cover.texels).map(|edge| edge as isize);
    let mut grown = [left, top, right, bottom];
    for row in top - 1..=bottom {
        for column in left - 1..=right {
            let at = slot(column, row);
            let neighbours = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (column + dx, row + dy)));
            let is_beside = |(x, y): (isize, isize)| {
                (left..right).contains(&x) && (top..bottom).contains(&y) && states[slot(x, y)] == State::Shown
            };
            let w = cover.plane.w(tile.edge_u(column as f64 + 0.5), tile.edge_v(row as f64 + 0.5));
            if states[at] == State::Outside
                && neighbours.into_iter().any(is_beside)
                && w > 0.0
                && w <= tile.around(column, row).w * (1.0 + 1e-6)
            {
                states[at] = State::Grown;
                grown = [grown[0].min(column), grown[1].min(row), grown[2].max(column + 1), grown[3].max(row + 1)];
            }
        }
    }
    let colors = colors(world, center, tile, cover);
    let mut by_slot = vec![None; WIDE * WIDE];
    for (&texel, color) in cover.texels.iter().zip(&colors) {
        by_slot[slot((usize::from(texel) % SIDE) as isize, (usize::from(texel) / SIDE) as isize)] = Some(*color);
    }
    let mean = mean(colors.iter().map(|color| color.0));
    let mut texels = Vec::with_capacity(((grown[2] - grown[0]) * (grown[3] - grown[1])) as usize);
    for row in grown[1]..grown[3] {
        for column in grown[0]..grown[2] {
            let beside = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (column + dx, row + dy)));
            let beside = beside
                .filter(|&(x, y)| (-1..=SIDE as isize).contains(&x) && (-1..=SIDE as isize).contains(&y))
                .filter_map(|(x, y)| by_slot[slot(x, y)].map(|color: ([f32; 3], u8)| color.0));
            let own = by_slot[slot(column, row)];
            let color = own.map(|own| own.0).or_else(|| average(beside)).unwrap_or(mean);
            let [r, g, b] = color.map(srgb_from_linear);
            texels.push([r, g, b, match states[slot(column, row)] {
                State::Outside => 0,
                State::Grown => u8::MAX,
                State::Shown => own.map_or(u8::MAX, |own| own.1),
            }]);
        }
    }
    let cells = super::strips::cells(&cover.plane, tile, grown);
    Quad { plane: cover.plane, place: tile.place, rectangle: grown, cells, texels }
}

fn mean(colors: impl Iterator<Item = [f32; 3]>) -> [f32; 3] {
    average(colors).unwrap_or_default()
}

fn average(colors: impl Iterator<Item = [f32; 3]>) -> Option<[f32; 3]> {
    let (sum, count) =
        colors.fold(([0.0f32; 3], 0), |(sum, count), color| (std::array::from_fn(|i| sum[i] + color[i]), count + 1));
    (count > 0).then(|| sum.map(|x| x / count as f32))
}

/// Returns the linear RGB of a cover's texels: the mean of the samples that lie on its plane, or else the colour in the
/// texel's centre. Texels inside a face without a texture take one sample.
fn colors(world: &World<'_>, center: DVec3, tile: &Tile, cover: &Cover) -> Vec<([f32; 3], u8)> {
    let width = |hit: &Hit, secant: f64| {
        (2.0 / tile.size as f64 / secant.powf(1.5) * f64::from(hit.t)) as f32
    };
    let mut colors = Vec::with_capacity(cover.texels.len());
    let mut rays = Vec::new();
    let mut sampled = Vec::new();
    for (n, &number) in cover.texels.iter().enumerate() {
        let (column, row) = (usize::from(number) % SIDE, usize::from(number) / SIDE);
        let (x, y) = (column as f64 + 0.5, row as f64 + 0.5);
        let ray = tile.ray(center, x, y);
        let hit = tile.at(column, row).hit;
        let secant = direction_from_face(tile.place.face, tile.edge_u(x), tile.edge_v(y)).length();
        colors.push((Surface::of_hit(world.scene, &ray, &hit).color(world.scene, width(&hit, secant)), u8::MAX));
        if needs_samples(world, tile, column, row) {
            sampled.push(n);
            rays.extend(SAMPLES.map(|(dx, dy)| tile.ray(center, column as f64 + dx, row as f64 + dy)));
        }
    }
    let mut hits = vec![Hit::MISS; rays.len()];
    world.trace(&rays, true, &mut hits);
    for ((&n, rays), hits) in sampled.iter().zip(rays.chunks(SAMPLES.len())).zip(hits.chunks(SAMPLES.len())) {
        let number = usize::from(cover.texels[n]);
        let (column, row) = (number % SIDE, number / SIDE);
        let texel = tile.at(column, row);
        let allowed = (texel.greatest - texel.least).max(1e-3 * texel.w);
        let on_plane = rays.iter().zip(hits).zip(SAMPLES).filter_map(|((ray, hit), (dx, dy))| {
            let (u, v) = (tile.edge_u(column as f64 + dx), tile.edge_v(row as f64 + dy));
            let secant = direction_from_face(tile.place.face, u, v).length();
            let is_on_plane = !hit.is_miss() && (secant / f64::from(hit.t) - cover.plane.w(u, v)).abs() <= allowed;
            let color = || Surface::of_hit(world.scene, ray, hit).color(world.scene, 0.5 * width(hit, secant));
            is_on_plane.then(color)
        });
        if let Some(color) = average(on_plane) {
            colors[n].0 = color;
        }
        // Samples that see past the plane lie outside the surface's silhouette.
        let is_beyond = |((hit, (dx, dy)), _): &((&Hit, (f64, f64)), ())| {
            let (u, v) = (tile.edge_u(column as f64 + dx), tile.edge_v(row as f64 + dy));
            let secant = direction_from_face(tile.place.face, u, v).length();
            hit.is_miss() || secant / f64::from(hit.t) < cover.plane.w(u, v) - allowed
        };
        let beyond = hits.iter().zip(SAMPLES).zip([(); 4]).filter(is_beyond).count();
        colors[n].1 = (u8::MAX as usize * (SAMPLES.len() - beyond) / SAMPLES.len()) as u8;
    }
    colors
}

/// Returns whether a texel's colour may vary: its neighbours show other faces, or its material has a texture.
fn needs_samples(world: &World<'_>, tile: &Tile, column: usize, row: usize) -> bool {
    let hit = tile.at(column, row).hit;
    let mesh = &world.scene.instance(hit.instance).mesh;
    let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (column as isize + dx, row as isize + dy)));
    world.scene.material_of(mesh, hit.face).textures().next().is_some()
        || around.into_iter().any(|(x, y)| {
            let other = tile.around(x, y).hit;
            (other.instance, other.face) != (hit.instance, hit.face)
        })
}
