use super::super::select::Model;
use super::hull::{Choice, LANES, Ladder, Lanes, RatedModel, slopes};
use super::plan::{Filling, Step};
use super::prices::{ALWAYS, NEVER, class};
use crate::base::random::uniform;

/// Returns a source of random numbers from 0 to 1.
fn random_numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut index = 0..;
    move || uniform(seed, 0, index.next().unwrap())
}

/// Creates a ladder of levels with the given triangle counts.
fn ladder(triangles: &[i64]) -> Ladder {
    let curves = vec![[1.0, 1.0, 1.0, 0.5]; triangles.len() - 1];
    let model = Model { curves: &curves, range: [0.0, 1.0], pixel: f64::NAN };
    Ladder::new(&RatedModel { model, rises: &[], triangles }, 0).unwrap()
}

/// Returns the slope of the smallest concave function above the points between levels `step` + 1 and `step`.
fn slope(triangles: &[i64], scores: &[f64], step: usize) -> f64 {
    let height = |triangles: &[i64], at: f64| {
        let mut most = f64::NEG_INFINITY;
        for j in 0..triangles.len() {
            for k in 0..triangles.len() {
                let (right, left) = (triangles[j] as f64, triangles[k] as f64);
                if left <= at && at <= right && left < right {
                    most = most.max(scores[k] + (scores[j] - scores[k]) * (at - left) / (right - left));
                }
            }
        }
        most
    };
    let (right, left) = (triangles[step] as f64, triangles[step + 1] as f64);
    ((height(triangles, right) - height(triangles, left)) / (right - left)).max(0.0)
}

#[test]
fn slopes_equal_the_upper_hull() {
    let mut random = random_numbers(1);
    for _ in 0..200 {
        let mut triangles: Vec<i64> =
            (0..2 + (random() * 9.0) as i64).map(|n| n * 100 + (random() * 90.0) as i64).collect();
        triangles.reverse();
        let ladder = ladder(&triangles);
        let scores: Vec<Lanes> = triangles.iter().map(|_| std::array::from_fn(|_| random())).collect();
        let mut found = vec![[0.0; LANES]; ladder.steps()];
        slopes(&ladder, &scores, &[0.0; LANES], Choice::All, &mut found);
        for lane in 0..LANES {
            let own: Vec<f64> = scores.iter().map(|scores| scores[lane]).collect();
            for (step, found) in found.iter().enumerate() {
                let expected = slope(&triangles, &own, step);
                assert!((found[lane] - expected).abs() <= 1e-12, "{} {expected}", found[lane]);
            }
            assert!(found.windows(2).all(|steps| steps[0][lane] <= steps[1][lane]));
        }
    }
}

#[test]
fn steps_of_an_edge_have_the_same_bits() {
    // The middle level lies below the edge between the others.
    let (ladder, mut found) = (ladder(&[1000, 300, 10]), [[0.0; LANES]; 2]);
    let scores = [[1.0; LANES], [0.4; LANES], [0.3; LANES]];
    slopes(&ladder, &scores, &[0.0; LANES], Choice::All, &mut found);
    assert_eq!(found[0][0].to_bits(), found[1][0].to_bits());
    assert!((found[0][0] - 0.7 / 990.0).abs() < 1e-15);
}

#[test]
fn floors_divide_the_hull() {
    let (ladder, mut found) = (ladder(&[1000, 300, 10]), [[0.0; LANES]; 2]);
    let scores = [[1.0; LANES], [0.4; LANES], [0.3; LANES]];
    slopes(&ladder, &scores, &[1.0; LANES], Choice::FromFloor, &mut found);
    assert_eq!(found[1][0], f64::INFINITY);
    assert!((found[0][0] - 0.6 / 700.0).abs() < 1e-15);
    slopes(&ladder, &scores, &[1.0; LANES], Choice::ToFloor, &mut found);
    assert_eq!(found[0][0], 0.0);
    assert!((found[1][0] - 0.1 / 290.0).abs() < 1e-15);
}

#[test]
fn levels_without_curves_are_left_out() {
    let curves = [[1.0, 1.0, 1.0, 0.5], [f64::NAN; 4], [1.0, 1.0, 1.0, 0.2]];
    let model = Model { curves: &curves, range: [0.0, 1.0], pixel: f64::NAN };
    let ladder = Ladder::new(&RatedModel { model, rises: &[], triangles: &[40, 30, 20, 10] }, 0).unwrap();
    assert_eq!((ladder.level.as_slice(), ladder.triangles.as_slice()), (&[0, 1, 3][..], &[40, 30, 10][..]));
    assert!(Ladder::new(&RatedModel { model, rises: &[], triangles: &[40, 30, 20, 35] }, 0).is_err());
}

#[test]
fn classes_rise_with_slopes() {
    let mut slopes: Vec<f64> = (-1022..1024).map(|n| 2f64.powi(n)).collect();
    let mut random = random_numbers(2);
    slopes.extend((0..10_000).map(|_| 2f64.powf(60.0 * random() - 50.0)));
    slopes.sort_by(f64::total_cmp);
    assert!(slopes.windows(2).all(|pair| class(pair[0]) <= class(pair[1])));
    assert!(slopes.iter().all(|&slope| (NEVER + 1..ALWAYS).contains(&class(slope))));
    assert_eq!((class(0.0), class(-1.0), class(f64::INFINITY)), (NEVER, NEVER, ALWAYS));
}

#[test]
fn smaller_steps_are_taken_after_a_step_that_does_not_fit() {
    let step = |object, to, triangles| Step { slope: 1.0 / f64::from(object + 1), object, to, triangles, gain: 1.0 };
    let steps = [step(0, 1, 50), step(1, 1, 60), step(1, 0, 1), step(2, 1, 40), step(3, 1, 30)];
    let mut filling = Filling::new(100, 0);
    filling.take(&steps);
    // An object whose step did not fit takes no later step.
    filling.take(&[step(3, 0, 1), step(4, 1, 10)]);
    assert_eq!((filling.remaining, filling.gain, filling.first_without_room.unwrap().slope), (0, 3.0, 0.5));
    assert_eq!(filling.levels(), [(0, 1), (2, 1), (4, 1)]);
}
