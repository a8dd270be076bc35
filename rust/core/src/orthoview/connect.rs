//! Connectivity of neighbouring pixels of a view: whether they show one surface.
//!
//! Let P₁ and P₂ be the points of two neighbours, p̂ the unit vector between them, and n₁ and n₂ their normals. They
//! are connected if their depths differ by less than τ₁, if |n₁·p̂| and |n₂·p̂| are less than τ₂, and if n₁ mirrored
//! in the plane perpendicular to p̂, n₁ − 2 (n₁·p̂) p̂, has a cosine with n₂ above τ₃: on a sphere both are equal.
//! Within a block of 2 × 2 pixels, connectivity is transitive.

use glam::Vec3;
use rayon::prelude::*;

use super::direction::{Direction, Frame};
use super::normals;
use super::view::{Format, View, Views};
use crate::base::memory::room_for;
use crate::base::{Result, ensure};

/// Bounds τ₁, τ₂ and τ₃.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Maximum difference of depths, in widths of the larger side of a pixel.
    pub depth: f32,
    /// Maximum cosine between a normal and the vector between the points.
    pub slope: f32,
    /// Minimum cosine between one normal, mirrored, and the other one.
    pub bend: f32,
}

/// Steps to the neighbours whose connections a pixel stores, as (columns, rows). Bit n belongs to the n-th step.
const NEIGHBOURS: [(i64, i64); 4] = [(1, 0), (0, 1), (1, 1), (-1, 1)];

/// Pairs of pixels of a block, whose pixels are numbered row by row.
const PAIRS: [(usize, usize); 6] = [(0, 1), (0, 2), (1, 3), (2, 3), (0, 3), (1, 2)];

/// Pixel of the block that stores the connection of each pair, and the bit.
const PAIR_BITS: [(usize, u8); 6] = [(0, 0), (0, 1), (1, 1), (2, 0), (0, 2), (1, 3)];

/// Maximum number of connected neighbours of a ball.
const MAX_BALL_NEIGHBOURS: u8 = 4;

/// Returns four bits per pixel of each view: whether the pixel is connected with its neighbours to the right, below,
/// below right, and below left.
pub fn connected(views: &Views, bounds: &Bounds) -> Result<Vec<u8>> {
    // Direct and closed bits of each view, the bits of all views, and the normals of one view per thread.
    let (pixels, count) = (views.format.pixels(), views.directions.len());
    room_for((pixels * (3 * count + rayon::current_num_threads() * size_of::<Vec3>())) as u64)?;
    let connect_view = |(direction, view): (&Direction, &View)| {
        close_blocks(&direct_connections(view, direction.frame(), &views.format, bounds), views.format.size)
    };
    Ok(views.directions.par_iter().zip(views.views()).map(connect_view).collect::<Vec<_>>().concat())
}

/// Returns, for each pixel of views of `size` × `size` pixels, whether it is a surfel (a piece of a plane): it is
/// connected with more than four of its eight neighbours. All other pixels are balls.
pub fn surfels(bits: &[u8], size: usize) -> Result<Vec<bool>> {
    let is_whole = size > 0 && bits.len().is_multiple_of(size * size);
    ensure!(is_whole, "bits", format!("views of {size} × {size} pixels"), bits.len());
    // Neighbour counts, the threads' lists, and the list of all pixels.
    room_for(3 * bits.len() as u64)?;
    let classify_view = |bits| neighbours(bits, size).into_iter().map(is_surfel);
    Ok(bits.par_chunks(size * size).flat_map_iter(classify_view).collect())
}

/// Returns whether a pixel with a number of connected neighbours is a surfel.
pub(super) fn is_surfel(neighbours: u8) -> bool {
    neighbours > MAX_BALL_NEIGHBOURS
}

/// Counts the connected neighbours of each pixel of a view.
pub(super) fn neighbours(bits: &[u8], size: usize) -> Vec<u8> {
    let mut counts = vec![0u8; bits.len()];
    for (pixel, &connections) in bits.iter().enumerate() {
        for (_, step) in (0..).zip(NEIGHBOURS).filter(|(bit, _)| connections >> bit & 1 == 1) {
            // Bits that lead out of the picture are ignored.
            let Some(other) = neighbour(pixel, step, size) else { continue };
            counts[pixel] += 1;
            counts[other] += 1;
        }
    }
    counts
}

/// Returns the pixel some columns and rows away; `None` beyond the border.
#[inline]
fn neighbour(pixel: usize, (columns, rows): (i64, i64), size: usize) -> Option<usize> {
    let (column, row) = ((pixel % size) as i64 + columns, (pixel / size) as i64 + rows);
    let inside = 0..size as i64;
    (inside.contains(&column) && inside.contains(&row)).then(|| row as usize * size + column as usize)
}

/// Returns the connection bits of each pixel before the transitive closure.
fn direct_connections(view: &View, frame: Frame, format: &Format, bounds: &Bounds) -> Vec<u8> {
    let size = format.size;
    let pixels = Pixels::new(view, frame, format, bounds);
    let bits_of_pixel = |pixel: usize| {
        let connects = |step| neighbour(pixel, step, size).is_some_and(|other| pixels.connect(pixel, other, step));
        (0..).zip(NEIGHBOURS).fold(0, |bits, (bit, step)| bits | u8::from(connects(step)) << bit)
    };
    (0..format.pixels()).map(bits_of_pixel).collect()
}

/// Points and normals of a view's pixels, along the axes of the view.
struct Pixels<'a> {
    view: &'a View,
    bounds: &'a Bounds,
    /// Width and height of a pixel and length of a depth step, in sides of the cell.
    pitch: Vec3,
    /// Maximum difference of depths, in sides of the cell.
    max_difference: f32,
    normals: Vec<Vec3>,
}

impl<'a> Pixels<'a> {
    fn new(view: &'a View, frame: Frame, format: &Format, bounds: &'a Bounds) -> Self {
        let counts = Vec3::new(format.size as f32, format.size as f32, format.steps as f32);
        let pitch = frame.extents().as_vec3() / counts;
        let axes = frame.axes().map(|axis| axis.as_vec3());
        let in_view = |normal: Vec3| Vec3::from_array(axes.map(|axis| axis.dot(normal)));
        let normals = view.iter().map(|texel| in_view(normals::decode(texel.normal, format.normal_bits)));
        Self { view, bounds, pitch, max_difference: bounds.depth * pitch.x.max(pitch.y), normals: normals.collect() }
    }

    #[inline]
    fn connect(&self, pixel: usize, other: usize, (columns, rows): (i64, i64)) -> bool {
        let [depth, other_depth] = [pixel, other].map(|pixel| i32::from(self.view[pixel].depth));
        if depth == 0 || other_depth == 0 {
            return false;
        }
        let between = Vec3::new(columns as f32, -rows as f32, (depth - other_depth) as f32) * self.pitch;
        if between.z.abs() >= self.max_difference {
            return false;
        }
        let (n, m, unit) = (self.normals[pixel], self.normals[other], between.normalize());
        let (slope, other_slope) = (n.dot(unit), m.dot(unit));
        slope.abs() < self.bounds.slope
            && other_slope.abs() < self.bounds.slope
            && n.dot(m) - 2.0 * slope * other_slope > self.bounds.bend
    }
}

/// Adds the connections of pixels that are connected through other pixels of their block.
fn close_blocks(direct: &[u8], size: usize) -> Vec<u8> {
    let closures: [u8; 64] = std::array::from_fn(|bits| closure(bits as u8));
    let mut all = direct.to_vec();
    for first in (0..size - 1).flat_map(|row| (0..size - 1).map(move |column| row * size + column)) {
        let block = [first, first + 1, first + size, first + size + 1];
        let pair = |(pixel, bit): (usize, u8)| direct[block[pixel]] >> bit & 1;
        let bits = (0..).zip(PAIR_BITS).fold(0, |bits, (n, stored)| bits | pair(stored) << n);
        let added = closures[usize::from(bits)] & !bits;
        for (_, (pixel, bit)) in (0..).zip(PAIR_BITS).filter(|(n, _)| added >> n & 1 == 1) {
            all[block[pixel]] |= 1 << bit;
        }
    }
    all
}

/// Returns the pairs of a block that are connected directly or through its other pixels; bit n stands for `PAIRS[n]`.
fn closure(bits: u8) -> u8 {
    let mut group = [0, 1, 2, 3];
    for (_, (one, other)) in (0..).zip(PAIRS).filter(|(n, _)| bits >> n & 1 == 1) {
        let (from, to) = (group[other], group[one]);
        group.iter_mut().filter(|group| **group == from).for_each(|group| *group = to);
    }
    (0..).zip(PAIRS).fold(0, |all, (n, (one, other))| all | u8::from(group[one] == group[other]) << n)
}
