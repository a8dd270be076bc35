//! Block kernel for `Kind::Cylinder`, for strengths below 1, and for blends outside the limits of the kernel `blend`.
//! It is the scalar form in float64, without branches. Points with nearly opposed directions are in doubt.

use super::lanes::{BLOCK, BlockCoordinates, gather, scatter};
use super::point::{Kind, Morph};
use crate::base::Real;

/// Minimum length of a blend of unit vectors; shorter blends are in doubt.
const MIN_BLEND_LENGTH: f64 = 1e-6;

/// Morphs a block. Returns one bit for each point in doubt.
#[inline(always)]
pub(super) fn block<T: Real>(morph: &Morph, points: &[[T; 3]; BLOCK], morphed: &mut [[T; 3]; BLOCK]) -> u64 {
    let coordinates = gather(points);
    let (center, offset) = (morph.center.to_array(), morph.offset.to_array());
    let offset_rho = (offset[0] * offset[0] + offset[2] * offset[2]).sqrt();
    let keeps_rho = morph.kind == Kind::Cylinder;
    let mut results: BlockCoordinates<T> = [[T::zero(); BLOCK]; 3];
    let mut doubtful = [false; BLOCK];
    for i in 0..BLOCK {
        let [px, py, pz] = [coordinates[0][i].wide(), coordinates[1][i].wide(), coordinates[2][i].wide()];
        let [x, y, z] = [px - center[0], py - center[1], pz - center[2]];
        let [ax, ay, az] = [x - offset[0], y - offset[1], z - offset[2]];
        let rho = (x * x + z * z).sqrt();
        let linear = if morph.r2 == 0.0 { 0.0 } else { (morph.r2 - rho) / (morph.r2 - morph.r1) };
        let low = if linear > 0.0 { linear } else { 0.0 };
        let w = morph.strength * if low < 1.0 { low } else { 1.0 };
        let from_user = (ax * ax + ay * ay + az * az).sqrt();
        let from_center = (x * x + y * y + z * z).sqrt();
        let (by_user, by_center) = (w / from_user, (1.0 - w) / from_center);
        let [mx, my, mz] = [ax * by_user + x * by_center, ay * by_user + y * by_center, az * by_user + z * by_center];
        let length = (mx * mx + my * my + mz * mz).sqrt();
        let [dx, dy, dz] = [mx / length, my / length, mz / length];
        let blended = w * from_user + (1.0 - w) * from_center;
        // The exit from the cylinder of radius ρ, as in `leave_cylinder`.
        let a = dx * dx + dz * dz;
        let b = dx * offset[0] + dz * offset[2];
        let c = (offset_rho - rho) * (offset_rho + rho);
        let q = (b * b - a * c).sqrt();
        let exit = if b > 0.0 { -c / (b + q) } else { (q - b) / a };
        let leaves = keeps_rho & (rho > offset_rho) & (a > 0.0);
        let t = if leaves { exit } else { blended };
        let shifts = !keeps_rho & (w == 0.0);
        let [sx, sy, sz] = [px + offset[0], py + offset[1], pz + offset[2]];
        let [qx, qy, qz] =
            [center[0] + (offset[0] + t * dx), center[1] + (offset[1] + t * dy), center[2] + (offset[2] + t * dz)];
        results[0][i] = T::narrow(if shifts { sx } else { qx });
        results[1][i] = T::narrow(if shifts { sy } else { qy });
        results[2][i] = T::narrow(if shifts { sz } else { qz });
        // If a length is 0, the blend is NaN and fails the comparison, which marks the point as doubtful.
        doubtful[i] = !((w == 1.0) | shifts | (length > MIN_BLEND_LENGTH));
        let stays = w == 1.0;
        results[0][i] = if stays { coordinates[0][i] } else { results[0][i] };
        results[1][i] = if stays { coordinates[1][i] } else { results[1][i] };
        results[2][i] = if stays { coordinates[2][i] } else { results[2][i] };
    }
    scatter(&results, morphed);
    doubtful.iter().enumerate().fold(0, |doubts, (i, &doubtful)| doubts | u64::from(doubtful) << i)
}
