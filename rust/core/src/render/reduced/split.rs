//! Splits near triangles so that morphing their vertices shows them where morphing every point would.
//!
//! Whether and where an edge is split follows from the edge alone, so that both triangles at an edge get the same new
//! vertices and no cracks open between them.

use glam::{DVec2, DVec3};

use crate::morph::Morph;

/// A triangle or a piece of one, with the places of its corners on the whole.
#[derive(Clone, Copy, Debug)]
pub(super) struct Triangle {
    pub corners: [DVec3; 3],
    pub weights: [[f32; 2]; 3],
}

/// A new vertex on an edge.
#[derive(Clone, Copy, Debug)]
struct Cut {
    point: DVec3,
    /// Of the way along the edge, in the triangle's sense.
    share: f64,
}

pub(super) struct Splitter<'a> {
    pub morph: &'a Morph,
    /// Radians as the user sees them; none splits nothing.
    pub tolerance: Option<f64>,
}

/// Edges below this share of r₂ are not split any more: it only stops where the morph itself jumps.
const SHORTEST: f64 = 1e-3;

impl Splitter<'_> {
    /// Pieces that cover a triangle. Those of a standing one that lie beyond r₂ are left out.
    pub fn split(&self, whole: Triangle, moving: bool) -> Vec<Triangle> {
        let Some(tolerance) = self.tolerance else { return vec![whole] };
        let mut pieces = Vec::new();
        let mut rest = vec![whole];
        while let Some(piece) = rest.pop() {
            if !moving && self.is_beyond(&piece.corners) {
                continue;
            }
            let [a, b, c] = piece.corners;
            let cuts = [(a, b), (b, c), (c, a)].map(|(a, b)| self.cut(a, b, tolerance, moving));
            match piece.divide(cuts) {
                Some(parts) => rest.extend(parts),
                None => pieces.push(piece),
            }
        }
        pieces
    }

    /// Where an edge is split. Both triangles at the edge get the same bits: its ends are put in one order.
    fn cut(&self, a: DVec3, b: DVec3, tolerance: f64, moving: bool) -> Option<Cut> {
        if (a.x, a.y, a.z) > (b.x, b.y, b.z) {
            let share = self.share(b, a, tolerance, moving)?;
            return Some(Cut { point: b.lerp(a, share), share: 1.0 - share });
        }
        let share = self.share(a, b, tolerance, moving)?;
        Some(Cut { point: a.lerp(b, share), share })
    }

    /// Share of the way from a to b at which their edge is split.
    fn share(&self, a: DVec3, b: DVec3, tolerance: f64, moving: bool) -> Option<f64> {
        let Morph { r1, r2, center, .. } = *self.morph;
        let rho = |p: DVec3| DVec2::new(p.x - center.x, p.z - center.z).length();
        let (rho_a, rho_b) = (rho(a), rho(b));
        let length = (b - a).length();
        if rho_a.max(rho_b) <= r1 || length < SHORTEST * r2 {
            return None;
        }
        let nearest = self.nearest(a, b);
        let least = rho(a.lerp(b, nearest));
        // Edges that are long for their distance are halved, so that no triangle holds the cylinder between its edges.
        if length > least.max(r2) {
            return Some(0.5);
        }
        if least >= r2 {
            return None;
        }
        // Between the radii, and where the edge crosses them, the morph is not straight.
        let crossings = self.crossings(a, b);
        let samples = [Some(0.25), Some(0.5), Some(0.75)].into_iter().chain(crossings).flatten();
        let [shown_a, shown_b] = [a, b].map(|p| self.morph.apply(p));
        let misses = |s: f64| {
            let p = a.lerp(b, s);
            // Beyond r₂ nothing that stands is drawn; half a part in a million more holds the crossing itself.
            if !moving && rho(p) > r2 * (1.0 + 5e-7) {
                return false;
            }
            let exact = self.morph.apply(p);
            let sight = exact - self.morph.user;
            sight.cross(shown_a.lerp(shown_b, s) - exact).length() > tolerance * sight.length_squared()
        };
        if !samples.into_iter().any(misses) {
            return None;
        }
        let room = SHORTEST * r2 / length;
        let crossing = crossings.into_iter().flatten().find(|s| (room..=1.0 - room).contains(s));
        Some(crossing.unwrap_or(0.5))
    }

    /// Share of the way from a to b at which the edge comes nearest to the axis.
    fn nearest(&self, a: DVec3, b: DVec3) -> f64 {
        let (p, d) = (self.on_ground(a), self.on_ground(b) - self.on_ground(a));
        let squared = d.length_squared();
        if squared > 0.0 { (-p.dot(d) / squared).clamp(0.0, 1.0) } else { 0.0 }
    }

    /// Shares of the way from a to b at which the edge crosses r₂ and r₁.
    fn crossings(&self, a: DVec3, b: DVec3) -> [Option<f64>; 4] {
        let (p, d) = (self.on_ground(a), self.on_ground(b) - self.on_ground(a));
        let (squared, along) = (d.length_squared(), p.dot(d));
        let cross = |radius: f64| {
            let discriminant = along * along - squared * (p.length_squared() - radius * radius);
            let root = discriminant.sqrt();
            [(-along - root) / squared, (-along + root) / squared].map(|s| (s > 0.0 && s < 1.0).then_some(s))
        };
        // NaN, where the edge misses a cylinder or is upright, is neither above 0 nor below 1.
        let ([e, f], [g, h]) = (cross(self.morph.r2), cross(self.morph.r1));
        [e, f, g, h]
    }

    /// True where no point of a triangle is inside r₂, as far as one edge's side tells.
    fn is_beyond(&self, corners: &[DVec3; 3]) -> bool {
        let r2 = self.morph.r2;
        let p = corners.map(|corner| self.on_ground(corner));
        let beyond = |axis: DVec2| p.iter().all(|p| p.dot(axis) > r2);
        // The directions of the corners and of the edges' normals.
        let normal = |a: DVec2, b: DVec2| {
            let n = (b - a).perp().normalize_or_zero();
            if n.dot(a) < 0.0 { -n } else { n }
        };
        p.iter().any(|p| beyond(p.normalize_or_zero()))
            || [(p[0], p[1]), (p[1], p[2]), (p[2], p[0])].into_iter().any(|(a, b)| beyond(normal(a, b)))
    }

    fn on_ground(&self, p: DVec3) -> DVec2 {
        DVec2::new(p.x - self.morph.center.x, p.z - self.morph.center.z)
    }
}

impl Triangle {
    /// Two, three or four parts for splits on the edges ab, bc and ca; none without any.
    fn divide(&self, cuts: [Option<Cut>; 3]) -> Option<Vec<Self>> {
        let count = cuts.iter().flatten().count();
        // Turned so that the edges that are split (or for two: the one that is not) come first.
        let first = match count {
            0 => return None,
            1 => cuts.iter().position(Option::is_some),
            2 => cuts.iter().position(Option::is_none).map(|whole| (whole + 1) % 3),
            _ => Some(0),
        }?;
        let turned = self.turned(first);
        let at = |edge: usize| cuts[(first + edge) % 3].map(|cut| (cut.point, turned.weights_at(edge, cut.share)));
        let [a, b, c] = [0, 1, 2].map(|i| (turned.corners[i], turned.weights[i]));
        let parts = match (at(0), at(1), at(2)) {
            (Some(m), Some(n), Some(o)) => vec![[a, m, o], [m, b, n], [o, n, c], [m, n, o]],
            (Some(m), Some(n), None) if (m.0 - c.0).length_squared() < (n.0 - a.0).length_squared() => {
                vec![[m, b, n], [a, m, c], [m, n, c]]
            }
            (Some(m), Some(n), None) => vec![[m, b, n], [a, m, n], [a, n, c]],
            (Some(m), _, _) => vec![[a, m, c], [m, b, c]],
            _ => return None,
        };
        Some(parts.into_iter().map(Self::from_corners).collect())
    }

    fn from_corners(corners: [(DVec3, [f32; 2]); 3]) -> Self {
        Self { corners: corners.map(|corner| corner.0), weights: corners.map(|corner| corner.1) }
    }

    fn turned(&self, first: usize) -> Self {
        let order = [0, 1, 2].map(|i| (first + i) % 3);
        Self { corners: order.map(|i| self.corners[i]), weights: order.map(|i| self.weights[i]) }
    }

    /// Weights on the whole at a share of the way along an edge.
    fn weights_at(&self, edge: usize, share: f64) -> [f32; 2] {
        let (a, b) = (self.weights[edge], self.weights[(edge + 1) % 3]);
        [0, 1].map(|k| (f64::from(a[k]) + (f64::from(b[k]) - f64::from(a[k])) * share) as f32)
    }
}
