//! Rate limit of a user's traffic.

use std::time::Instant;

/// Token bucket: an amount that refills over time up to a maximum.
pub struct Bucket {
    rate: f64,
    most: f64,
    left: f64,
    at: Instant,
}

impl Bucket {
    /// Creates a full bucket that refills by `rate` per second up to `most`.
    pub fn new(rate: f64, most: f64, now: Instant) -> Self {
        Bucket { rate, most, left: most, at: now }
    }

    /// Takes an amount; false if less is left. The balance can become negative.
    pub fn take(&mut self, amount: f64, now: Instant) -> bool {
        self.refill(now);
        self.left -= amount;
        self.left >= 0.0
    }

    /// Takes an amount only if it is left; returns whether it was taken.
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
