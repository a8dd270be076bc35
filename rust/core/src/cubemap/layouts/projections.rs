//! Projections of directions to flat layouts. They have no branches, so that the compiler vectorises them. Vector and
//! scalar code return the same bits.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// tan(π/8). For larger t, `angle_of` uses atan t = π/4 + atan((t − 1)/(t + 1)).
const LIMIT: f64 = 0.414_213_562_373_095;

/// atan(t)/t as a polynomial of t² for t ≤ tan(π/8), from twelve Chebyshev points; the error is at most 1.3e-18.
const SERIES: [f64; 12] = [
    1.0,
    -0.333_333_333_333_331_2,
    0.199_999_999_999_408_9,
    -0.142_857_142_792_502_4,
    0.111_111_107_449_193_96,
    -0.090_908_968_090_564_38,
    0.076_920_453_307_659_12,
    -0.066_629_518_120_618_38,
    0.058_468_782_857_870_01,
    -0.050_351_024_039_430_294,
    0.037_965_256_099_576_565,
    -0.017_805_395_704_537_506,
];

/// Returns the angle of (x, y) from the first axis, −π to π: `y.atan2(x)` for finite numbers, except that x = −0
/// counts as +0. The error is at most 2 ulp of π: seven roundings of numbers up to π.
#[inline(always)]
fn angle_of(y: f64, x: f64) -> f64 {
    let (ax, ay) = (x.abs(), y.abs());
    let is_steep = ay > ax;
    let (less, more) = if is_steep { (ax, ay) } else { (ay, ax) };
    let is_large = less > LIMIT * more;
    let above = if is_large { less - more } else { less };
    let below = if is_large { less + more } else { more };
    // The zero vector has t = 0.
    let t = if below > 0.0 { above / below } else { 0.0 };
    let square = t * t;
    let mut sum = SERIES[11];
    for k in 1..12 {
        sum = sum * square + SERIES[11 - k];
    }
    let angle = sum * t + if is_large { FRAC_PI_4 } else { 0.0 };
    let angle = if is_steep { FRAC_PI_2 - angle } else { angle };
    let angle = if x < 0.0 { PI - angle } else { angle };
    angle.copysign(y)
}

/// Returns the position of a direction in an equirectangular picture, 0 to 1 across and down.
#[inline(always)]
pub(super) fn equirectangular(x: f64, y: f64, z: f64) -> (f64, f64) {
    let (longitude, latitude) = (angle_of(x, -z), angle_of(y, (x * x + z * z).sqrt()));
    (longitude * (0.5 / PI) + 0.5, 0.5 - latitude * (1.0 / PI))
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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn angles_equal_the_library(x in -1.0..1.0f64, y in -1.0..1.0f64, scale in -12..12i32) {
            let y = y * 10f64.powi(scale);
            prop_assert!((angle_of(y, x) - y.atan2(x)).abs() <= 2.0 * f64::EPSILON * 2.0);
            // Small angles keep their relative precision.
            let (t, small) = (angle_of(y * 1e-9, x.abs() + 0.1), (y * 1e-9).atan2(x.abs() + 0.1));
            prop_assert!((t - small).abs() <= 4.0 * f64::EPSILON * small.abs());
        }
    }

    #[test]
    fn axes_are_exact() {
        for (x, y) in [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (1.0, 1.0), (-2.0, 2.0), (0.0, 0.0)] {
            assert_eq!(angle_of(y, x), f64::atan2(y, x), "{x} {y}");
        }
    }
}
