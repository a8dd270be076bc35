//! Tests of similarity against its definition, and of the variants of each kernel against each other.

use super::moments::{COLUMNS, Moments, row_moments, row_moments_kernel, window_moments, window_moments_kernel};
use super::*;
use crate::base::Progress;
use crate::metrics::extremes::LANES;
use crate::metrics::pair::Pair;
use crate::metrics::plane::{self, Plane};
use crate::metrics::{Stacks, ValueRange};
use proptest::prelude::*;

const CONSTANTS: Similarity = Similarity { c1: 1e-4, c2: 9e-4 };

/// Generates the pixels of two images, their size and that of the window, and a mask.
fn images() -> impl Strategy<Value = (Vec<f64>, Vec<f64>, [usize; 2], usize, Vec<u8>)> {
    (1..24usize, 1..170usize, 1..9usize).prop_flat_map(|(height, width, taps)| {
        let pixels = || prop::collection::vec(-1.0..1.0f64, height * width);
        let mask = prop::collection::vec(0..2u8, height * width);
        (pixels(), pixels(), Just([height, width]), Just(taps), mask)
    })
}

/// Evaluates Eq. 13 at a pixel from the weights and values around it; images are mirrored at their border.
fn by_definition(
    [a, b]: [&[f64]; 2],
    [height, width]: [usize; 2],
    weights: &[f64],
    (row, column): (usize, usize),
    mask: Option<&[u8]>,
) -> f64 {
    let before = weights.len() as i64 / 2;
    let mut weighted = Vec::new();
    for (i, down) in weights.iter().enumerate() {
        for (j, across) in weights.iter().enumerate() {
            let position = [row as i64 + i as i64 - before, column as i64 + j as i64 - before];
            let within = (0..height as i64).contains(&position[0]) && (0..width as i64).contains(&position[1]);
            let index = plane::mirror(position[0], height) * width + plane::mirror(position[1], width);
            if mask.is_none_or(|mask| within && mask[index] != 0) {
                weighted.push((down * across, a[index], b[index]));
            }
        }
    }
    let total: f64 = weighted.iter().map(|(weight, ..)| weight).sum();
    let mean = |value: &dyn Fn(f64, f64) -> f64| weighted.iter().map(|&(w, x, y)| w * value(x, y)).sum::<f64>() / total;
    let (mx, my) = (mean(&|x, _| x), mean(&|_, y| y));
    let (vx, vy) = (mean(&|x, _| (x - mx).powi(2)), mean(&|_, y| (y - my).powi(2)));
    let covariance = mean(&|x, y| (x - mx) * (y - my));
    let Similarity { c1, c2 } = CONSTANTS;
    (2.0 * mx * my + c1) * (2.0 * covariance + c2) / ((mx * mx + my * my + c1) * (vx + vy + c2))
}

proptest! {
    #[test]
    fn random_images_equal_the_definition((a, b, size, taps, mask) in images(), uniform: bool, masks_windows: bool) {
        let [height, width] = size;
        let window = if uniform { Window::uniform(taps) } else { Window::gaussian(taps, 1.5) };
        let Window::Weights(weights) = &window else { unreachable!() };
        let narrow: Vec<[f32; 2]> = a.iter().zip(&b).map(|(&a, &b)| [a as f32, b as f32]).collect();
        let (a32, b32): (Vec<f32>, Vec<f32>) = narrow.iter().map(|&[a, b]| (a, b)).unzip();
        let mask_plane = Plane::new(&mask, size, [width, 1]).unwrap();
        let selection = Selection { includes_border: true, mask: masks_windows.then_some(Mask::Windows(mask_plane)), contrast: false, range: false, progress: &Progress::new() };
        let (mut map, mut map32) = (vec![0.0; height * width], vec![0.0f32; height * width]);
        let pair = |a, b| Pair::new(Plane::new(a, size, [width, 1]).unwrap(), Plane::new(b, size, [width, 1]).unwrap());
        let sums = similarity(&pair(&a, &b).unwrap(), &window, CONSTANTS, selection, Some(&mut map)).unwrap();
        let steps = [width, 1];
        let pair32 = Pair::new(Plane::new(&a32, size, steps).unwrap(), Plane::new(&b32, size, steps).unwrap()).unwrap();
        similarity(&pair32, &window, CONSTANTS, selection, Some(&mut map32)).unwrap();
        let mut total = 0.0;
        for n in (0..height * width).filter(|&n| !masks_windows || mask[n] != 0) {
            let expected = by_definition([&a, &b], size, weights, (n / width, n % width), masks_windows.then_some(&mask));
            prop_assert!((map[n] - expected).abs() < 1e-11, "{} {expected}", map[n]);
            prop_assert!((f64::from(map32[n]) - expected).abs() < 1e-5 * f64::from(map32[n]).abs().max(1.0));
            total += expected;
        }
        prop_assert!((sums.similarity - total).abs() < 1e-9);
    }

    #[test]
    fn squared_errors_equal_their_definition((a, b, size, _, _) in images()) {
        let plane = |values| Plane::new(values, size, [size[1], 1]).unwrap();
        let stacks = Stacks { references: vec![plane(&a)], tests: vec![plane(&b)], masks: None };
        let exact = a.iter().zip(&b).map(|(a, b)| (a - b).powi(2)).sum::<f64>() / a.len() as f64;
        prop_assert!((stacks.mean_squared_errors(false, &Progress::new()).unwrap()[0].mean - exact).abs() < 1e-14);
    }

    #[test]
    fn kernels_without_fused_operations_agree(
        line in prop::collection::vec(-1.0..1.0f64, COLUMNS + 10), level in -100.0..100.0f64,
    ) {
        let Window::Weights(weights) = Window::gaussian(11, 1.5) else { unreachable!() };
        let line: Vec<f64> = line.iter().map(|value| value + level).collect();
        let blocks = COLUMNS / LANES;
        let (mut fast, mut slow) = (Moments::default(), Moments::default());
        row_moments(&line, &weights, &mut fast, blocks);
        row_moments_kernel::<f64, false>(&line, &weights, &mut slow, blocks);
        let (rows, order) = (vec![fast.clone(); 11], (0..11).collect::<Vec<_>>());
        let (mut fast_window, mut slow_window) = (Moments::default(), Moments::default());
        window_moments(&rows, &order, &weights, &mut fast_window, blocks);
        window_moments_kernel::<f64, false>(&rows, &order, &weights, &mut slow_window, blocks);
        for (fast, slow) in [(&fast, &slow), (&fast_window, &slow_window)] {
            for i in 0..COLUMNS {
                prop_assert!((fast.mean[i] - slow.mean[i]).abs() < 1e-12);
                prop_assert!((fast.variance[i] - slow.variance[i]).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn equal_images_are_exactly_alike_and_order_does_not_matter() {
    let a: Vec<f64> = (0..35).map(|i| f64::from(i * i % 17) / 16.0).collect();
    let b: Vec<f64> = (0..35).map(|i| f64::from(i * 7 % 13) / 12.0).collect();
    for window in [Window::gaussian(11, 1.5), Window::uniform(4), Window::Global] {
        let compare = |a: &[f64], b: &[f64]| {
            let mut map = vec![0.0; 35];
            let [a, b] = [a, b].map(|values| Plane::new(values, [5, 7], [7, 1]).unwrap());
            let pair = Pair::new(a, b).unwrap();
            let selection = Selection {
                includes_border: true,
                mask: None,
                contrast: true,
                range: true,
                progress: &Progress::new(),
            };
            let sums = similarity(&pair, &window, CONSTANTS, selection, Some(&mut map)).unwrap();
            assert_eq!(sums, similarity(&pair, &window, CONSTANTS, selection, None).unwrap());
            (sums, map)
        };
        assert!(compare(&a, &a).1.iter().all(|&value| value == 1.0));
        let SimilaritySums { similarity, contrast, pixels, range } = compare(&a, &a).0;
        assert_eq!([similarity, contrast, pixels], [35.0; 3]);
        assert_eq!(range, ValueRange { least: 0.0, greatest: 1.0 });
        assert_eq!(compare(&a, &b), compare(&b, &a));
        assert!(compare(&a, &b).1.iter().all(|&value| value < 1.0));
    }
}
