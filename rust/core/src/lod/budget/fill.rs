//! Greedy selection of steps, one by one, within the remaining budget.

use std::collections::HashSet;

/// A step between two levels on an object's hull.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    /// Weighted score per triangle.
    pub slope: f64,
    pub object: u32,
    /// Ladder position that the step leads to.
    pub to: u16,
    pub triangles: u64,
    /// Weighted score.
    pub gain: f64,
}

/// Steps taken in order. A step that does not fit is skipped, and its object takes no later step.
#[derive(Default)]
pub(super) struct Filling {
    /// Remaining triangles.
    pub left: u64,
    /// Number of remaining triangles at which the selection may end.
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

    /// Returns whether few enough triangles remain.
    pub fn is_done(&self) -> bool {
        self.left <= self.spare
    }

    /// Returns whether a step did not fit.
    pub fn has_missed(&self) -> bool {
        !self.is_over.is_empty()
    }

    /// Takes the steps that fit, in order.
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
                    // No other step fits. Finer steps of their objects would come later.
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

    /// Returns the objects that took steps, with the finest ladder position of each.
    pub fn levels(mut self) -> Vec<(u32, u16)> {
        // The last step of an object leads to its finest position, which has the smallest number.
        self.levels.sort_unstable();
        self.levels.dedup_by_key(|level| level.0);
        self.levels
    }
}
