//! Any coefficients as a lens: an error, or radii that are distorted to numbers, for which numbers are found again.

#![no_main]

use arbitrary::Arbitrary;
use libfuzzer_sys::fuzz_target;
use nearfar_core::base::Progress;
use nearfar_core::lens::{InverseMethod, RadialLens};

#[derive(Arbitrary, Debug)]
struct Input {
    k: Vec<f64>,
    tangential: [f64; 2],
    radii: Vec<f64>,
    steps: u8,
}

fuzz_target!(|input: Input| {
    let Ok(lens) = RadialLens::new(&input.k, input.tangential) else { return };
    assert!(lens.r_max() >= 0.0 && lens.reach >= 0.0, "{} {}", lens.r_max(), lens.reach);
    let mut distorted = vec![0.0; input.radii.len()];
    let mut again = distorted.clone();
    for refuse in [false, true] {
        if lens.distort_all(&input.radii, &mut distorted, refuse, &Progress::new()).is_err() {
            continue;
        }
        for method in [InverseMethod::Newton, InverseMethod::Table, InverseMethod::FixedPoint(input.steps.into())] {
            let found = lens.undistort_all(&distorted, &mut again, method, refuse, &Progress::new());
            if refuse && method == InverseMethod::Newton && found.is_ok() {
                assert!(again.iter().all(|radius| !radius.is_nan()), "{distorted:?} {again:?}");
            }
        }
        for (&from, &through) in input.radii.iter().zip(&distorted) {
            assert!(!refuse || !from.is_finite() || !through.is_nan(), "{from} {through}");
        }
    }
    let (bound, end) = lens.table_bound();
    assert!(!bound.is_nan() && !end.is_nan());
});
