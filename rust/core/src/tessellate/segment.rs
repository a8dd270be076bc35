//! Edges and triangles in the ground plane, relative to the axis.

use glam::DVec2;

/// Returns the distance of the axis from a segment in the ground plane.
pub(super) fn segment_distance(p: DVec2, q: DVec2) -> f64 {
    let d = q - p;
    let squared = d.length_squared();
    let share = if squared > 0.0 { (-p.dot(d) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (p + d * share).length()
}

/// Returns the fraction of the way from p to q at which their segment crosses one of the radii: the crossing nearest
/// to the middle. `None` if there is no crossing or all lie within `room` of the ends.
pub(super) fn crossing(p: DVec2, q: DVec2, radii: &[f64], room: f64) -> Option<f64> {
    let d = q - p;
    let (squared, along) = (d.length_squared(), p.dot(d));
    let roots = radii.iter().flat_map(|&radius| {
        let root = (along * along - squared * (p.length_squared() - radius * radius)).sqrt();
        [(-along - root) / squared, (-along + root) / squared]
    });
    // The fraction is NaN if the edge misses a cylinder or is vertical; NaN lies in no range.
    roots
        .filter(|share| (room..=1.0 - room).contains(share))
        .min_by(|a, b| (a - 0.5).abs().total_cmp(&(b - 0.5).abs()).then(a.total_cmp(b)))
}

/// Returns the weights of a triangle's corners at the axis, if it contains the axis.
pub(super) fn weights_of_axis([a, b, c]: [DVec2; 3]) -> Option<[f64; 3]> {
    let areas = [b.perp_dot(c), c.perp_dot(a), a.perp_dot(b)];
    let whole = areas[0] + areas[1] + areas[2];
    let weights = areas.map(|area| area / whole);
    weights.iter().all(|&weight| weight > 0.0).then_some(weights)
}
