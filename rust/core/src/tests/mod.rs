//! Comparison of kernels with the test vectors that all languages share: inputs, exact outputs, and error bounds.

mod bend;
mod cubemap;
mod fit_4pl;
mod lens;
mod morph;

use crate::morph::{Kind, Morph};
use glam::DVec3;
use serde_json::Value;

/// Returns the cases of a section of a file.
fn cases(file: &str, section: &str) -> Vec<Value> {
    let path = format!("{}/../../tests/vectors/{file}.json", env!("CARGO_MANIFEST_DIR"));
    let document: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    assert_eq!((&document["format"], &document["version"]), (&"nearfar.vectors".into(), &1.into()));
    let cases = document[section].as_array().unwrap().clone();
    assert!(!cases.is_empty());
    cases
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    serde_json::from_value(value.clone()).unwrap()
}

fn indices(value: &Value) -> Vec<u32> {
    serde_json::from_value(value.clone()).unwrap()
}

fn row<const N: usize>(value: &Value) -> [f64; N] {
    numbers(value).try_into().unwrap()
}

fn rows<const N: usize>(value: &Value) -> Vec<[f64; N]> {
    value.as_array().unwrap().iter().map(row).collect()
}

/// Returns the morph of a case.
fn morph_of(case: &Value, kind: Kind) -> Morph {
    let [user, center] = ["user", "center"].map(|name| DVec3::from_array(row(&case[name])));
    let full = Morph::new(user, center, number(&case["r1"]), number(&case["r2"]), kind).unwrap();
    full.with_strength(case["strength"].as_f64().unwrap_or(1.0)).unwrap()
}

/// Asserts that numbers differ from the expected ones by at most a bound.
#[track_caller]
fn assert_near(case: &Value, found: &[f64], expected: &[f64], bound: f64) {
    assert_within(case, found, expected, |_| bound);
}

/// Asserts that numbers differ from the expected ones by at most a relative bound.
#[track_caller]
fn assert_relative(case: &Value, found: &[f64], expected: &[f64], bound: f64) {
    assert_within(case, found, expected, |expected| bound * expected.abs());
}

#[track_caller]
fn assert_within(case: &Value, found: &[f64], expected: &[f64], bound: impl Fn(f64) -> f64) {
    assert_eq!(found.len(), expected.len(), "{}", case["region"]);
    for (n, (&found, &expected)) in found.iter().zip(expected).enumerate() {
        let (error, bound) = ((found - expected).abs(), bound(expected));
        assert!(error <= bound, "{}: {found} for {expected} at {n}, error {error:e} > {bound:e}", case["region"]);
    }
}
