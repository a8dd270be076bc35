//! Edge-splitting rule for `Kind::Blend`.

use glam::{DVec2, DVec3};

use super::bound::{Form, MIN_CLEARANCE, RadialZone};
use super::edge::{Cut, crossing, segment_distance, weights_of_axis};
use super::settings::{Precision, Settings};
use crate::base::{Result, ensure};

/// Fraction of the tolerance for points inside r₁ of triangles outside it. A larger fraction gives fewer triangles
/// along r₁ and more elsewhere near it. The lengths of edges get the rest of the tolerance; 4/3 of the sum of this
/// fraction and the next must be below 1.
const PASSING_R1: f64 = 0.25;
/// Fraction of the tolerance for vertices outside r₁ of triangles inside it.
const MISSING_R1: f64 = 0.05;
/// Fraction of the tolerance for triangles beyond r₂ that reach inside it; 4/3 of it is below 1.
const PASSING_R2: f64 = 0.7;
/// Maximum edge length between the radii, relative to the longest edge that any form allows. This value, like
/// PASSING_R1, was chosen by measurement.
const MAX_EDGE_FRACTION: f64 = 0.7;
/// Number of intervals between the distances for which a form is stored. Other distances are rounded towards the axis.
const FORM_INTERVALS: usize = 64;
/// Edge lengths, relative to r₂ − r₁, below which edges are not split if the tolerance is a bound, and otherwise. The
/// first is also the minimum (r₂ − r₁)/r₂ for which there is a bound.
const MIN_BOUNDED_EDGE: f64 = 1.0 / 4096.0;
const MIN_UNBOUNDED_EDGE: f64 = 1.0 / 64.0;

/// Rule for one centre, region of users and tolerance.
#[derive(Clone, Debug, Default)]
pub(super) struct BlendRule {
    settings: Settings,
    /// Forms by distance from the axis, from r₁ outwards.
    forms: Vec<Form>,
    /// Spacing of these distances, metres.
    interval: f64,
    /// Maximum horizontal length of an edge between the radii, metres; the forms hold up to it.
    max_edge: f64,
    /// Length below which edges are not halved, metres.
    min_edge: f64,
    /// Metres by which points of a triangle outside r₁ may lie inside r₁, and vertices of one inside r₁ outside it.
    passing_r1: f64,
    missing_r1: f64,
    /// Metres by which points and vertices of a triangle beyond r₂ may lie inside it.
    passing_r2: f64,
    /// Length up to which no edge needs a split, wherever it lies, metres.
    harmless_length: f64,
    /// Metres by which a vertex on a radius may miss it: rounding, and the sag of edges too short to be split.
    rounding: f64,
    holds: bool,
}

impl BlendRule {
    /// Computes the forms for settings that have been checked.
    pub fn new(settings: &Settings, precision: Precision) -> Self {
        let Settings { r1, r2, reach, tolerance, .. } = *settings;
        if r2 == 0.0 {
            // Every point is shown as the centre sees it.
            return Self { settings: *settings, harmless_length: f64::INFINITY, holds: true, ..Self::default() };
        }
        let width = r2 - r1;
        let zone = RadialZone { reach, width };
        let rounding = settings.rounding(precision);
        // At most a hundredth of the width, because the forms extend only that far into the other zones.
        let passing =
            |fraction: f64, rho: f64| (fraction * tolerance / zone.slope(rho)).min(width / 100.0).max(rounding);
        let [passing_r1, missing_r1, passing_r2] =
            [passing(PASSING_R1, r1), passing(MISSING_R1, r1), passing(PASSING_R2, r2)];
        let min_rho = r1 - passing_r1;
        let longest_edge = |form: f64| (6.0 * tolerance / form).sqrt();
        let narrowest = zone.form(min_rho, 0.5);
        let finest = (width * MIN_BOUNDED_EDGE).max(4.0 * rounding);
        let holds = zone.holds(min_rho)
            && width >= r2 * MIN_BOUNDED_EDGE
            && tolerance * MISSING_R1 >= zone.slope(min_rho) * rounding
            && longest_edge(narrowest.across + narrowest.any) * (1.0 - PASSING_R1).sqrt() > finest;
        let min_edge = if holds { finest } else { finest.max(width * MIN_UNBOUNDED_EDGE).max(r2 / 1024.0) };
        let mut rule = Self {
            settings: *settings,
            forms: Vec::new(),
            interval: width / FORM_INTERVALS as f64,
            max_edge: 0.0,
            min_edge,
            passing_r1,
            missing_r1,
            passing_r2,
            // A chord across a kink has an error of the change of slope times a quarter of its length; it may cross
            // both kinks.
            harmless_length: longest_edge(narrowest.across + narrowest.along + narrowest.any)
                .min(2.0 * tolerance / zone.slope(min_rho)),
            rounding: rounding.max(min_edge * min_edge / (2.0 * r1.max(width))),
            holds,
        };
        // A fraction of the longest edges that any form allows: the shorter edges are, the closer to an edge is the
        // distance at which its form is evaluated.
        let widest = zone.form(r2, 0.0);
        rule.max_edge = (MAX_EDGE_FRACTION * longest_edge(widest.along + widest.any)).min(width / 2.0).min(r1 / 2.0);
        rule.max_edge = rule.max_edge.max(4.0 * min_edge);
        rule.forms = (0..=FORM_INTERVALS)
            .map(|interval| {
                let rho = (min_rho + interval as f64 * rule.interval).max(f64::MIN_POSITIVE);
                zone.form(rho, (rule.max_edge / rho).min(1.0))
            })
            .collect();
        rule
    }

    /// Returns the fraction of the way from a to b at which their edge is split, as `Rule::cut` requires.
    fn split_fraction(&self, a: DVec3, b: DVec3) -> Option<f64> {
        let Settings { r1, r2, .. } = self.settings;
        let (p, q) = (self.settings.on_ground(a), self.settings.on_ground(b));
        let (min_rho, max_rho) = (p.length().min(q.length()), p.length().max(q.length()));
        let length = (b - a).length();
        if length <= self.min_edge.max(1e-14 * a.abs().max(b.abs()).max_element()) {
            return None;
        }
        let (nearest, end_margin) = (segment_distance(p, q), self.min_edge / length);
        if max_rho <= r1 + self.missing_r1 {
            // With both ends on r₁, the triangle beyond is displayed as if it ended at this edge.
            return (min_rho >= r1 - self.rounding && nearest < r1 - self.passing_r1).then_some(0.5);
        }
        if min_rho >= r2 - self.passing_r2 {
            if nearest < r2 - self.passing_r2 {
                return Some(crossing(p, q, &[r2], end_margin).unwrap_or(0.5));
            }
            return None;
        }
        if min_rho < r1 - self.rounding || max_rho > r2 + self.rounding {
            return Some(crossing(p, q, &[r1, r2], f64::EPSILON).unwrap_or(0.5));
        }
        if nearest < r1 - self.rounding
            && let Some(fraction) = crossing(p, q, &[r1], end_margin)
        {
            return Some(fraction);
        }
        // Splits at the boundary between equal parts that is nearest to the middle.
        let parts = self.parts(p, q, a.y - b.y, nearest);
        (parts >= 2.0).then(|| (parts / 2.0).floor() / parts)
    }

    /// Returns the number of parts into which an edge between the radii is split.
    fn parts(&self, p: DVec2, q: DVec2, height: f64, nearest: f64) -> f64 {
        let Settings { r1, tolerance, .. } = self.settings;
        let (edge, middle) = (q - p, (p + q) / 2.0);
        let min_rho = nearest - self.max_edge;
        let interval = ((min_rho - (r1 - self.passing_r1)) / self.interval).max(0.0) as usize;
        let form = self.forms[interval.min(self.forms.len() - 1)];
        let horizontal = edge.length_squared();
        let along = edge.dot(middle.normalize_or_zero()).powi(2);
        let across = (horizontal - along).max(0.0);
        let value = form.across * across + form.along * along + form.any * (horizontal + height * height);
        let fraction = if min_rho < r1 { 1.0 - PASSING_R1 - MISSING_R1 } else { 1.0 };
        let parts = (value / (6.0 * tolerance * fraction)).sqrt().max(horizontal.sqrt() / self.max_edge);
        let max_parts = ((horizontal + height * height).sqrt() / self.min_edge).min(1e9);
        (parts * (1.0 - 1e-9)).ceil().min(max_parts.floor())
    }

    pub fn holds(&self) -> bool {
        self.holds
    }

    pub fn require_bound(&self) -> Result<()> {
        let Settings { r1, reach, tolerance, .. } = self.settings;
        let max_reach = (1.0 - MIN_CLEARANCE) * (r1 - self.passing_r1);
        let expected = format!("users within {max_reach:.3} m of the centre, 0.6 of r1, where the error has a bound");
        ensure!(reach < max_reach, "user_region", expected, format!("{reach} m"));
        let expected = "a tolerance that triangles of a few thousandths of r2 - r1 and the coordinates' digits reach";
        ensure!(self.holds, "tolerance_px", expected, format!("{tolerance:e} radians"));
        Ok(())
    }

    pub fn harmless_length(&self) -> f64 {
        self.harmless_length
    }

    pub fn cut(&self, a: DVec3, b: DVec3) -> Option<Cut> {
        self.split_fraction(a, b).map(|fraction| Cut { fraction, size: (b - a).length() })
    }

    pub fn inner_split_point(&self, corners: &[DVec3; 3]) -> Option<[f64; 3]> {
        if self.settings.r2 == 0.0 {
            return None;
        }
        let p = corners.map(|corner| self.settings.on_ground(corner));
        let is_far = p.iter().all(|p| p.length() >= self.settings.r2 - self.passing_r2);
        if is_far { weights_of_axis(p) } else { None }
    }

    pub fn outer(&self) -> f64 {
        self.settings.r2
    }

    pub fn is_within(&self, rho: f64) -> bool {
        rho < self.settings.r1 - self.rounding
    }
}
