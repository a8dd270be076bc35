use super::descend::{EvaluatedLine, LocalModel};
use super::frame::SampleFrame;
use super::logistic::{self, Line, LogisticScratch, Samples};
use super::*;
use crate::base::{Error, Progress};
use proptest::prelude::*;

/// Returns the squared residual of the best a and d for given b and c, by the textbook formula. If all samples lie near
/// the left plateau, it uses p − 1, because p would lose digits.
fn residual(x: &[f64], y: &[f64], b: f64, c: f64) -> f64 {
    let count = x.len() as f64;
    let u: Vec<f64> = x.iter().map(|x| (x / c).powf(b)).collect();
    let is_left = u.iter().all(|&u| u < 1.0);
    let p: Vec<f64> = u.iter().map(|u| if is_left { -u } else { 1.0 } / (1.0 + u)).collect();
    let (mean_p, mean_y) = (p.iter().sum::<f64>() / count, y.iter().sum::<f64>() / count);
    let square: f64 = p.iter().map(|p| (p - mean_p).powi(2)).sum();
    let product: f64 = p.iter().zip(y).map(|(p, y)| (p - mean_p) * (y - mean_y)).sum();
    let slope = if square > 0.0 { product / square } else { 0.0 };
    p.iter().zip(y).map(|(p, y)| (y - mean_y - slope * (p - mean_p)).powi(2)).sum()
}

/// Runs a test with the samples of a frame; their values are shifted to mean 0.
fn with_samples<R>(x: &[f64], y: &[f64], run: impl FnOnce(&SampleFrame, &Samples<'_>, &mut LogisticScratch) -> R) -> R {
    let frame = SampleFrame::new(x, |_| true, &Progress::new()).unwrap().unwrap();
    let mean = y.iter().sum::<f64>() / y.len() as f64;
    let mut packed = vec![[0.0; logistic::LANES]; frame.v.len()];
    for (to, &n) in packed.as_flattened_mut().iter_mut().zip(&frame.order) {
        *to = y[n] - mean;
    }
    let mut scratch = LogisticScratch::default();
    scratch.resize(frame.v.len());
    let samples =
        Samples { v: &frame.v, weight: &frame.weight, y: &packed, count: x.len() as f64, progress: &Progress::new() };
    run(&frame, &samples, &mut scratch)
}

fn positions(count: usize) -> Vec<f64> {
    (0..count).map(|n| 1e-4 * (3e4f64).powf(n as f64 / (count - 1) as f64)).collect()
}

proptest! {
    #[test]
    fn sums_and_their_derivatives_are_those_of_the_residual(
        values in prop::collection::vec(-1.0..1.0f64, 9..40), level in -6.0..6.0f64, rise in 0.2..20.0f64,
        origin in -1.0..1.0f64, falls: bool,
    ) {
        let x = positions(values.len());
        with_samples(&x, &values, |frame, samples, scratch| {
            let line = Line { level, rise: if falls { -rise } else { rise }, origin };
            let found = EvaluatedLine::evaluate(samples, &frame.limits, line, scratch);
            let (b, c) = (frame.over_ln(rise), frame.x(line.origin - line.level / line.rise));
            // Values have size 1: the rounding error is a multiple of 2⁻⁵³ of their squares.
            let total: f64 = values.iter().map(|y| y * y).sum();
            prop_assert!((found.sums.residual - residual(&x, &values, b, c)).abs() < 1e-11 * total);
            let LocalModel { line: at, gradient, hessian } = LocalModel::new(&found, samples.count);
            let mut half = |level: f64, stretch: f64| {
                let line = Line { level: at.level + level, rise: at.rise * stretch.exp(), origin: at.origin };
                0.5 * logistic::evaluate(samples, &line, scratch).residual
            };
            // Central differences have an error of h² times higher derivatives, plus 2⁻⁵³/h or 2⁻⁵³/h² from rounding.
            let h = 1e-4;
            let close = |found: f64, expected: f64, scale: f64| {
                prop_assert!((found - expected).abs() < 1e-5 * scale, "{} {}", found, expected);
                Ok(())
            };
            let scale = total * (1.0 + at.rise * at.rise);
            close(gradient[0], (half(h, 0.0) - half(-h, 0.0)) / (2.0 * h), scale)?;
            close(gradient[1], (half(0.0, h) - half(0.0, -h)) / (2.0 * h), scale)?;
            let middle = half(0.0, 0.0);
            close(hessian[0], (half(h, 0.0) - 2.0 * middle + half(-h, 0.0)) / (h * h), scale)?;
            close(hessian[2], (half(0.0, h) - 2.0 * middle + half(0.0, -h)) / (h * h), scale)?;
            let mixed = half(h, h) - half(h, -h) - half(-h, h) + half(-h, -h);
            close(hessian[1], mixed / (4.0 * h * h), scale)?;
            Ok(())
        })?;
    }

    #[test]
    fn no_line_of_a_fine_grid_is_better(noise in prop::collection::vec(-0.4..0.4f64, 8..25), share in 0.2..0.8f64) {
        let x = positions(noise.len());
        let after = |n: usize| if n as f64 > share * noise.len() as f64 { 1.0 } else { 0.0 };
        let values: Vec<f64> = noise.iter().enumerate().map(|(n, noise)| noise + after(n)).collect();
        let curve = fit_4pl(&x, &values, x.len(), &Progress::new()).unwrap()[0];
        prop_assume!(!matches!(curve.status, Status::Flat));
        let found = curve.rms * curve.rms * x.len() as f64;
        for i in 0..60 {
            let b = 0.02 * 1.15f64.powi(i);
            for j in 0..120 {
                let c = 1e-6 * 1.25f64.powi(j);
                let other = residual(&x, &values, b, c);
                prop_assert!(found <= other * (1.0 + 1e-9) + 1e-20, "{} {} at {} {}", found, other, b, c);
            }
        }
    }
}

#[test]
fn steps_explain_the_stated_fraction() {
    let x = positions(12);
    let y = [0.9, 1.0, 1.1, 1.0, 0.3, -0.9, -1.0, -1.1, -1.0, -1.0, -1.0, -1.0];
    with_samples(&x, &y, |frame, samples, scratch| {
        let total: f64 = samples.y.as_flattened().iter().map(|y| y * y).sum();
        let unit: Vec<f64> = samples.y.as_flattened()[..12].iter().map(|y| y / total.sqrt()).collect();
        for start in curve::best_steps(frame, &unit).into_iter().flatten() {
            // The steepest allowed line of the same transition.
            let limit = Line { rise: frame.limits.steepest * start.line.rise.signum(), ..start.line };
            let found = EvaluatedLine::evaluate(samples, &frame.limits, limit, scratch);
            assert!((found.sums.residual / total - (1.0 - start.explained)).abs() < 1e-12);
        }
    });
}

#[test]
fn cancelled_fits_stop_and_wrong_lengths_are_refused() {
    let (x, y) = (positions(20), vec![0.5; 2000]);
    let progress = Progress::new();
    progress.cancel();
    assert_eq!(fit_4pl(&x, &y, 20, &progress), Err(Error::Cancelled));
    for (x, count) in [(&x[..], 0), (&x[..], 19), (&x[..19], 20)] {
        assert!(matches!(fit_4pl(x, &y, count, &Progress::new()), Err(Error::Value { argument: "x", .. })));
    }
}
