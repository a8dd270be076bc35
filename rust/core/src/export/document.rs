//! GLB writer: buffer views, accessors, meshes, nodes and binary data.

use std::collections::{BTreeMap, BTreeSet};

use glam::{DAffine3, DVec3};
use serde_json::{Map, Value, json};

use super::attribute::{Attribute, Layout, Stream};
use super::mesh::{ALIGNMENT, EncodedMesh, append};
use super::statistics::Kind;
use super::surfaces::{OPTIONAL, Surfaces};
use crate::base::memory::{room_for_values, try_with_capacity};
use crate::base::{Error, Result};

const COMPRESSION: &str = "EXT_meshopt_compression";
const PLACEMENT: &str = "EXT_mesh_gpu_instancing";
const QUANTIZATION: &str = "KHR_mesh_quantization";

const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

const MAGIC: &[u8; 4] = b"glTF";
const VERSION: u32 = 2;

/// Memory for a node's entries, bytes. With `NODE_TEXT_BYTES` it is an eighth more than the 2,600 bytes that each of
/// 100,000 nodes with names and matrices took.
const NODE_BYTES: usize = 2 << 10;
/// Memory for a node's text, which is kept twice while the document is written, bytes.
const NODE_TEXT_BYTES: usize = 1 << 10;

/// Nodes per request of memory.
const NODES_PER_REQUEST: usize = 1 << 10;

struct View {
    /// Index of the buffer among those with a URI; `None` for the file's own binary chunk.
    external: Option<usize>,
    offset: usize,
    length: usize,
    attribute: Attribute,
    count: usize,
}

/// Parts of a GLB.
#[derive(Default)]
pub(super) struct Document {
    compressed: bool,
    chunk: Vec<u8>,
    /// URI and size in bytes of each external buffer.
    external: Vec<(String, usize)>,
    views: Vec<View>,
    accessors: Vec<Value>,
    meshes: Vec<Value>,
    nodes: Vec<Value>,
    /// Material numbers in the file, by (material, whether it is textured).
    materials: BTreeMap<(i32, bool), usize>,
    extensions: BTreeSet<&'static str>,
}

impl Document {
    /// Creates an empty document with capacity for this many bytes of arrays.
    pub fn with_room(compressed: bool, bytes: usize) -> Result<Self> {
        Ok(Self { compressed, chunk: try_with_capacity(bytes)?, ..Self::default() })
    }

    /// Adds a mesh, in an external buffer if `uri` is given; returns its number.
    pub fn add_mesh(&mut self, mesh: &EncodedMesh, uri: Option<&str>) -> usize {
        let external = uri.map(|uri| (uri, self.external.len()));
        let mut end = 0;
        let mut primitives = Vec::new();
        for primitive in &mesh.primitives {
            let mut attributes = Map::new();
            let mut entry = json!({});
            for stream in &primitive.streams {
                let accessor = match external {
                    None => self.add(stream),
                    Some((_, number)) => {
                        let start = end;
                        end = (start + stream.bytes.len()).next_multiple_of(ALIGNMENT);
                        self.describe(stream, Some(number), start)
                    }
                };
                match stream.attribute {
                    Attribute::Corners | Attribute::ShortCorners => entry["indices"] = json!(accessor),
                    attribute => drop(attributes.insert(attribute.layout().name.into(), json!(accessor))),
                }
            }
            let next = self.materials.len();
            let material = (primitive.key.material, primitive.key.textured);
            entry["material"] = json!(*self.materials.entry(material).or_insert(next));
            entry["attributes"] = Value::Object(attributes);
            primitives.push(entry);
        }
        self.external.extend(external.map(|(uri, _)| (uri.to_owned(), end)));
        self.meshes.push(json!({ "primitives": primitives }));
        self.meshes.len() - 1
    }

    pub fn add_node(&mut self, mesh: usize, name: Option<&str>, to_scene: &DAffine3) -> Result<()> {
        if self.nodes.len().is_multiple_of(NODES_PER_REQUEST) {
            room_for_values::<[u8; NODE_BYTES]>(NODES_PER_REQUEST)?;
        }
        let mut node = json!({ "mesh": mesh });
        if let Some(name) = name {
            node["name"] = json!(name);
        }
        if *to_scene != DAffine3::IDENTITY {
            node["matrix"] = json!(glam::DMat4::from(*to_scene).to_cols_array());
        }
        self.nodes.push(node);
        Ok(())
    }

    /// Adds a node with a mesh at several placements, given as arrays.
    pub fn add_placements(&mut self, mesh: usize, placements: &[Stream]) {
        let mut attributes = Map::new();
        for stream in placements {
            attributes.insert(stream.attribute.layout().name.into(), json!(self.add(stream)));
        }
        self.extensions.insert(PLACEMENT);
        let extensions = json!({ PLACEMENT: { "attributes": attributes } });
        self.nodes.push(json!({ "mesh": mesh, "extensions": extensions }));
    }

    /// Adds an array to the file's chunk; returns the number of its accessor.
    fn add(&mut self, stream: &Stream) -> usize {
        let start = append(&mut self.chunk, &stream.bytes);
        self.describe(stream, None, start)
    }

    /// Adds a view and an accessor for an array.
    fn describe(&mut self, stream: &Stream, external: Option<usize>, offset: usize) -> usize {
        let (attribute, count) = (stream.attribute, stream.count);
        if attribute == Attribute::ShortNormal {
            self.extensions.insert(QUANTIZATION);
        }
        let layout = attribute.layout();
        let mut accessor = json!({
            "bufferView": self.views.len(), "componentType": layout.component, "count": count, "type": layout.shape,
        });
        if layout.normalized {
            accessor["normalized"] = json!(true);
        }
        if let Some([min, max]) = stream.extent {
            (accessor["min"], accessor["max"]) = (json!(min), json!(max));
        }
        self.views.push(View { external, offset, length: stream.bytes.len(), attribute, count });
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    /// Returns the file's bytes. Node 0 is the parent of all others and translates by the scene's origin.
    pub fn encode(mut self, origin: DVec3, surfaces: &Surfaces) -> Result<Vec<u8>> {
        let mut materials: Vec<(i32, bool)> = self.materials.keys().copied().collect();
        materials.sort_by_key(|key| self.materials[key]);
        let (surfaces, extensions) = surfaces.describe(&materials);
        self.extensions.extend(extensions);
        if self.compressed && !self.views.is_empty() {
            self.extensions.insert(COMPRESSION);
        }
        room_for_values::<[u8; NODE_TEXT_BYTES]>(self.nodes.len())?;
        let (buffers, views) = self.buffers();
        let mut root = json!({ "name": "nearfar" });
        if origin != DVec3::ZERO {
            root["translation"] = json!(origin.to_array());
        }
        if !self.nodes.is_empty() {
            root["children"] = json!((1..=self.nodes.len()).collect::<Vec<_>>());
        }
        let nodes = std::iter::once(root).chain(self.nodes).collect();
        let used = self.extensions.iter().map(|name| json!(name)).collect();
        let required = self.extensions.iter().filter(|name| !OPTIONAL.contains(name)).map(|name| json!(name)).collect();
        let mut document = json!({
            "asset": { "version": "2.0", "generator": concat!("nearfar ", env!("CARGO_PKG_VERSION")) },
            "scene": 0,
            "scenes": [{ "nodes": [0] }],
        });
        let lists = [
            ("nodes", nodes),
            ("meshes", self.meshes),
            ("accessors", self.accessors),
            ("bufferViews", views),
            ("buffers", buffers),
            ("extensionsUsed", used),
            ("extensionsRequired", required),
        ];
        // glTF forbids empty lists.
        for (name, list) in lists.into_iter().chain(surfaces).filter(|(_, list)| !list.is_empty()) {
            document[name] = Value::Array(list);
        }
        file(&document.to_string(), &self.chunk)
    }

    /// Returns the document's buffers and views. Compressed views also refer to a fallback buffer without data, which
    /// the extension requires as a place for the decompressed arrays.
    fn buffers(&self) -> (Vec<Value>, Vec<Value>) {
        let has_chunk = usize::from(!self.chunk.is_empty());
        let fallback_number = has_chunk + self.external.len();
        let mut fallback_length = 0;
        let mut views = Vec::new();
        for view in &self.views {
            let layout = view.attribute.layout();
            let buffer = view.external.map_or(0, |number| has_chunk + number);
            let stored = buffer_range(buffer, view.offset, view.length);
            let mut entry = if self.compressed {
                let length = view.count * layout.stride;
                let mut entry = buffer_range(fallback_number, fallback_length, length);
                fallback_length = (fallback_length + length).next_multiple_of(ALIGNMENT);
                entry["extensions"] = json!({ COMPRESSION: compression(stored, &layout, view.count) });
                entry
            } else {
                stored
            };
            // Placements need neither target nor stride.
            match layout.kind {
                Kind::Corners => entry["target"] = json!(ELEMENT_ARRAY_BUFFER),
                Kind::Placements => {}
                _ => {
                    entry["target"] = json!(ARRAY_BUFFER);
                    entry["byteStride"] = json!(layout.stride);
                }
            }
            views.push(entry);
        }
        let chunk = (has_chunk == 1).then(|| json!({ "byteLength": self.chunk.len() }));
        let external = self.external.iter().map(|(uri, length)| json!({ "uri": uri, "byteLength": length }));
        let fallback = (self.compressed && !views.is_empty())
            .then(|| json!({ "byteLength": fallback_length, "extensions": { COMPRESSION: { "fallback": true } } }));
        (chunk.into_iter().chain(external).chain(fallback).collect(), views)
    }
}

fn buffer_range(buffer: usize, offset: usize, length: usize) -> Value {
    json!({ "buffer": buffer, "byteOffset": offset, "byteLength": length })
}

/// Completes the extension object of a compressed view with `count` rows.
fn compression(mut entry: Value, layout: &Layout, count: usize) -> Value {
    entry["byteStride"] = json!(layout.stride);
    entry["count"] = json!(count);
    entry["mode"] = json!(if layout.kind == Kind::Corners { "TRIANGLES" } else { "ATTRIBUTES" });
    if layout.filter != "NONE" {
        entry["filter"] = json!(layout.filter);
    }
    entry
}

/// Assembles a GLB from its JSON document and its binary chunk.
fn file(document: &str, chunk: &[u8]) -> Result<Vec<u8>> {
    let mut text = document.as_bytes().to_vec();
    text.resize(text.len().next_multiple_of(ALIGNMENT), b' ');
    let chunks: &[(&[u8; 4], &[u8])] =
        if chunk.is_empty() { &[(b"JSON", &text)] } else { &[(b"JSON", &text), (b"BIN\0", chunk)] };
    let total = 12 + chunks.iter().map(|(_, bytes)| 8 + bytes.len()).sum::<usize>();
    let total_bytes =
        u32::try_from(total).map_err(|_| Error::value("scene", "a file of less than 4 GiB in each group", total))?;
    let mut bytes = try_with_capacity(total)?;
    bytes.extend_from_slice(MAGIC);
    bytes.extend(VERSION.to_le_bytes());
    bytes.extend(total_bytes.to_le_bytes());
    for (kind, content) in chunks {
        bytes.extend((content.len() as u32).to_le_bytes());
        bytes.extend_from_slice(*kind);
        bytes.extend_from_slice(content);
    }
    Ok(bytes)
}
