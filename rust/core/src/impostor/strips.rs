//! Division of slanted quads, so that affine texture coordinates stay within half a texel of perspective ones.

use super::plane::Plane;
use super::tile::Tile;

/// Greatest error of a texture coordinate, texels.
const MAX_ERROR: f64 = 0.5;
/// Greatest number of columns or rows of a quad.
const MAX_CELLS: usize = 64;

/// Returns the longest of the parts of an edge, as a share of it, over which inverse depth grows by equal ratios; `log` is
/// the logarithm of the ratio at the ends.
fn longest_part(log: f64, parts: usize) -> f64 {
    let n = parts as f64;
    if log < 1e-6 { 1.0 / n } else { (log.exp() - (log * (n - 1.0) / n).exp()) / (log.exp() - 1.0) }
}

/// Returns the number of columns and rows into which a rectangle of a plane is divided; their product is least.
///
/// Along an edge of L texels whose ends have inverse depths in the ratio κ, the affine coordinate is off by at most
/// L (√κ − 1)/(√κ + 1). Both directions add up on a cell's diagonal.
pub fn cells(plane: &Plane, tile: &Tile, [left, top, right, bottom]: [isize; 4]) -> [usize; 2] {
    let w = |x: isize, y: isize| plane.w(tile.edge_u(x as f64), tile.edge_v(y as f64));
    let corners = [w(left, top), w(right, top), w(left, bottom), w(right, bottom)];
    let log = |a: f64, b: f64| (a / b).ln().abs();
    let across = log(corners[0], corners[1]).max(log(corners[2], corners[3]));
    let down = log(corners[0], corners[2]).max(log(corners[1], corners[3]));
    let (width, height) = ((right - left) as f64, (bottom - top) as f64);
    let error = |columns: usize, rows: usize| {
        let ratio = (0.5 * (across / columns as f64 + down / rows as f64)).exp();
        let longest = (width * longest_part(across, columns)).max(height * longest_part(down, rows));
        longest * (ratio - 1.0) / (ratio + 1.0)
    };
    let mut best = [MAX_CELLS; 2];
    for columns in 1..=MAX_CELLS {
        let Some(rows) = (1..=MAX_CELLS).find(|&rows| error(columns, rows) <= MAX_ERROR) else { continue };
        if columns * rows < best[0] * best[1] {
            best = [columns, rows];
        }
        if columns >= best[0] * best[1] {
            break;
        }
    }
    best
}
