//! Spheres in an eye's view: visibility, solid angle, and angle from the axis.

use std::f64::consts::PI;

use bytemuck::Zeroable;
use glam::{DMat3, DVec3};

use super::objects::CHUNK;
use super::rules::Acuity;
use crate::base::Result;
use crate::base::simd::vectorized;
use crate::bounds::check_spheres;
use crate::camera::Fov;

/// Number of spheres that a kernel processes together.
const LANES: usize = 32;
type Centers = [[f64; 3]; LANES];
/// Range of squared distances that have full precision.
const PRECISE_SQUARES: std::ops::Range<f64> = 1e-280..1e280;
/// Relative rounding error of a sphere's distance from a side plane; as a margin it keeps visible spheres in view.
const SLACK: f64 = 1e-14;
/// σ of spheres outside the view.
pub(crate) const HIDDEN: f64 = -1.0;

/// An eye's pose and view.
#[derive(Clone, Copy, Debug)]
pub struct Frustum {
    pub(crate) position: DVec3,
    /// Unit directions in the world: right, up and ahead.
    axes: [[f64; 3]; 3],
    /// Outward normals of the view's four sides and its back, in the eye's axes.
    sides: [[f64; 3]; 5],
    /// Tangent of the angle between the axis and the view's farthest corner.
    pub(super) corner: f64,
}

impl Frustum {
    /// Creates a frustum from the eye's position, its axes in the world, and the tangents of its view.
    pub fn new(position: DVec3, axes: DMat3, fov: &Fov) -> Self {
        let unit = |x: f64, y: f64, ahead: f64| DVec3::new(x, y, ahead).normalize().to_array();
        let sides = [
            unit(1.0, 0.0, -fov.right),
            unit(-1.0, 0.0, fov.left),
            unit(0.0, 1.0, -fov.up),
            unit(0.0, -1.0, fov.down),
            unit(0.0, 0.0, -1.0),
        ];
        let axes = [axes.x_axis, axes.y_axis, -axes.z_axis].map(|axis| axis.to_array());
        let corner = fov.left.abs().max(fov.right.abs()).hypot(fov.down.abs().max(fov.up.abs()));
        Self { position, axes, sides, corner }
    }

    /// Returns the unit viewing direction.
    pub fn forward(&self) -> DVec3 {
        DVec3::from_array(self.axes[2])
    }

    /// Writes the visibility, size and angles of a chunk of spheres; `first` is the index of its first sphere. If
    /// `cull`, spheres outside the view get the size HIDDEN. Spheres around the eye get 4π.
    pub(crate) fn see(
        &self,
        centers: &[[f64; 3]],
        radii: &[f64],
        first: usize,
        cull: bool,
        to: &mut Sight,
    ) -> Result<()> {
        let hidden = if cull { HIDDEN } else { 0.0 };
        let (center_blocks, last_centers) = centers.as_chunks();
        let (radius_blocks, last_radii) = radii.as_chunks();
        see(self, hidden, center_blocks, radius_blocks, to, 0);
        if !last_centers.is_empty() {
            let (mut centers, mut radii) = ([[0.0; 3]; LANES], [0.0; LANES]);
            centers[..last_centers.len()].copy_from_slice(last_centers);
            radii[..last_radii.len()].copy_from_slice(last_radii);
            see(self, hidden, &[centers], &[radii], to, center_blocks.len());
        }
        for n in 0..centers.len() {
            if to.imprecise[n] > 0.0 {
                check_spheres(&centers[n..=n], &radii[n..=n], self.position, first + n)?;
                self.see_one(centers[n], radii[n], hidden, to, n);
            }
        }
        Ok(())
    }

    /// Processes one sphere whose squared lengths overflow or underflow.
    fn see_one(&self, center: [f64; 3], radius: f64, hidden: f64, to: &mut Sight, n: usize) {
        let offset = DVec3::from_array(center) - self.position;
        let scale = offset.abs().max_element().max(radius);
        let scale = if scale > 0.0 { scale } else { 1.0 };
        let place = self.axes.map(|axis| DVec3::from_array(axis).dot(offset / scale));
        (to.sigma[n], [to.sin_alpha[n], to.cos_alpha[n], to.sin_mu[n], to.cos_mu[n]], _) =
            see_sphere(self, hidden, place, radius / scale);
    }
}

/// An eye: a view and, optionally, its acuity.
#[derive(Clone, Copy, Debug)]
pub struct Eye {
    /// Pose and view.
    pub view: Frustum,
    /// Acuity as a function of eccentricity; `None` to ignore it.
    pub acuity: Option<Acuity>,
    /// Width of a pixel in the middle of the picture, as a tangent.
    pub pixel: f64,
}

/// Visibility, sizes and angles of a chunk of spheres.
#[derive(Debug, Zeroable)]
pub(crate) struct Sight {
    /// σ in steradians: HIDDEN outside the view, 4π around the eye.
    pub sigma: [f64; CHUNK],
    pub sin_alpha: [f64; CHUNK],
    pub cos_alpha: [f64; CHUNK],
    pub sin_mu: [f64; CHUNK],
    pub cos_mu: [f64; CHUNK],
    /// 1 if squares overflow or underflow, or the sphere is invalid; otherwise 0.
    imprecise: [f64; CHUNK],
}

vectorized! {
    fn see(view: &Frustum, hidden: f64, centers: &[Centers], radii: &[[f64; LANES]], to: &mut Sight, first: usize)
        = see_blocks;
}

/// Processes whole blocks, from block `first` on.
#[inline(always)]
fn see_blocks(view: &Frustum, hidden: f64, centers: &[Centers], radii: &[[f64; LANES]], to: &mut Sight, first: usize) {
    let eye = view.position.to_array();
    let [right, up, ahead] = view.axes;
    let angles = to.sin_alpha.as_chunks_mut().0.iter_mut().zip(to.cos_alpha.as_chunks_mut().0);
    let sizes = to.sin_mu.as_chunks_mut().0.iter_mut().zip(to.cos_mu.as_chunks_mut().0);
    let others = to.sigma.as_chunks_mut().0.iter_mut().zip(to.imprecise.as_chunks_mut().0);
    let results = angles.zip(sizes).zip(others).skip(first);
    for ((from, radius), (((sin_alpha, cos_alpha), (sin_mu, cos_mu)), (sigma, imprecise))) in
        centers.iter().zip(radii).zip(results)
    {
        let mut offset = [[0.0; LANES]; 3];
        for n in 0..LANES {
            offset[0][n] = from[n][0] - eye[0];
            offset[1][n] = from[n][1] - eye[1];
            offset[2][n] = from[n][2] - eye[2];
        }
        let (sin_alpha, cos_alpha): (&mut [f64; LANES], &mut [f64; LANES]) = (sin_alpha, cos_alpha);
        let (sin_mu, cos_mu): (&mut [f64; LANES], &mut [f64; LANES]) = (sin_mu, cos_mu);
        let (sigma, imprecise): (&mut [f64; LANES], &mut [f64; LANES]) = (sigma, imprecise);
        for n in 0..LANES {
            let (x, y, z) = (offset[0][n], offset[1][n], offset[2][n]);
            let place = [
                right[0] * x + right[1] * y + right[2] * z,
                up[0] * x + up[1] * y + up[2] * z,
                ahead[0] * x + ahead[1] * y + ahead[2] * z,
            ];
            let (size, angles, is_precise) = see_sphere(view, hidden, place, radius[n]);
            sigma[n] = size;
            [sin_alpha[n], cos_alpha[n], sin_mu[n], cos_mu[n]] = angles;
            imprecise[n] = if is_precise { 0.0 } else { 1.0 };
        }
    }
}

/// Returns σ, the sines and cosines of α and μ, and whether the squares have full precision, for a sphere at `place`:
/// (right, up, ahead) of the eye.
#[inline(always)]
#[expect(clippy::manual_range_contains, reason = "ranges have branches, which do not become vectors")]
fn see_sphere(view: &Frustum, hidden: f64, place: [f64; 3], radius: f64) -> (f64, [f64; 4], bool) {
    let [x, y, ahead] = place;
    let mut outside = f64::NEG_INFINITY;
    for side in &view.sides {
        let from_side = side[0] * x + side[1] * y + side[2] * ahead;
        outside = if from_side > outside { from_side } else { outside };
    }
    let from_axis = x * x + y * y;
    let square = from_axis + ahead * ahead;
    let distance = square.sqrt();
    let inverse = 1.0 / distance;
    let sin_mu = radius / distance;
    let cos_mu = ((1.0 - sin_mu) * (1.0 + sin_mu)).sqrt();
    let sigma = 2.0 * PI * (sin_mu * sin_mu / (1.0 + cos_mu));
    let sigma = if distance > radius { sigma } else { 4.0 * PI };
    let is_outside = (outside - radius > SLACK * distance) & (hidden < 0.0);
    let has_precision = (square >= PRECISE_SQUARES.start) & (square <= PRECISE_SQUARES.end);
    let is_precise = has_precision & (radius >= 0.0) & (radius < f64::INFINITY);
    let angles = [from_axis.sqrt() * inverse, ahead * inverse, sin_mu, cos_mu];
    (if is_outside { hidden } else { sigma }, angles, is_precise)
}
