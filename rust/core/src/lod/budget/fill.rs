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

/// Steps that are taken in their order. After one that does not fit come those that do; an object whose step did not fit
/// takes no further one.
#[derive(Default)]
pub(super) struct Filling {
    /// Triangles that are left.
    pub left: u64,
    /// Triangles that may be left in the end.
    spare: u64,
    /// Slope of the first step that did not fit; 0 if all did.
    pub slope: f64,
    pub gain: f64,
    levels: Vec<(u32, u16)>,
    is_over: HashSet<u32>,
}

impl Filling {
    pub fn new(left: u64, spare: u64) -> Self {
        Self { left, spare, ..Self::default() }
    }

    /// Whether little enough is left.
    pub fn is_done(&self) -> bool {
        self.left <= self.spare
    }

    /// Whether a step did not fit.
    pub fn has_missed(&self) -> bool {
        !self.is_over.is_empty()
    }

    /// Takes those of some steps that fit.
    pub fn take(&mut self, steps: &[Step]) {
        let least = steps.iter().map(|step| step.triangles).min().unwrap_or(0);
        for (n, step) in steps.iter().enumerate() {
            if self.is_over.contains(&step.object) {
                continue;
            }
            if step.triangles > self.left {
                if self.is_over.is_empty() {
                    self.slope = step.slope;
                }
                self.is_over.insert(step.object);
                if self.left < least {
                    // None of the others fits. Finer steps of their objects would come later.
                    if !self.is_done() {
                        self.is_over.extend(steps[n..].iter().map(|step| step.object));
                    }
                    return;
                }
            } else {
                self.left -= step.triangles;
                self.gain += step.gain;
                self.levels.push((step.object, step.to));
            }
        }
    }

    /// Objects that took steps, and the finest place on its ladder of each.
    pub fn levels(mut self) -> Vec<(u32, u16)> {
        // The last step of an object leads to its finest place, which has the least number.
        self.levels.sort_unstable();
        self.levels.dedup_by_key(|level| level.0);
        self.levels
    }
}
