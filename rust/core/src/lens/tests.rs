//! Tests of f⁻¹ against f in twice the precision, for the vector kernels and for the scalar search.

use proptest::prelude::*;

use super::exact::residual;
use super::*;
use crate::base::Progress;

/// Returns whether r is the root: its residual is at most two ulps, or its neighbours lie on both sides of the root.
fn is_root(k: &[f64], r: f64, x: f64) -> bool {
    let ulp = x.abs() * f64::EPSILON;
    residual(k, r, x).abs() <= 2.0 * ulp || residual(k, r.next_down(), x) <= 0.0 && residual(k, r.next_up(), x) >= 0.0
}

#[test]
fn every_radius_of_a_headset_is_inverted() {
    for k in
        [vec![0.22, 0.24], vec![], vec![0.1], vec![-0.2, 0.0], vec![-0.4, 0.05], vec![-0.3, 0.1], vec![0.0, 0.0, 0.7]]
    {
        let lens = RadialLens::new(&k, [0.0; 2]).unwrap();
        let end = lens.radial.x_max.min(40.0);
        let x: Vec<f64> = (0..=20_000).map(|n| end * (f64::from(n) / 20_000.0)).collect();
        let mut r = vec![0.0; x.len()];
        lens.undistort_all(&x, &mut r, InverseMethod::Newton, true, &Progress::new()).unwrap();
        for (&x, &r) in x.iter().zip(&r) {
            assert!(is_root(&k, r, x), "{k:?} {x} {r} {}", residual(&k, r, x));
        }
        let mut cubic = vec![0.0; x.len()];
        lens.undistort_all(&x, &mut cubic, InverseMethod::Table, true, &Progress::new()).unwrap();
        let (bound, _) = lens.table_bound();
        assert!(bound <= 5e-10, "{k:?} {bound}");
        for (x, (cubic, exact)) in x.iter().zip(cubic.iter().zip(&r)) {
            assert!((cubic - exact).abs() <= bound * exact, "{k:?} {x} {cubic} {exact} {bound}");
        }
    }
}

proptest! {
    #[test]
    fn roots_are_roots(
        k in prop::collection::vec(-1.0..1.0f64, 0..6), scale in -3..3i32, shares in prop::collection::vec(0.0..=1.0f64, 40),
    ) {
        let k: Vec<f64> = k.iter().map(|c| c * 10.0f64.powi(scale)).collect();
        let lens = RadialLens::new(&k, [0.0; 2]).unwrap();
        let x: Vec<f64> = shares.iter().map(|share| share * lens.radial.x_max.min(1e3)).collect();
        let mut r = vec![0.0; x.len()];
        lens.undistort_all(&x, &mut r, InverseMethod::Newton, true, &Progress::new()).unwrap();
        for (&x, &r) in x.iter().zip(&r) {
            prop_assert!(r <= lens.r_max() && is_root(&k, r, x), "{:?} {} {}", k, x, r);
            prop_assert!(is_root(&k, lens.undistort(x), x));
        }
    }
}
