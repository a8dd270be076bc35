//! Steps that are taken one by one while they fit.

use std::collections::HashSet;

/// One edge of an object's hull.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    /// Weighted score for each triangle.
    pub slope: f64,
    pub object: u32,
    /// Place on the ladder to which it leads.
    pub to: u16,
    pub triangles: u64,
    /// Weighted score.
    pub gain: f64,
}

/// The steps that were taken, summed up.
pub(super) struct Filled {
    /// Slope of the first step that did not fit; 0 if all did.
    pub slope: f64,
    pub triangles: u64,
    pub gain: f64,
    /// Objects and the places on their ladders.
    pub levels: Vec<(u32, u16)>,
}

/// Takes steps in their order. After one that does not fit come those that do; an object whose step did not fit takes
/// no further one.
pub(super) fn fill(steps: &[Step], left: u64) -> Filled {
    let mut filled = Filled { slope: 0.0, triangles: 0, gain: 0.0, levels: Vec::new() };
    let mut is_over = HashSet::new();
    let least = steps.iter().map(|step| step.triangles).min().unwrap_or(0);
    for step in steps {
        if is_over.contains(&step.object) {
            continue;
        }
        if filled.triangles + step.triangles > left {
            if is_over.is_empty() {
                filled.slope = step.slope;
            }
            is_over.insert(step.object);
            if left - filled.triangles < least {
                break;
            }
            continue;
        }
        filled.triangles += step.triangles;
        filled.gain += step.gain;
        filled.levels.push((step.object, step.to));
    }
    // The last step of an object leads to its finest place, which has the least number.
    filled.levels.sort_unstable();
    filled.levels.dedup_by_key(|level| level.0);
    filled
}
