use crate::base::Progress;
use crate::lod::{Status, fit_4pl};

use super::{assert_near, assert_relative, cases, number, numbers};

#[test]
fn fits_find_the_parameters_of_exact_samples() {
    for case in cases("fit_4pl", "fits") {
        let (x, y) = (numbers(&case["x"]), numbers(&case["y"]));
        let curve = fit_4pl(&x, &y, x.len(), &Progress::new()).unwrap()[0];
        assert_eq!(curve.status, Status::Fitted, "{}", case["region"]);
        let [a, b, c, d] = ["a", "b", "c", "d"].map(|name| number(&case[name]));
        let bound = number(&case["tolerance"]["float64"]);
        assert_relative(&case, &[curve.b, curve.c], &[b, c], bound);
        assert_near(&case, &[curve.a, curve.d], &[a, d], bound * a.abs().max(d.abs()));
    }
}
