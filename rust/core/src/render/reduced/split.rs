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

/// Rules for one user's position.
pub(super) struct Splitter<'a> {
    morph: &'a Morph,
    rules: Option<Rules>,
}

/// Lengths in metres. Every part of an edge that the rules leave whole is left whole too: otherwise thin triangles would
/// be split for ever.
#[derive(Clone, Copy, Debug)]
struct Rules {
    /// Greatest length of an edge between the radii.
    pitch: f64,
    /// Least distance from an edge's ends to where it crosses a radius, below which it is not split there.
    room: f64,
}

/// Triangles that are thinner than this share of their length show nothing and are left out.
const THINNEST: f64 = 1e-9;
/// Parts of an edge shorter than this share of its coordinates: float64 may round their ends to one point, and splits
/// would never end.
const SHORTEST: f64 = 1e-14;
/// Share of a radius by which an end of an edge may miss it and still lie on it.
const ON_RADIUS: f64 = 1e-9;

impl<'a> Splitter<'a> {
    /// `tolerance` is in radians as the user sees them; none splits nothing.
    pub fn new(morph: &'a Morph, tolerance: Option<f64>) -> Self {
        Self { morph, rules: tolerance.map(|tolerance| Rules::new(morph, tolerance)) }
    }

    /// Pieces that cover a triangle. Those of a standing one that lie beyond r₂ are left out.
    pub fn split(&self, whole: Triangle, moving: bool) -> Vec<Triangle> {
        let Some(rules) = self.rules else { return vec![whole] };
        let mut pieces = Vec::new();
        let mut rest = vec![whole];
        while let Some(piece) = rest.pop() {
            if piece.is_thin() || (!moving && self.is_beyond(&piece.corners)) {
                continue;
            }
            let [a, b, c] = piece.corners;
            match piece.divide([(a, b), (b, c), (c, a)].map(|(a, b)| self.cut(a, b, &rules))) {
                Some(parts) => rest.extend(parts),
                None => pieces.push(piece),
            }
        }
        pieces
    }

    /// Where an edge is split. Both triangles at the edge get the same bits: its ends are put in one order.
    fn cut(&self, a: DVec3, b: DVec3, rules: &Rules) -> Option<Cut> {
        if (a.x, a.y, a.z) > (b.x, b.y, b.z) {
            let share = self.share(b, a, rules)?;
            return Some(Cut { point: b.lerp(a, share), share: 1.0 - share });
        }
        let share = self.share(a, b, rules)?;
        Some(Cut { point: a.lerp(b, share), share })
    }

    /// Share of the way from a to b at which their edge is split.
    fn share(&self, a: DVec3, b: DVec3, rules: &Rules) -> Option<f64> {
        let Morph { r1, r2, .. } = *self.morph;
        let rho = |p: DVec3| self.on_ground(p).length();
        if rho(a).max(rho(b)) <= r1 * (1.0 + ON_RADIUS) {
            return None;
        }
        let length = (b - a).length();
        let shortest = SHORTEST * a.abs().max(b.abs()).max_element();
        if length <= shortest {
            return None;
        }
        let least = rho(a.lerp(b, self.nearest(a, b)));
        if least >= r2 * (1.0 - ON_RADIUS) {
            // Edges that are long for their distance are halved, so that no triangle holds the cylinder between them.
            return (length > least).then_some(0.5);
        }
        let room = rules.room.max(shortest) / length;
        let crossing = self.crossings(a, b).into_iter().flatten().find(|s| (room..=1.0 - room).contains(s));
        crossing.or((length > rules.pitch).then_some(0.5))
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

impl Rules {
    /// Measures the morph at some places between the radii: how far the middle of an edge misses its curve grows with
    /// the square of the edge's length, and how far an edge that bends at a radius misses it grows with the length
    /// of its shorter end.
    fn new(morph: &Morph, tolerance: f64) -> Self {
        let width = morph.r2 - morph.r1;
        let length = width / 8.0;
        let (mut bend, mut turn) = (0.0f64, 0.0f64);
        for place in 0..16 {
            let (z, x) = (f64::from(place) * std::f64::consts::TAU / 16.0).sin_cos();
            let (away, along) = (DVec3::new(x, 0.0, z), DVec3::new(-z, 0.0, x));
            for depth in [0.125, 0.5, 0.875] {
                let p = morph.center + away * (morph.r1 + width * depth);
                for edge in [away, along, DVec3::Y].map(|direction| direction * (length / 2.0)) {
                    let [a, middle, b] = [p - edge, p, p + edge].map(|p| morph.apply(p) - morph.user);
                    bend = bend.max(angle((a + b) / 2.0, middle));
                }
                turn = turn.max(angle(p - morph.user, p - morph.center));
            }
        }
        let pitch = (length * (tolerance / bend).sqrt()).clamp(width / 32.0, morph.r2);
        // The picture turns by `turn` over the width; on the other side of the radius it does not.
        let room = (tolerance * width / turn).clamp(width / 1024.0, width / 8.0);
        Self { pitch, room }
    }
}

/// Tangent of the angle between two directions, infinite where one of them is none.
fn angle(a: DVec3, b: DVec3) -> f64 {
    let tangent = a.cross(b).length() / a.dot(b).abs();
    if tangent.is_nan() { f64::INFINITY } else { tangent }
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

    fn is_thin(&self) -> bool {
        let [a, b, c] = self.corners;
        let longest = (b - a).length_squared().max((c - b).length_squared()).max((a - c).length_squared());
        (b - a).cross(c - a).length() <= THINNEST * longest
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::morph::Kind;
    use proptest::prelude::*;

    const WHOLE: [[f32; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

    fn area(corners: &[DVec3; 3]) -> f64 {
        (corners[1] - corners[0]).cross(corners[2] - corners[0]).length() / 2.0
    }

    fn point() -> impl Strategy<Value = DVec3> {
        (-80.0..80.0f64, -5.0..60.0f64, -80.0..80.0f64).prop_map(|(x, y, z)| DVec3::new(x, y, z))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn neighbours_get_the_same_vertices_and_nothing_is_lost(
            a in point(), b in point(), c in point(), d in point(), user in point(), cylinder in any::<bool>(),
            tolerance in 1e-3..1e-1f64,
        ) {
            let kind = if cylinder { Kind::Cylinder } else { Kind::Blend };
            let morph = Morph::new(user, DVec3::new(1.0, 1.7, -2.0), 20.0, 40.0, kind).unwrap();
            let splitter = Splitter::new(&morph, Some(tolerance));
            let on_edge = |third: DVec3, turned: bool| {
                let corners = if turned { [b, a, third] } else { [a, b, third] };
                let pieces = splitter.split(Triangle { corners, weights: WHOLE }, true);
                // Moving triangles are covered whole: 1e-9 of slivers, and roundings of thousands of pieces.
                let sum: f64 = pieces.iter().map(|piece| area(&piece.corners)).sum();
                assert!((sum - area(&corners)).abs() <= 1e-6 * (1.0 + area(&corners)));
                for piece in &pieces {
                    for (corner, [u, v]) in piece.corners.into_iter().zip(piece.weights) {
                        let expected = corners[0] + (corners[1] - corners[0]) * f64::from(u)
                            + (corners[2] - corners[0]) * f64::from(v);
                        // Weights are float32: 6e-8 of 250 m, a few times over.
                        assert!((expected - corner).length() < 1e-4);
                    }
                }
                // Vertices on the edge ab, by their bits: the weight of the third corner is exactly 0 there.
                let mut bits: Vec<[u64; 3]> = pieces
                    .iter()
                    .flat_map(|piece| piece.corners.into_iter().zip(piece.weights))
                    .filter(|(_, weights)| weights[1] == 0.0)
                    .map(|(corner, _)| corner.to_array().map(f64::to_bits))
                    .collect();
                bits.sort_unstable();
                bits.dedup();
                bits
            };
            prop_assert_eq!(on_edge(c, false), on_edge(d, true));
        }

        #[test]
        fn what_lies_within_r2_is_covered(a in point(), b in point(), c in point(), u in 0.0..1.0f64, v in 0.0..1.0f64) {
            let morph = Morph::new(DVec3::new(5.0, 2.0, 3.0), DVec3::ZERO, 20.0, 40.0, Kind::Blend).unwrap();
            let splitter = Splitter::new(&morph, Some(0.01));
            let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
            // Ten times as large: most of it is beyond r₂, and all its edges may be.
            let corners = [a, b, c].map(|corner| corner * 10.0);
            let p = corners[0] + (corners[1] - corners[0]) * u + (corners[2] - corners[0]) * v;
            let p = p * (30.0 / p.x.hypot(p.z)).min(1.0);
            let triangle = [corners[0] - corners[1] + p, corners[1] - corners[2] + p, corners[2] - corners[0] + p];
            prop_assume!(area(&triangle) > 1.0);
            let center = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
            let pieces = splitter.split(Triangle { corners: triangle, weights: WHOLE }, false);
            let inside = |piece: &Triangle| {
                let [a, b, c] = piece.corners;
                let parts = [[a, b, center], [b, c, center], [c, a, center]].map(|part| area(&part));
                parts.iter().sum::<f64>() <= area(&piece.corners) * (1.0 + 1e-9) + 1e-9
            };
            prop_assert!(center.x.hypot(center.z) > 40.0 || pieces.iter().any(inside));
        }
    }

    #[test]
    fn radii_below_what_coordinates_tell_apart_end_too() {
        let corners = [(-4e3, -4e3), (-4e3, 8e3), (8e3, -4e3)].map(|(x, z)| DVec3::new(x, 0.0, z));
        for r2 in [1e-9, 1e-12, 1e-13, 1e-14, 1e-15, 1e-300] {
            let morph = Morph::new(DVec3::X, DVec3::new(3.0, 1.7, -2.0), 0.0, r2, Kind::Blend).unwrap();
            for moving in [false, true] {
                let pieces = Splitter::new(&morph, Some(5e-4)).split(Triangle { corners, weights: WHOLE }, moving);
                assert!(pieces.len() < 100_000, "{r2} {}", pieces.len());
            }
        }
    }

    #[test]
    fn ground_around_everything_is_refined_only_between_the_radii() {
        let corners = [(-4e3, -4e3), (-4e3, 8e3), (8e3, -4e3)].map(|(x, z)| DVec3::new(x, 0.0, z));
        let morph = Morph::new(DVec3::new(9.0, 1.7, 0.0), DVec3::new(0.0, 1.7, 0.0), 30.0, 50.0, Kind::Blend).unwrap();
        // Half a pixel of 90 degrees at 1080p.
        let pieces = Splitter::new(&morph, Some(5e-4)).split(Triangle { corners, weights: WHOLE }, false);
        assert!((200..20_000).contains(&pieces.len()), "{}", pieces.len());
        let whole = Splitter::new(&morph, None).split(Triangle { corners, weights: WHOLE }, false);
        assert_eq!(whole.len(), 1);
    }
}
