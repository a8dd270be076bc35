//! Nearest point of a triangle to the origin.
//!
//! Ericson: Real-time collision detection, 2005, section 5.1.5, distinguishes cases by the signs of barycentric
//! weights. These signs are unreliable for slivers, so this code takes the minimum distance over the three edges and
//! the plane.

use glam::DVec3;

/// Barycentric weights of the nearest point, and its squared distance.
#[derive(Clone, Copy, Debug)]
pub struct Closest {
    /// Weight of the second corner.
    pub u: f64,
    /// Weight of the third corner.
    pub v: f64,
    /// Squared distance from the origin.
    pub square: f64,
}

/// Squared sine of an angle below which only a triangle's edges count: all its points are within 10⁻¹³ of their length.
const SLIVER: f64 = 1e-26;

/// Returns the nearest point of an edge: the weight of the second end, and the squared distance.
#[inline(always)]
fn closest_on_edge(a: DVec3, b: DVec3) -> (f64, f64) {
    let edge = b - a;
    let squared_length = edge.length_squared();
    let along = -a.dot(edge);
    let t = if along <= 0.0 {
        0.0
    } else if along >= squared_length {
        1.0
    } else {
        along / squared_length
    };
    // Computed from the nearer end, because a distant end would cost precision.
    let point = if t > 0.5 { b - edge * (1.0 - t) } else { a + edge * t };
    (t, point.length_squared())
}

/// Returns weights and squared distance in the plane, if the foot of the perpendicular lies in the triangle.
#[inline(always)]
fn closest_on_plane([a, b, c]: [DVec3; 3]) -> Option<([f64; 2], f64)> {
    let (ab, ac) = (b - a, c - a);
    let normal = ab.cross(ac);
    let squared_normal = normal.length_squared();
    if squared_normal <= SLIVER * (ab.length_squared() * ac.length_squared()) {
        return None;
    }
    let (v, w) = (normal.dot(ac.cross(a)) / squared_normal, normal.dot(a.cross(ab)) / squared_normal);
    if v < 0.0 || w < 0.0 || v + w > 1.0 {
        return None;
    }
    let height = normal.dot(a);
    Some(([v, w], height * height / squared_normal))
}

/// Returns the squared distance of a triangle from the origin.
#[inline(always)]
pub(super) fn squared_distance(corners: [DVec3; 3]) -> f64 {
    match closest_on_plane(corners) {
        Some((_, squared)) => squared,
        None => {
            let [a, b, c] = corners;
            closest_on_edge(a, b).1.min(closest_on_edge(b, c).1).min(closest_on_edge(c, a).1)
        }
    }
}

/// Returns the point of a triangle nearest to the origin.
pub fn closest(corners: [DVec3; 3]) -> Closest {
    if let Some(([u, v], square)) = closest_on_plane(corners) {
        return Closest { u, v, square };
    }
    let [a, b, c] = corners;
    let edges = [closest_on_edge(a, b), closest_on_edge(b, c), closest_on_edge(c, a)];
    let nearest = (1..3).fold(0, |nearest, edge| if edges[edge].1 < edges[nearest].1 { edge } else { nearest });
    let (t, square) = edges[nearest];
    let (u, v) = match nearest {
        0 => (t, 0.0),
        1 => (1.0 - t, t),
        _ => (0.0, 1.0 - t),
    };
    Closest { u, v, square }
}
