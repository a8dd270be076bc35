use std::sync::Arc;

use glam::{DAffine3, DQuat, DVec3, Vec3};
use rayon::ThreadPoolBuilder;

use self::read::{Read, Triangle};
use super::{Export, Glb, Kind, Settings};
use crate::base::random::uniform;
use crate::base::{Buffer, FaceMap, Progress};
use crate::scene::{Alpha, Instance, Material, Mesh, Scene, Texture};

mod read;

/// Creates `count` random triangles between vertices within a cube of 8 m, with all attributes.
fn random_mesh(seed: u64, count: u64, objects: FaceMap, materials: FaceMap) -> Mesh {
    let vertex_count = count + 2;
    let number = |stream: u64, row: u64| uniform(seed, stream, row) as f32;
    let rows = |stream: u64| (0..vertex_count).map(move |row| [0, 1, 2].map(|i| 8.0 * number(stream + i, row) - 4.0));
    let positions: Buffer<[f32; 3]> = rows(0).collect();
    let uvs: Buffer<[f32; 2]> =
        (0..vertex_count).map(|row| [3, 4].map(|stream| 6.0 * number(stream, row) - 3.0)).collect();
    let colors: Buffer<[u8; 4]> =
        (0..vertex_count).map(|row| [5, 6, 7, 8].map(|stream| (255.0 * number(stream, row)) as u8)).collect();
    let normals: Buffer<[f32; 3]> = rows(9).collect();
    let corner = |stream: u64, row: u64| (uniform(seed, stream, row) * vertex_count as f64) as u32;
    let faces: Buffer<[u32; 3]> = (0..count).map(|row| [12, 13, 14].map(|stream| corner(stream, row))).collect();
    let mesh = Mesh::new(positions, faces, Some(uvs), Some(colors), objects, materials).unwrap();
    mesh.with_normals(Some(normals)).unwrap()
}

fn plain_mesh(seed: u64, count: u64) -> Arc<Mesh> {
    let mesh = random_mesh(seed, count, FaceMap::Uniform(-1), FaceMap::Uniform(0));
    let flat = FaceMap::Uniform(-1);
    Arc::new(Mesh::new(mesh.positions, mesh.faces, None, None, flat, FaceMap::Uniform(0)).unwrap())
}

fn instance(mesh: &Arc<Mesh>, to_scene: DAffine3, object: i32) -> Instance {
    Instance::new(Arc::clone(mesh), to_scene, Some(object)).unwrap()
}

fn pose(seed: u64, distance: f64) -> DAffine3 {
    let [x, y, z, a, b] = [0, 1, 2, 3, 4].map(|index| uniform(seed, 77, index));
    let rotation = DQuat::from_euler(glam::EulerRot::XYZ, 6.0 * a, 6.0 * b, 1.0);
    let translation = DVec3::new(2.0 * x - 1.0, 0.1 * y, 2.0 * z - 1.0) * distance;
    DAffine3::from_scale_rotation_translation(DVec3::splat(0.5 + x), rotation, translation)
}

fn scene(standing: Vec<Instance>, moving: Vec<Instance>) -> Scene {
    let cut = Material { alpha: Alpha::Mask { cutoff: 0.25 }, texture: Some(0), ..Material::default() };
    let blue = Material { base_color: [0.0, 0.0, 1.0, 1.0], ..Material::default() };
    let texture = Texture::new(2, 2, vec![[9; 4]; 4].into()).unwrap();
    Scene::new(DVec3::ZERO, standing, moving, Arc::new(vec![blue, cut]), Arc::new(vec![texture])).unwrap()
}

/// `groups` has the group of each object, then that of the faces without an object.
fn export(scene: &Scene, groups: &[u16], count: usize, settings: Settings) -> Export {
    let names = (0..groups.len() - 1).map(|object| format!("object {object}")).collect();
    Export::new(scene, groups, count, names, vec![Some("a.png".into())], settings, &Progress::new()).unwrap()
}

fn glb(export: &Export, group: u16) -> Glb {
    export.glb(group, &vec![None; export.shared.len()], &Progress::new()).unwrap()
}

const PLAIN: Settings = Settings { step: 1.0 / 1024.0, compressed: false };
const COMPRESSED: Settings = Settings { compressed: true, ..PLAIN };

/// Rounds triangles with area to multiples of `unit` and sorts them; each starts with its smallest corner.
fn rounded(triangles: impl IntoIterator<Item = [DVec3; 3]>, unit: f64) -> Vec<[[i64; 3]; 3]> {
    let mut all = vec![];
    for corners in triangles {
        let mut corners = corners.map(|p| p.to_array().map(|x| rounded_number(x / unit)));
        let [a, b, c] = corners.map(glam::I64Vec3::from_array);
        if (b - a).cross(c - a) == glam::I64Vec3::ZERO {
            continue;
        }
        let least = (0..3).min_by_key(|&i| corners[i]).unwrap();
        corners.rotate_left(least);
        all.push(corners);
    }
    all.sort_unstable();
    all
}

/// Rounds to an integer that float32 holds exactly: to a multiple of the least power of two, at least 1, for which the
/// quotient stays below 2²³.
fn rounded_number(x: f64) -> i64 {
    let mut power = 1.0;
    while (x / power).round_ties_even().abs() >= 2f64.powi(23) {
        power *= 2.0;
    }
    ((x / power).round_ties_even() * power) as i64
}

/// Returns the scene's triangles, placed in float64.
fn exact(scene: &Scene) -> Vec<[DVec3; 3]> {
    let triangles = |instance: &Instance| -> Vec<[DVec3; 3]> {
        let corner = |p: Vec3| instance.to_scene.transform_point3(p.as_dvec3());
        (0..instance.mesh.faces.len() as u32).map(|face| instance.mesh.corners(face).map(corner)).collect()
    };
    scene.instances().flat_map(triangles).collect()
}

fn corners(triangles: &[Triangle]) -> impl Iterator<Item = [DVec3; 3]> + '_ {
    triangles.iter().map(|&(corners, _)| corners)
}

#[test]
fn merged_triangles_equal_those_of_the_scene_rounded_to_the_grid_up_to_eight_kilometres() {
    for seed in 0..6 {
        let parts = (0..4).map(|i| instance(&plain_mesh(10 * seed + i, 60), pose(seed + i, 8000.0), 0)).collect();
        let scene = scene(parts, vec![]);
        for settings in [PLAIN, COMPRESSED] {
            let file = glb(&export(&scene, &[0, 0], 1, settings), 0);
            let found = Read::new(&file.bytes, &[]).triangles();
            assert_eq!(rounded(corners(&found), settings.step), rounded(exact(&scene), settings.step));
            let on_grid = |x: f64| (x / settings.step).fract() == 0.0;
            assert!(corners(&found).flatten().all(|p| p.to_array().into_iter().all(on_grid)));
            assert_eq!(file.statistics.position_error, settings.step / 2.0);
            assert_eq!((file.statistics.triangles, file.statistics.drawn), (found.len() as u64, found.len() as u64));
        }
    }
}

#[test]
fn far_corners_get_a_coarser_grid_and_the_error_is_reported() {
    let scene = scene(vec![instance(&plain_mesh(1, 50), DAffine3::from_translation(DVec3::X * 20_000.0), 0)], vec![]);
    let file = glb(&export(&scene, &[0, 0], 1, COMPRESSED), 0);
    assert_eq!(file.statistics.position_error, 2.0 / 1024.0);
    let found = Read::new(&file.bytes, &[]).triangles();
    assert_eq!(rounded(corners(&found), COMPRESSED.step), rounded(exact(&scene), COMPRESSED.step));
}

#[test]
fn compressed_arrays_are_the_plain_ones_bit_for_bit() {
    let materials = FaceMap::PerFace((0..400).map(|face| face % 3 - 1).collect());
    let mesh = Arc::new(random_mesh(3, 400, FaceMap::Uniform(-1), materials));
    let scene = scene(vec![instance(&mesh, pose(5, 100.0), 0)], vec![]);
    let [plain, compressed] = [PLAIN, COMPRESSED].map(|settings| {
        let file = glb(&export(&scene, &[0, 0], 1, settings), 0);
        Read::new(&file.bytes, &[])
    });
    let primitives = |file: &Read| file.list("meshes")[0]["primitives"].as_array().unwrap().clone();
    let (plain_primitives, compressed_primitives) = (primitives(&plain), primitives(&compressed));
    // No material, the blue one, which needs no texture coordinates, and the textured one.
    assert_eq!((plain_primitives.len(), compressed_primitives.len()), (3, 3));
    for (a, b) in plain_primitives.iter().zip(&compressed_primitives) {
        // The codec for triangles may rotate the corners.
        let from_least = |corners: Vec<u32>| -> Vec<[u32; 3]> {
            let turned = |&[a, b, c]: &[u32; 3]| [[a, b, c], [b, c, a], [c, a, b]].into_iter().min();
            corners.as_chunks().0.iter().filter_map(turned).collect()
        };
        let faces = [plain.corners(&a["indices"]), compressed.corners(&b["indices"])].map(from_least);
        assert!(faces[0] == faces[1]);
        for name in ["POSITION", "TEXCOORD_0", "COLOR_0"] {
            assert_eq!(a["attributes"].get(name).is_some(), b["attributes"].get(name).is_some());
            if let Some(accessor) = a["attributes"].get(name) {
                assert!(plain.bytes(accessor) == compressed.bytes(&b["attributes"][name]), "{name}");
            }
        }
        let exact = plain.floats::<3>(&a["attributes"]["NORMAL"]);
        let short = compressed.bytes(&b["attributes"]["NORMAL"]);
        for (exact, short) in exact.iter().zip(short.chunks_exact(4)) {
            let short = Vec3::from_array([0, 1, 2].map(|i| f32::from(short[i] as i8))).normalize();
            assert!(short.distance(Vec3::from_array(*exact)) < 1e-6);
        }
    }
    let textured = plain_primitives.iter().filter(|primitive| primitive["attributes"].get("TEXCOORD_0").is_some());
    assert_eq!(textured.count(), 1);
    assert!(plain.document.get("extensionsUsed").is_none());
}

#[test]
fn shared_meshes_are_written_once_and_placed_within_their_bound() {
    let mesh = plain_mesh(7, 40);
    let standing: Vec<Instance> = (0..9).map(|i| instance(&mesh, pose(i, 500.0), i as i32)).collect();
    let scene = scene(standing, vec![instance(&mesh, pose(99, 10.0), 9)]);
    let groups = [0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0];
    for settings in [PLAIN, COMPRESSED] {
        let export = export(&scene, &groups, 3, settings);
        assert_eq!(export.shared.len(), 1);
        assert_eq!(export.shared[0].groups, [0, 1]);
        let blob = export.shared[0].bytes().unwrap();
        let mut found = vec![];
        for group in [0, 1] {
            let inside = glb(&export, group);
            let outside = export.glb(group, &[Some("mesh.bin".into())], &Progress::new()).unwrap();
            assert!(inside.bytes.len() > outside.bytes.len() + blob.len() / 2);
            assert_eq!(inside.statistics.drawn, outside.statistics.drawn);
            assert_eq!(outside.statistics.triangles, 0);
            let outside = Read::new(&outside.bytes, &[("mesh.bin", blob.clone())]);
            let triangles = outside.triangles();
            assert_eq!(Read::new(&inside.bytes, &[]).triangles(), triangles);
            assert_eq!(outside.list("meshes").len(), 1);
            found.extend(corners(&triangles).map(|corners| (corners, inside.statistics.position_error)));
        }
        // Each triangle is compared with the nearest of the scene, corner by corner, over all pairs.
        let exact = exact(&scene);
        let stored = export.shared[0].statistics();
        assert_eq!(found.len() as u64, 10 * stored.triangles);
        let rotations = |[a, b, c]: [DVec3; 3]| [[a, b, c], [b, c, a], [c, a, b]];
        let error =
            |a: [DVec3; 3], b: [DVec3; 3]| (0..3).map(|i| (a[i] - b[i]).abs().max_element()).fold(0.0, f64::max);
        for (corners, bound) in found {
            let nearest = exact.iter().flat_map(|&other| rotations(other)).map(|other| error(corners, other));
            let nearest = nearest.fold(f64::INFINITY, f64::min);
            assert!(nearest <= bound + 1e-12 && bound <= settings.step, "{nearest} {bound}");
        }
    }
}

#[test]
fn mirrored_placements_keep_their_fronts() {
    let mesh = plain_mesh(11, 30);
    let mirror = DAffine3::from_scale(DVec3::new(1.0, 1.0, -1.0));
    let poses = [pose(1, 50.0), pose(2, 50.0) * mirror, pose(3, 50.0) * mirror, pose(4, 50.0)];
    let standing = poses.iter().map(|&pose| instance(&mesh, pose, 0)).collect();
    let moving = vec![instance(&plain_mesh(12, 30), pose(5, 50.0) * mirror, 1)];
    let scene = scene(standing, moving);
    for settings in [PLAIN, COMPRESSED] {
        let export = export(&scene, &[0, 0, 0], 1, settings);
        assert_eq!(export.shared.len(), 2, "one for each side");
        let file = glb(&export, 0);
        let found = Read::new(&file.bytes, &[]).triangles();
        // Normals are rounded coarsely, because this compares the winding, not the error.
        let normal = |[a, b, c]: &[DVec3; 3]| (b - a).cross(c - a).normalize().to_array();
        let normals = |triangles: &[[DVec3; 3]]| {
            let rounded = triangles.iter().map(|corners| normal(corners).map(|x| (x * 20.0).round() as i64));
            let mut normals: Vec<[i64; 3]> = rounded.collect();
            normals.sort_unstable();
            normals
        };
        let found: Vec<_> = corners(&found).collect();
        let exact: Vec<_> =
            exact(&scene).into_iter().filter(|[a, b, c]| (b - a).cross(c - a).length() > 1e-3).collect();
        let same = normals(&found).iter().zip(&normals(&exact)).filter(|(a, b)| a == b).count();
        assert!(found.len() == exact.len() && same * 10 > 9 * exact.len(), "{same} of {}", exact.len());
        let turned = normals(&exact.iter().map(|&[a, b, c]| [a, c, b]).collect::<Vec<_>>());
        assert!(normals(&found).iter().zip(&turned).filter(|(a, b)| a == b).count() * 2 < exact.len());
    }
}

#[test]
fn faces_of_merged_objects_go_to_the_files_of_their_groups() {
    let objects = FaceMap::PerFace((0..300).map(|face| face / 7 % 5 - 1).collect());
    let mesh = Arc::new(random_mesh(21, 300, objects, FaceMap::Uniform(1)));
    let instance = |mesh: &Arc<Mesh>, object| Instance::new(Arc::clone(mesh), DAffine3::IDENTITY, object).unwrap();
    let scene = scene(vec![instance(&mesh, None), instance(&plain_mesh(22, 20), Some(3))], vec![]);
    let whole = export(&scene, &[0; 5], 1, COMPRESSED);
    let parts = export(&scene, &[2, 0, 2, 3, 1], 4, COMPRESSED);
    let read = |export: &Export, group| {
        let triangles = Read::new(&glb(export, group).bytes, &[]).triangles();
        rounded(corners(&triangles), COMPRESSED.step)
    };
    let mut joined: Vec<_> = (0..4).flat_map(|group| read(&parts, group)).collect();
    joined.sort_unstable();
    assert_eq!(joined, read(&whole, 0));
    let faces_of = |object: i32| (0..300).filter(|face| face / 7 % 5 - 1 == object).count() as u64;
    let counts: Vec<u64> = (0..4).map(|group| glb(&parts, group).statistics).map(|s| s.triangles + s.dropped).collect();
    assert_eq!(counts, [faces_of(1), faces_of(-1), faces_of(0) + faces_of(2), faces_of(3) + 20]);
}

#[test]
fn moving_objects_are_nodes_with_names() {
    let objects = FaceMap::PerFace((0..20).map(|face| face % 2).collect());
    let both = Arc::new(random_mesh(31, 20, objects, FaceMap::Uniform(0)));
    let wheel = plain_mesh(32, 10);
    let moving = vec![
        Instance::new(both, pose(1, 9.0), None).unwrap(),
        instance(&wheel, pose(2, 9.0), 2),
        instance(&wheel, pose(3, 9.0), 1),
    ];
    let scene = Scene { origin: DVec3::new(5.0, 0.0, -1e6), ..scene(vec![], moving.clone()) };
    let file = Read::new(&glb(&export(&scene, &[0, 1, 0, 0], 2, COMPRESSED), 0).bytes, &[]);
    let nodes = file.list("nodes");
    assert_eq!(nodes[0]["translation"], serde_json::json!([5.0, 0.0, -1e6]));
    assert_eq!(nodes[0]["children"], serde_json::json!([1, 2]));
    assert_eq!([&nodes[1]["name"], &nodes[2]["name"]], ["object 0", "object 2"]);
    assert_eq!(file.placements(&nodes[2]), [moving[1].to_scene]);
    let other = Read::new(&glb(&export(&scene, &[0, 1, 0, 0], 2, COMPRESSED), 1).bytes, &[]);
    assert_eq!(other.list("nodes").len(), 3);
}

#[test]
fn faces_are_oriented_to_their_normals() {
    // Faces whose corners lack one, two and all three normals. All list their corners clockwise as seen from +z: the
    // first two are turned to their normals, the third stays as it is.
    let positions = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 2.0, 0.0]];
    let up = [0.0, 0.0, 1.0];
    let normals = vec![up, up, [0.0; 3], [0.0; 3], [0.0; 3]];
    let faces = vec![[0, 2, 1], [0, 3, 2], [2, 3, 4]];
    let none = FaceMap::Uniform(-1);
    let mesh = Mesh::new(positions.into(), faces.into(), None, None, none.clone(), none).unwrap();
    let mesh = Arc::new(mesh.with_normals(Some(normals.into())).unwrap());
    let scene = scene(vec![instance(&mesh, DAffine3::IDENTITY, 0)], vec![]);
    let file = Read::new(&glb(&export(&scene, &[0, 0], 1, PLAIN), 0).bytes, &[]);
    let primitives = file.list("meshes")[0]["primitives"].as_array().unwrap();
    assert_eq!(primitives.len(), 2);
    let lit = primitives.iter().find(|primitive| primitive["attributes"].get("NORMAL").is_some()).unwrap();
    assert!(file.floats::<3>(&lit["attributes"]["NORMAL"]).iter().all(|&normal| normal == up));
    let fronts: Vec<f64> = corners(&file.triangles()).map(|[a, b, c]| (b - a).cross(c - a).z.signum()).collect();
    assert_eq!(fronts.len(), 3);
    assert_eq!(fronts.iter().sum::<f64>(), 1.0, "{fronts:?}");
}

#[test]
fn bytes_do_not_depend_on_the_number_of_threads() {
    let materials = || FaceMap::PerFace((0..5000).map(|face| face % 3 - 1).collect());
    let mesh = Arc::new(random_mesh(41, 5000, FaceMap::Uniform(-1), materials()));
    let tree = plain_mesh(42, 100);
    let trees = [1, 2].map(|seed| instance(&tree, pose(seed, 9.0), 0));
    let standing = [instance(&mesh, DAffine3::IDENTITY, 0)].into_iter().chain(trees).collect();
    let scene = scene(standing, vec![instance(&plain_mesh(43, 10), pose(3, 9.0), 1)]);
    let files = [1, 2].map(|threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let export = export(&scene, &[0, 0, 0], 1, COMPRESSED);
            (export.shared[0].bytes().unwrap(), glb(&export, 0).bytes)
        })
    });
    assert!(files[0] == files[1]);
}

#[test]
fn groups_without_triangles_are_files_without_meshes() {
    let zero = FaceMap::Uniform(0);
    let flat = Mesh::new(vec![[0.0; 3]; 3].into(), vec![[0, 1, 2]].into(), None, None, zero.clone(), zero);
    let flat = Arc::new(flat.unwrap());
    let standing = vec![instance(&flat, DAffine3::IDENTITY, 0), instance(&flat, pose(1, 1.0), 0)];
    let lone = Instance::new(Arc::clone(&plain_mesh(1, 0)), DAffine3::IDENTITY, Some(1)).unwrap();
    let export = export(&scene(standing, vec![lone]), &[1, 1, 1], 2, COMPRESSED);
    for group in [0, 1] {
        let file = glb(&export, group);
        let read = Read::new(&file.bytes, &[]);
        let names: Vec<&String> = read.document.as_object().unwrap().keys().collect();
        assert_eq!(names, ["asset", "nodes", "scene", "scenes"]);
        assert_eq!(file.statistics.bytes(Kind::Document), file.bytes.len() as u64);
        assert_eq!((file.statistics.triangles, file.statistics.drawn), (0, 0));
    }
}

#[test]
fn wrong_arguments_are_refused() {
    let scene = scene(vec![instance(&plain_mesh(1, 5), DAffine3::IDENTITY, 0)], vec![]);
    let images = || vec![None];
    let new = |groups: &[u16], count, images, step| {
        Export::new(&scene, groups, count, vec![], images, Settings { step, ..PLAIN }, &Progress::new()).map(drop)
    };
    assert!(new(&[0, 0], 1, images(), 1.0).is_ok());
    assert!(new(&[], 1, images(), 1.0).is_err());
    assert!(new(&[0, 1], 1, images(), 1.0).is_err());
    assert!(new(&[0, 0], 1, vec![], 1.0).is_err());
    for step in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-300] {
        assert!(new(&[0, 0], 1, images(), step).is_err());
    }
    let export = export(&scene, &[0, 0], 1, PLAIN);
    assert!(export.glb(1, &[], &Progress::new()).is_err());
    assert!(export.glb(0, &[None], &Progress::new()).is_err());
    let cancelled = Progress::new();
    cancelled.cancel();
    assert!(export.glb(0, &[], &cancelled).is_err());
}
