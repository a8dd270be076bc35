//! How much a user may send in a time.

use std::time::Instant;

/// An amount that refills with time up to a most, and that what is sent is taken from.
pub struct Bucket {
    rate: f64,
    most: f64,
    left: f64,
    at: Instant,
}

impl Bucket {
    /// Refill so much a second, up to a most.
    pub fn new(rate: f64, most: f64, now: Instant) -> Self {
        Bucket { rate, most, left: most, at: now }
    }

    /// Take an amount; false if there is less.
    pub fn take(&mut self, amount: f64, now: Instant) -> bool {
        let refilled = self.left + self.rate * now.saturating_duration_since(self.at).as_secs_f64();
        self.at = self.at.max(now);
        self.left = refilled.min(self.most) - amount;
        self.left >= 0.0
    }
}
