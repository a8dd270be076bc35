//! Comparison of stored meshes with meshes made from arrays and merged.

use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3};

use super::rows::Table;
use super::*;
use crate::base::{Buffer, FaceMap, Progress};
use crate::scene::{Mesh, PlacedMesh, merge};

/// A growing byte buffer and the rows that describe it.
#[derive(Default)]
struct Bytes {
    bytes: Vec<u8>,
    rows: Vec<Rows>,
}

impl Bytes {
    /// Adds rows with a gap of `gap` bytes after each.
    fn add<const W: usize>(
        &mut self,
        values: &[[f32; W]],
        component: ComponentType,
        is_fraction: bool,
        gap: usize,
    ) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0xee);
        let start = self.bytes.len();
        for value in values.iter().map(|row| row.as_slice()) {
            for &value in value {
                match component {
                    ComponentType::I8 => self.bytes.extend((value as i8).to_le_bytes()),
                    ComponentType::U8 => self.bytes.extend((value as u8).to_le_bytes()),
                    ComponentType::I16 => self.bytes.extend((value as i16).to_le_bytes()),
                    ComponentType::U16 => self.bytes.extend((value as u16).to_le_bytes()),
                    ComponentType::U32 => self.bytes.extend((value as u32).to_le_bytes()),
                    ComponentType::F32 => self.bytes.extend(value.to_le_bytes()),
                }
            }
            self.bytes.resize(self.bytes.len() + gap, 0xee);
        }
        let step = W * component.size() + gap;
        self.rows.push(Rows { block: 0, start, step, count: values.len(), width: W, component, is_fraction });
        self.rows.len() - 1
    }

    fn stored(self, faces: &[StoredFaces]) -> StoredMeshes {
        StoredMeshes::new(vec![self.bytes.into()], self.rows, faces, &Progress::new()).unwrap()
    }
}

const SQUARE: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 1.0], [0.0, 2.0, 0.0]];
const HALVES: [[f32; 1]; 6] = [[0.0], [1.0], [2.0], [0.0], [2.0], [3.0]];

fn attributes(positions: usize) -> Attributes {
    Attributes { positions, normals: None, uvs: None, colors: None }
}

fn faces(mesh: usize, attributes: Attributes, corners: usize, material: i32) -> StoredFaces {
    StoredFaces { mesh, attributes, corners: Some(corners), material }
}

fn part(mesh: usize, to_scene: DAffine3, object: i32) -> StoredPart {
    StoredPart { mesh, to_scene, object }
}

#[test]
fn joined_meshes_equal_meshes_merged_from_arrays() {
    let mut bytes = Bytes::default();
    let positions = bytes.add(&SQUARE, ComponentType::F32, false, 4);
    let normals = bytes.add(&[[0.0, 0.0, 127.0]; 4], ComponentType::I8, true, 1);
    let uvs = bytes.add(&[[0.0, 0.0], [65535.0, 0.0], [65535.0, 65535.0], [0.0, 65535.0]], ComponentType::U16, true, 0);
    let colors = bytes.add(&[[255.0, 0.0, 0.0]; 4], ComponentType::U8, true, 1);
    let corners = bytes.add(&HALVES, ComponentType::U16, false, 0);
    let other = bytes.add(&SQUARE.map(|p| p.map(|x| 10.0 * x)), ComponentType::I16, false, 2);
    let rich = Attributes { positions, normals: Some(normals), uvs: Some(uvs), colors: Some(colors) };
    let stored = bytes.stored(&[faces(0, rich, corners, 3), faces(1, attributes(other), corners, 5)]);
    assert!(stored.is_usable(0) && stored.is_usable(1));

    let indices = || Buffer::from(vec![[0, 1, 2], [0, 2, 3]]);
    let up = vec![[0.0, 0.0, 1.0]; 4];
    let flipped = vec![[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]];
    let first = Mesh::new(
        SQUARE.to_vec().into(),
        indices(),
        Some(flipped.into()),
        Some(vec![[255, 0, 0, 255]; 4].into()),
        FaceMap::Uniform(-1),
        FaceMap::Uniform(3),
    );
    let first = first.unwrap().with_normals(Some(up.into())).unwrap();
    let tenfold = SQUARE.map(|p| p.map(|x| 10.0 * x)).to_vec();
    let second = Mesh::new(tenfold.into(), indices(), None, None, FaceMap::Uniform(-1), FaceMap::Uniform(5)).unwrap();
    let turn = DAffine3 {
        matrix3: DMat3::from_rotation_y(0.7) * DMat3::from_diagonal(DVec3::new(1.0, -2.0, 1.0)),
        translation: DVec3::new(100.0, -3.0, 0.5),
    };
    let meshes = [Arc::new(first), Arc::new(second)];
    let placed = |mesh: usize, to_scene, object| PlacedMesh { mesh: Arc::clone(&meshes[mesh]), to_scene, object };
    let expected = merge(
        &[placed(0, turn, Some(7)), placed(1, DAffine3::IDENTITY, Some(2)), placed(0, DAffine3::IDENTITY, Some(1))],
        &Progress::new(),
    )
    .unwrap();
    let parts = [part(0, turn, 7), part(1, DAffine3::IDENTITY, 2), part(0, DAffine3::IDENTITY, 1)];
    let found = stored.join(&parts, &Progress::new()).unwrap();
    assert_eq!(found.positions[..], expected.positions[..]);
    assert_eq!(found.faces[..], expected.faces[..]);
    assert_eq!(found.uvs.as_deref(), expected.uvs.as_deref());
    assert_eq!(found.colors.as_deref(), expected.colors.as_deref());
    assert_eq!(found.normals.as_deref(), expected.normals.as_deref());
    let labels =
        |mesh: &Mesh| (0..6).map(|face| (mesh.objects.get(face), mesh.materials.get(face))).collect::<Vec<_>>();
    assert_eq!(labels(&found), labels(&expected));
    assert_eq!(found.bounds(), expected.bounds());
    assert_eq!((stored.vertex_count(0), stored.face_count(1)), (4, 2));
}

#[test]
fn faces_of_one_mesh_share_vertices_and_meshes_read_only_their_range() {
    let mut bytes = Bytes::default();
    let pool: Vec<[f32; 3]> = (0..30).map(|i| [i as f32, (i * i) as f32, 0.0]).collect();
    let positions = bytes.add(&pool, ComponentType::F32, false, 0);
    let low = bytes.add(&[[0.0], [1.0], [2.0]], ComponentType::U8, false, 0);
    let high = bytes.add(&[[20.0], [21.0], [23.0]], ComponentType::U32, false, 0);
    let wide = bytes.add(&[[0.0], [1.0], [29.0]], ComponentType::U8, false, 0);
    let faces = |mesh, corners, material| faces(mesh, attributes(positions), corners, material);
    let stored = bytes.stored(&[faces(0, low, 0), faces(0, low, 1), faces(1, high, 0), faces(2, wide, 0)]);
    // The third mesh would read 30 vertices for its three corners.
    assert_eq!([0, 1, 2].map(|mesh| stored.is_usable(mesh)), [true, true, false]);
    assert_eq!([0, 1].map(|mesh| stored.vertex_count(mesh)), [3, 4]);
    let boxes = stored.face_bounds(&Progress::new()).unwrap();
    assert_eq!((stored.bounds(1), boxes[1]), ([[20.0, 400.0, 0.0], [23.0, 529.0, 0.0]], stored.bounds(1)));
    assert!(boxes[2][0][0] > boxes[2][1][0]);
    let left = stored.only(&[1]);
    assert_eq!((left.len(), left.vertex_count(0), left.is_usable(0)), (1, 4, true));
    let mesh = stored.mesh(1, &Progress::new()).unwrap();
    assert_eq!((&mesh.faces[..], &mesh.positions[..]), (&[[0, 1, 3]][..], &pool[20..24]));
    let both = [part(0, DAffine3::IDENTITY, 4), part(1, DAffine3::IDENTITY, 5)];
    let mesh = stored.join(&both, &Progress::new()).unwrap();
    assert_eq!(mesh.faces[..], [[0, 1, 2], [0, 1, 2], [3, 4, 6]]);
    assert_eq!([0, 1, 2].map(|face| (mesh.objects.get(face), mesh.materials.get(face))), [(4, 0), (4, 1), (5, 0)]);
}

#[test]
fn boxes_of_faces_exclude_unused_vertices() {
    let mut bytes = Bytes::default();
    let positions = bytes.add(&SQUARE, ComponentType::F32, false, 0);
    let corners = bytes.add(&HALVES[..3], ComponentType::U16, false, 0);
    let stored = bytes.stored(&[faces(0, attributes(positions), corners, 0)]);
    assert_eq!(stored.bounds(0), [[0.0, 0.0, 0.0], [2.0, 2.0, 1.0]]);
    let scaled = stored.scaled(0.5).face_bounds(&Progress::new()).unwrap();
    assert_eq!(scaled, [[[0.0, 0.0, 0.0], [1.0, 1.0, 0.5]]]);
    let unindexed = StoredFaces { corners: None, ..faces(0, attributes(0), 0, 0) };
    let mut bytes = Bytes::default();
    bytes.add(&[SQUARE[0], SQUARE[1], SQUARE[3]], ComponentType::F32, false, 0);
    assert_eq!(bytes.stored(&[unindexed]).face_bounds(&Progress::new()).unwrap(), [[[0.0; 3], [2.0, 2.0, 0.0]]]);
}

#[test]
fn arrays_in_usable_form_are_not_copied() {
    let mut bytes = Bytes::default();
    let positions = bytes.add(&SQUARE, ComponentType::F32, false, 0);
    let corners = bytes.add(&HALVES, ComponentType::U32, false, 0);
    let stored = bytes.stored(&[faces(0, attributes(positions), corners, 0)]);
    let mesh = stored.mesh(0, &Progress::new()).unwrap();
    assert_eq!(mesh.positions.as_ptr().cast(), stored.blocks[0].as_ptr());
    assert_eq!((&mesh.positions[..], mesh.faces[..].as_ptr().cast()), (&SQUARE[..], &raw const stored.blocks[0][48]));
    let doubled = stored.scaled(2.0).mesh(0, &Progress::new()).unwrap();
    assert_eq!(doubled.positions[..], SQUARE.map(|p| p.map(|x| 2.0 * x)));
    assert_eq!(stored.scaled(2.0).bounds(0), [[0.0, 0.0, 0.0], [4.0, 4.0, 2.0]]);
}

#[test]
fn scaled_coordinates_are_rounded_after_placement() {
    let mut bytes = Bytes::default();
    let feet = [[500_000.03, 0.0, 0.0], [500_000.06, 0.0, 0.0], [500_000.0, 9.0, 0.0]];
    let positions = bytes.add(&feet, ComponentType::F32, false, 0);
    let faces = StoredFaces { mesh: 0, attributes: attributes(positions), corners: None, material: 0 };
    let stored = bytes.stored(&[faces]).scaled(0.3048);
    let away = DAffine3::from_translation(DVec3::new(-152_400.0, 0.0, 0.0));
    let mesh = stored.join(&[part(0, away, 0)], &Progress::new()).unwrap();
    let expected = feet.map(|[x, ..]| (f64::from(x) * 0.3048 - 152_400.0) as f32);
    assert_eq!([0, 1, 2].map(|vertex| mesh.positions[vertex][0]), expected);
    assert!(expected[0] != expected[1]);
    let far = DAffine3::from_scale(DVec3::splat(1e36));
    assert!(stored.join(&[part(0, far, 0)], &Progress::new()).is_err());
}

#[test]
fn meshes_with_missing_or_non_finite_values_are_unusable() {
    for (point, corner) in [(f32::NAN, 0.0), (f32::INFINITY, 0.0), (2e30, 0.0), (0.0, 4.0)] {
        let mut bytes = Bytes::default();
        let positions = bytes.add(&[SQUARE[0], SQUARE[1], SQUARE[2], [0.0, point, 0.0]], ComponentType::F32, false, 0);
        let corners = bytes.add(&[[corner], [1.0], [2.0]], ComponentType::U16, false, 0);
        assert!(!bytes.stored(&[faces(0, attributes(positions), corners, 0)]).is_usable(0), "{point} {corner}");
    }
}

#[test]
fn normals_are_normalised_and_transparent_colours_are_found() {
    let mut bytes = Bytes::default();
    let positions = bytes.add(&SQUARE[..3], ComponentType::F32, false, 0);
    let normals = bytes.add(&[[0.0, 3.0, 0.0], [0.0; 3], [0.0, f32::NAN, 1.0]], ComponentType::F32, false, 0);
    let colors = bytes.add(&[[1.0, 0.0, f32::NAN, 1.0], [0.5, 0.0, 2.0, 0.5], [0.0; 4]], ComponentType::F32, false, 0);
    let lit = Attributes { normals: Some(normals), colors: Some(colors), ..attributes(positions) };
    let plain = StoredFaces { mesh: 1, attributes: attributes(positions), corners: None, material: 0 };
    let stored = bytes.stored(&[StoredFaces { mesh: 0, attributes: lit, corners: None, material: 0 }, plain]);
    let mesh = stored.mesh(0, &Progress::new()).unwrap();
    assert_eq!(mesh.normals.as_deref().unwrap(), [[0.0, 1.0, 0.0], [0.0; 3], [0.0; 3]]);
    assert_eq!(mesh.colors.as_deref().unwrap(), [[255, 0, 0, 255], [188, 0, 255, 128], [0; 4]]);
    assert_eq!(stored.see_through(), [true, false]);
}

#[test]
fn integer_colours_equal_fractions() {
    let shorts: Vec<[f32; 4]> =
        (0..=u16::MAX).map(|x| [f32::from(x), f32::from(u16::MAX - x), 7.0, f32::from(x)]).collect();
    let mut bytes = Bytes::default();
    let whole = bytes.add(&shorts, ComponentType::U16, true, 0);
    let floats = bytes.add(
        &shorts.iter().map(|row| row.map(|x| (f64::from(x) / 65535.0) as f32)).collect::<Vec<_>>(),
        ComponentType::F32,
        false,
        4,
    );
    let blocks = [Buffer::from(bytes.bytes)];
    let [ours, expected] = [whole, floats].map(|rows| {
        let mut slots = vec![[0; 4]; shorts.len()];
        Table::new(bytes.rows[rows], &blocks).colors(0, &mut slots);
        slots
    });
    assert_eq!(ours, expected);
}

#[test]
fn tables_that_do_not_fit_are_refused() {
    let table = |change: fn(&mut Rows)| {
        let mut bytes = Bytes::default();
        let positions = bytes.add(&SQUARE, ComponentType::F32, false, 0);
        let corners = bytes.add(&HALVES, ComponentType::U16, false, 0);
        change(&mut bytes.rows[1]);
        StoredMeshes::new(
            vec![bytes.bytes.into()],
            bytes.rows,
            &[faces(0, attributes(positions), corners, 0)],
            &Progress::new(),
        )
    };
    assert!(table(|_| ()).is_ok());
    for change in [
        (|rows| rows.count = 4) as fn(&mut Rows),
        |rows| rows.count = 9,
        |rows| rows.start = usize::MAX,
        |rows| rows.step = 0,
        |rows| rows.step = 3,
        |rows| rows.block = 1,
        |rows| rows.component = ComponentType::I16,
    ] {
        assert!(table(change).is_err());
    }
    let short = |faces| StoredMeshes::new(vec![], vec![], &[faces], &Progress::new());
    assert!(short(StoredFaces { mesh: 0, attributes: attributes(0), corners: None, material: 0 }).is_err());
}
