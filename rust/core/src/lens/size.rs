//! Solid angles of spheres seen through a lens (Liebisch 2021, Eq. 4.10–4.12). Angles from the axis are α without the
//! lens and α′ with it; μ is half the angle that a sphere subtends.

use std::f64::consts::PI;

use glam::DVec3;

use super::inverse::LANES;
use super::radial::RadialLens;
use crate::base::{Progress, Result, ensure};
use crate::bounds::{SphereView, each_chunk};

/// The exact area of a sphere whose half angle is below this fraction of its distance to 90° and to the fold is
/// computed from the mean magnification at seven points, with a relative error of 10⁻¹⁴. The sum around its edge would
/// lose more digits by cancellation.
const SMALL_ANGLE: f64 = 2e-3;
/// The sum around the edge is refined until it changes by at most this fraction, or has `MAX_PARTS` parts.
const AREA_TOLERANCE: f64 = 1e-13;
const MAX_PARTS: usize = 1 << 12;
/// Spheres between two checks for cancellation.
const SPHERES_PER_CHECK: usize = 1 << 6;

/// A view through a lens.
#[derive(Clone, Copy, Debug)]
pub struct Sizes<'a> {
    /// The lens.
    pub lens: &'a RadialLens,
    /// Position of the eye, metres.
    pub eye: DVec3,
    /// Unit viewing direction: the lens's axis.
    pub forward: DVec3,
    /// Tangent of half the horizontal field of view; the larger of its two sides.
    pub tan_omega: f64,
    /// Whether to compute the exact area instead of the published product.
    pub exact: bool,
}

/// Writes the solid angles of the images of spheres, steradians. Spheres that extend to 90° from the axis or to the
/// lens's fold keep their undistorted solid angle.
pub fn corrected_solid_angles(
    sizes: &Sizes<'_>,
    centers: &[[f64; 3]],
    radii: &[f64],
    to: &mut [f64],
    progress: &Progress,
) -> Result<()> {
    let is_valid = sizes.tan_omega > 0.0 && sizes.tan_omega.is_finite();
    ensure!(is_valid, "lens_radius", "a tangent above 0", sizes.tan_omega);
    each_chunk(centers, radii, sizes.eye, to, |centers, radii, to| {
        // An exact area takes up to a millisecond.
        let spheres = centers.chunks(SPHERES_PER_CHECK).zip(radii.chunks(SPHERES_PER_CHECK));
        spheres.zip(to.chunks_mut(SPHERES_PER_CHECK)).try_for_each(|((centers, radii), to)| {
            sizes.solid_angles(centers, radii, to);
            progress.check()
        })
    })
}

impl Sizes<'_> {
    /// Same as `corrected_solid_angles`, for a few spheres that have been checked.
    pub fn solid_angles(&self, centers: &[[f64; 3]], radii: &[f64], to: &mut [f64]) {
        let spheres = centers.chunks(LANES / 2).zip(radii.chunks(LANES / 2));
        for ((centers, radii), to) in spheres.zip(to.chunks_mut(LANES / 2)) {
            self.process_block(centers, radii, to);
        }
    }

    /// Processes half a block of spheres, because the two edges of each sphere fill a block.
    fn process_block(&self, centers: &[[f64; 3]], radii: &[f64], to: &mut [f64]) {
        let mut caps = [const { None }; LANES / 2];
        let mut roots = [0.0; LANES];
        for (n, (center, &radius)) in centers.iter().zip(radii).enumerate() {
            let Some(sphere) = SphereView::new(DVec3::from_array(*center) - self.eye, radius) else {
                to[n] = 4.0 * PI;
                continue;
            };
            to[n] = sphere.solid_angle();
            let cap = Cap {
                lens: self.lens,
                scale: self.tan_omega,
                sin_alpha: sphere.direction.cross(self.forward).length(),
                cos_alpha: sphere.direction.dot(self.forward),
                sin_mu: sphere.sine,
                cos_mu: sphere.cosine,
            };
            if cap.cos_far() > 0.0 && to[n] > 0.0 {
                [roots[2 * n], roots[2 * n + 1]] = cap.edges();
                caps[n] = Some(cap);
            }
        }
        self.lens.undistort_blocks(&mut roots, true, 0.0);
        for (n, cap) in caps.iter().enumerate() {
            let (far, near) = (roots[2 * n], roots[2 * n + 1]);
            // Beyond the fold the root is NaN.
            if let Some(cap) = cap.as_ref().filter(|_| far.is_finite()) {
                to[n] = match self.exact {
                    false => to[n] * cap.stretch(far, near),
                    true if cap.is_small() => to[n] * cap.mean_magnification(),
                    true => cap.area(),
                }
            }
        }
    }
}

/// The spherical cap that a sphere covers: directions within μ of its centre, which is α from the axis.
pub(super) struct Cap<'a> {
    pub lens: &'a RadialLens,
    /// tan ω
    pub scale: f64,
    pub sin_alpha: f64,
    pub cos_alpha: f64,
    pub sin_mu: f64,
    pub cos_mu: f64,
}

impl Cap<'_> {
    fn cos_far(&self) -> f64 {
        self.cos_alpha * self.cos_mu - self.sin_alpha * self.sin_mu
    }

    fn cos_near(&self) -> f64 {
        self.cos_alpha * self.cos_mu + self.sin_alpha * self.sin_mu
    }

    /// Returns tan(α + μ) / tan ω and tan(α − μ) / tan ω.
    pub fn edges(&self) -> [f64; 2] {
        let (sin_cos, cos_sin) = (self.sin_alpha * self.cos_mu, self.cos_alpha * self.sin_mu);
        [(sin_cos + cos_sin) / self.cos_far() / self.scale, (sin_cos - cos_sin) / self.cos_near() / self.scale]
    }

    /// Returns whether the lens's magnification is nearly constant over the sphere.
    fn is_small(&self) -> bool {
        let [far, near] = self.edges();
        let to_fold = self.lens.x_max() - far;
        self.sin_mu < SMALL_ANGLE * self.cos_far() && far - near < SMALL_ANGLE * to_fold
    }

    /// Returns (α⁺ − α⁻) / 2μ with α± = atan(tan ω · f⁻¹(tan(α ± μ) / tan ω)). a and b are the two values of f⁻¹.
    pub fn stretch(&self, a: f64, b: f64) -> f64 {
        // a − b = (tan(α+μ) − tan(α−μ)) / tan ω / (divided difference of f), and tan(α+μ) − tan(α−μ) =
        // sin 2μ / (cos(α+μ) cos(α−μ)). In this form nothing cancels, however small the sphere is.
        let distorted = 2.0 * self.sin_mu * self.cos_mu / (self.cos_far() * self.cos_near() * self.scale);
        let difference = distorted / divided_difference(&self.lens.radial.k, a, b);
        let angle = (self.scale * difference).atan2(1.0 + self.scale * self.scale * a * b);
        angle / (2.0 * self.sin_mu.atan2(self.cos_mu))
    }

    /// Returns the area of the image: ∮ (1 − cos α′) dφ around its edge, with φ the azimuth about the axis. The
    /// trapezoidal rule has 2ⁿ equal steps of ψ, the azimuth about the cap's centre, over half the circle.
    fn area(&self) -> f64 {
        let mut parts = 8;
        let mut sum = self.edge_sum(0.0, PI / parts as f64, parts)
            + 0.5 * (self.edge_sum(PI, 0.0, 1) - self.edge_sum(0.0, 0.0, 1));
        let mut area = 2.0 * PI * sum / parts as f64;
        loop {
            let step = PI / parts as f64;
            sum += self.edge_sum(0.5 * step, step, parts);
            parts *= 2;
            let finer = 2.0 * PI * sum / parts as f64;
            if (finer - area).abs() <= AREA_TOLERANCE * finer || parts >= MAX_PARTS {
                return finer;
            }
            area = finer;
        }
    }

    /// Returns the sum of (1 − cos α′) dφ/dψ over `count` values of ψ. It is Q (x dy/dψ − y dx/dψ) with
    /// Q = (1 − cos α′) / sin² α, which is smooth on the axis.
    fn edge_sum(&self, from: f64, step: f64, count: usize) -> f64 {
        let mut sum = 0.0;
        for first in (0..count).step_by(LANES) {
            let length = LANES.min(count - first);
            let (mut roots, mut squares, mut turns) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
            for n in 0..length {
                let (sine, cosine) = (from + step * (first + n) as f64).sin_cos();
                squares[n] = self.tan_square(self.sin_mu * cosine, self.sin_mu * sine, self.cos_mu);
                turns[n] = self.sin_mu * (self.cos_mu * self.sin_alpha * cosine + self.sin_mu * self.cos_alpha);
                roots[n] = squares[n].sqrt() / self.scale;
            }
            let distorted = roots;
            self.lens.undistort_blocks(&mut roots, true, 0.0);
            for n in 0..length {
                let ratio = if distorted[n] == 0.0 { 1.0 } else { roots[n] / distorted[n] };
                let (square, image) = (squares[n], squares[n] * ratio * ratio);
                sum += ratio * ratio * (1.0 + square) / (1.0 + image + (1.0 + image).sqrt()) * turns[n];
            }
        }
        sum
    }

    /// Returns tan² of the angle from the axis of a direction (away from the axis, around it, to the cap's centre).
    fn tan_square(&self, radial: f64, tangential: f64, central: f64) -> f64 {
        let from_axis = central * self.sin_alpha + radial * self.cos_alpha;
        let ahead = central * self.cos_alpha - radial * self.sin_alpha;
        (from_axis * from_axis + tangential * tangential) / (ahead * ahead)
    }

    /// Returns the mean of sin α′ dα′ / (sin α dα) over the cap, by Radon's rule for discs, exact up to degree 5.
    fn mean_magnification(&self) -> f64 {
        // Radius ϱ of the unit disc maps to angle θ from the cap's centre; sin(θ/2) = ϱ sin(μ/2) preserves areas.
        let half = self.sin_mu / (2.0 * (1.0 + self.cos_mu)).sqrt() * (2.0f64 / 3.0).sqrt();
        let (sine, cosine) = (2.0 * half * (1.0 - half * half).sqrt(), 1.0 - 2.0 * half * half);
        let mut squares = [self.tan_square(0.0, 0.0, 1.0); 7];
        for (n, square) in squares[1..].iter_mut().enumerate() {
            let (tangential, radial) = (PI / 3.0 * n as f64).sin_cos();
            *square = self.tan_square(sine * radial, sine * tangential, cosine);
        }
        let mut roots = [0.0; LANES];
        for (root, square) in roots.iter_mut().zip(squares) {
            *root = square.sqrt() / self.scale;
        }
        let distorted = roots;
        self.lens.undistort_blocks(&mut roots, true, 0.0);
        let magnification = |n: usize| {
            let ratio = if distorted[n] == 0.0 { 1.0 } else { roots[n] / distorted[n] };
            let slope = (1.0 + squares[n]) / (1.0 + squares[n] * ratio * ratio);
            ratio / self.lens.radial.derivative(roots[n]) * slope * slope.sqrt()
        };
        magnification(0) / 4.0 + (1..7).map(magnification).sum::<f64>() / 8.0
    }
}

/// Returns (f(a) − f(b)) / (a − b), computed from sums of aⁱbʲ.
fn divided_difference(k: &[f64], a: f64, b: f64) -> f64 {
    let (mut sum, mut power, mut total) = (1.0, 1.0, 1.0);
    for c in k {
        for _ in 0..2 {
            power *= b;
            sum = sum * a + power;
        }
        total += c * sum;
    }
    total
}
