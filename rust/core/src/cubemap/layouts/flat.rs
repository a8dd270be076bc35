//! Block look-ups in flat layouts, those without faces: equirectangular and octahedral.

use super::super::lookup::{BLOCK, BlockValues, Positions, clamped_floor, index};
use super::layout::{Grid, Layout};
use super::projections::{equirectangular, octahedral};
use crate::base::simd::vectorized;

/// Returns the positions of a block's directions, 0 to 1 across and down. Directions are finite, not zero, and neither
/// so long nor so short that their squares overflow or underflow.
#[inline(always)]
fn positions<const OCTAHEDRAL: bool>(d: &[[f64; 3]; BLOCK]) -> [BlockValues<f64>; 2] {
    let mut p = [BlockValues([0.0f64; BLOCK]); 3];
    for (i, direction) in d.iter().enumerate() {
        p[0].0[i] = direction[0];
        p[1].0[i] = direction[1];
        p[2].0[i] = direction[2];
    }
    let mut found = [BlockValues([0.0; BLOCK]); 2];
    for i in 0..BLOCK {
        let (x, y, z) = (p[0].0[i], p[1].0[i], p[2].0[i]);
        let (across, down) = if OCTAHEDRAL { octahedral(x, y, z) } else { equirectangular(x, y, z) };
        found[0].0[i] = across;
        found[1].0[i] = down;
    }
    found
}

/// Finds each direction's position between texels. A direction is at a seam if its filter crosses an edge of the
/// picture. `filter_extent` is `TexelFilter::extent`.
#[inline(always)]
fn locate_kernel<const OCTAHEDRAL: bool>(
    d: &[[f64; 3]; BLOCK],
    grid: Grid,
    filter_extent: [u32; 2],
    out: &mut Positions,
) {
    let [across, down] = positions::<OCTAHEDRAL>(d);
    let (width, height) = (f64::from(grid.width), f64::from(grid.height));
    let low = f64::from(filter_extent[0]);
    let (right, bottom) = (width - 1.0 - f64::from(filter_extent[1]), height - 1.0 - f64::from(filter_extent[1]));
    for i in 0..BLOCK {
        let (x, y) = (across.0[i] * width - 0.5, down.0[i] * height - 0.5);
        let inside = (x >= low) & (x <= right) & (y >= low) & (y <= bottom);
        out.seam.0[i] = u8::from(!inside);
        let (column, row) = (clamped_floor(x, low, right), clamped_floor(y, low, bottom));
        out.first.0[i] = index(row * width + column);
        out.s.0[i] = x - column;
        out.t.0[i] = y - row;
    }
}

/// Finds the texels that directions hit.
#[inline(always)]
fn find_texels_kernel<const OCTAHEDRAL: bool>(d: &[[f64; 3]; BLOCK], grid: Grid, texel: &mut BlockValues<u32>) {
    let [across, down] = positions::<OCTAHEDRAL>(d);
    let (width, height) = (f64::from(grid.width), f64::from(grid.height));
    for i in 0..BLOCK {
        let column = clamped_floor(across.0[i] * width, 0.0, width - 1.0);
        let row = clamped_floor(down.0[i] * height, 0.0, height - 1.0);
        texel.0[i] = index(row * width + column);
    }
}

vectorized! {
    fn locate_octahedral(d: &[[f64; 3]; BLOCK], grid: Grid, filter_extent: [u32; 2], out: &mut Positions) = locate_kernel::<true>;
    fn locate_equirectangular(d: &[[f64; 3]; BLOCK], grid: Grid, filter_extent: [u32; 2], out: &mut Positions) = locate_kernel::<false>;
    fn find_octahedral_texels(d: &[[f64; 3]; BLOCK], grid: Grid, texel: &mut BlockValues<u32>) = find_texels_kernel::<true>;
    fn find_equirectangular_texels(d: &[[f64; 3]; BLOCK], grid: Grid, texel: &mut BlockValues<u32>) = find_texels_kernel::<false>;
}

/// Calls `locate_kernel` for the grid's layout.
pub(super) fn locate(d: &[[f64; 3]; BLOCK], grid: Grid, filter_extent: [u32; 2], out: &mut Positions) {
    match grid.layout {
        Layout::Octahedral => locate_octahedral(d, grid, filter_extent, out),
        _ => locate_equirectangular(d, grid, filter_extent, out),
    }
}

/// Calls `find_texels_kernel` for the grid's layout.
pub(super) fn find_texels(d: &[[f64; 3]; BLOCK], grid: Grid, texel: &mut BlockValues<u32>) {
    match grid.layout {
        Layout::Octahedral => find_octahedral_texels(d, grid, texel),
        _ => find_equirectangular_texels(d, grid, texel),
    }
}
