//! Edge-splitting rule for `Kind::Cylinder`, for all radii of its growth.

use glam::{DVec2, DVec3};

use super::edge::{Cut, crossing, segment_distance, weights_of_axis};
use super::grown_bound::{
    MAX_FAR_LENGTH, MAX_FAR_SPREAD, MAX_LENGTH, MAX_RATIO, MAX_SPREAD, Measure, Region, allowed_error,
};
use super::settings::{Precision, Settings};
use crate::base::{Result, ensure};

/// Fraction of the error for the range of ρ along edges; the rest is for their lengths. The number of pieces per area
/// is minimal for 2/3 if the first part is proportional to a width and the second to a squared length, and for ½ if
/// both are proportional to squares.
const RANGE_FRACTION: f64 = 0.6;
/// Fraction of r₁ within which pieces stay as long as at its border, if points within r₁ move: shorter ones would be
/// endless.
const CENTRE_FRACTION: f64 = 1.0 / 64.0;
/// Minimum edge length if there is no bound, as a fraction of r₂ − r₁ (of r₂ if points within r₁ move) and of the
/// minimum distance for which there is a bound.
const MIN_UNBOUNDED_EDGE: f64 = 1.0 / 64.0;
/// Spacing of two bands relative to the maximum range between them: the rest is for edges across the radius, which
/// pass a band.
const BAND_SPACING: f64 = 0.9;
/// Minimum (r₂ − r₁)/r₂ for which there is a bound.
const MIN_WIDTH: f64 = 1.0 / 4096.0;
/// Minimum distance of a cut at a band from the ends of an edge, relative to the maximum range: half of an edge that
/// is too long to be left whole is longer.
const BAND_MARGIN: f64 = 0.25;
const MAX_BANDS: usize = 1 << 16;
/// Minimum length of harmless edges relative to the minimum distance for which there is a bound: finer pieces would
/// not fit into memory.
const MIN_HARMLESS_LENGTH: f64 = 1.0 / (1 << 20) as f64;
/// Maximum sag of edges between two points of r₁, relative to r₁: h²/(8 r₁²) for h = r₁/8.
const MAX_SAG: f64 = 0.003;

/// Radius beyond which edges are not split, relative to the drawn radius: no triangle with a drawn point has such an
/// edge, if its other edges are no longer than an eighth of their distance.
const OUTER_FACTOR: f64 = 1.25;

/// Rule for one centre, region of users and tolerance.
#[derive(Clone, Debug)]
pub(super) struct GrownRule {
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
    /// Lengths below which edges are not split, metres: anywhere, and nearer to the axis than `min_rho`.
    min_edge: f64,
    min_unbounded_edge: f64,
    /// Metres by which a vertex on a radius may miss it.
    rounding: f64,
    /// Length up to which no edge needs a split, wherever it lies, metres.
    harmless_length: f64,
    /// Whether the slope of w between the radii is bounded.
    is_wide: bool,
    /// Whether it is, and the coordinates are precise enough for the tolerance.
    is_fine: bool,
}

impl GrownRule {
    /// Creates the rule for checked settings, all radii from `least` to r₂, and full strength or all strengths.
    pub fn new(settings: &Settings, least: f64, is_full: bool, precision: Precision) -> Self {
        let Settings { r1, r2, reach, tolerance, .. } = *settings;
        let near = if r2 > 0.0 { r1 / r2 } else { 0.0 };
        let is_cut = least == r2;
        let is_wide = r2 - r1 >= r2 * MIN_WIDTH;
        let inner = near * least;
        let still_radius = if is_full { inner } else { 0.0 };
        let kinks = if is_cut { vec![r1, r2] } else { vec![inner] };
        let region = Region { reach, near, radii: [least, r2], is_cut };
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
            let longest = 1.0 / rule.by_range(&anywhere, 1.0).max(rule.by_length(&anywhere, 1.0, 1.0));
            rule.harmless_length = longest.min(MAX_LENGTH * min_rho);
            rule.is_fine &= rule.harmless_length > min_edge.max(min_rho * MIN_HARMLESS_LENGTH);
            rule.bands = if is_cut { Vec::new() } else { rule.bands_from(inner.max(min_rho)) };
        }
        rule
    }

    /// Returns where an edge crosses a band; among several crossed bands, the one whose number has the most factors of
    /// two. So the edges of a triangle are cut at the same band, and the edge between the cuts lies along it. Bands
    /// close to an end are skipped, because they would cut off slivers.
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

    /// Returns radii from one on, between which the range of ρ is small enough for all edges.
    fn bands_from(&self, first: f64) -> Vec<f64> {
        let mut bands = vec![first];
        let mut rho = first;
        while rho < self.settings.r2 && bands.len() < MAX_BANDS {
            let near = (rho / MAX_SPREAD).max(self.min_rho);
            let measure = self.region.measure(near, near, false);
            rho += BAND_SPACING / self.by_range(&measure, 1.0).max(1e-9);
            bands.push(rho);
        }
        bands
    }

    /// Returns the bound of all triangles at an edge.
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

    /// Returns the distance from the axis beyond which edges may be longer, metres: all points of their triangles lie
    /// beyond r₂.
    fn far(&self) -> f64 {
        self.region.radii[1].max(self.min_rho) * (1.0 + MAX_FAR_LENGTH)
    }

    /// Returns the minimum number of parts that an edge's h and ℓ require, before rounding up.
    fn by_lengths(&self, measure: &Measure, edge: &Extent) -> f64 {
        let longest = if edge.nearest >= self.far() { MAX_FAR_LENGTH } else { MAX_LENGTH };
        let long =
            (edge.horizontal / edge.nearest.max(self.min_rho)).max(edge.length / edge.distance.max(self.min_rho));
        self.by_length(measure, edge.horizontal, edge.length).max(long / longest)
    }

    /// Returns the minimum number of parts that keeps an edge with these h and ℓ within the bound.
    fn by_length(&self, measure: &Measure, horizontal: f64, length: f64) -> f64 {
        // If ρ does not count, the whole error is available for lengths.
        let fraction = if measure.range == [0.0; 2] { 1.0 } else { 1.0 - RANGE_FRACTION };
        let bent = measure.length[0] * horizontal * horizontal + measure.length[1] * length * length;
        let [_, max_horizontal, max_length] = measure.limits;
        (bent / (self.allowed_error * fraction)).sqrt().max(horizontal / max_horizontal).max(length / max_length)
    }

    /// Returns the minimum number of parts that an edge with this c requires.
    fn by_range(&self, measure: &Measure, range: f64) -> f64 {
        let [first, second] = measure.range;
        let allowed_error = self.allowed_error * RANGE_FRACTION;
        // The count at which first/count + second/count² is within the fraction.
        let (linear, quadratic) = (first * range / allowed_error, second * range * range / allowed_error);
        ((linear + (linear * linear + 4.0 * quadratic).sqrt()) / 2.0).max(range / measure.limits[0])
    }

    pub fn holds(&self) -> bool {
        let is_clear = self.still_radius > 0.0 && self.min_rho < self.still_radius;
        self.settings.reach == 0.0 || self.is_fine && is_clear
    }

    pub fn demand(&self) -> Result<()> {
        let Settings { r1, r2, reach, tolerance, .. } = self.settings;
        let inner = self.region.near * self.region.radii[0];
        let greatest = MAX_RATIO * (1.0 - MAX_SAG) * inner;
        let expected =
            format!("users within {greatest:.3} m of the centre, half of the least r1, where the error has a bound");
        ensure!(reach <= greatest, "user_region", expected, format!("{reach} m"));
        ensure!(self.is_wide, "r1", format!("a radius of at most {}", r2 * (1.0 - MIN_WIDTH)), r1);
        let expected = "a tolerance that pieces of a millionth of the least r1 and the coordinates' digits reach";
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

    /// A triangle around the axis whose edges all lie beyond the drawn radius is split.
    pub fn inner_split_point(&self, corners: &[DVec3; 3]) -> Option<[f64; 3]> {
        let p = corners.map(|corner| self.settings.on_ground(corner));
        let is_far = self.settings.reach > 0.0 && p.iter().all(|p| p.length() >= self.outer());
        if is_far { weights_of_axis(p) } else { None }
    }

    /// Each part of an edge that is left whole is left whole, because all measures decrease.
    pub fn cut(&self, a: DVec3, b: DVec3) -> Option<Cut> {
        let center = self.settings.center;
        let (p, q) = (self.settings.on_ground(a), self.settings.on_ground(b));
        let (least, greatest) = (p.length().min(q.length()), p.length().max(q.length()));
        let length = (b - a).length();
        let is_short = length <= self.min_edge.max(1e-14 * a.abs().max(b.abs()).max_element());
        if is_short || self.settings.reach == 0.0 {
            return None;
        }
        let nearest = segment_distance(p, q);
        let is_still = greatest <= self.still_radius + self.rounding && least < self.still_radius - self.rounding;
        if is_still || nearest >= self.outer() {
            return None;
        }
        let extent = Extent {
            nearest,
            farthest: greatest,
            distance: distance(a - center, b - center),
            horizontal: (q - p).length(),
            length,
            is_flat: self.region.radii[0] > 0.0
                && greatest <= self.inner + self.rounding
                && least < self.inner - self.rounding,
        };
        let measure = self.measure(&extent);
        let by_range = self.by_range(&measure, greatest - nearest);
        // The bound lets pieces high above the centre be higher than wide: measured in metres, each width would be
        // split in two heights.
        let tall = (nearest.max(self.min_rho) / extent.distance.max(self.min_rho)).min(1.0);
        let size = extent.horizontal.hypot((b.y - a.y) * tall);
        let cut_at = |fraction: f64| Some(Cut { fraction, size });
        let is_across = |kink: &f64| least < kink - self.rounding && greatest > kink + self.rounding;
        if let Some(&kink) = self.kinks.iter().find(|kink| is_across(kink)) {
            return cut_at(crossing(p, q, &[kink], f64::EPSILON).unwrap_or(0.5));
        }
        let is_bounded = self.is_fine && nearest >= self.min_rho;
        let fewest = if is_bounded { self.min_edge } else { self.min_unbounded_edge };
        if by_range > 1.0
            && length >= 2.0 * fewest
            && let Some(fraction) = self.band_at(p, q, (greatest - nearest) / by_range, fewest / length)
        {
            return cut_at(fraction);
        }
        let parts = (by_range.max(self.by_lengths(&measure, &extent)) * (1.0 - 1e-9))
            .ceil()
            .min((length / fewest).floor())
            .min(1e9);
        if parts >= 2.0 { cut_at((parts / 2.0).floor() / parts) } else { None }
    }
}

/// An edge in the measures of the bound.
struct Extent {
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
