//! How much of the sight spheres take through a lens (Liebisch 2021, Eq. 4.10–4.12).

use std::f64::consts::PI;

use glam::DVec3;

use super::RadialLens;
use crate::base::{Error, Result};
use crate::bounds::{Seen, each_sphere};

/// Half angles below which an area is the mean of the lens's magnification at seven places; what lies between them is
/// 10⁻¹⁴ of it, and around the edge more would cancel.
const SMALL: f64 = 2e-3;
/// A sum around the edge is refined until it changes by less than this share of itself, or has that many parts.
const CLOSE: f64 = 1e-13;
const MOST_PARTS: usize = 1 << 12;

/// A view through a lens.
#[derive(Clone, Copy, Debug)]
pub struct Sizes<'a> {
    /// The lens.
    pub lens: &'a RadialLens,
    /// Where the eye is.
    pub eye: DVec3,
    /// Where it looks, of length 1: the lens's axis.
    pub forward: DVec3,
    /// Tangent of half the horizontal field of view, the larger side of it.
    pub tan_omega: f64,
    /// The area that is shown instead of the published product.
    pub exact: bool,
}

/// Solid angles in steradians of what is shown of each sphere. Those that reach 90° from the axis, or to where the lens
/// folds, keep their own.
pub fn corrected_solid_angles(sizes: &Sizes<'_>, centers: &[[f64; 3]], radii: &[f64], to: &mut [f64]) -> Result<()> {
    if !(sizes.tan_omega > 0.0 && sizes.tan_omega.is_finite()) {
        return Err(Error::value("camera", "a field of view with a right or left side", sizes.tan_omega));
    }
    each_sphere(centers, radii, to, |center, radius| sizes.of(center, radius))
}

impl Sizes<'_> {
    fn of(&self, center: DVec3, radius: f64) -> f64 {
        let Some(seen) = Seen::new(center - self.eye, radius) else { return 4.0 * PI };
        let own = seen.solid_angle();
        let cap = Cap::new(self, &seen);
        if !(cap.cos_far() > 0.0 && self.lens.undistort(cap.far().0).is_finite()) || own == 0.0 {
            return own;
        }
        if !self.exact {
            return own * cap.stretch();
        }
        if seen.sine < SMALL { own * cap.mean_magnification() } else { cap.area() }
    }
}

/// What a sphere covers: the directions within μ of one that is α from the axis.
struct Cap<'a> {
    lens: &'a RadialLens,
    /// tan ω
    scale: f64,
    sin_alpha: f64,
    cos_alpha: f64,
    sin_mu: f64,
    cos_mu: f64,
}

impl<'a> Cap<'a> {
    fn new(sizes: &Sizes<'a>, seen: &Seen) -> Self {
        Self {
            lens: sizes.lens,
            scale: sizes.tan_omega,
            sin_alpha: seen.direction.cross(sizes.forward).length(),
            cos_alpha: seen.direction.dot(sizes.forward),
            sin_mu: seen.sine,
            cos_mu: seen.cosine,
        }
    }

    fn cos_far(&self) -> f64 {
        self.cos_alpha * self.cos_mu - self.sin_alpha * self.sin_mu
    }

    fn cos_near(&self) -> f64 {
        self.cos_alpha * self.cos_mu + self.sin_alpha * self.sin_mu
    }

    /// tan(α + μ) / tan ω and tan(α − μ) / tan ω.
    fn far(&self) -> (f64, f64) {
        let sum = (self.sin_alpha * self.cos_mu, self.cos_alpha * self.sin_mu);
        ((sum.0 + sum.1) / self.cos_far() / self.scale, (sum.0 - sum.1) / self.cos_near() / self.scale)
    }

    /// (α⁺ − α⁻) / 2μ with α± = atan(tan ω · f⁻¹(tan(α ± μ) / tan ω)).
    fn stretch(&self) -> f64 {
        let (far, near) = self.far();
        let (a, b) = (self.lens.undistort(far), self.lens.undistort(near.abs()).copysign(near));
        // tan(α+μ) − tan(α−μ) = sin 2μ / (cos(α+μ) cos(α−μ)), and a − b is it over f's divided difference: nothing
        // cancels for spheres as small as they come.
        let apart = 2.0 * self.sin_mu * self.cos_mu / (self.cos_far() * self.cos_near() * self.scale);
        let apart = apart / divided_difference(&self.lens.radial.k, a, b);
        let angle = (self.scale * apart).atan2(1.0 + self.scale * self.scale * a * b);
        angle / (2.0 * self.sin_mu.atan2(self.cos_mu))
    }

    /// Area of what is shown: ∮ (1 − cos α′) dφ around its edge, in 2ⁿ equal parts of ψ.
    fn area(&self) -> f64 {
        let mut parts = 8;
        // Trapezoids of half the edge, which is symmetric; its ends count half.
        let mut sum = 0.5 * (self.around(0.0) + self.around(PI));
        sum += (1..parts).map(|n| self.around(PI * n as f64 / parts as f64)).sum::<f64>();
        let mut area = 2.0 * PI * sum / parts as f64;
        loop {
            sum += (0..parts).map(|n| self.around(PI * (n as f64 + 0.5) / parts as f64)).sum::<f64>();
            parts *= 2;
            let finer = 2.0 * PI * sum / parts as f64;
            if (finer - area).abs() <= CLOSE * finer || parts >= MOST_PARTS {
                return finer;
            }
            area = finer;
        }
    }

    /// (1 − cos α′) dφ/dψ at ψ around the edge: Q (x dy/dψ − y dx/dψ) with Q = (1 − cos α′) / sin² α, smooth on the axis.
    fn around(&self, psi: f64) -> f64 {
        let (sine, cosine) = psi.sin_cos();
        let square = self.tan_square(self.sin_mu * cosine, self.sin_mu * sine, self.cos_mu);
        let turn = self.sin_mu * (self.cos_mu * self.sin_alpha * cosine + self.sin_mu * self.cos_alpha);
        let (ratio, _) = self.shrinks(square.sqrt());
        let shown = square * ratio * ratio;
        ratio * ratio * (1.0 + square) / (1.0 + shown + (1.0 + shown).sqrt()) * turn
    }

    /// tan² of the angle from the axis of a direction given by its parts away from the axis, around it, and along the cap's.
    fn tan_square(&self, away: f64, around: f64, along: f64) -> f64 {
        let out = along * self.sin_alpha + away * self.cos_alpha;
        let ahead = along * self.cos_alpha - away * self.sin_alpha;
        (out * out + around * around) / (ahead * ahead)
    }

    /// tan α′ / tan α and f′ there, for tan α.
    fn shrinks(&self, tangent: f64) -> (f64, f64) {
        let x = tangent / self.scale;
        let r = self.lens.undistort(x);
        (if x == 0.0 { 1.0 } else { r / x }, self.lens.radial.derivative(r))
    }

    /// Mean of sin α′ dα′ / (sin α dα) over the cap, by Radon's rule for discs, exact for polynomials of degree 5.
    fn mean_magnification(&self) -> f64 {
        // Equal areas: sin(θ/2) = share · sin(μ/2).
        let half = self.sin_mu / (2.0 * (1.0 + self.cos_mu)).sqrt() * (2.0f64 / 3.0).sqrt();
        let (sine, cosine) = (2.0 * half * (1.0 - half * half).sqrt(), 1.0 - 2.0 * half * half);
        let ring = (0..6).map(|n| {
            let (around, away) = (PI / 3.0 * f64::from(n)).sin_cos();
            self.magnification(self.tan_square(sine * away, sine * around, cosine))
        });
        self.magnification(self.tan_square(0.0, 0.0, 1.0)) / 4.0 + ring.sum::<f64>() / 8.0
    }

    fn magnification(&self, square: f64) -> f64 {
        let (ratio, slope) = self.shrinks(square.sqrt());
        ratio / slope * ((1.0 + square) / (1.0 + square * ratio * ratio)).powf(1.5)
    }
}

/// (f(a) − f(b)) / (a − b), from sums of aⁱbʲ.
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
