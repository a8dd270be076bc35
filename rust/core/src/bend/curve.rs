//! Curve of points that the morph shows in one direction, and its polyline.

use glam::{DVec2, DVec3};

use crate::morph::Morph;

/// Maximum number of steps of the root search. Bisection alone needs one step per bit of a float64, which has 53.
const STEPS: usize = 80;
/// Maximum number of halvings of a stretch beyond the number that the tolerance requires.
const SPARE_HALVINGS: u32 = 8;
/// `SPARE_HALVINGS` for strengths below 1, where the curve may turn by a right angle within micrometres of U and O.
const SPARE_HALVINGS_BESIDE_U_AND_O: u32 = 24;
/// A stretch has at most `MAX_CHORDS` / √tolerance chords, with the tolerance in radians. Where the picture folds, the
/// curve jumps and no chord meets the tolerance.
pub(super) const MAX_CHORDS: f64 = 64.0;
/// A chord whose end is more than this many times as far from the user as its start is halved on a logarithmic scale.
const MAX_CHORD_RATIO: f64 = 4.0;
/// s at which a vertical curve is cut, as a multiple of r₂ + |v⊥|.
const VERTICAL_END: f64 = 1e4;
/// Fraction of the tolerance that a chord may use at the tested points; elsewhere its error may be larger.
const TESTED_TOLERANCE: f64 = 0.75;
/// Position of the first tested point, as a fraction of the chord.
const FIRST_TEST: f64 = 1e-6;

/// Curve of points that the morph shows in one direction. The module `bend` defines the symbols.
#[derive(Clone, Copy, Debug)]
pub struct RayCurve<'a> {
    morph: &'a Morph,
    /// The direction d, a unit vector.
    pub direction: DVec3,
    /// v·d in metres: coordinate of the centre along d.
    center_s: f64,
    /// |v⊥| in metres: distance between the user's ray and the centre's parallel ray.
    pub ray_distance: f64,
    /// e: the unit vector from the user's ray to the centre's ray.
    pub offset_direction: DVec3,
}

/// A stretch of a curve between two values of s, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// s of its start.
    pub from: f64,
    /// s of its end.
    pub to: f64,
    /// True inside r₁ at full strength, where the curve is the user's ray.
    pub is_straight: bool,
}

impl<'a> RayCurve<'a> {
    /// Creates the curve in a direction, a unit vector.
    pub fn new(morph: &'a Morph, direction: DVec3) -> Self {
        let v = morph.center - morph.user;
        let center_s = v.dot(direction);
        // The projection is subtracted twice, because rounding may leave a component along d after the first time.
        let once = v - direction * center_s;
        let perpendicular = once - direction * once.dot(direction);
        let ray_distance = perpendicular.length();
        let offset_direction = if ray_distance > 0.0 { perpendicular / ray_distance } else { DVec3::ZERO };
        Self { morph, direction, center_s, ray_distance, offset_direction }
    }

    /// Returns the point at s along the user's ray and y beside it, in metres.
    pub fn point(&self, s: f64, y: f64) -> DVec3 {
        self.morph.user + self.direction * s + self.offset_direction * y
    }

    /// Returns s where the centre's parallel ray leaves r₂, and the distance from O there; `None` if d is vertical.
    pub fn end(&self) -> Option<(f64, f64)> {
        let slope = on_ground(self.direction).length();
        let from_center = self.morph.r2 / slope;
        from_center.is_finite().then_some((self.center_s + from_center, from_center))
    }

    /// Returns the curve's last point, where the centre's ray leaves r₂; `end` returns `from_center`.
    pub fn last(&self, from_center: f64) -> DVec3 {
        self.morph.center + self.direction * from_center
    }

    /// Returns s where the curve starts: at U, or at O if w at U is below ½, which a strength below 1 can cause. If w
    /// is ½, the blended direction of points between U and O is 0, and the curve starts where it leaves this segment.
    pub fn start(&self) -> f64 {
        let weight = self.morph.weight(on_ground(self.morph.user - self.morph.center).length());
        if self.morph.strength == 1.0 || weight > 0.5 {
            0.0
        } else if weight < 0.5 {
            self.center_s
        } else {
            self.center_s.max(0.0)
        }
    }

    /// Returns the stretches of the curve from its start to r₂, in order of s. There are three if the ray of a user
    /// between the radii crosses r₁. At a strength below 1 they also end where the curve crosses r₁, and beside U and O:
    /// within a millimetre of U or O the curve may turn by a right angle, which a long chord does not show.
    pub fn stretches(&self) -> Vec<Stretch> {
        // Vertical curves never reach r₂; they are cut far beyond both radii.
        let end = self.end().map_or(VERTICAL_END * (self.morph.r2 + self.ray_distance), |(s, _)| s);
        let start = self.start();
        if self.ray_distance == 0.0 || end <= start {
            return Vec::new();
        }
        let mut stretches = Vec::with_capacity(3);
        let mut add = |from: f64, to: f64, is_straight| {
            stretches.extend((to > from).then_some(Stretch { from, to, is_straight }));
        };
        if let Some((enter, leave)) = self.within_r1() {
            add(0.0, enter.min(end), false);
            add(enter, leave, true);
            add(leave, end, false);
        } else {
            let mut ends = vec![start, end];
            if self.morph.strength < 1.0 {
                ends.extend([0.0, self.center_s].into_iter().filter(|s| (start..end).contains(s)));
                ends.sort_by(f64::total_cmp);
                let crossings: Vec<f64> = ends.windows(2).filter_map(|pair| self.crossing(pair[0], pair[1])).collect();
                ends.extend(crossings);
                ends.sort_by(f64::total_cmp);
            }
            ends.windows(2).for_each(|pair| add(pair[0], pair[1], false));
        }
        stretches
    }

    /// Returns s where the curve crosses r₁ between two values of s, of which one is inside and one outside.
    fn crossing(&self, from: f64, to: f64) -> Option<f64> {
        let is_inside = |s: f64| {
            let point = self.point(s, self.offset(s, 0.5 * self.ray_distance));
            on_ground(point - self.morph.center).length() < self.morph.r1
        };
        let starts_inside = is_inside(from);
        (starts_inside != is_inside(to)).then(|| {
            let (mut low, mut high) = (from, to);
            for _ in 0..STEPS {
                let middle = 0.5 * (low + high);
                if is_inside(middle) == starts_inside { low = middle } else { high = middle }
            }
            high
        })
    }

    /// Returns the interval of s in which the user's ray lies inside r₁ and coincides with the curve.
    fn within_r1(&self) -> Option<(f64, f64)> {
        if self.morph.strength < 1.0 {
            return None;
        }
        let (p, d) = (on_ground(self.morph.user - self.morph.center), on_ground(self.direction));
        within_cylinder(p, d, self.morph.r1).filter(|&(_, leave)| leave > 0.0)
    }

    /// Returns y(s), found from an initial guess. Where the picture folds, it returns one of several roots.
    pub fn offset(&self, s: f64, guess: f64) -> f64 {
        self.search(s, guess, f64::EPSILON)
    }

    /// Same as `offset`, but the search ends when a step is below `precision` |v⊥|. The error after Newton's last step
    /// is about the square of that step.
    #[inline]
    pub fn search(&self, s: f64, guess: f64, precision: f64) -> f64 {
        let (mut low, mut high) = (0.0, self.ray_distance);
        let mut y = guess.clamp(low, high);
        for _ in 0..STEPS {
            let (value, slope) = self.residual(s, y);
            if value == 0.0 {
                return y;
            }
            if value > 0.0 {
                high = y
            } else {
                low = y
            }
            let newton = y - value / slope;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - y).abs() <= precision * self.ray_distance {
                return next;
            }
            y = next;
        }
        y
    }

    /// Returns the equation for y multiplied by |P−U| |P−O|, and its derivative by y.
    #[inline]
    fn residual(&self, s: f64, y: f64) -> (f64, f64) {
        let Morph { r1, r2, strength, .. } = *self.morph;
        let from_axis = on_ground(self.point(s, y) - self.morph.center);
        let rho = from_axis.length();
        let w = self.morph.weight(rho);
        let (q, z) = (s - self.center_s, y - self.ray_distance);
        let (a, b) = ((s * s + y * y).sqrt(), (q * q + z * z).sqrt());
        let value = w * y * b + (1.0 - w) * z * a;
        let is_between = w > 0.0 && w < strength;
        let w_slope = if is_between {
            -strength * from_axis.dot(on_ground(self.offset_direction)) / (rho * (r2 - r1))
        } else {
            0.0
        };
        // If a length is 0, the value is 0 as well, and the slope is not used.
        let slope = w * (b + y * z / b) + (1.0 - w) * (a + y * z / a) + w_slope * (y * b - z * a);
        (value, slope)
    }

    /// Returns the tangent of the angle between d and the direction in which the morph shows a point of the curve's
    /// plane. It is an upper bound of the angle in radians; infinite for angles of 90° or more.
    #[inline]
    pub fn miss(&self, s: f64, y: f64) -> f64 {
        let w = self.morph.weight(on_ground(self.point(s, y) - self.morph.center).length());
        let (q, z) = (s - self.center_s, y - self.ray_distance);
        let by_user = w / (s * s + y * y).sqrt().max(f64::MIN_POSITIVE);
        let by_center = (1.0 - w) / (q * q + z * z).sqrt().max(f64::MIN_POSITIVE);
        let (sine, cosine) = (by_user * y + by_center * z, by_user * s + by_center * q);
        if cosine > 0.0 { sine.abs() / cosine } else { f64::INFINITY }
    }

    /// Appends a stretch as a polyline: the morph shows each of its points within a tolerance, in radians, of d. The
    /// first point lies at `stretch.from`, the last at `stretch.to`.
    fn flatten(&self, stretch: &Stretch, tolerance: f64, points: &mut Vec<DVec3>) {
        let vertex = |s: f64, guess: f64| (s, self.offset(s, guess));
        // At a strength below 1, U and O are roots beside which the curve may pass: the search begins between them.
        let (mut first, mut last) = (0.0, self.ray_distance);
        if self.morph.strength < 1.0 {
            last *= 0.5;
            if stretch.from > self.start() {
                first = last;
            }
        }
        let (first, last) = (vertex(stretch.from, first), vertex(stretch.to, last));
        points.push(self.point(first.0, first.1));
        // The error of a chord is proportional to the square of its length.
        let is_partial = self.morph.strength < 1.0;
        let spare_halvings = if is_partial { SPARE_HALVINGS_BESIDE_U_AND_O } else { SPARE_HALVINGS };
        let max_depth = (-0.5 * tolerance.log2()).ceil().max(0.0) as u32 + spare_halvings;
        let max_count = points.len() + (MAX_CHORDS / tolerance.sqrt()) as usize;
        let mut chords = vec![(first, last, 0)];
        while let Some((a, b, depth)) = chords.pop() {
            // At a strength below 1 a chord may begin or end beside U or O, where the curve turns most.
            let levels = (if depth < 2 { 3 } else { 2 }) + (if is_partial { 2 } else { 0 });
            let is_last = depth == max_depth || points.len() >= max_count;
            let tested = TESTED_TOLERANCE * tolerance;
            let ends_flat = self.is_flat_beside(a, b, tested) && (!is_partial || self.is_flat_beside(b, a, tested));
            if is_last || ends_flat && self.is_flat(a, b, levels, tested) {
                points.push(self.point(b.0, b.1));
                continue;
            }
            let (s, y) = self.middle(a, b);
            let middle = vertex(s, y);
            chords.push((middle, b, depth + 1));
            chords.push((a, middle, depth + 1));
        }
    }

    /// Tests a chord beside one of its ends. Beside U and O the error is greatest: the curve's direction differs most
    /// from the chord's, and the view from there changes most.
    fn is_flat_beside(&self, a: (f64, f64), b: (f64, f64), tolerance: f64) -> bool {
        let [s, y] = [a.0 + (b.0 - a.0) * FIRST_TEST, a.1 + (b.1 - a.1) * FIRST_TEST];
        self.miss(s, y) <= tolerance
    }

    /// Tests a chord at its middle, at the middles of its halves and so on, over a number of levels.
    fn is_flat(&self, a: (f64, f64), b: (f64, f64), levels: u32, tolerance: f64) -> bool {
        let middle = self.middle(a, b);
        self.miss(middle.0, middle.1) <= tolerance
            && (levels == 1
                || self.is_flat(a, middle, levels - 1, tolerance) && self.is_flat(middle, b, levels - 1, tolerance))
    }

    /// Returns the midpoint of a chord. The curvature falls with the distance from the user, so long chords are halved
    /// on a logarithmic scale of s that begins at |v⊥|.
    fn middle(&self, a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
        let near = a.0.max(self.ray_distance);
        let s = if b.0 > MAX_CHORD_RATIO * near { (near * b.0).sqrt() } else { 0.5 * (a.0 + b.0) };
        (s, a.1 + (b.1 - a.1) * (s - a.0) / (b.0 - a.0))
    }

    /// Returns the curve as a polyline: its start (U for users inside r₁ at full strength), its bends, and the point
    /// where it leaves r₂. Beyond r₂ the curve continues along d.
    pub fn polyline(&self, tolerance: f64) -> Vec<DVec3> {
        if self.morph.r2 == 0.0 {
            return vec![self.morph.center];
        }
        let stretches = self.stretches();
        let mut points = Vec::new();
        for stretch in &stretches {
            if stretch.is_straight {
                points.push(self.point(stretch.from, 0.0));
                points.extend(stretch.to.is_finite().then(|| self.point(stretch.to, 0.0)));
            } else {
                self.flatten(stretch, tolerance, &mut points);
            }
        }
        points.dedup();
        match (self.end(), stretches.is_empty()) {
            _ if self.ray_distance == 0.0 => points.push(self.point(self.start(), 0.0)),
            (Some((_, from_center)), true) => points.push(self.last(from_center)),
            _ => {}
        }
        points
    }
}

/// Returns the horizontal components.
pub(crate) fn on_ground(p: DVec3) -> DVec2 {
    DVec2::new(p.x, p.z)
}

/// Returns a ray's interval inside a vertical cylinder, in units of the direction; `start` is relative to the axis.
pub(crate) fn within_cylinder(start: DVec2, direction: DVec2, radius: f64) -> Option<(f64, f64)> {
    let (a, b) = (direction.length_squared(), start.dot(direction));
    let c = start.length_squared() - radius * radius;
    if a == 0.0 {
        return (c <= 0.0).then_some((0.0, f64::INFINITY));
    }
    let discriminant = b * b - a * c;
    if discriminant < 0.0 {
        return None;
    }
    // Both roots of the quadratic equation in the form without cancellation.
    let q = -(b + discriminant.sqrt().copysign(b));
    let (first, second) = if q == 0.0 { (0.0, 0.0) } else { (q / a, c / q) };
    let (enter, leave) = (first.min(second), first.max(second));
    (leave >= 0.0).then_some((enter.max(0.0), leave))
}
