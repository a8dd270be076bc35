use crate::base::Progress;
use crate::morph::Kind;
use glam::DVec3;
use serde_json::Value;

use super::{assert_near, cases, morph_of, number, numbers, rows};

const FILES: [(&str, Kind); 2] = [("blend", Kind::Blend), ("cylinder", Kind::Cylinder)];

fn opposed(case: &Value) -> Vec<bool> {
    case["opposed"].as_array().unwrap().iter().map(|x| x.as_bool().unwrap()).collect()
}

#[test]
fn single_points_equal_the_formula() {
    for (file, kind) in FILES {
        for case in cases(file, "cases") {
            let morph = morph_of(&case, kind);
            let (tolerance, weights) = (&case["tolerance"], numbers(&case["weight"]));
            let (points, shown, opposed) = (rows::<3>(&case["points"]), rows::<3>(&case["shown"]), opposed(&case));
            for n in 0..points.len() {
                let found = morph.examine(DVec3::from_array(points[n]));
                assert_near(&case, &found.point.to_array(), &shown[n], number(&tolerance["float64"]));
                assert_near(&case, &[found.weight], &[weights[n]], number(&tolerance["weight"]));
                assert_eq!(found.opposed, opposed[n], "{}", case["region"]);
            }
        }
    }
}

#[test]
fn streams_of_points_equal_the_formula() {
    for (file, kind) in FILES {
        for case in cases(file, "cases") {
            let morph = morph_of(&case, kind);
            let (points, shown) = (rows::<3>(&case["points"]), rows::<3>(&case["shown"]));
            let count = opposed(&case).iter().filter(|&&opposed| opposed).count() as u64;
            let mut double = vec![[0.0; 3]; points.len()];
            let opposed = morph.apply_all(&points, &mut double, &Progress::new()).unwrap();
            assert_eq!(opposed, count, "{}", case["region"]);
            assert_near(&case, double.as_flattened(), shown.as_flattened(), number(&case["tolerance"]["float64"]));
            let single: Vec<[f32; 3]> = points.iter().map(|p| p.map(|x| x as f32)).collect();
            let mut moved = vec![[0.0; 3]; points.len()];
            let opposed = morph.apply_all(&single, &mut moved, &Progress::new()).unwrap();
            assert_eq!(opposed, count, "{}", case["region"]);
            let moved: Vec<[f64; 3]> = moved.iter().map(|p| p.map(f64::from)).collect();
            assert_near(&case, moved.as_flattened(), shown.as_flattened(), number(&case["tolerance"]["float32"]));
        }
    }
}

#[test]
fn far_distances_are_those_of_far_points() {
    for (file, kind) in FILES {
        for case in cases(file, "cases") {
            let morph = morph_of(&case, kind);
            let (weights, distances) = (numbers(&case["weight"]), numbers(&case["distance"]));
            for (n, point) in rows::<3>(&case["points"]).into_iter().enumerate().filter(|&(n, _)| weights[n] == 0.0) {
                let from_center = DVec3::from_array(point) - morph.center;
                let found = morph.far_distance(from_center.normalize(), from_center.length());
                assert_near(&case, &[found], &distances[n..=n], number(&case["tolerance"]["float64"]));
            }
        }
    }
}
