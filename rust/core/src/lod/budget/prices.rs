//! Histogram of steps by slope. A class is a range of slopes.

/// Number of classes. A class is a slope's exponent and a few bits of its mantissa.
pub(super) const CLASSES: usize = 1 << 12;
/// Class of steps that gain nothing.
pub(super) const NEVER: u16 = 0;
/// Class of steps that are taken at any price.
pub(super) const ALWAYS: u16 = CLASSES as u16 - 1;
/// Number of mantissa bits in a class, which is then about 2 % of its slope wide.
const DIGITS: u32 = 5;
const SHIFT: u32 = f64::MANTISSA_DIGITS - 1 - DIGITS;
/// Lower end of the range with separate classes, up to 2¹²⁸ times this slope; the outermost classes have all others.
const MIN: f64 = 1.0 / (1u128 << 112) as f64;

/// Returns the class of a slope, which increases with the slope.
#[inline(always)]
pub(super) fn class(slope: f64) -> u16 {
    const FIRST: i64 = (MIN.to_bits() >> SHIFT) as i64;
    const LAST: i64 = ALWAYS as i64 - 1;
    let number = (slope.to_bits() >> SHIFT) as i64 - FIRST;
    let number = if number < 1 { 1 } else { number };
    let number = if number > LAST { LAST } else { number };
    let number = if slope > 0.0 { number } else { NEVER as i64 };
    (if slope == f64::INFINITY { ALWAYS as i64 } else { number }) as u16
}

/// Sums over the steps of a class. The alignment makes its address a shift of the index.
#[derive(Clone, Copy, Default)]
#[repr(align(32))]
pub(super) struct Entry {
    pub triangles: u64,
    /// Weighted score.
    pub gain: f64,
    pub steps: u32,
}

impl Entry {
    #[inline(always)]
    pub fn add(&mut self, triangles: u64, gain: f64) {
        self.triangles += triangles;
        self.gain += gain;
        self.steps += 1;
    }
}

/// Sums over steps by class, and over objects at their coarsest level.
pub(super) struct Ledger {
    pub classes: Box<[Entry; CLASSES]>,
    /// Triangles, weighted score and weight of all objects at their coarsest level.
    pub first_triangles: u64,
    pub first_score: f64,
    pub weight: f64,
}

impl Default for Ledger {
    fn default() -> Self {
        Self { classes: Box::new([Entry::default(); CLASSES]), first_triangles: 0, first_score: 0.0, weight: 0.0 }
    }
}

impl Ledger {
    /// Adds another ledger. Callers add in a fixed order, so that rounding does not depend on threads.
    pub fn add(&mut self, other: &Ledger) {
        for (own, other) in self.classes.iter_mut().zip(other.classes.iter()) {
            own.triangles += other.triangles;
            own.gain += other.gain;
            own.steps += other.steps;
        }
        self.first_triangles += other.first_triangles;
        self.first_score += other.first_score;
        self.weight += other.weight;
    }
}
