//! Smallest sphere about a few points, by trying all possible supports.

use glam::DVec3;

/// The support of a sphere: at most four points on its surface that determine it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Support {
    points: [DVec3; 4],
    count: usize,
    pub center: DVec3,
    pub radius: f64,
}

impl Support {
    /// Creates the sphere of radius 0 about one point.
    pub fn point(point: DVec3) -> Self {
        Self { points: [point; 4], count: 1, center: point, radius: 0.0 }
    }

    /// Returns the points of the support.
    pub fn points(&self) -> &[DVec3] {
        &self.points[..self.count]
    }

    /// Returns the smallest sphere about this support and a new point outside the sphere; the new point lies on its
    /// surface. Among the spheres determined by subsets of the points, it takes the one whose radius needs the smallest
    /// increase to contain all points. So a degenerate subset, whose sphere is undefined, is never chosen.
    pub fn extend(&self, new: DVec3) -> Self {
        let old = self.points();
        let mut best = Self { radius: f64::INFINITY, ..Self::point(new) };
        for subset in 0u32..1 << old.len() {
            let count = subset.count_ones() as usize;
            if count > 3 {
                continue;
            }
            let mut points = [new; 4];
            let chosen = (0..old.len()).filter(|n| subset >> n & 1 == 1);
            for (slot, n) in points[1..].iter_mut().zip(chosen) {
                *slot = old[n];
            }
            let center = equidistant(&points[..=count]);
            let squared = old.iter().chain([&new]).map(|point| (*point - center).length_squared());
            let radius = squared.fold(0.0, worse).sqrt();
            if radius < best.radius {
                best = Self { points, count: count + 1, center, radius };
            }
        }
        best
    }
}

/// Returns the larger value; NaN if either is NaN.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// Returns the point equidistant from one to four points: in their plane if there are three, on their line if two.
pub(super) fn equidistant(points: &[DVec3]) -> DVec3 {
    let from = points[0];
    match *points {
        [_, b] => from + (b - from) * 0.5,
        [_, b, c] => {
            let (u, v) = (b - from, c - from);
            let normal = u.cross(v);
            let across = (v * u.length_squared() - u * v.length_squared()).cross(normal);
            from + across / (2.0 * normal.length_squared())
        }
        [_, b, c, d] => {
            let (u, v, w) = (b - from, c - from, d - from);
            let sum =
                v.cross(w) * u.length_squared() + w.cross(u) * v.length_squared() + u.cross(v) * w.length_squared();
            from + sum / (2.0 * u.dot(v.cross(w)))
        }
        _ => from,
    }
}
