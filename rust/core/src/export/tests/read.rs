//! Reader for exported files, for tests.

use std::collections::BTreeMap;

use glam::{DAffine3, DMat4, DQuat, DVec3};
use serde_json::Value;

use crate::scene::meshopt::{Filter, Layout, Mode, decode};

/// A file with its external buffers.
pub struct Read {
    pub document: Value,
    chunk: Vec<u8>,
    external: BTreeMap<String, Vec<u8>>,
}

/// A placed triangle: corners relative to the scene's origin, with the material's number in the file.
pub type Triangle = ([DVec3; 3], u64);

fn index(value: &Value) -> usize {
    value.as_u64().unwrap() as usize
}

impl Read {
    pub fn new(glb: &[u8], external: &[(&str, Vec<u8>)]) -> Self {
        let word = |at: usize| u32::from_le_bytes(glb[at..at + 4].try_into().unwrap()) as usize;
        assert_eq!((&glb[..4], word(4), word(8)), (&b"glTF"[..], 2, glb.len()));
        let end = 20 + word(12);
        assert!(&glb[16..20] == b"JSON" && end.is_multiple_of(4));
        let document: Value = serde_json::from_slice(&glb[20..end]).unwrap();
        let chunk = if end < glb.len() {
            assert_eq!((&glb[end + 4..end + 8], end + 8 + word(end)), (&b"BIN\0"[..], glb.len()));
            glb[end + 8..].to_vec()
        } else {
            vec![]
        };
        let external = external.iter().map(|(uri, bytes)| ((*uri).to_owned(), bytes.clone())).collect();
        Self { document, chunk, external }
    }

    fn buffer(&self, number: usize) -> &[u8] {
        let described = &self.document["buffers"][number];
        let bytes = match described.get("uri") {
            Some(uri) => &self.external[uri.as_str().unwrap()],
            None => &self.chunk,
        };
        assert_eq!(index(&described["byteLength"]), bytes.len());
        bytes
    }

    fn slice(&self, at: &Value) -> &[u8] {
        let (start, length) = (index(&at["byteOffset"]), index(&at["byteLength"]));
        assert!(start.is_multiple_of(4));
        &self.buffer(index(&at["buffer"]))[start..start + length]
    }

    /// Returns the bytes of an accessor, without compression and padding.
    pub fn bytes(&self, accessor: &Value) -> Vec<u8> {
        let accessor = &self.document["accessors"][index(accessor)];
        let view = &self.document["bufferViews"][index(&accessor["bufferView"])];
        let count = index(&accessor["count"]);
        let Some(packed) = view.get("extensions").map(|e| &e["EXT_meshopt_compression"]) else {
            return self.slice(view).to_vec();
        };
        assert_eq!(index(&packed["count"]), count);
        assert_eq!(index(&view["byteLength"]), count * index(&packed["byteStride"]));
        let bytes = self.slice(packed);
        let filter = match packed.get("filter").map(|filter| filter.as_str().unwrap()) {
            None => Filter::None,
            Some("EXPONENTIAL") => Filter::Exponential,
            Some("OCTAHEDRAL") => Filter::Octahedral,
            other => panic!("{other:?}"),
        };
        let mode = match packed["mode"].as_str().unwrap() {
            "TRIANGLES" => Mode::Triangles,
            "ATTRIBUTES" => Mode::Attributes,
            other => panic!("{other}"),
        };
        assert!(mode == Mode::Triangles || meshopt::decode_vertex_version(bytes) == Some(0));
        let layout = Layout { count, stride: index(&packed["byteStride"]), mode, filter };
        bytemuck::cast_slice(&decode(bytes, layout).unwrap())[..count * layout.stride].to_vec()
    }

    pub fn floats<const N: usize>(&self, accessor: &Value) -> Vec<[f32; N]> {
        let bytes = self.bytes(accessor);
        let numbers: Vec<f32> = bytes.chunks_exact(4).map(|b| f32::from_le_bytes(b.try_into().unwrap())).collect();
        numbers.as_chunks().0.to_vec()
    }

    pub fn corners(&self, accessor: &Value) -> Vec<u32> {
        let bytes = self.bytes(accessor);
        match index(&self.document["accessors"][index(accessor)]["componentType"]) {
            5123 => bytes.chunks_exact(2).map(|b| u16::from_le_bytes([b[0], b[1]]).into()).collect(),
            5125 => bytes.chunks_exact(4).map(|b| u32::from_le_bytes(b.try_into().unwrap())).collect(),
            other => panic!("{other}"),
        }
    }

    pub fn list(&self, name: &str) -> &[Value] {
        self.document.get(name).map_or(&[], |list| list.as_array().unwrap())
    }

    /// Returns the placements of a node's mesh, relative to the root node.
    pub fn placements(&self, node: &Value) -> Vec<DAffine3> {
        let own = match node.get("matrix") {
            Some(matrix) => {
                let numbers: Vec<f64> = matrix.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
                DAffine3::from_mat4(DMat4::from_cols_slice(&numbers))
            }
            None => DAffine3::IDENTITY,
        };
        let Some(instancing) = node.get("extensions").map(|e| &e["EXT_mesh_gpu_instancing"]["attributes"]) else {
            return vec![own];
        };
        let translations = self.floats::<3>(&instancing["TRANSLATION"]);
        let rotations = self.floats::<4>(&instancing["ROTATION"]);
        let scales = self.floats::<3>(&instancing["SCALE"]);
        let rows = translations.iter().zip(&rotations).zip(&scales);
        rows.map(|((&t, &r), &s)| {
            let [t, s] = [t, s].map(|v| DVec3::from_array(v.map(f64::from)));
            own * DAffine3::from_scale_rotation_translation(s, DQuat::from_array(r.map(f64::from)).normalize(), t)
        })
        .collect()
    }

    /// Returns all triangles as viewers show them: corners counter-clockwise from the front, also of mirrored nodes.
    pub fn triangles(&self) -> Vec<Triangle> {
        let mut triangles = vec![];
        for node in self.list("nodes").iter().filter(|node| node.get("mesh").is_some()) {
            for primitive in self.list("meshes")[index(&node["mesh"])]["primitives"].as_array().unwrap() {
                let positions = self.floats::<3>(&primitive["attributes"]["POSITION"]);
                let corners = self.corners(&primitive["indices"]);
                for placement in self.placements(node) {
                    for &[a, b, c] in corners.as_chunks::<3>().0 {
                        let face = if placement.matrix3.determinant() < 0.0 { [a, c, b] } else { [a, b, c] };
                        let point = |v: u32| DVec3::from_array(positions[v as usize].map(f64::from));
                        let placed = face.map(|v| placement.transform_point3(point(v)));
                        triangles.push((placed, primitive["material"].as_u64().unwrap()));
                    }
                }
            }
        }
        triangles
    }
}
