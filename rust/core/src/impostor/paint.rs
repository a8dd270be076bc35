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

/// Samples of a texel.
const SAMPLES: usize = 16;
/// Least error of a sample on the plane, as a share of its inverse depth.
const MIN_ERROR: f64 = 5e-4;

/// Share of the differences from the four neighbours that is added to a texel. A look-up between texels blurs: at a
/// random position linear interpolation has a variance of 1/6 of a texel squared along each axis, which this share undoes.
const SHARPNESS: f32 = 1.0 / 12.0;

/// A textured rectangle of a plane.
#[derive(Clone, Debug)]
pub struct Quad {
    /// Plane over the face.
    pub plane: Plane,
    /// Place of the tile on the faces.
    pub place: Place,
    /// Left, top, right and bottom in the tile, from −1 to `SIDE` + 1.
    pub rectangle: [isize; 4],
    /// Texels that the quad was made for, as in `Cover`; the mask may be larger.
    pub own: Vec<u16>,
    /// Object of most texels; −1 without one.
    pub object: i32,
    /// Columns and rows of cells.
    pub cells: [usize; 2],
    /// sRGB, and alpha from the share of the texel that the surface covers; rows from the top.
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

/// Alpha of texels of which the surface covers less than 1/8, 1/2 and 7/8, and of others. WebP stores alpha without loss:
/// with 17 steps a picture of the city has 0.04 dB more, and the atlas takes 10 % more bytes.
const ALPHAS: [u8; 4] = [0, 64, 192, 255];

/// Linear RGB and alpha of a texel.
pub(super) type Painted = ([f32; 3], u8);

/// Paints a cover of a tile. Its texels have the mean colour of the samples on the plane. Texels beside them overlap
/// neighbouring quads where the plane lies on or behind what is seen there; elsewhere they have the share of the texel
/// that the surface covers, so that silhouettes keep their places.
pub fn paint(world: &World<'_>, center: DVec3, tile: &Tile, cover: &Cover) -> Quad {
    let mut painter = Painter { world, center, tile, plane: &cover.plane, shown: vec![None; WIDE * WIDE] };
    painter.paint(cover);
    painter.grow(cover);
    let shown = painter.shown;
    let mean = average(shown.iter().flatten().map(|painted| painted.0)).unwrap_or_default();
    let [left, top, right, bottom] = rectangle(&cover.texels).map(|edge| edge as isize);
    let mut rectangle = [left, top, right, bottom];
    for row in top - 1..=bottom {
        for column in left - 1..=right {
            if shown[slot(column, row)].is_some_and(|(_, alpha)| alpha > 0) {
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
        let (color, alpha) = sharpen(&shown, column, row).unwrap_or((mean, 0));
        let [r, g, b] = color.map(srgb_from_linear);
        [r, g, b, alpha]
    });
    let cells = cells(&cover.plane, tile, rectangle);
    let object = object_of_most(world, tile, cover);
    let own = cover.texels.clone();
    Quad { plane: cover.plane, place: tile.place, rectangle, own, object, cells, texels: texels.collect() }
}

/// Returns a painted texel, sharpened.
pub(super) fn sharpen(shown: &[Option<Painted>], column: isize, row: isize) -> Option<Painted> {
    let (color, alpha) = shown[slot(column, row)]?;
    let is_beside = |&(x, y): &(isize, isize)| x.abs_diff(column) + y.abs_diff(row) == 1;
    let beside = neighbourhood(column, row).filter(is_beside).filter_map(|(x, y)| shown[slot(x, y)]);
    let mut sharp = color;
    for (neighbour, _) in beside.filter(|&(_, alpha)| alpha > 0) {
        (0..3).for_each(|i| sharp[i] += SHARPNESS * (color[i] - neighbour[i]));
    }
    Some((sharp.map(|x| x.clamp(0.0, 1.0)), alpha))
}

/// Returns the object of most of a cover's texels, the first of equals.
fn object_of_most(world: &World<'_>, tile: &Tile, cover: &Cover) -> i32 {
    let object = |&texel: &u16| {
        let (column, row) = column_and_row(texel);
        let hit = tile.texel_inside(column, row).hit;
        world.scene.instance(hit.instance).object_of(hit.face)
    };
    let mut objects: Vec<i32> = cover.texels.iter().map(object).collect();
    objects.sort_unstable();
    objects.chunk_by(|a, b| a == b).rev().max_by_key(|group| group.len()).map_or(-1, |group| group[0])
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

/// Colours of one quad.
struct Painter<'a> {
    world: &'a World<'a>,
    center: DVec3,
    tile: &'a Tile,
    plane: &'a Plane,
    /// Texels with the apron.
    shown: Vec<Option<Painted>>,
}

/// Samples of a texel.
#[derive(Default)]
struct Samples {
    /// Sum of the colours on the plane.
    sum: [f32; 3],
    /// Samples on the plane.
    on: usize,
    /// Samples that see past the plane.
    beyond: usize,
}

impl Samples {
    /// Returns the mean colour on the plane.
    fn color(&self) -> Option<[f32; 3]> {
        (self.on > 0).then(|| self.sum.map(|x| x / self.on as f32))
    }

    /// Returns the alpha of the share that does not see past the plane.
    fn alpha(&self) -> u8 {
        let covered = SAMPLES - self.beyond;
        ALPHAS[[1, 4, 7].iter().filter(|&&eighths| 8 * covered >= eighths * SAMPLES).count()]
    }
}

/// Returns the positions of a texel's samples: each row and column of 16 × 16 cells has one, so that bars as narrow as
/// a cell show in any direction along the axes.
fn positions(x: isize, y: isize) -> impl Iterator<Item = (f64, f64)> {
    let middle = |cell: usize| (cell as f64 + 0.5) / SAMPLES as f64;
    (0..SAMPLES).map(move |n| (x as f64 + middle(n), y as f64 + middle(7 * n % SAMPLES)))
}

impl Painter<'_> {
    /// Paints the cover's texels: the mean colour of the samples that lie on its plane, or else the colour in the
    /// texel's centre, and the share of samples that do not see past the plane.
    fn paint(&mut self, cover: &Cover) {
        let place = |&texel: &u16| {
            let (column, row) = column_and_row(texel);
            (column as isize, row as isize, 2.0 * self.allowed(texel))
        };
        let texels: Vec<_> = cover.texels.iter().map(place).collect();
        for (&(x, y, _), samples) in texels.iter().zip(self.samples(&texels)) {
            let color = samples.color().unwrap_or_else(|| {
                let ray = self.tile.ray(self.center, x as f64 + 0.5, y as f64 + 0.5);
                self.color(&ray, &self.tile.texel(x, y).hit, self.secant(x as f64 + 0.5, y as f64 + 0.5))
            });
            self.shown[slot(x, y)] = Some((color, samples.alpha()));
        }
    }

    /// Paints the texels beside the cover's.
    fn grow(&mut self, cover: &Cover) {
        let mut beside = Vec::new();
        for &texel in &cover.texels {
            let (column, row) = column_and_row(texel);
            for (x, y) in neighbourhood(column as isize, row as isize) {
                if self.shown[slot(x, y)].is_none() {
                    beside.push((x, y, self.allowed(texel)));
                }
            }
        }
        beside.sort_by_key(|&(x, y, _)| slot(x, y));
        beside.dedup_by_key(|&mut (x, y, _)| slot(x, y));
        let painted = beside.iter().zip(self.samples(&beside)).map(|(&(x, y, _), samples)| {
            let shown = || neighbourhood(x, y).filter_map(|(x, y)| self.shown[slot(x, y)]).map(|painted| painted.0);
            let color = samples.color().or_else(|| average(shown())).unwrap_or_default();
            let w = self.w(x as f64 + 0.5, y as f64 + 0.5);
            let is_behind = w > 0.0 && w <= self.tile.texel(x, y).w * (1.0 + 1e-6);
            let alpha = if samples.on > 0 { samples.alpha() } else { 0 };
            (color, if is_behind { u8::MAX } else { alpha })
        });
        let painted: Vec<Painted> = painted.collect();
        for ((x, y, _), painted) in beside.into_iter().zip(painted) {
            self.shown[slot(x, y)] = Some(painted);
        }
    }

    /// Returns the error of inverse depth that the bound allows about a texel's surface.
    fn allowed(&self, texel: u16) -> f64 {
        let (column, row) = column_and_row(texel);
        let texel = self.tile.texel_inside(column, row);
        (0.5 * (texel.greatest - texel.least)).max(MIN_ERROR * texel.w)
    }

    /// Samples texels, given with the error of inverse depth up to which a sample lies on the plane.
    fn samples(&self, texels: &[(isize, isize, f64)]) -> Vec<Samples> {
        let rays: Vec<Ray> = texels
            .iter()
            .flat_map(|&(x, y, _)| positions(x, y))
            .map(|(x, y)| self.tile.ray(self.center, x, y))
            .collect();
        let mut hits = vec![Hit::MISS; rays.len()];
        self.world.trace(&rays, true, &mut hits);
        let sampled = texels.iter().zip(rays.chunks(SAMPLES)).zip(hits.chunks(SAMPLES));
        sampled.map(|((texel, rays), hits)| self.sum(texel, rays, hits)).collect()
    }

    /// Sums the samples of a texel.
    fn sum(&self, &(x, y, allowed): &(isize, isize, f64), rays: &[Ray], hits: &[Hit]) -> Samples {
        let mut samples = Samples::default();
        for ((ray, hit), (x, y)) in rays.iter().zip(hits).zip(positions(x, y)) {
            let secant = self.secant(x, y);
            let w = if hit.is_miss() { 0.0 } else { secant / f64::from(hit.t) };
            let off = w - self.w(x, y);
            samples.beyond += usize::from(off < -allowed);
            if off.abs() <= allowed && !hit.is_miss() {
                let color = self.color(ray, hit, secant);
                (0..3).for_each(|i| samples.sum[i] += color[i]);
                samples.on += 1;
            }
        }
        samples
    }

    /// Returns the plane's inverse depth.
    fn w(&self, x: f64, y: f64) -> f64 {
        self.plane.w(self.tile.edge_u(x), self.tile.edge_v(y))
    }

    /// Returns the distance of a position on the face, whose depth is 1.
    fn secant(&self, x: f64, y: f64) -> f64 {
        direction_from_face(self.tile.place.face, self.tile.edge_u(x), self.tile.edge_v(y)).length()
    }

    /// Returns the colour of a hit by a sample's ray.
    fn color(&self, ray: &Ray, hit: &Hit, secant: f64) -> [f32; 3] {
        // Width of a sample on a sphere at the distance of the hit.
        let texel = 2.0 / self.tile.size as f64 / secant.powf(1.5) * f64::from(hit.t);
        let width = texel / (SAMPLES as f64).sqrt();
        Surface::of_hit(self.world.scene, ray, hit).color(self.world.scene, width as f32)
    }
}
