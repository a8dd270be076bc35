//! Edge-splitting rule for `Kind::Cylinder`, for all radii of its growth.

use glam::{DVec2, DVec3};

use super::grown_bound::{LONGEST, LONGEST_FAR, MAX_RATIO, Measure, Region, SPREAD, SPREAD_FAR, allowed};
use super::rule::{Cut, EdgeRule, crossing, segment_distance, weights_of_axis};
use super::settings::{Precision, Settings};
use crate::base::{Error, Result};

/// Fraction of the error for the range of ρ along edges; the rest is for their lengths. The number of pieces per area
/// is minimal for 2/3 if the first part is proportional to a width and the second to a squared length, and for ½ if
/// both are proportional to squares.
const RANGE_SHARE: f64 = 0.6;
/// Fraction of r₁ within which pieces stay as long as at its border, if points within r₁ move: shorter ones would be
/// endless.
const CENTRE: f64 = 1.0 / 64.0;
/// Minimum edge length if there is no bound, as a fraction of r₂ − r₁ (of r₂ if points within r₁ move) and of the
/// minimum distance for which there is a bound.
const COARSEST: f64 = 1.0 / 64.0;
/// Spacing of two bands relative to the maximum range between them: the rest is for edges across the radius, which
/// pass a band.
const FILLED: f64 = 0.9;
/// Minimum (r₂ − r₁)/r₂ for which there is a bound.
const THINNEST: f64 = 1.0 / 4096.0;
/// Minimum distance of a cut at a band from the ends of an edge, relative to the maximum range: half of an edge that
/// is too long to be left whole is longer.
const MARGIN: f64 = 0.25;
const MAX_BANDS: usize = 1 << 16;
/// Minimum length of harmless edges relative to the minimum distance for which there is a bound: finer pieces would
/// not fit into memory.
const FINEST: f64 = 1.0 / (1 << 20) as f64;
/// Maximum sag of edges between two points of r₁, relative to r₁: h²/(8 r₁²) for h = r₁/8.
const SAG: f64 = 0.003;

/// Radius beyond which edges are not split, relative to the drawn radius: no triangle with a drawn point has such an
/// edge, if its other edges are no longer than an eighth of their distance.
const DRAWN: f64 = 1.25;

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
    still: f64,
    /// Minimum distance from the axis at which edges are measured, metres.
    floor: f64,
    /// Maximum sum of an edge's error terms.
    allowed: f64,
    /// Lengths below which edges are not split, metres: anywhere, and nearer to the axis than `floor`.
    shortest: f64,
    coarsest: f64,
    /// Metres by which a vertex on a radius may miss it.
    rounding: f64,
    /// Length up to which no edge needs a split, wherever it lies, metres.
    harmless: f64,
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
        let is_wide = r2 - r1 >= r2 * THINNEST;
        let inner = near * least;
        let still = if is_full { inner } else { 0.0 };
        let kinks = if is_cut { vec![r1, r2] } else { vec![inner] };
        let region = Region { reach, near, radii: [least, r2], is_cut };
        let floor =
            (reach / MAX_RATIO).max(if still > 0.0 { still * (1.0 - SAG) } else { inner.max(r2 / 2.0) * CENTRE });
        let rounding = settings.rounding(precision);
        let shortest = 4.0 * rounding;
        // Vertices that miss a kink, and edges that are too short to be cut there, pass it by at most `shortest`.
        let passing = if floor > reach { 2.0 * shortest * region.slope(floor) * reach / (floor - reach) } else { 0.0 };
        let mut rule = Self {
            settings: *settings,
            region,
            kinks: kinks.into_iter().filter(|&kink| kink > 0.0).collect(),
            bands: Vec::new(),
            inner,
            still,
            floor,
            allowed: (allowed(tolerance) - passing).max(tolerance / 2.0),
            shortest,
            coarsest: shortest.max((r2 - still).max(floor) * COARSEST),
            rounding,
            harmless: f64::INFINITY,
            is_wide,
            is_fine: is_wide && passing < tolerance / 4.0,
        };
        if reach > 0.0 {
            let anywhere = Region { is_cut: false, ..region }.measure(floor, floor, false);
            let longest = 1.0 / rule.by_range(&anywhere, 1.0).max(rule.by_length(&anywhere, 1.0, 1.0));
            rule.harmless = longest.min(LONGEST * floor);
            rule.is_fine &= rule.harmless > shortest.max(floor * FINEST);
            rule.bands = if is_cut { Vec::new() } else { rule.bands_from(inner.max(floor)) };
        }
        rule
    }

    /// Returns where an edge crosses a band; among several crossed bands, the one whose number has the most factors of
    /// two. So the edges of a triangle are cut at the same band, and the edge between the cuts lies along it. Bands
    /// close to an end are skipped, because they would cut off slivers.
    fn band_at(&self, p: DVec2, q: DVec2, allowed: f64, room: f64) -> Option<f64> {
        let margin = self.rounding.max(allowed * MARGIN);
        let (nearest, farthest) = (segment_distance(p, q) + margin, p.length().max(q.length()) - margin);
        let [before, last] = [nearest, farthest].map(|rho| self.bands.partition_point(|&band| band < rho));
        if last <= before {
            return None;
        }
        let power = (before ^ last).ilog2();
        let number = last >> power << power;
        crossing(p, q, &[self.bands[number - 1]], room)
    }

    /// Returns radii from one on, between which the range of ρ is small enough for all edges.
    fn bands_from(&self, first: f64) -> Vec<f64> {
        let mut bands = vec![first];
        let mut rho = first;
        while rho < self.settings.r2 && bands.len() < MAX_BANDS {
            let near = (rho / SPREAD).max(self.floor);
            let measure = self.region.measure(near, near, false);
            rho += FILLED / self.by_range(&measure, 1.0).max(1e-9);
            bands.push(rho);
        }
        bands
    }

    /// Returns the bound of all triangles at an edge.
    fn measure(&self, edge: &Extent) -> Measure {
        let far = self.far();
        // The points of a triangle with an edge at the longer limit lie beyond far/SPREAD.
        let rho = if edge.nearest >= far {
            (edge.nearest / (1.0 + LONGEST_FAR)).max(far / SPREAD)
        } else {
            (edge.nearest / SPREAD).max(self.floor)
        };
        let away = edge.distance / if edge.farthest >= far { SPREAD_FAR } else { SPREAD };
        self.region.measure(rho, away.max(rho), edge.is_flat)
    }

    /// Returns the distance from the axis beyond which edges may be longer, metres: all points of their triangles lie
    /// beyond r₂.
    fn far(&self) -> f64 {
        self.region.radii[1].max(self.floor) * (1.0 + LONGEST_FAR)
    }

    /// Returns the minimum number of parts that an edge's h and ℓ require, before rounding up.
    fn by_lengths(&self, measure: &Measure, edge: &Extent) -> f64 {
        let longest = if edge.nearest >= self.far() { LONGEST_FAR } else { LONGEST };
        let long = (edge.level / edge.nearest.max(self.floor)).max(edge.length / edge.distance.max(self.floor));
        self.by_length(measure, edge.level, edge.length).max(long / longest)
    }

    /// Returns the minimum number of parts that keeps an edge with these h and ℓ within the bound.
    fn by_length(&self, measure: &Measure, level: f64, length: f64) -> f64 {
        // If ρ does not count, the whole error is available for lengths.
        let share = if measure.range == [0.0; 2] { 1.0 } else { 1.0 - RANGE_SHARE };
        let bent = measure.length[0] * level * level + measure.length[1] * length * length;
        let [_, most_level, most_length] = measure.most;
        (bent / (self.allowed * share)).sqrt().max(level / most_level).max(length / most_length)
    }

    /// Returns the minimum number of parts that an edge with this c requires.
    fn by_range(&self, measure: &Measure, range: f64) -> f64 {
        let [first, second] = measure.range;
        let allowed = self.allowed * RANGE_SHARE;
        // The count at which first/count + second/count² is within the fraction.
        let (one, two) = (first * range / allowed, second * range * range / allowed);
        ((one + (one * one + 4.0 * two).sqrt()) / 2.0).max(range / measure.most[0])
    }
}

impl EdgeRule for GrownRule {
    fn holds(&self) -> bool {
        let is_clear = self.still > 0.0 && self.floor < self.still;
        self.settings.reach == 0.0 || self.is_fine && is_clear
    }

    fn demand(&self) -> Result<()> {
        let inner = self.region.near * self.region.radii[0];
        let greatest = MAX_RATIO * (1.0 - SAG) * inner;
        if self.settings.reach > greatest {
            let expected = format!(
                "users within {greatest:.3} m of the centre, half of the least r1, where the error has a bound"
            );
            return Err(Error::value("user_region", expected, format!("{} m", self.settings.reach)));
        }
        if !self.is_wide {
            let Settings { r1, r2, .. } = self.settings;
            return Err(Error::value("r1", format!("a radius of at most {}", r2 * (1.0 - THINNEST)), r1));
        }
        if !self.is_fine {
            let expected = "a tolerance that pieces of a millionth of the least r1 and the coordinates' digits reach";
            return Err(Error::value("tolerance_px", expected, format!("{:e} radians", self.settings.tolerance)));
        }
        Ok(())
    }

    fn harmless(&self) -> f64 {
        self.harmless
    }

    fn outer(&self) -> f64 {
        DRAWN * self.settings.drawn
    }

    fn is_within(&self, rho: f64) -> bool {
        rho < self.still - self.rounding
    }

    /// A triangle around the axis whose edges all lie beyond the drawn radius is split.
    fn inner_split_point(&self, corners: &[DVec3; 3]) -> Option<[f64; 3]> {
        let p = corners.map(|corner| self.settings.on_ground(corner));
        let is_far = self.settings.reach > 0.0 && p.iter().all(|p| p.length() >= self.outer());
        if is_far { weights_of_axis(p) } else { None }
    }

    /// Each part of an edge that is left whole is left whole, because all measures decrease.
    fn cut(&self, a: DVec3, b: DVec3) -> Option<Cut> {
        let center = self.settings.center;
        let (p, q) = (self.settings.on_ground(a), self.settings.on_ground(b));
        let (least, greatest) = (p.length().min(q.length()), p.length().max(q.length()));
        let length = (b - a).length();
        let is_short = length <= self.shortest.max(1e-14 * a.abs().max(b.abs()).max_element());
        if is_short || self.settings.reach == 0.0 {
            return None;
        }
        let nearest = segment_distance(p, q);
        let is_still = greatest <= self.still + self.rounding && least < self.still - self.rounding;
        if is_still || nearest >= self.outer() {
            return None;
        }
        let extent = Extent {
            nearest,
            farthest: greatest,
            distance: distance(a - center, b - center),
            level: (q - p).length(),
            length,
            is_flat: self.region.radii[0] > 0.0
                && greatest <= self.inner + self.rounding
                && least < self.inner - self.rounding,
        };
        let measure = self.measure(&extent);
        let by_range = self.by_range(&measure, greatest - nearest);
        // The bound lets pieces high above the centre be higher than wide: measured in metres, each width would be
        // split in two heights.
        let tall = (nearest.max(self.floor) / extent.distance.max(self.floor)).min(1.0);
        let size = extent.level.hypot((b.y - a.y) * tall);
        let at = |fraction: f64| Some(Cut { fraction, size });
        let is_across = |kink: &f64| least < kink - self.rounding && greatest > kink + self.rounding;
        if let Some(&kink) = self.kinks.iter().find(|kink| is_across(kink)) {
            return at(crossing(p, q, &[kink], f64::EPSILON).unwrap_or(0.5));
        }
        let is_bounded = self.is_fine && nearest >= self.floor;
        let fewest = if is_bounded { self.shortest } else { self.coarsest };
        if by_range > 1.0
            && length >= 2.0 * fewest
            && let Some(share) = self.band_at(p, q, (greatest - nearest) / by_range, fewest / length)
        {
            return at(share);
        }
        let parts = (by_range.max(self.by_lengths(&measure, &extent)) * (1.0 - 1e-9))
            .ceil()
            .min((length / fewest).floor())
            .min(1e9);
        if parts >= 2.0 { at((parts / 2.0).floor() / parts) } else { None }
    }
}

/// An edge in the measures of the bound.
struct Extent {
    nearest: f64,
    farthest: f64,
    /// Minimum distance from the centre.
    distance: f64,
    level: f64,
    length: f64,
    /// Whether all triangles at the edge lie within the minimum r₁.
    is_flat: bool,
}

/// Returns the distance of the origin from a segment.
fn distance(a: DVec3, b: DVec3) -> f64 {
    let d = b - a;
    let squared = d.length_squared();
    let share = if squared > 0.0 { (-a.dot(d) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (a + d * share).length()
}
