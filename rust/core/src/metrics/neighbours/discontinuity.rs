//! Discontinuity map δ of a frame.

use glam::DVec3;
use rayon::prelude::*;

use super::neighbourhood::Neighbourhood;
use super::pairs::PairSums;
use super::points::{BANDS, TruthPoints, check_pixels};
use crate::base::{Progress, Result};
use crate::camera::Camera;

/// Bands of points per task; its pairs reach as many bands further.
const GROUP: usize = BANDS;

/// Returns δ for each pixel of a frame, rows of `width`; NaN for pixels without a surface, behind the truth's camera,
/// or without neighbours. Positions are relative to `origin`.
pub fn discontinuity(
    position: &[[f32; 3]],
    origin: DVec3,
    width: usize,
    truth: &Camera,
    neighbourhood: Neighbourhood,
    progress: &Progress,
) -> Result<Vec<f32>> {
    let Neighbourhood { epsilon, least } = neighbourhood;
    check_pixels("min_distance", least)?;
    let points = TruthPoints::new(position, origin, width, truth, epsilon, progress)?;
    progress.expect(points.len() as u64);
    let groups: Vec<usize> = (0..points.bands.len()).step_by(GROUP).collect();
    // Each pair is visited once and counts for both points, so a task's sums extend into the next task's bands.
    let sums = |&first: &usize| {
        let bands = first..points.bands.len().min(first + GROUP);
        PairSums::new(&points, bands, neighbourhood, progress)
    };
    let sums: Vec<PairSums> = groups.par_iter().map(sums).collect::<Result<_>>()?;
    let mut image = vec![f32::NAN; position.len()];
    for (number, own) in sums.iter().enumerate() {
        progress.check()?;
        let before = number.checked_sub(1).map(|before| &sums[before]);
        for n in own.own.clone() {
            let (excess, count) = match before {
                Some(before) if n < before.end() => before.point_sums(n),
                _ => (0.0, 0.0),
            };
            let (own_excess, own_count) = own.point_sums(n);
            if count + own_count > 0.0 {
                image[points.pixel[n] as usize] = (excess + own_excess) / (count + own_count);
            }
        }
    }
    Ok(image)
}
