//! The curve of points that the morph shows in one direction, and its polyline.

use glam::{DVec2, DVec3};

use crate::morph::Morph;

/// Steps of the root's search at most: bisection alone needs as many as a float64 has digits.
const STEPS: usize = 80;
/// Most halvings of a stretch beyond those of a chord's length that the tolerance asks for.
const SPARE_HALVINGS: u32 = 8;
/// Most chords of a stretch, times the root of the tolerance. Where the picture folds, curves jump and no chord is flat.
pub(super) const MAX_CHORDS: f64 = 64.0;
/// Ratio of a chord's end to its start, both as distances from the user, above which it is long.
const LONG_CHORD: f64 = 4.0;
/// End of an upright curve, in radii.
const UPRIGHT_END: f64 = 1e4;
/// Share of the tolerance that a chord may miss at the points where it is tried: between them it may miss all of it.
const CHORD_SHARE: f64 = 0.75;

/// The curve of points that are shown in one direction.
#[derive(Clone, Copy, Debug)]
pub struct RayCurve<'a> {
    morph: &'a Morph,
    /// Unit.
    pub direction: DVec3,
    /// v·d: how far along d the centre lies.
    along: f64,
    /// |v⊥|: how far the centre's ray runs beside the user's.
    pub beside: f64,
    /// e: the unit vector from the user's ray to the centre's.
    pub across: DVec3,
}

/// A stretch of a curve between two values of s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// True inside r₁, where it is the user's ray.
    pub straight: bool,
}

impl<'a> RayCurve<'a> {
    /// The curve in a unit direction.
    pub fn new(morph: &'a Morph, direction: DVec3) -> Self {
        let v = morph.center - morph.user;
        let along = v.dot(direction);
        // Twice, because the first difference may leave a part along d of the size of its rounding.
        let once = v - direction * along;
        let rest = once - direction * once.dot(direction);
        let beside = rest.length();
        let across = if beside > 0.0 { rest / beside } else { DVec3::ZERO };
        Self { morph, direction, along, beside, across }
    }

    /// The point at s along and y beside the user's ray.
    pub fn point(&self, s: f64, y: f64) -> DVec3 {
        self.morph.user + self.direction * s + self.across * y
    }

    /// Where the centre's parallel ray leaves r₂: s, and the distance from O; none for an upright direction.
    pub fn end(&self) -> Option<(f64, f64)> {
        let slope = on_ground(self.direction).length();
        let from_center = self.morph.r2 / slope;
        from_center.is_finite().then_some((self.along + from_center, from_center))
    }

    /// The last point of the curve between the radii, on the centre's ray.
    pub fn last(&self, from_center: f64) -> DVec3 {
        self.morph.center + self.direction * from_center
    }

    /// The curve from where it begins to r₂, in order of s. Users between the radii see it in three stretches.
    pub fn stretches(&self) -> Vec<Stretch> {
        // Upright curves never end; far above everything they are cut.
        let end = self.end().map_or(UPRIGHT_END * (self.morph.r2 + self.beside), |(s, _)| s);
        if self.beside == 0.0 || end <= 0.0 {
            return Vec::new();
        }
        let within = self.within_r1();
        let mut stretches = Vec::with_capacity(3);
        let mut add = |from: f64, to: f64, straight: bool| {
            if to > from {
                stretches.push(Stretch { from, to, straight });
            }
        };
        match within {
            Some((enter, leave)) => {
                add(0.0, enter.min(end), false);
                add(enter, leave, true);
                add(leave, end, false);
            }
            None => add(0.0, end, false),
        }
        stretches
    }

    /// The part of the user's ray inside r₁.
    fn within_r1(&self) -> Option<(f64, f64)> {
        let (p, d) = (on_ground(self.morph.user - self.morph.center), on_ground(self.direction));
        within_cylinder(p, d, self.morph.r1).filter(|&(_, leave)| leave > 0.0)
    }

    /// y(s), searched from a guess. Where the picture folds there are several roots, and one of them is found.
    pub fn offset(&self, s: f64, guess: f64) -> f64 {
        self.search(s, guess, f64::EPSILON)
    }

    /// The same until a step is below this share of |v⊥|; after Newton's last one the error is about its square.
    #[inline]
    pub fn search(&self, s: f64, guess: f64, precision: f64) -> f64 {
        let (mut low, mut high) = (0.0, self.beside);
        let mut y = guess.clamp(low, high);
        for _ in 0..STEPS {
            let (value, slope) = self.residual(s, y);
            if value == 0.0 {
                return y;
            }
            if value > 0.0 {
                high = y;
            } else {
                low = y;
            }
            let newton = y - value / slope;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - y).abs() <= precision * self.beside {
                return next;
            }
            y = next;
        }
        y
    }

    /// The equation for y, times |P−U| |P−O|, and its derivative.
    #[inline]
    fn residual(&self, s: f64, y: f64) -> (f64, f64) {
        let Morph { r1, r2, .. } = *self.morph;
        let from_axis = on_ground(self.point(s, y) - self.morph.center);
        let rho = from_axis.length();
        let w = self.morph.weight(rho);
        let (q, z) = (s - self.along, y - self.beside);
        let (a, b) = ((s * s + y * y).sqrt(), (q * q + z * z).sqrt());
        let value = w * y * b + (1.0 - w) * z * a;
        let turn = if w > 0.0 && w < 1.0 { -from_axis.dot(on_ground(self.across)) / (rho * (r2 - r1)) } else { 0.0 };
        // Where a length is 0 so is the value, and the slope is not used.
        let slope = w * (b + y * z / b) + (1.0 - w) * (a + y * z / a) + turn * (y * b - z * a);
        (value, slope)
    }

    /// Angle between d and the direction in which the morph shows a point of the curve's plane: its tangent, which is no
    /// less; infinite from a right angle on.
    #[inline]
    pub fn miss(&self, s: f64, y: f64) -> f64 {
        let w = self.morph.weight(on_ground(self.point(s, y) - self.morph.center).length());
        let (q, z) = (s - self.along, y - self.beside);
        let by_user = w / (s * s + y * y).sqrt().max(f64::MIN_POSITIVE);
        let by_center = (1.0 - w) / (q * q + z * z).sqrt().max(f64::MIN_POSITIVE);
        let (across, along) = (by_user * y + by_center * z, by_user * s + by_center * q);
        if along > 0.0 { across.abs() / along } else { f64::INFINITY }
    }

    /// Appends points of the curve so that no chord between them misses its direction by more than a tolerance in
    /// radians; the first is where it leaves `stretch.from`, the last where it arrives.
    fn flatten(&self, stretch: &Stretch, tolerance: f64, points: &mut Vec<DVec3>) {
        let at = |s: f64, guess: f64| (s, self.offset(s, guess));
        let first = at(stretch.from, 0.0);
        let last = at(stretch.to, self.beside);
        points.push(self.point(first.0, first.1));
        // Chords miss by the square of their length.
        let deepest = (-0.5 * tolerance.log2()).ceil().max(0.0) as u32 + SPARE_HALVINGS;
        let most = points.len() + (MAX_CHORDS / tolerance.sqrt()) as usize;
        let mut open = vec![(first, last, 0)];
        while let Some((a, b, depth)) = open.pop() {
            let levels = if depth < 2 { 3 } else { 2 };
            if depth == deepest || points.len() >= most || self.is_flat(a, b, levels, CHORD_SHARE * tolerance) {
                points.push(self.point(b.0, b.1));
                continue;
            }
            let (s, y) = self.middle(a, b);
            let middle = at(s, y);
            open.push((middle, b, depth + 1));
            open.push((a, middle, depth + 1));
        }
    }

    /// Whether a chord misses nothing in its middle, in the middles of its halves, and so on.
    fn is_flat(&self, a: (f64, f64), b: (f64, f64), levels: u32, tolerance: f64) -> bool {
        let middle = self.middle(a, b);
        self.miss(middle.0, middle.1) <= tolerance
            && (levels == 1
                || self.is_flat(a, middle, levels - 1, tolerance) && self.is_flat(middle, b, levels - 1, tolerance))
    }

    /// A chord's point halfway. What is seen from far away bends as slowly as it is far: long chords are halved on a
    /// logarithmic scale, from |v⊥| on.
    fn middle(&self, a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
        let near = a.0.max(self.beside);
        let s = if b.0 > LONG_CHORD * near { (near * b.0).sqrt() } else { 0.5 * (a.0 + b.0) };
        (s, a.1 + (b.1 - a.1) * (s - a.0) / (b.0 - a.0))
    }

    /// The curve as a polyline: where it begins (U for users inside r₁), where it bends, and where it leaves r₂; from
    /// there it goes on along d.
    pub fn polyline(&self, tolerance: f64) -> Vec<DVec3> {
        if self.morph.r2 == 0.0 {
            return vec![self.morph.center];
        }
        let stretches = self.stretches();
        let mut points = Vec::new();
        for stretch in &stretches {
            if stretch.straight {
                points.push(self.point(stretch.from, 0.0));
                points.extend(stretch.to.is_finite().then(|| self.point(stretch.to, 0.0)));
            } else {
                self.flatten(stretch, tolerance, &mut points);
            }
        }
        points.dedup();
        match (self.end(), stretches.is_empty()) {
            _ if self.beside == 0.0 => points.push(self.morph.user),
            (Some((_, from_center)), true) => points.push(self.last(from_center)),
            _ => {}
        }
        points
    }
}

/// The horizontal part.
pub(crate) fn on_ground(p: DVec3) -> DVec2 {
    DVec2::new(p.x, p.z)
}

/// The part of a ray inside an upright cylinder, in units of its direction; its start is given relative to the axis.
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
    // Both roots in the form that does not cancel.
    let q = -(b + discriminant.sqrt().copysign(b));
    let (one, other) = if q == 0.0 { (0.0, 0.0) } else { (q / a, c / q) };
    let (enter, leave) = (one.min(other), one.max(other));
    (leave >= 0.0).then_some((enter.max(0.0), leave))
}
