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

    /// Take an amount; false if there is less, which is owed then.
    pub fn take(&mut self, amount: f64, now: Instant) -> bool {
        self.refill(now);
        self.left -= amount;
        self.left >= 0.0
    }

    /// Take an amount, or nothing if there is less; whether it was taken.
    pub fn take_if(&mut self, amount: f64, now: Instant) -> bool {
        self.refill(now);
        let is_there = self.left >= amount;
        if is_there {
            self.left -= amount;
        }
        is_there
    }

    fn refill(&mut self, now: Instant) {
        let refilled = self.left + self.rate * now.saturating_duration_since(self.at).as_secs_f64();
        self.at = self.at.max(now);
        self.left = refilled.min(self.most);
    }
}
