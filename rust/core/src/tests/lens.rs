use crate::base::Progress;
use crate::lens::{InverseMethod, RadialLens};
use serde_json::Value;

use super::{assert_near, assert_relative, cases, number, numbers, row, rows};

fn lens_of(case: &Value) -> RadialLens {
    let tangential = if case["tangential"].is_null() { [0.0; 2] } else { row(&case["tangential"]) };
    RadialLens::new(&numbers(&case["k"]), tangential).unwrap()
}

#[test]
fn distorted_radii_equal_the_polynomial() {
    for case in cases("lens", "radial") {
        let (lens, r, tolerance) = (lens_of(&case), numbers(&case["r"]), &case["tolerance"]);
        let mut found = vec![0.0; r.len()];
        lens.distort_all(&r, &mut found, true, &Progress::new()).unwrap();
        assert_relative(&case, &found, &numbers(&case["distorted"]), number(&tolerance["distort"]));
        lens.derivative_all(&r, &mut found, true, &Progress::new()).unwrap();
        assert_near(&case, &found, &numbers(&case["derivative"]), number(&tolerance["derivative"]));
        for (&r, &expected) in r.iter().zip(&numbers(&case["distorted"])) {
            assert_relative(&case, &[lens.distort(r.abs())], &[expected.abs()], number(&tolerance["distort"]));
        }
    }
}

#[test]
fn every_method_undistorts_radii() {
    for case in cases("lens", "radial") {
        let (lens, x, tolerance) = (lens_of(&case), numbers(&case["distorted"]), &case["tolerance"]);
        let expected = numbers(&case["undistorted"]);
        let exact = number(&tolerance["undistort"]);
        let mut found = vec![0.0; x.len()];
        for (method, bound) in
            [(InverseMethod::Newton, exact), (InverseMethod::Table, exact + number(&tolerance["lut"]))]
        {
            lens.undistort_all(&x, &mut found, method, true, &Progress::new()).unwrap();
            assert_relative(&case, &found, &expected, bound);
        }
        for (&x, &expected) in x.iter().zip(&expected) {
            assert_relative(&case, &[lens.undistort(x.abs())], &[expected.abs()], exact);
        }
    }
}

#[test]
fn fixed_point_iteration_gives_the_steps_of_the_vectors() {
    for case in cases("lens", "radial") {
        let (lens, x) = (lens_of(&case), numbers(&case["distorted"]));
        let mut found = vec![0.0; x.len()];
        lens.undistort_all(&x, &mut found, InverseMethod::FixedPoint(4), true, &Progress::new()).unwrap();
        assert_relative(&case, &found, &numbers(&case["fixed_point"]), number(&case["tolerance"]["fixed_point"]));
    }
}

#[test]
fn lenses_fold_at_the_root_of_the_derivative() {
    for case in cases("lens", "radial") {
        let lens = lens_of(&case);
        if case["r_max"].is_null() {
            assert_eq!(lens.r_max(), f64::INFINITY, "{}", case["region"]);
            continue;
        }
        let bound = number(&case["tolerance"]["fold"]);
        assert_relative(&case, &[lens.r_max()], &[number(&case["r_max"])], bound);
        assert_relative(
            &case,
            &[lens.x_max()],
            &[number(&case["distorted_max"])],
            number(&case["tolerance"]["distort"]),
        );
    }
}

#[test]
fn points_are_distorted_and_undistorted() {
    for case in cases("lens", "points") {
        let (lens, points) = (lens_of(&case), rows::<2>(&case["points"]));
        let expected = [rows::<2>(&case["distorted"]), rows::<2>(&case["undistorted"])];
        let mut found = vec![[0.0; 2]; points.len()];
        lens.distort_points(&points, &mut found, true, &Progress::new()).unwrap();
        let bound = |name: &str| number(&case["tolerance"][name]);
        assert_near(&case, found.as_flattened(), expected[0].as_flattened(), bound("distort"));
        lens.undistort_points(&expected[0], &mut found, true, &Progress::new()).unwrap();
        assert_near(&case, found.as_flattened(), expected[1].as_flattened(), bound("undistort"));
    }
}
