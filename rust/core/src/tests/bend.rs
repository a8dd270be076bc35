use crate::base::Progress;
use crate::bend::{RayCurve, bend_rays, margin};
use crate::morph::Kind;
use glam::DVec3;
use serde_json::Value;

use super::{assert_near, cases, morph_of, number, numbers, row, rows};

/// Returns the kinds of a case; a blend needs near geometry.
fn kinds(case: &Value) -> &'static [Kind] {
    if number(&case["r2"]) > 0.0 { &[Kind::Blend, Kind::Cylinder] } else { &[Kind::Cylinder] }
}

#[test]
fn curves_satisfy_the_equation() {
    for case in cases("bend", "cases") {
        let bound = number(&case["tolerance"]["float64"]);
        for &kind in kinds(&case) {
            let morph = morph_of(&case, kind);
            let curve = RayCurve::new(&morph, DVec3::from_array(row(&case["direction"])).normalize());
            let (s, y, points) = (numbers(&case["s"]), numbers(&case["y"]), rows::<3>(&case["points"]));
            for n in 0..s.len() {
                for guess in [0.0, 0.5 * curve.ray_distance, curve.ray_distance] {
                    let found = curve.offset(s[n], guess);
                    assert_near(&case, &[found], &y[n..=n], bound);
                    assert_near(&case, &curve.point(s[n], found).to_array(), &points[n], bound);
                }
            }
        }
    }
}

#[test]
fn polylines_lie_on_the_curve_and_end_on_the_rays_from_the_centre() {
    // Radians; the bounds for polylines use this tolerance.
    let tolerance = 1e-6;
    for case in cases("bend", "cases") {
        for &kind in kinds(&case) {
            let morph = morph_of(&case, kind);
            let direction = row::<3>(&case["direction"]);
            let (line, longest) = bend_rays(&morph, &[direction], tolerance, &Progress::new()).unwrap();
            assert_eq!(line.len(), longest);
            let unit = DVec3::from_array(direction).normalize();
            let line: Vec<DVec3> = line.into_iter().map(DVec3::from_array).collect();
            let along = |p: DVec3| (p - morph.user).dot(unit);
            for (&s, point) in numbers(&case["s"]).iter().zip(rows::<3>(&case["points"])) {
                let leg = line.windows(2).find(|leg| along(leg[0]) <= s && s <= along(leg[1]));
                let found = match leg {
                    Some(leg) => leg[0].lerp(leg[1], (s - along(leg[0])) / (along(leg[1]) - along(leg[0]))),
                    None => line[longest - 1] + unit * (s - along(line[longest - 1])),
                };
                assert_near(&case, &found.to_array(), &point, number(&case["tolerance"]["polyline"]));
            }
            if !case["end"].is_null() {
                let bound = number(&case["tolerance"]["float64"]);
                assert_near(&case, &line[longest - 1].to_array(), &row::<3>(&case["end"]), bound);
            }
        }
    }
}

#[test]
fn the_cylinders_margin_is_the_distance_to_its_near_radius() {
    for case in cases("bend", "cylinder_margins") {
        let found = margin(&morph_of(&case, Kind::Cylinder)).unwrap();
        assert_near(&case, &[found], &[number(&case["margin"])], number(&case["tolerance"]["float64"]));
    }
}
