//! Projections of directions to layouts without faces.

use super::angles::angle_of;

/// Returns the position of a direction in an equirectangular picture, 0 to 1 across and down.
#[inline(always)]
pub(super) fn equirectangular(x: f64, y: f64, z: f64) -> (f64, f64) {
    let (longitude, latitude) = (angle_of(x, -z), angle_of(y, (x * x + z * z).sqrt()));
    (longitude * (0.5 / std::f64::consts::PI) + 0.5, 0.5 - latitude * (1.0 / std::f64::consts::PI))
}

/// Returns the position of a direction in an octahedral picture, 0 to 1 across and down.
#[inline(always)]
pub(super) fn octahedral(x: f64, y: f64, z: f64) -> (f64, f64) {
    let sum = x.abs() + y.abs() + z.abs();
    let (px, pz) = (x / sum, z / sum);
    let (fx, fz) = ((1.0 - pz.abs()).copysign(px), (1.0 - px.abs()).copysign(pz));
    let (px, pz) = if y < 0.0 { (fx, fz) } else { (px, pz) };
    ((px + 1.0) * 0.5, (pz + 1.0) * 0.5)
}
