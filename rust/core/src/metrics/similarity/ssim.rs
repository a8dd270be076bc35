//! Similarity of a pair for any window.

use super::super::pair::Pair;
use super::super::pixel_rows::PixelRows;
use super::global::global;
use super::masked::Masked;
use super::tiles::Windows;
use super::window::{Similarity, Window};
use super::window_sums::{Counted, Mask, SimilaritySums};
use crate::base::{Error, Result};

/// Returns the summed similarity of windows and, if requested, writes its map: rows of the image's width. Images are
/// mirrored at their borders. Without a map only windows that count are computed.
pub fn similarity<P: PixelRows>(
    pair: &Pair<'_, P>,
    window: &Window,
    constants: Similarity,
    counted: Counted<'_>,
    map: Option<&mut [P::Real]>,
) -> Result<SimilaritySums> {
    let size = [pair.reference.height, pair.reference.width];
    if let Some(mask) = counted.mask {
        pair.reference.expect_size("mask", [mask.plane().height, mask.plane().width])?;
    }
    if let Some(map) = map.as_ref().filter(|map| map.len() != size[0] * size[1]) {
        return Err(Error::value("map", format!("{} × {} values", size[0], size[1]), map.len()));
    }
    let constants = [constants.c1, constants.c2];
    let sums = match (window, counted.mask) {
        (Window::Global, _) => global(pair, constants, counted, map),
        (Window::Weights(weights), Some(Mask::Windows(mask))) => {
            let Counted { contrast, progress, .. } = counted;
            Masked { pair: *pair, weights, constants, mask, contrast, progress }.sums(map)
        }
        (Window::Weights(weights), _) => Windows::new(*pair, weights, constants, counted).sums(map),
    };
    counted.progress.check().map(|()| sums)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::Progress;
    use crate::metrics::{Plane, ValueRange};

    fn plane(values: &[f64]) -> Plane<'_, f64> {
        Plane::new(values, [5, 7], [7, 1]).unwrap()
    }

    #[test]
    fn equal_images_are_exactly_alike_and_order_does_not_matter() {
        let a: Vec<f64> = (0..35).map(|i| f64::from(i * i % 17) / 16.0).collect();
        let b: Vec<f64> = (0..35).map(|i| f64::from(i * 7 % 13) / 12.0).collect();
        let constants = Similarity { c1: 1e-4, c2: 9e-4 };
        for window in [Window::gaussian(11, 1.5), Window::uniform(4), Window::Global] {
            let of = |a: &[f64], b: &[f64]| {
                let mut map = vec![0.0; 35];
                let pair = Pair::new(plane(a), plane(b)).unwrap();
                let counted =
                    Counted { all: true, mask: None, contrast: true, range: true, progress: &Progress::new() };
                let sums = similarity(&pair, &window, constants, counted, Some(&mut map)).unwrap();
                assert_eq!(sums, similarity(&pair, &window, constants, counted, None).unwrap());
                (sums, map)
            };
            assert!(of(&a, &a).1.iter().all(|&value| value == 1.0));
            let SimilaritySums { similarity, contrast, pixels, range } = of(&a, &a).0;
            assert_eq!([similarity, contrast, pixels], [35.0; 3]);
            assert_eq!(range, ValueRange { least: 0.0, greatest: 1.0 });
            assert_eq!(of(&a, &b), of(&b, &a));
            assert!(of(&a, &b).1.iter().all(|&value| value < 1.0));
        }
    }
}
