//! Any numbers as a morph: an error, or points, rays and a margin that are numbers.

#![no_main]

use arbitrary::Arbitrary;
use glam::DVec3;
use libfuzzer_sys::fuzz_target;
use nearfar_core::base::Progress;
use nearfar_core::bend::{bend_rays, margin};
use nearfar_core::bounds::{SphereMethod, bounding_sphere};
use nearfar_core::morph::{Kind, Morph};

#[derive(Arbitrary, Debug)]
struct Input {
    user: [f64; 3],
    center: [f64; 3],
    radii: [f64; 2],
    is_cylinder: bool,
    points: Vec<[f64; 3]>,
    tolerance: f64,
}

fuzz_target!(|input: Input| {
    for method in [SphereMethod::Exact, SphereMethod::Ritter, SphereMethod::Best] {
        if let Ok(sphere) = bounding_sphere(&input.points, method, &Progress::new()) {
            assert!(sphere.radius >= 0.0 && sphere.center.is_finite(), "{sphere:?}");
        }
    }
    let kind = if input.is_cylinder { Kind::Cylinder } else { Kind::Blend };
    let (user, center) = (DVec3::from_array(input.user), DVec3::from_array(input.center));
    let Ok(morph) = Morph::new(user, center, input.radii[0], input.radii[1], kind) else { return };
    let mut shown = input.points.clone();
    morph.apply_all(&input.points, &mut shown, &Progress::new()).expect("nothing cancels it");
    if let Ok(margin) = margin(&morph) {
        assert!(!margin.is_nan());
    }
    // Few rays, because a small tolerance takes many points.
    let few = &input.points[..input.points.len().min(4)];
    if let Ok((points, longest)) = bend_rays(&morph, few, input.tolerance, &Progress::new()) {
        assert_eq!(points.len(), longest * few.len());
    }
});
