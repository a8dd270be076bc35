//! The exponential function in plain arithmetic.

/// Greatest |t|: little beyond ±700 the exponential overflows, and the logistic function is 0 or 1 to 300 digits.
const FARTHEST: f64 = 700.0;

/// e^t for |t| ≤ 700, with an error of at most 2 units in the last place. t = n ln 2 + r with |r| ≤ ln 2/2; the first
/// omitted term of Taylor's series of e^r is below 2⁻⁵⁷. Plain arithmetic lets the compiler vectorise it and gives the
/// same bits on every machine.
#[inline(always)]
pub(super) fn exp(t: f64) -> f64 {
    /// 1.5 · 2⁵². Adding it to a number leaves the nearest whole number in the lowest bits.
    const WHOLE: f64 = 6_755_399_441_055_744.0;
    /// ln 2 as the sum of two parts; products of the first part with numbers of up to 11 bits are exact.
    const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];
    const TAYLOR: [f64; 14] = [
        1.0,
        1.0,
        1.0 / 2.0,
        1.0 / 6.0,
        1.0 / 24.0,
        1.0 / 120.0,
        1.0 / 720.0,
        1.0 / 5_040.0,
        1.0 / 40_320.0,
        1.0 / 362_880.0,
        1.0 / 3_628_800.0,
        1.0 / 39_916_800.0,
        1.0 / 479_001_600.0,
        1.0 / 6_227_020_800.0,
    ];
    let t = if t > FARTHEST { FARTHEST } else { t };
    let t = if t < -FARTHEST { -FARTHEST } else { t };
    let shifted = t * std::f64::consts::LOG2_E + WHOLE;
    let n = shifted - WHOLE;
    let r = (t - n * LN_2[0]) - n * LN_2[1];
    let mut sum = TAYLOR[13];
    let mut k = 13;
    while k > 0 {
        k -= 1;
        sum = sum * r + TAYLOR[k];
    }
    sum * f64::from_bits(shifted.to_bits().wrapping_add(1023) << 52)
}
