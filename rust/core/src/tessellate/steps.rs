//! Quantisation of reach and tolerance, so that one split serves all users at similar distances from the centre.

use super::settings::{Settings, Stages};

/// Fraction of r₁ within which a user's error has a bound, reduced by how far triangles may pass r₁: 0.6 for a blend,
/// 0.5 for a cylinder.
const MAX_BLEND_REACH: f64 = 0.59;
const MAX_CYLINDER_REACH: f64 = 0.498;

/// Reach and tolerance in steps of √2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Steps {
    reach: i32,
    tolerance: i32,
}

impl Settings {
    /// Rounds the reach up and the tolerance down to the next step; returns both steps and the settings there. A reach
    /// with a bound keeps it.
    pub fn stepped(self) -> (Steps, Self) {
        let Self { r1, drawn, reach, tolerance, .. } = self;
        let unit = r1.max(drawn / 16.0);
        let outwards = (2.0 * (reach / unit).log2()).ceil().clamp(-40.0, 40.0);
        let finer = (2.0 * tolerance.log2()).floor().clamp(-80.0, 80.0);
        let farther = unit * (outwards / 2.0).exp2();
        let most = if self.stages == Stages::Blend { MAX_BLEND_REACH } else { MAX_CYLINDER_REACH };
        let bounded = most * r1;
        let reach = if reach <= bounded { farther.min(bounded) } else { farther.max(reach) };
        let tolerance = (finer / 2.0).exp2().min(tolerance);
        (Steps { reach: outwards as i32, tolerance: finer as i32 }, Self { reach, tolerance, ..self })
    }
}
