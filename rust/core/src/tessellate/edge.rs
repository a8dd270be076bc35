//! Edges and triangles in the ground plane, relative to the axis, and the split points of edges.

use glam::DVec2;

/// Position at which an edge is split.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    /// Fraction of the way along the edge.
    pub fraction: f64,
    /// Length of the edge in the rule's own measure. The longest edge of a triangle is split first.
    pub size: f64,
}

/// Returns the distance of the axis from a segment in the ground plane.
pub(super) fn segment_distance(p: DVec2, q: DVec2) -> f64 {
    let d = q - p;
    let squared = d.length_squared();
    let fraction = if squared > 0.0 { (-p.dot(d) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (p + d * fraction).length()
}

/// Returns the fraction of the way from p to q at which the segment crosses one of the radii, nearest to the middle.
/// `None` if there is no crossing or all lie within the fraction `end_margin` of the ends.
pub(super) fn crossing(p: DVec2, q: DVec2, radii: &[f64], end_margin: f64) -> Option<f64> {
    let d = q - p;
    let (squared, along) = (d.length_squared(), p.dot(d));
    let roots = radii.iter().flat_map(|&radius| {
        let root = (along * along - squared * (p.length_squared() - radius * radius)).sqrt();
        [(-along - root) / squared, (-along + root) / squared]
    });
    // If the edge misses a cylinder or is vertical, its fractions are NaN, which lies in no range.
    roots
        .filter(|fraction| (end_margin..=1.0 - end_margin).contains(fraction))
        .min_by(|a, b| (a - 0.5).abs().total_cmp(&(b - 0.5).abs()).then(a.total_cmp(b)))
}

/// Returns the weights of a triangle's corners at the axis, if it contains the axis.
pub(super) fn weights_of_axis([a, b, c]: [DVec2; 3]) -> Option<[f64; 3]> {
    let areas = [b.perp_dot(c), c.perp_dot(a), a.perp_dot(b)];
    let total = areas[0] + areas[1] + areas[2];
    let weights = areas.map(|area| area / total);
    weights.iter().all(|&weight| weight > 0.0).then_some(weights)
}
