//! The rule that splits edges. It depends on the two ends of an edge alone, so all triangles at an edge split it alike.

use glam::{DVec2, DVec3};

use super::bound::{Form, LEAST_CLEARANCE, RadialZone};
use crate::base::{Error, Result};
use crate::morph::{Kind, Morph};

/// The cylinders and the region of users for which surfaces are split.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// The centre O, in the frame of the points.
    pub center: DVec3,
    /// r₁, metres: points inside are not moved.
    pub r1: f64,
    /// r₂, metres: for points outside, the weight w of the user's view is 0.
    pub r2: f64,
    /// Radius up to which surfaces are drawn, metres; at least r₂.
    pub drawn: f64,
    /// Greatest distance of a user from the centre, metres.
    pub reach: f64,
    /// Greatest error in radians as the user sees it.
    pub tolerance: f64,
    /// Kind of the morph. For `Kind::Cylinder` the error is an estimate, not a bound.
    pub kind: Kind,
}

/// Radius from which on a morph bends triangles: r₁, or 0 if points within r₁ move too.
pub fn bent_from(morph: &Morph) -> f64 {
    if morph.strength < 1.0 { 0.0 } else { morph.r1 }
}

impl Settings {
    /// For one morph. Where it bends triangles from the axis on, w falls over r₂ − r₁ nonetheless, and the tolerance is
    /// smaller in proportion.
    pub fn of(morph: &Morph, drawn: f64, reach: f64, tolerance: f64) -> Self {
        let Morph { center, r2, kind, .. } = *morph;
        let r1 = bent_from(morph);
        let share = if r2 > r1 { (r2 - morph.r1) / (r2 - r1) } else { 1.0 };
        Self { center, r1, r2, drawn, reach, tolerance: tolerance * share, kind }
    }
}

/// Floating-point type to which the coordinates of new vertices are rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// float32.
    Single,
    /// float64.
    Double,
}

impl Precision {
    /// A point rounded to this type.
    pub fn round(self, p: DVec3) -> DVec3 {
        match self {
            Self::Single => p.as_vec3().as_dvec3(),
            Self::Double => p,
        }
    }

    fn step(self) -> f64 {
        match self {
            Self::Single => f64::from(f32::EPSILON),
            Self::Double => f64::EPSILON,
        }
    }
}

/// Share of the tolerance for points of triangles outside r₁ that lie inside it. A greater share gives fewer triangles
/// along r₁ and more triangles elsewhere near it. Edges that these shares leave whole must be short enough for the
/// rest, because 4/3 of the sum of this share and the next stays below the tolerance.
const PASSING_R1: f64 = 0.25;
/// Share of the tolerance for vertices of triangles inside r₁ that lie outside it.
const MISSING_R1: f64 = 0.05;
/// Share of the tolerance for triangles beyond r₂ that reach inside it; 4/3 of it is below 1.
const PASSING_R2: f64 = 0.7;
/// Greatest edge length between the radii as a share of the longest edge that any form allows. Its value, like that of
/// PASSING_R1, was chosen by measurement.
const LONGEST: f64 = 0.7;
/// Number of distances for which a form is stored; a distance between two is rounded towards the axis.
const RINGS: usize = 64;
/// Shares of r₂ − r₁ below which edges are not split: the first if the tolerance is a bound, the second otherwise. The
/// first is also the least (r₂ − r₁)/r₂ for which there is a bound.
const SHORTEST: f64 = 1.0 / 4096.0;
const COARSEST: f64 = 1.0 / 64.0;
/// Greatest angle in radians, as seen from the axis, of an edge beyond r₂ with `Kind::Cylinder`. It is shown in its true
/// direction, but the distances of points between its ends are off by an eighth of the square of the angle times
/// |U−O|: 2 cm for 8 m.
const FAR_TURN: f64 = 0.125;
/// Least distance from the axis at which such edges are measured, as a share of the radius up to which they are drawn.
const FAR_LEAST: f64 = 1.0 / 64.0;

/// The rule for one centre, region of users and tolerance.
#[derive(Clone, Debug)]
pub struct Rule {
    settings: Settings,
    /// Forms by distance from the axis, from r₁ outwards, and the distance between two of them in metres.
    forms: Vec<Form>,
    ring: f64,
    /// Greatest horizontal length of an edge between the radii, metres; the forms hold up to it.
    longest: f64,
    /// Length below which edges are not halved, metres.
    shortest: f64,
    /// Metres by which points of a triangle outside r₁ may lie inside it, and vertices of a triangle inside may lie
    /// outside it.
    passing_r1: f64,
    missing_r1: f64,
    /// Metres by which points and vertices of a triangle beyond r₂ may lie inside it.
    passing_r2: f64,
    /// Length up to which no edge needs a split, wherever it lies, metres.
    harmless: f64,
    /// Metres by which a vertex on a radius may miss it: rounding, and the sag of edges that are too short to be split.
    rounding: f64,
    holds: bool,
}

impl Rule {
    /// Checks the settings and computes the forms.
    pub fn new(settings: &Settings, precision: Precision) -> Result<Self> {
        let Settings { center, r1, r2, reach, tolerance, kind, .. } = *settings;
        if !center.is_finite() {
            return Err(Error::value("center", "three finite numbers", center));
        }
        if !(r1.is_finite() && r1 >= 0.0) {
            return Err(Error::value("r1", "a finite radius of at least 0", r1));
        }
        if !(r2.is_finite() && r2 >= r1) {
            return Err(Error::value("r2", format!("a finite radius of at least r1 = {r1}"), r2));
        }
        if !(reach.is_finite() && reach >= 0.0) {
            return Err(Error::value("user_region", "a finite distance from the centre", reach));
        }
        if !(tolerance.is_finite() && tolerance > 0.0) {
            return Err(Error::value("tolerance_px", "a number above 0", tolerance));
        }
        if r2 == 0.0 {
            return Ok(Self::of_nothing_near(settings));
        }
        let width = r2 - r1;
        let zone = RadialZone { reach, width, kind };
        let rounding = (center.abs().max_element() + r2) * precision.step() * 2.0;
        // At most a hundredth of the width: the forms extend that far into the other zones.
        let passing = |share: f64, rho: f64| (share * tolerance / zone.slope(rho)).min(width / 100.0).max(rounding);
        let [passing_r1, missing_r1, passing_r2] =
            [passing(PASSING_R1, r1), passing(MISSING_R1, r1), passing(PASSING_R2, r2)];
        let least = r1 - passing_r1;
        let pitch = |form: f64| (6.0 * tolerance / form).sqrt();
        let narrowest = zone.form(least, 0.5);
        let finest = (width * SHORTEST).max(4.0 * rounding);
        let holds = zone.holds(least)
            && width >= r2 * SHORTEST
            && tolerance * MISSING_R1 >= zone.slope(least) * rounding
            && pitch(narrowest.across + narrowest.any) * (1.0 - PASSING_R1).sqrt() > finest;
        let shortest = if holds { finest } else { finest.max(width * COARSEST).max(r2 / 1024.0) };
        let mut rule = Self {
            settings: *settings,
            forms: Vec::new(),
            ring: width / RINGS as f64,
            longest: 0.0,
            shortest,
            passing_r1,
            missing_r1,
            passing_r2,
            // A chord across a kink has an error of the change of slope times a quarter of its length; it may cross
            // both kinks.
            harmless: pitch(narrowest.across + narrowest.along + narrowest.any)
                .min(2.0 * tolerance / zone.slope(least)),
            rounding: rounding.max(shortest * shortest / (2.0 * r1.max(width))),
            holds: holds && kind == Kind::Blend,
        };
        // A share of the longest edges that any form allows. The shorter these are, the closer to an edge is the
        // distance at which its form is taken.
        let widest = zone.form(r2, 0.0);
        rule.longest = (LONGEST * pitch(widest.along + widest.any)).min(width / 2.0).min(r1 / 2.0);
        rule.longest = rule.longest.max(4.0 * shortest);
        rule.forms = (0..=RINGS)
            .map(|ring| {
                let rho = (least + ring as f64 * rule.ring).max(f64::MIN_POSITIVE);
                zone.form(rho, (rule.longest / rho).min(1.0))
            })
            .collect();
        Ok(rule)
    }

    /// The rule for r₂ = 0: every point is shown as the centre sees it.
    fn of_nothing_near(settings: &Settings) -> Self {
        let is_blend = settings.kind == Kind::Blend;
        Self {
            settings: *settings,
            forms: Vec::new(),
            ring: 0.0,
            longest: 0.0,
            shortest: 0.0,
            passing_r1: 0.0,
            missing_r1: 0.0,
            passing_r2: 0.0,
            harmless: if is_blend { f64::INFINITY } else { FAR_TURN * FAR_LEAST * settings.drawn },
            rounding: 0.0,
            holds: is_blend,
        }
    }

    /// Whether the tolerance is a bound for every user of the region: they stay well inside r₁, and the tolerance is
    /// not below the resolution of the coordinates.
    pub fn holds(&self) -> bool {
        self.holds
    }

    /// Fails if the tolerance is not a bound.
    pub fn demand(&self) -> Result<()> {
        let Settings { r1, reach, kind, .. } = self.settings;
        let greatest = (1.0 - LEAST_CLEARANCE) * (r1 - self.passing_r1);
        if kind == Kind::Blend && reach >= greatest {
            let expected =
                format!("users within {greatest:.3} m of the centre, 0.6 of r1, where the error has a bound");
            return Err(Error::value("user_region", expected, format!("{reach} m")));
        }
        if !self.holds {
            let expected =
                "a tolerance that triangles of a few thousandths of r2 - r1 and the coordinates' digits reach";
            return Err(Error::value("tolerance_px", expected, format!("{:e} radians", self.settings.tolerance)));
        }
        Ok(())
    }

    /// Length up to which edges have an error below the tolerance wherever they lie, also across the radii.
    pub fn harmless(&self) -> f64 {
        self.harmless
    }

    /// The settings of this rule.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Share of the way from a to b at which their edge is split. The caller must order the ends of an edge
    /// consistently.
    ///
    /// If an edge is left whole, each part of it must be left whole as well; otherwise thin triangles would be split
    /// for ever.
    pub(super) fn share(&self, a: DVec3, b: DVec3) -> Option<f64> {
        let Settings { r1, r2, .. } = self.settings;
        let (p, q) = (self.on_ground(a), self.on_ground(b));
        let (least, greatest) = (p.length().min(q.length()), p.length().max(q.length()));
        let length = (b - a).length();
        if length <= self.shortest.max(1e-14 * a.abs().max(b.abs()).max_element()) {
            return None;
        }
        let (nearest, room) = (segment_distance(p, q), self.shortest / length);
        if greatest <= r1 + self.missing_r1 {
            // Both ends on r₁: the triangle beyond is displayed as if it ended at this edge.
            return (least >= r1 - self.rounding && nearest < r1 - self.passing_r1).then_some(0.5);
        }
        if least >= r2 - self.passing_r2 {
            if nearest < r2 - self.passing_r2 {
                return Some(crossing(p, q, &[r2], room).unwrap_or(0.5));
            }
            return self.far_share((q - p).length(), nearest);
        }
        if least < r1 - self.rounding || greatest > r2 + self.rounding {
            return Some(crossing(p, q, &[r1, r2], f64::EPSILON).unwrap_or(0.5));
        }
        if nearest < r1 - self.rounding
            && let Some(share) = crossing(p, q, &[r1], room)
        {
            return Some(share);
        }
        // The edge consists of equal parts and is split at the end of a part that is nearest to its middle.
        let parts = self.parts(p, q, a.y - b.y, nearest);
        (parts >= 2.0).then(|| (parts / 2.0).floor() / parts)
    }

    /// Share at which an edge beyond r₂ is split: a blend moves all of it alike, a cylinder by its direction.
    fn far_share(&self, length: f64, nearest: f64) -> Option<f64> {
        let Settings { drawn, kind, .. } = self.settings;
        if kind == Kind::Blend || nearest >= drawn {
            return None;
        }
        let parts = (length / (FAR_TURN * nearest.max(FAR_LEAST * drawn))).ceil();
        (parts >= 2.0).then(|| (parts / 2.0).floor() / parts)
    }

    /// Radius beyond which no edge is split.
    pub(super) fn outer(&self) -> f64 {
        let Settings { r2, drawn, kind, .. } = self.settings;
        if kind == Kind::Cylinder { drawn } else { r2 }
    }

    /// Number of parts into which an edge between the radii is to be split.
    fn parts(&self, p: DVec2, q: DVec2, height: f64, nearest: f64) -> f64 {
        let Settings { r1, tolerance, .. } = self.settings;
        let (edge, middle) = (q - p, (p + q) / 2.0);
        let least = nearest - self.longest;
        let ring = ((least - (r1 - self.passing_r1)) / self.ring).max(0.0) as usize;
        let form = self.forms[ring.min(self.forms.len() - 1)];
        let horizontal = edge.length_squared();
        let along = edge.dot(middle.normalize_or_zero()).powi(2);
        let across = (horizontal - along).max(0.0);
        let value = form.across * across + form.along * along + form.any * (horizontal + height * height);
        let share = if least < r1 { 1.0 - PASSING_R1 - MISSING_R1 } else { 1.0 };
        let parts = (value / (6.0 * tolerance * share)).sqrt().max(horizontal.sqrt() / self.longest);
        let fewest = ((horizontal + height * height).sqrt() / self.shortest).min(1e9);
        (parts * (1.0 - 1e-9)).ceil().min(fewest.floor())
    }

    /// A point at which a triangle must be split although none of its edges is: the triangle contains the whole
    /// cylinder.
    pub(super) fn inside(&self, corners: &[DVec3; 3]) -> Option<[f64; 3]> {
        if self.settings.r2 == 0.0 {
            return None;
        }
        let [a, b, c] = corners.map(|corner| self.on_ground(corner));
        if [a, b, c].iter().any(|p| p.length() < self.settings.r2 - self.passing_r2) {
            return None;
        }
        let areas = [b.perp_dot(c), c.perp_dot(a), a.perp_dot(b)];
        let whole = areas[0] + areas[1] + areas[2];
        let weights = areas.map(|area| area / whole);
        weights.iter().all(|&weight| weight > 0.0).then_some(weights)
    }

    /// Whether a triangle needs no examination: by its box and corners, no point of it lies where edges are split.
    pub(super) fn leaves_alone(&self, corners: &[DVec3; 3]) -> bool {
        let p = corners.map(|corner| self.on_ground(corner));
        let (low, high) = (p[0].min(p[1]).min(p[2]), p[0].max(p[1]).max(p[2]));
        low.max(-high).max(DVec2::ZERO).length() >= self.outer() || p.iter().all(|p| self.is_within(p.length()))
    }

    /// Whether a distance from the axis is less than that of any end of a split edge. Edges between two points of r₁
    /// are split too.
    pub(super) fn is_within(&self, rho: f64) -> bool {
        rho < self.settings.r1 - self.rounding
    }

    /// Whether no point of a triangle is drawn, by a separating line.
    pub fn is_beyond(&self, corners: &[DVec3; 3]) -> bool {
        let drawn = self.settings.drawn;
        let p = corners.map(|corner| self.on_ground(corner));
        let beyond = |axis: DVec2| p.iter().all(|p| p.dot(axis) > drawn);
        // The directions of the corners, and of the edges' normals.
        let normal = |a: DVec2, b: DVec2| {
            let n = (b - a).perp().normalize_or_zero();
            if n.dot(a) < 0.0 { -n } else { n }
        };
        p.iter().any(|p| beyond(p.normalize_or_zero()))
            || [(p[0], p[1]), (p[1], p[2]), (p[2], p[0])].into_iter().any(|(a, b)| beyond(normal(a, b)))
    }

    pub(super) fn on_ground(&self, p: DVec3) -> DVec2 {
        DVec2::new(p.x - self.settings.center.x, p.z - self.settings.center.z)
    }
}

/// Distance of the axis from a segment in the ground plane.
fn segment_distance(p: DVec2, q: DVec2) -> f64 {
    let d = q - p;
    let squared = d.length_squared();
    let share = if squared > 0.0 { (-p.dot(d) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (p + d * share).length()
}

/// Share of the way from p to q at which their segment crosses one of the radii: the crossing nearest to the middle.
/// `None` if there is no crossing or all lie within `room` of the ends.
fn crossing(p: DVec2, q: DVec2, radii: &[f64], room: f64) -> Option<f64> {
    let d = q - p;
    let (squared, along) = (d.length_squared(), p.dot(d));
    let roots = radii.iter().flat_map(|&radius| {
        let root = (along * along - squared * (p.length_squared() - radius * radius)).sqrt();
        [(-along - root) / squared, (-along + root) / squared]
    });
    // A share is NaN if the edge misses a cylinder or is vertical; NaN lies in no range.
    roots
        .filter(|share| (room..=1.0 - room).contains(share))
        .min_by(|a, b| (a - 0.5).abs().total_cmp(&(b - 0.5).abs()).then(a.total_cmp(b)))
}
