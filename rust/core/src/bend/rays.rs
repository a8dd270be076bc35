//! Polylines of bent rays in many directions.

use glam::DVec3;
use rayon::prelude::*;

use super::curve::RayCurve;
use crate::base::{Error, Progress, Result, ensure, memory::room_for};
use crate::morph::Morph;

/// Minimum tolerance in radians. A polyline with this tolerance has a few thousand points.
const MIN_TOLERANCE: f64 = 1e-9;

/// Returns (points, longest): the polylines of many rays, each padded with NaN to `longest` points, the length of the
/// longest. Directions may have any length above 0.
pub fn bend_rays(
    morph: &Morph,
    directions: &[[f64; 3]],
    tolerance: f64,
    progress: &Progress,
) -> Result<(Vec<[f64; 3]>, usize)> {
    let is_valid = tolerance.is_finite() && tolerance >= MIN_TOLERANCE;
    ensure!(is_valid, "tolerance", format!("at least {MIN_TOLERANCE:e} radians"), tolerance);
    let unit = |row: &[f64; 3]| {
        // Scaled first, because the square of a length overflows long before the length does.
        let d = DVec3::from_array(*row);
        let longest = d.abs().max_element();
        (longest > 0.0 && d.is_finite()).then(|| (d / longest).normalize())
    };
    if let Some(row) = directions.iter().position(|row| unit(row).is_none()) {
        let expected = "finite directions with a length above zero";
        return Err(Error::value("directions", expected, format!("{:?} at index {row}", directions[row])));
    }
    progress.expect(directions.len() as u64);
    let bend = |rows: &[[f64; 3]]| {
        let lines: Vec<Vec<DVec3>> =
            rows.iter().filter_map(unit).map(|unit| RayCurve::new(morph, unit).polyline(tolerance)).collect();
        progress.report(rows.len() as u64)?;
        Ok(lines)
    };
    let lines: Vec<Vec<Vec<DVec3>>> = directions.par_chunks(1024).map(bend).collect::<Result<_>>()?;
    let longest = lines.iter().flatten().map(Vec::len).max().unwrap_or(1);
    room_for((directions.len() * longest * size_of::<[f64; 3]>()) as u64)?;
    let mut padded = Vec::with_capacity(directions.len() * longest);
    for line in lines.iter().flatten() {
        padded.extend(line.iter().map(|point| point.to_array()));
        padded.resize(padded.len() + longest - line.len(), [f64::NAN; 3]);
    }
    Ok((padded, longest))
}
