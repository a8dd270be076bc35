//! Edge-splitting rule for `Kind::Cylinder`, for all radii and strengths while the morph grows.

use glam::{DVec2, DVec3};

use super::edge::{Cut, crossing, segment_distance, weights_of_axis};
use super::grown_bound::{
    MAX_FAR_LENGTH, MAX_FAR_SPREAD, MAX_LENGTH, MAX_RATIO, MAX_SPREAD, Measure, Region, allowed_error,
};
use super::settings::{Precision, Settings};
use crate::base::{Result, ensure};

/// Fraction of the error for the range of ρ along edges; the rest is for their lengths. The number of pieces per area
/// is minimal for 2/3 if the first part is proportional to the range, and for ½ if it is proportional to its square;
/// the second part is proportional to a squared length.
const RANGE_FRACTION: f64 = 0.6;
/// Fraction of r₁ within which pieces are as long as at its border, if points within r₁ move. Otherwise there would be
/// ever shorter pieces towards the axis.
const CENTRE_FRACTION: f64 = 1.0 / 64.0;
/// Minimum edge length if there is no bound, as a fraction of r₂ − r₁ (of r₂ if points within r₁ move) and of the
/// minimum distance for which there is a bound.
const MIN_UNBOUNDED_EDGE: f64 = 1.0 / 64.0;
/// Spacing of two bands relative to the maximum range between them. The rest is for edges across the radius, which
/// bulge over a band.
const BAND_SPACING: f64 = 0.9;
/// Minimum (r₂ − r₁)/r₂ for which there is a bound.
const MIN_WIDTH: f64 = 1.0 / 4096.0;
/// Minimum distance of a cut at a band from the ends of an edge, relative to the maximum range. Half of an edge with
/// too large a range is longer.
const BAND_MARGIN: f64 = 0.25;
const MAX_BANDS: usize = 1 << 16;
/// Minimum length of harmless edges relative to the minimum distance for which there is a bound. Finer pieces would not
/// fit into memory.
const MIN_HARMLESS_LENGTH: f64 = 1.0 / (1 << 20) as f64;
/// Maximum sag of edges between two points of r₁, relative to r₁: h²/(8 r₁²) for h = r₁/8.
const MAX_SAG: f64 = 0.003;

/// Radius beyond which edges are not split, relative to the drawn radius. A triangle with a drawn point has no such
/// edge if its other edges are no longer than an eighth of their distance.
const OUTER_FACTOR: f64 = 1.25;

/// Rule for one centre, region of users and tolerance.
#[derive(Clone, Debug)]
pub(super) struct CylinderRule {
    settings: Settings,
    region: Region,
    /// Radii at which edges are cut, metres.
    kinks: Vec<f64>,
    /// Radii at which edges with too large a range of ρ are cut, metres, ascending.
    bands: Vec<f64>,
    /// Minimum r₁, metres.
    inner: f64,
    /// Radius within which nothing moves, metres; 0 if all strengths count.
    still_radius: f64,
    /// Minimum distance from the axis at which edges are measured, metres.
    min_rho: f64,
    /// Maximum sum of an edge's error terms.
    allowed_error: f64,
    /// Lengths below which edges are not split, metres: where there is a bound, and where there is none.
    min_edge: f64,
    min_unbounded_edge: f64,
    /// Metres by which a vertex on a radius may miss it.
    rounding: f64,
    /// Length up to which no edge needs a split, wherever it lies, metres.
    harmless_length: f64,
    /// Whether the slope of w between the radii is bounded.
    is_wide: bool,
    /// Whether it is bounded and the coordinates are precise enough for the tolerance.
    is_fine: bool,
}

impl CylinderRule {
    /// Creates the rule for checked settings, all radii from `min_radius` to r₂, and full strength or all strengths.
    pub fn new(settings: &Settings, min_radius: f64, is_full: bool, precision: Precision) -> Self {
        let Settings { r1, r2, reach, tolerance, .. } = *settings;
        let near = if r2 > 0.0 { r1 / r2 } else { 0.0 };
        let is_cut = min_radius == r2;
        let is_wide = r2 - r1 >= r2 * MIN_WIDTH;
        let inner = near * min_radius;
        let still_radius = if is_full { inner } else { 0.0 };
        let kinks = if is_cut { vec![r1, r2] } else { vec![inner] };
        let region = Region { reach, near, radii: [min_radius, r2], is_cut };
        let min_rho = (reach / MAX_RATIO).max(if still_radius > 0.0 {
            still_radius * (1.0 - MAX_SAG)
        } else {
            inner.max(r2 / 2.0) * CENTRE_FRACTION
        });
        let rounding = settings.rounding(precision);
        let min_edge = 4.0 * rounding;
        // Vertices that miss a kink, and edges that are too short to be cut there, pass it by at most `min_edge`.
        let passing =
            if min_rho > reach { 2.0 * min_edge * region.slope(min_rho) * reach / (min_rho - reach) } else { 0.0 };
        let mut rule = Self {
            settings: *settings,
            region,
            kinks: kinks.into_iter().filter(|&kink| kink > 0.0).collect(),
            bands: Vec::new(),
            inner,
            still_radius,
            min_rho,
            allowed_error: (allowed_error(tolerance) - passing).max(tolerance / 2.0),
            min_edge,
            min_unbounded_edge: min_edge.max((r2 - still_radius).max(min_rho) * MIN_UNBOUNDED_EDGE),
            rounding,
            harmless_length: f64::INFINITY,
            is_wide,
            is_fine: is_wide && passing < tolerance / 4.0,
        };
        if reach > 0.0 {
            let anywhere = Region { is_cut: false, ..region }.measure(min_rho, min_rho, false);
            let longest = 1.0 / rule.parts_by_range(&anywhere, 1.0).max(rule.parts_by_length(&anywhere, 1.0, 1.0));
            rule.harmless_length = longest.min(MAX_LENGTH * min_rho);
            rule.is_fine &= rule.harmless_length > min_edge.max(min_rho * MIN_HARMLESS_LENGTH);
            rule.bands = if is_cut { Vec::new() } else { rule.bands_from(inner.max(min_rho)) };
        }
        rule
    }

    /// Returns where an edge crosses a band: of several bands, the one whose number has the most factors of two. So the
    /// edges of a triangle are cut at the same band, and the edge between the cuts lies along it. Bands close to an end
    /// are skipped, because they would cut off slivers.
    fn band_at(&self, p: DVec2, q: DVec2, max_range: f64, end_margin: f64) -> Option<f64> {
        let margin = self.rounding.max(max_range * BAND_MARGIN);
        let (nearest, farthest) = (segment_distance(p, q) + margin, p.length().max(q.length()) - margin);
        let [before, last] = [nearest, farthest].map(|rho| self.bands.partition_point(|&band| band < rho));
        if last <= before {
            return None;
        }
        let power = (before ^ last).ilog2();
        let number = last >> power << power;
        crossing(p, q, &[self.bands[number - 1]], end_margin)
    }

    /// Returns radii from `first` to r₂, between which the range of ρ is small enough for all edges.
    fn bands_from(&self, first: f64) -> Vec<f64> {
        let mut bands = vec![first];
        let mut rho = first;
        while rho < self.settings.r2 && bands.len() < MAX_BANDS {
            let near = (rho / MAX_SPREAD).max(self.min_rho);
            let measure = self.region.measure(near, near, false);
            rho += BAND_SPACING / self.parts_by_range(&measure, 1.0).max(1e-9);
            bands.push(rho);
        }
        bands
    }

    /// Returns the bound for all triangles with an edge.
    fn measure(&self, edge: &Extent) -> Measure {
        let far = self.far();
        // The points of a triangle with an edge at the longer limit lie beyond far/SPREAD.
        let rho = if edge.nearest >= far {
            (edge.nearest / (1.0 + MAX_FAR_LENGTH)).max(far / MAX_SPREAD)
        } else {
            (edge.nearest / MAX_SPREAD).max(self.min_rho)
        };
        let min_distance = edge.distance / if edge.farthest >= far { MAX_FAR_SPREAD } else { MAX_SPREAD };
        self.region.measure(rho, min_distance.max(rho), edge.is_flat)
    }

    /// Returns the distance from the axis beyond which edges may be longer: their triangles lie beyond r₂.
    fn far(&self) -> f64 {
        self.region.radii[1].max(self.min_rho) * (1.0 + MAX_FAR_LENGTH)
    }

    /// Returns the minimum number of parts that an edge's h and ℓ require, before rounding up.
    fn parts_by_extent(&self, measure: &Measure, edge: &Extent) -> f64 {
        let max_ratio = if edge.nearest >= self.far() { MAX_FAR_LENGTH } else { MAX_LENGTH };
        let ratio =
            (edge.horizontal / edge.nearest.max(self.min_rho)).max(edge.length / edge.distance.max(self.min_rho));
        self.parts_by_length(measure, edge.horizontal, edge.length).max(ratio / max_ratio)
    }

    /// Returns the minimum number of parts that keeps an edge with these h and ℓ within the bound.
    fn parts_by_length(&self, measure: &Measure, horizontal: f64, length: f64) -> f64 {
        // Without terms for the range of ρ, the whole error is available for lengths.
        let fraction = if measure.range == [0.0; 2] { 1.0 } else { 1.0 - RANGE_FRACTION };
        let error = measure.length[0] * horizontal * horizontal + measure.length[1] * length * length;
        let [_, max_horizontal, max_length] = measure.limits;
        (error / (self.allowed_error * fraction)).sqrt().max(horizontal / max_horizontal).max(length / max_length)
    }

    /// Returns the minimum number of parts that an edge with this c requires.
    fn parts_by_range(&self, measure: &Measure, range: f64) -> f64 {
        let [first, second] = measure.range;
        let allowed_error = self.allowed_error * RANGE_FRACTION;
        // The number of parts n for which first/n + second/n² is within the fraction.
        let (linear, quadratic) = (first * range / allowed_error, second * range * range / allowed_error);
        ((linear + (linear * linear + 4.0 * quadratic).sqrt()) / 2.0).max(range / measure.limits[0])
    }

    pub fn holds(&self) -> bool {
        let is_clear = self.still_radius > 0.0 && self.min_rho < self.still_radius;
        self.settings.reach == 0.0 || self.is_fine && is_clear
    }

    pub fn require_bound(&self) -> Result<()> {
        let Settings { r1, r2, reach, tolerance, .. } = self.settings;
        let inner = self.region.near * self.region.radii[0];
        let max_reach = MAX_RATIO * (1.0 - MAX_SAG) * inner;
        let expected =
            format!("users within {max_reach:.3} m of the centre, half of the minimum r1, where the error has a bound");
        ensure!(reach <= max_reach, "user_region", expected, format!("{reach} m"));
        ensure!(self.is_wide, "r1", format!("a radius of at most {}", r2 * (1.0 - MIN_WIDTH)), r1);
        let expected = "a tolerance that pieces of a millionth of the minimum r1 and the coordinates' digits reach";
        ensure!(self.is_fine, "tolerance_px", expected, format!("{tolerance:e} radians"));
        Ok(())
    }

    pub fn harmless_length(&self) -> f64 {
        self.harmless_length
    }

    pub fn outer(&self) -> f64 {
        OUTER_FACTOR * self.settings.drawn
    }

    pub fn is_within(&self, rho: f64) -> bool {
        rho < self.still_radius - self.rounding
    }

    /// Returns the axis if a triangle contains it and all edges lie beyond the drawn radius.
    pub fn inner_split_point(&self, corners: &[DVec3; 3]) -> Option<[f64; 3]> {
        let p = corners.map(|corner| self.settings.on_ground(corner));
        let is_far = self.settings.reach > 0.0 && p.iter().all(|p| p.length() >= self.outer());
        if is_far { weights_of_axis(p) } else { None }
    }

    /// Returns where an edge is split. Parts of an edge that is left whole are left whole, because all measures of a
    /// part are smaller.
    pub fn cut(&self, a: DVec3, b: DVec3) -> Option<Cut> {
        let center = self.settings.center;
        let (p, q) = (self.settings.on_ground(a), self.settings.on_ground(b));
        let (min_rho, max_rho) = (p.length().min(q.length()), p.length().max(q.length()));
        let length = (b - a).length();
        let is_short = length <= self.min_edge.max(1e-14 * a.abs().max(b.abs()).max_element());
        if is_short || self.settings.reach == 0.0 {
            return None;
        }
        let nearest = segment_distance(p, q);
        let is_still = max_rho <= self.still_radius + self.rounding && min_rho < self.still_radius - self.rounding;
        if is_still || nearest >= self.outer() {
            return None;
        }
        let extent = Extent {
            nearest,
            farthest: max_rho,
            distance: distance(a - center, b - center),
            horizontal: (q - p).length(),
            length,
            is_flat: self.region.radii[0] > 0.0
                && max_rho <= self.inner + self.rounding
                && min_rho < self.inner - self.rounding,
        };
        let measure = self.measure(&extent);
        let parts_by_range = self.parts_by_range(&measure, max_rho - nearest);
        // High above the centre, the bound allows pieces that are higher than wide. If edges were compared in metres,
        // such a piece would be split in height first.
        let tall = (nearest.max(self.min_rho) / extent.distance.max(self.min_rho)).min(1.0);
        let size = extent.horizontal.hypot((b.y - a.y) * tall);
        let cut_at = |fraction: f64| Some(Cut { fraction, size });
        let is_across = |kink: &f64| min_rho < kink - self.rounding && max_rho > kink + self.rounding;
        if let Some(&kink) = self.kinks.iter().find(|kink| is_across(kink)) {
            return cut_at(crossing(p, q, &[kink], f64::EPSILON).unwrap_or(0.5));
        }
        let is_bounded = self.is_fine && nearest >= self.min_rho;
        let min_edge = if is_bounded { self.min_edge } else { self.min_unbounded_edge };
        if parts_by_range > 1.0
            && length >= 2.0 * min_edge
            && let Some(fraction) = self.band_at(p, q, (max_rho - nearest) / parts_by_range, min_edge / length)
        {
            return cut_at(fraction);
        }
        let parts = (parts_by_range.max(self.parts_by_extent(&measure, &extent)) * (1.0 - 1e-9))
            .ceil()
            .min((length / min_edge).floor())
            .min(1e9);
        if parts >= 2.0 { cut_at((parts / 2.0).floor() / parts) } else { None }
    }
}

/// Measures of an edge that the bound needs, metres.
struct Extent {
    /// Minimum and maximum distance from the axis.
    nearest: f64,
    farthest: f64,
    /// Minimum distance from the centre.
    distance: f64,
    horizontal: f64,
    length: f64,
    /// Whether all triangles at the edge lie within the minimum r₁.
    is_flat: bool,
}

/// Returns the distance of the origin from a segment.
fn distance(a: DVec3, b: DVec3) -> f64 {
    let d = b - a;
    let squared = d.length_squared();
    let fraction = if squared > 0.0 { (-a.dot(d) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (a + d * fraction).length()
}
