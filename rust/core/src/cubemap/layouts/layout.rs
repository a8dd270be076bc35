//! Layouts of panoramas: cube maps, equirectangular and octahedral pictures.
//!
//! - **Equirectangular**: latitude falls from +y in row 0 to −y; columns are longitudes; the middle column looks along
//!   −z, with +x to its right.
//! - **Octahedral** (Cigolle et al., "A survey of efficient representations for independent unit vectors", 2014): the
//!   octahedron |x| + |y| + |z| = 1 seen from +y, x to the right and z down. Its lower half is folded outwards, so that
//!   −y lies at all four corners.
//!
//! Positions are in texels: the centre of the first texel lies at (0.5, 0.5).

use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::super::faces::{MAX_SIZE, texel_from_direction};
use super::projections::{equirectangular, octahedral};
use crate::base::{Result, ensure, memory::room_for};
use crate::camera::direction_from_face;

/// A mapping from directions to positions in a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// Six faces of a cube map.
    Cube,
    /// Columns are longitudes, rows are latitudes.
    Equirectangular,
    /// An unfolded octahedron.
    Octahedral,
}

/// A layout with a size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid {
    /// The layout.
    pub layout: Layout,
    /// Number of rows; for a cube the rows of one face.
    pub height: u32,
    /// Number of columns.
    pub width: u32,
}

impl Grid {
    /// Creates a grid. Fails unless faces of cubes and octahedral pictures are square, equirectangular pictures have an
    /// even width, and the sides are within the limits.
    pub fn new(layout: Layout, height: u32, width: u32) -> Result<Self> {
        let limit = if layout == Layout::Cube { MAX_SIZE } else { 2 * MAX_SIZE };
        let size = || format!("{height} × {width}");
        let is_within = [height, width].iter().all(|side| (1..=limit).contains(side));
        ensure!(is_within, "size", format!("1 to {limit} texels"), size());
        if layout == Layout::Equirectangular {
            ensure!(width.is_multiple_of(2), "size", "an even number of columns", width);
        } else {
            ensure!(height == width, "size", "as many rows as columns", size());
        }
        Ok(Self { layout, height, width })
    }

    /// Returns the number of rows of all faces.
    pub fn rows(&self) -> u32 {
        if self.layout == Layout::Cube { 6 * self.height } else { self.height }
    }

    /// Returns the number of texels of all faces.
    pub fn texels(&self) -> usize {
        self.rows() as usize * self.width as usize
    }

    /// Returns the number of the texel that a direction (finite, not zero) hits.
    pub fn texel(&self, d: DVec3) -> u32 {
        if self.layout == Layout::Cube {
            return texel_from_direction(d, self.width);
        }
        let p = self.position(d);
        // Casts saturate at 0; positions on the right and bottom edge belong to the last texel.
        (p.y as u32).min(self.height - 1) * self.width + (p.x as u32).min(self.width - 1)
    }

    /// Returns the position in texels of a direction (finite, not zero) in a flat layout.
    pub fn position(&self, d: DVec3) -> DVec2 {
        // Scaled, so that neither squares nor sums overflow.
        let d = d / d.abs().max_element();
        let (across, down) = match self.layout {
            Layout::Octahedral => octahedral(d.x, d.y, d.z),
            _ => equirectangular(d.x, d.y, d.z),
        };
        DVec2::new(across * f64::from(self.width), down * f64::from(self.height))
    }

    /// Returns the direction (not normalised) of a position in a flat layout.
    pub fn direction(&self, p: DVec2) -> DVec3 {
        let (height, width) = (f64::from(self.height), f64::from(self.width));
        if self.layout == Layout::Equirectangular {
            let (sine, cosine) = ((0.5 - p.y / height) * PI).sin_cos();
            return direction_of_angles(sine, cosine, ((p.x / width - 0.5) * 2.0 * PI).sin_cos());
        }
        let p = p * 2.0 / width - 1.0;
        let y = 1.0 - p.x.abs() - p.y.abs();
        let p = if y < 0.0 { fold(p) } else { p };
        DVec3::new(p.x, y, p.y)
    }

    /// Returns the texel that continues a flat layout at a row and column beyond its edges.
    pub fn wrap(&self, mut row: i64, mut column: i64) -> usize {
        let (height, width) = (i64::from(self.height), i64::from(self.width));
        let outside = |row: i64, column: i64| !(0..height).contains(&row) || !(0..width).contains(&column);
        while outside(row, column) {
            if self.layout == Layout::Equirectangular {
                // Beyond a pole the picture continues at the opposite longitude.
                if !(0..height).contains(&row) {
                    (row, column) = (mirror(row, height), column + width / 2);
                }
                column = column.rem_euclid(width);
                continue;
            }
            // Each edge continues into itself, mirrored about its middle.
            if !(0..width).contains(&column) {
                (row, column) = (height - 1 - row, mirror(column, width));
            }
            if !(0..height).contains(&row) {
                (row, column) = (mirror(row, height), width - 1 - column);
            }
        }
        (row * width + column) as usize
    }
}

/// Returns the direction at a latitude and a longitude, each given by sine and cosine.
fn direction_of_angles(sine: f64, cosine: f64, longitude: (f64, f64)) -> DVec3 {
    DVec3::new(cosine * longitude.0, sine, -cosine * longitude.1)
}

/// Mirrors an index outside 0..count at the edge that it crossed.
fn mirror(index: i64, count: i64) -> i64 {
    if index < 0 { -1 - index } else { 2 * count - 1 - index }
}

/// Maps between the inner and the outer half of the unfolded octahedron. The map is its own inverse.
fn fold(p: DVec2) -> DVec2 {
    DVec2::new((1.0 - p.y.abs()).copysign(p.x), (1.0 - p.x.abs()).copysign(p.y))
}

/// Directions of a grid's texels, row by row, at `across` × `across` evenly spaced samples of each texel.
pub struct GridRows {
    grid: Grid,
    across: u32,
    /// Sine and cosine of each column's longitude, for each sample position across; only for equirectangular grids.
    longitudes: Vec<(f64, f64)>,
}

impl GridRows {
    /// Prepares the directions. If `across` is odd, one sample is the texel's centre.
    pub fn new(grid: Grid, across: u32) -> Result<Self> {
        let mut rows = Self { grid, across, longitudes: Vec::new() };
        if grid.layout == Layout::Equirectangular {
            let count = across as usize * grid.width as usize;
            room_for((count * size_of::<(f64, f64)>()) as u64)?;
            rows.longitudes.reserve_exact(count);
            for sample in 0..across {
                let within = rows.sample_offset(sample).x;
                let angle = |column: u32| ((f64::from(column) + within) / f64::from(grid.width) - 0.5) * 2.0 * PI;
                rows.longitudes.extend((0..grid.width).map(|column| angle(column).sin_cos()));
            }
        }
        Ok(rows)
    }

    /// Returns the number of samples of a texel.
    pub fn samples(&self) -> u32 {
        self.across * self.across
    }

    /// Returns the position of a sample within its texel, 0 to 1.
    fn sample_offset(&self, sample: u32) -> DVec2 {
        (DVec2::new(f64::from(sample % self.across), f64::from(sample / self.across)) + 0.5) / f64::from(self.across)
    }

    /// Writes the directions of one sample of a row's texels, from column `first` on.
    pub fn write(&self, sample: u32, row: u32, first: u32, out: &mut [[f64; 3]]) {
        let (height, width, within) =
            (f64::from(self.grid.height), f64::from(self.grid.width), self.sample_offset(sample));
        match self.grid.layout {
            Layout::Cube => {
                let (face, row) = ((row / self.grid.height) as u8, row % self.grid.height);
                let v = (f64::from(row) + within.y) * 2.0 / height - 1.0;
                for (column, d) in (first..).zip(out) {
                    let u = (f64::from(column) + within.x) * 2.0 / width - 1.0;
                    *d = direction_from_face(face, u, v).to_array();
                }
            }
            Layout::Equirectangular => {
                let (sine, cosine) = ((0.5 - (f64::from(row) + within.y) / height) * PI).sin_cos();
                let start = (sample % self.across * self.grid.width + first) as usize;
                for (longitude, d) in self.longitudes[start..].iter().zip(out) {
                    *d = direction_of_angles(sine, cosine, *longitude).to_array();
                }
            }
            Layout::Octahedral => {
                for (column, d) in (first..).zip(out) {
                    let p = DVec2::new(f64::from(column), f64::from(row)) + within;
                    *d = self.grid.direction(p).to_array();
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_have_their_positions_and_share_tables() {
        for (layout, height, width) in [(Layout::Equirectangular, 3, 8), (Layout::Octahedral, 5, 5)] {
            let grid = Grid::new(layout, height, width).unwrap();
            let rows = GridRows::new(grid, 4).unwrap();
            assert_eq!(rows.longitudes.len(), if layout == Layout::Octahedral { 0 } else { 4 * 8 });
            for (sample, row) in (0..rows.samples()).flat_map(|sample| (0..height).map(move |row| (sample, row))) {
                let mut directions = vec![[0.0; 3]; width as usize - 2];
                rows.write(sample, row, 2, &mut directions);
                for (column, d) in (2..).zip(directions) {
                    let place = |index: u32, within: u32| f64::from(index) + (f64::from(within) + 0.5) / 4.0;
                    let expected = grid.direction(DVec2::new(place(column, sample % 4), place(row, sample / 4)));
                    // Some roundings of coordinates of up to 8.
                    assert!((DVec3::from_array(d) - expected).length() < 1e-14);
                }
            }
        }
    }
}
