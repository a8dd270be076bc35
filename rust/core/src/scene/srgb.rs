//! sRGB transfer function (IEC 61966-2-1) and its inverse. All values except those in files are linear.

use std::sync::LazyLock;

use crate::base::mapped::write_mapped;
use crate::base::{Progress, Result};

/// Linear values of the 256 codes.
static LINEAR: LazyLock<[f32; 256]> = LazyLock::new(|| {
    std::array::from_fn(|code| {
        let s = code as f64 / 255.0;
        (if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) }) as f32
    })
});

/// Returns the table of linear values. Loops should fetch it once.
#[inline]
pub fn linear_from_srgb() -> &'static [f32; 256] {
    &LINEAR
}

/// Returns the nearest code of a linear value clamped to 0..1; NaN gives black.
#[inline]
pub fn srgb_from_linear(linear: f32) -> u8 {
    if linear.is_nan() || linear < f32::from_bits(DARK) {
        return 0;
    }
    if linear >= 1.0 {
        return 255;
    }
    let mut code = CODES.first[((linear.to_bits() - DARK) >> LOWER_BITS) as usize];
    while linear >= CODES.min[usize::from(code) + 1] {
        code += 1;
    }
    code
}

/// Returns the table of codes of the 65,536 fractions n/65,535. Loops should fetch it once.
pub fn srgb_from_u16() -> &'static [u8] {
    static CODES_OF_U16: LazyLock<Vec<u8>> = LazyLock::new(|| {
        (0..=u16::MAX).map(|short| srgb_from_linear((f64::from(short) / f64::from(u16::MAX)) as f32)).collect()
    });
    &CODES_OF_U16
}

/// Writes `srgb_from_linear` of many values.
pub fn srgb_from_all_linear(linear: &[f32], codes: &mut [u8], progress: &Progress) -> Result<()> {
    write_mapped(linear, codes, |&linear| srgb_from_linear(linear), progress)
}

/// Computes a code by the standard's formula, whose power function takes several times as long as the table.
fn encode(linear: f32) -> u8 {
    let x = linear.clamp(0.0, 1.0);
    let s = if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 };
    (s * 255.0 + 0.5) as u8
}

/// Lookup table from the upper bits of a float to a code, and the values at which codes begin.
struct Codes {
    /// Code of the smallest float of each interval.
    first: [u8; INTERVALS],
    /// Smallest value of each code; infinity after the last.
    min: [f32; 257],
}

/// Number of low bits of a float ignored by the interval number: each power of two has 128 intervals.
const LOWER_BITS: u32 = 16;
/// Float bits of 2⁻¹³, below which all codes are 0, and of 1.
const DARK: u32 = (127 - 13) << 23;
const WHITE: u32 = 127 << 23;
const INTERVALS: usize = ((WHITE - DARK) >> LOWER_BITS) as usize;

static CODES: LazyLock<Codes> = LazyLock::new(|| {
    let first = std::array::from_fn(|i| encode(f32::from_bits(DARK + ((i as u32) << LOWER_BITS))));
    let mut min = [f32::INFINITY; 257];
    for (code, min) in min.iter_mut().enumerate().take(256) {
        // Non-negative floats are ordered like their bits.
        let (mut low, mut high) = (0, WHITE);
        while low < high {
            let middle = low.midpoint(high);
            let has_code = usize::from(encode(f32::from_bits(middle))) >= code;
            (low, high) = if has_code { (low, middle) } else { (middle + 1, high) };
        }
        *min = f32::from_bits(high);
    }
    Codes { first, min }
});

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_is_restored() {
        for code in 0..=255u8 {
            assert_eq!(srgb_from_linear(linear_from_srgb()[usize::from(code)]), code);
        }
        assert_eq!((linear_from_srgb()[0], linear_from_srgb()[255]), (0.0, 1.0));
    }

    #[test]
    fn codes_are_those_of_the_formula() {
        let around = |&min: &f32| [min.next_down(), min, min.next_up()];
        let ends = CODES.min[1..256].iter().flat_map(around);
        let spread = (0..WHITE + 1000).step_by(997).map(f32::from_bits);
        for linear in ends.chain(spread) {
            assert_eq!(srgb_from_linear(linear), encode(linear), "{linear:e}");
        }
    }

    #[test]
    fn values_outside_the_gamut_are_clipped() {
        assert_eq!([-1.0, 2.0, f32::NAN, f32::INFINITY].map(srgb_from_linear), [0, 255, 0, 255]);
    }
}
