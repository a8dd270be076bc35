//! Fold margin: how far the user may move before two neighbouring surface points change sides in the picture.

use glam::{DMat3, DVec3};

use super::curve::on_ground;
use crate::base::{Result, ensure};
use crate::morph::{Kind, Morph};

/// Number of samples in distance, azimuth and elevation. The worst of them are refined.
const GRID: [usize; 3] = [13, 25, 31];
/// Number of the worst samples that are refined.
const REFINED_SAMPLES: usize = 6;
/// Tolerance of the margin, relative to r₂ − r₁.
const MARGIN_PRECISION: f64 = 1e-4;

/// Maximum distance of the user from the centre, metres; products of longer lengths overflow.
const FARTHEST: f64 = 1e30;

/// Returns how far the user may move horizontally away from the axis, in metres, before the picture folds: before the
/// determinant of the morph's Jacobian changes its sign somewhere between the radii. Negative if it folds already, −∞
/// if it folds even for a user on the axis. The user's height stays the same.
///
/// For `Kind::Cylinder` at full strength the margin is r₁ − |(U−O)_h|: the morph keeps each point on its cylinder about
/// the axis, and a user beyond r₁ stands outside some of these cylinders.
///
/// Nothing folds at strength 0, nor where w is constant, as within r₁. With A = |P−U| and B = |P−O|, the matrix M =
/// w (1 − d_U d_Uᵀ)/A + (1−w) (1 − d_O d_Oᵀ)/B has no negative eigenvalue, and m = w d_U + (1−w) d_O is the gradient of
/// the displayed distance. A step v that the Jacobian maps to 0 has M v ∥ m and m·v = 0, hence v·M v = 0. So v is
/// parallel to d_U and to d_O, and therefore 0.
///
/// For `Kind::Cylinder` at lower strengths, w is constant on each cylinder, and if U stands inside a cylinder, about at
/// O's height, its points are shown in different directions. So the picture of a user within r₁ never folds. Points
/// nearer to the axis than U are shown at the blend's distance, and fold as with `Kind::Blend`.
pub fn margin(morph: &Morph) -> Result<f64> {
    if morph.strength == 0.0 {
        return Ok(f64::INFINITY);
    }
    let expected = "a radius above 0, because without near geometry nothing folds";
    ensure!(morph.r2 != 0.0, "r2", expected, morph.r2);
    let offset = morph.user - morph.center;
    let user_rho = on_ground(offset).length();
    let is_near = offset.length() <= FARTHEST;
    ensure!(is_near, "user", format!("a place within {FARTHEST:e} m of the centre"), morph.user);
    if morph.kind == Kind::Cylinder && morph.strength == 1.0 {
        return Ok(morph.r1 - user_rho);
    }
    // The margin scales with all lengths. They are divided by a power of two near r₂, so that no product overflows or
    // underflows: twice by its root, because the inverse of the smallest r₂ is infinite.
    let root = (0.5 * morph.r2.log2()).floor().exp2();
    let [r1, r2, height] = [morph.r1, morph.r2, offset.y].map(|length| length / root / root);
    let height = height.clamp(-FARTHEST, FARTHEST);
    let width = r2 - r1;
    let folds = |distance: f64| -> Result<bool> {
        let user = DVec3::new(distance, height, 0.0);
        let scaled = Morph::new(user, DVec3::ZERO, r1, r2, morph.kind)?.with_strength(morph.strength)?;
        Ok(changes_sides(&scaled))
    };
    // For a user at (r₂ − r₁)/s from the axis, with s the strength, the picture always folds: on the line through U and
    // O, behind O, the displayed distance falls as ρ grows.
    let (mut sound, mut folded) = (0.0, width / morph.strength);
    match morph.kind {
        Kind::Blend if folds(0.0)? => return Ok(f64::NEG_INFINITY),
        Kind::Blend => {}
        Kind::Cylinder => (sound, folded) = (r1, folded.max(r1)),
    }
    while folded - sound > MARGIN_PRECISION * width {
        let middle = 0.5 * (sound + folded);
        if folds(middle)? { folded = middle } else { sound = middle }
    }
    Ok(0.5 * (sound + folded) * root * root - user_rho)
}

/// Whether `determinant` is 0 or negative between the radii, at a point that is shown at the blend's distance.
fn changes_sides(morph: &Morph) -> bool {
    let offset = morph.user - morph.center;
    let user_rho = on_ground(offset).length();
    let Morph { r1, r2, strength, .. } = *morph;
    if strength > 0.5 && user_rho > r1 && 3.0 * user_rho >= r1 + r2 - (r2 - r1) * (1.0 / strength - 1.0) {
        // U and O see a point between them in opposite directions, and the displayed distance has the derivative
        // 2w − 1 + s (|U−O| − 2ρ)/(r₂−r₁). Next to the user it vanishes at 3 |U−O| = 2 r₂ − (r₂−r₁)/s.
        return true;
    }
    let fraction = |i: usize, axis: usize| i as f64 / (GRID[axis] - 1) as f64;
    let indices = |n: usize| [n / (GRID[1] * GRID[2]), n / GRID[2] % GRID[1], n % GRID[2]];
    let position = |n: usize| {
        let [i, j, k] = indices(n);
        [fraction(i, 0), fraction(j, 1), 2.0 * fraction(k, 2) - 1.0]
    };
    let outward: Vec<DVec3> = (0..GRID[1]).map(|j| outward(fraction(j, 1))).collect();
    let slopes: Vec<f64> = (0..GRID[2]).map(|k| slope(2.0 * fraction(k, 2) - 1.0)).collect();
    let mut samples = Vec::with_capacity(GRID.iter().product());
    for n in 0..GRID.iter().product() {
        let [i, j, k] = indices(n);
        let value = determinant(morph, fraction(i, 0), outward[j], slopes[k]);
        if value <= 0.0 {
            return true;
        }
        samples.push((value, n));
    }
    // Equal samples, as those above and below the user, are taken in their order.
    let (worst, last, _) =
        samples.select_nth_unstable_by(REFINED_SAMPLES - 1, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    worst.iter().chain([&*last]).any(|&(value, n)| minimize(morph, value, position(n)) <= 0.0)
}

/// Minimises the determinant axis by axis, until the step is below 10⁻⁴ of the range. The position is `depth`, `turn`
/// and `lift` of `determinant`, `outward` and `slope`.
fn minimize(morph: &Morph, mut value: f64, mut position: [f64; 3]) -> f64 {
    let mut step = 1.0 / GRID[0] as f64;
    while step > 1e-4 {
        let mut is_better = false;
        for axis in 0..3 {
            for offset in [-step, step] {
                let mut next = position;
                next[axis] = (next[axis] + offset).clamp(if axis == 2 { -1.0 } else { 0.0 }, 1.0);
                let [depth, turn, lift] = next;
                let next_value = determinant(morph, depth, outward(turn), slope(lift));
                if next_value < value {
                    (value, position, is_better) = (next_value, next, true);
                }
            }
        }
        if !is_better {
            step *= 0.5;
        }
    }
    value
}

/// Returns the horizontal direction from the axis with an azimuth from the user's side, a fraction of 180°.
fn outward(turn: f64) -> DVec3 {
    let (sin, cos) = (turn * std::f64::consts::PI).sin_cos();
    DVec3::new(cos, 0.0, sin)
}

/// Returns the tangent of an elevation seen from the centre, which is a fraction of 86° (1.5 rad), −1 to 1.
fn slope(lift: f64) -> f64 {
    (1.5 * lift).tan()
}

/// Returns the determinant of the Jacobian at a position, scaled so that it does not depend on the distance. `depth` is
/// the fraction of the way from r₁ to r₂.
fn determinant(morph: &Morph, depth: f64, outward: DVec3, slope: f64) -> f64 {
    let farthest = match morph.kind {
        Kind::Blend => morph.r2,
        Kind::Cylinder => morph.r2.min(on_ground(morph.user - morph.center).length()),
    };
    let rho = morph.r1 + (farthest - morph.r1) * depth;
    let from_center = outward * rho + DVec3::Y * slope * rho.max(1e-3 * morph.r2);
    let from_user = from_center - (morph.user - morph.center);
    let (a, b) = (from_user.length(), from_center.length());
    if a == 0.0 || b == 0.0 {
        return f64::INFINITY;
    }
    let (by_user, by_center) = (from_user / a, from_center / b);
    let w = morph.weight(rho);
    let gradient = -outward * morph.strength / (morph.r2 - morph.r1);
    let blend = w * by_user + (1.0 - w) * by_center;
    let direction = blend.normalize_or(by_user);
    let outer = |p: DVec3, q: DVec3| DMat3::from_cols(p * q.x, p * q.y, p * q.z);
    let derivative = |unit: DVec3, length: f64| (DMat3::IDENTITY - outer(unit, unit)) * (1.0 / length);
    let blend_derivative =
        derivative(by_user, a) * w + derivative(by_center, b) * (1.0 - w) + outer(by_user - by_center, gradient);
    let angular = (DMat3::IDENTITY - outer(direction, direction)) * blend_derivative;
    let radial = w * by_user + (1.0 - w) * by_center + (a - b) * gradient;
    // Displacements along the direction are metres; those across it are angles times √(a b).
    (angular * (a * b).sqrt() + outer(direction, radial)).determinant()
}
