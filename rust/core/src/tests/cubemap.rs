use crate::base::Progress;
use crate::camera::{along_face, direction_from_face, face_from_direction};
use crate::cubemap::{CubeFaces, TexelFilter, direction_from_texel, lookup, nearest, texel_from_direction};
use glam::DVec3;

use super::{assert_near, cases, indices, number, numbers, rows};

#[test]
fn positions_on_faces_have_their_directions() {
    for case in cases("cubemap", "faces") {
        let face = number(&case["face"]) as u8;
        let (u, v) = (numbers(&case["u"]), numbers(&case["v"]));
        for (n, expected) in rows::<3>(&case["directions"]).into_iter().enumerate() {
            let found = direction_from_face(face, u[n], v[n]);
            assert_near(&case, &found.to_array(), &expected, number(&case["tolerance"]["float64"]));
            assert_eq!(along_face(face, DVec3::from_array(expected)), (u[n], v[n], 1.0));
        }
    }
}

#[test]
fn directions_have_their_faces_and_positions() {
    for case in cases("cubemap", "directions") {
        let (faces, u, v) = (indices(&case["face"]), numbers(&case["u"]), numbers(&case["v"]));
        for (n, direction) in rows::<3>(&case["directions"]).into_iter().map(DVec3::from_array).enumerate() {
            let (face, right, down) = face_from_direction(direction);
            assert_eq!(u32::from(face), faces[n], "{}: {direction}", case["region"]);
            assert_near(&case, &[right, down], &[u[n], v[n]], number(&case["tolerance"]["float64"]));
        }
    }
}

#[test]
fn directions_pass_through_their_texels() {
    for case in cases("cubemap", "directions") {
        let directions = rows::<3>(&case["directions"]);
        let single: Vec<[f32; 3]> = directions.iter().map(|d| d.map(|x| x as f32)).collect();
        for (size, expected) in case["texels"].as_object().unwrap() {
            let (size, expected) = (size.parse().unwrap(), indices(expected));
            let found: Vec<u32> =
                directions.iter().map(|&d| texel_from_direction(DVec3::from_array(d), size)).collect();
            assert_eq!(found, expected, "{}, {size} texels across", case["region"]);
            let map: Vec<u32> = (0..6 * size * size).collect();
            let faces = CubeFaces::new(&map, size, 1).unwrap();
            let mut found = vec![0; directions.len()];
            nearest(faces, &directions, &mut found, &Progress::new()).unwrap();
            assert_eq!(found, expected, "{}, {size} texels across", case["region"]);
            nearest(faces, &single, &mut found, &Progress::new()).unwrap();
            assert_eq!(found, expected, "{}, {size} texels across", case["region"]);
        }
    }
}

#[test]
fn texels_have_their_directions() {
    for case in cases("cubemap", "texels") {
        let size = number(&case["size"]) as u32;
        for (texel, expected) in indices(&case["texels"]).into_iter().zip(rows::<3>(&case["directions"])) {
            let found = direction_from_texel(texel, size);
            assert_near(&case, &found.to_array(), &expected, number(&case["tolerance"]["float64"]));
            assert_eq!(texel_from_direction(DVec3::from_array(expected), size), texel);
        }
    }
}

#[test]
fn filters_give_the_values_of_the_map() {
    for case in cases("cubemap", "lookups") {
        let map = numbers(&case["map"]);
        let faces = CubeFaces::new(&map, number(&case["size"]) as u32, 1).unwrap();
        let directions = rows::<3>(&case["directions"]);
        let mut found = vec![0.0; directions.len()];
        nearest(faces, &directions, &mut found, &Progress::new()).unwrap();
        assert_near(&case, &found, &numbers(&case["nearest"]), 0.0);
        let bound = number(&case["tolerance"]["float64"]);
        for (filter, name, bound) in
            [(TexelFilter::Linear, "linear", bound), (TexelFilter::Min, "min", 0.0), (TexelFilter::Max, "max", 0.0)]
        {
            lookup(faces, &directions, filter, &mut found, &Progress::new()).unwrap();
            assert_near(&case, &found, &numbers(&case[name]), bound);
        }
    }
}
