//! Any samples for a curve: an error, or curves of numbers.

#![no_main]

use arbitrary::Arbitrary;
use libfuzzer_sys::fuzz_target;
use nearfar_core::base::Progress;
use nearfar_core::lod::{Status, fit_4pl};

#[derive(Arbitrary, Debug)]
struct Input {
    samples: Vec<(f64, f64)>,
}

fuzz_target!(|input: Input| {
    let (x, y): (Vec<f64>, Vec<f64>) = input.samples.iter().copied().unzip();
    if let Ok(curves) = fit_4pl(&x, &y, x.len(), &Progress::new()) {
        for curve in curves.iter().filter(|curve| matches!(curve.status, Status::Fitted)) {
            assert!(
                [curve.a, curve.b, curve.c, curve.d, curve.rms].iter().all(|number| number.is_finite()),
                "{curve:?}"
            );
        }
    }
});
