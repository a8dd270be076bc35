//! sRGB's transfer function (IEC 61966-2-1) and its inverse. All values except those in files are linear.

use std::sync::LazyLock;

/// Linear values of the 256 codes.
static LINEAR: LazyLock<[f32; 256]> = LazyLock::new(|| {
    std::array::from_fn(|code| {
        let s = code as f64 / 255.0;
        (if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) }) as f32
    })
});

/// The table of linear values. Loops should fetch it once.
#[inline]
pub fn linear_from_srgb() -> &'static [f32; 256] {
    &LINEAR
}

/// The nearest code of a linear value clamped to 0..1; NaN is black.
#[inline]
pub fn srgb_from_linear(linear: f32) -> u8 {
    let x = linear.clamp(0.0, 1.0);
    let s = if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 };
    (s * 255.0 + 0.5) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_comes_back() {
        for code in 0..=255u8 {
            assert_eq!(srgb_from_linear(linear_from_srgb()[usize::from(code)]), code);
        }
        assert_eq!((linear_from_srgb()[0], linear_from_srgb()[255]), (0.0, 1.0));
    }

    #[test]
    fn what_is_no_colour_is_clipped() {
        assert_eq!([-1.0, 2.0, f32::NAN, f32::INFINITY].map(srgb_from_linear), [0, 255, 0, 255]);
    }
}
