//! Encoding of a scene as GLB files.

use std::collections::{BTreeMap, BTreeSet};

use rayon::prelude::*;

use super::attribute::{Attribute, Stream};
use super::document::Document;
use super::faces::{Frame, Part};
use super::grid::Grid;
use super::mesh::{EncodedMesh, room_to_encode};
use super::placement::{Trs, greatest_stretch};
use super::plan::{Contents, InstanceFaces, MAX_STEP, MIN_STEP, Moving, Plan, Settings, SharedPlan};
use super::statistics::{Kind, Statistics};
use super::surfaces::Surfaces;
use crate::base::memory::room_for_values;
use crate::base::{Error, Progress, Result, by_number, ensure, number};
use crate::scene::{Scene, is_mirror};

/// Placements between two checks for cancellation.
const PLACEMENTS_PER_CHECK: usize = 1 << 12;

/// Bytes of a placement: translation, rotation and scale.
const PLACEMENT_BYTES: usize = size_of::<[f32; 10]>();

/// A scene divided into files.
#[derive(Debug)]
pub struct Export {
    scene: Scene,
    settings: Settings,
    names: Vec<String>,
    surfaces: Surfaces,
    plan: Plan,
    /// Meshes with several placements.
    pub shared: Vec<SharedMesh>,
}

/// A mesh with several placements.
#[derive(Debug)]
pub struct SharedMesh {
    encoded: EncodedMesh,
    /// Groups that contain placements of the mesh, ascending.
    pub groups: Vec<u16>,
}

/// A GLB file.
#[derive(Clone, Debug)]
pub struct Glb {
    /// Bytes of the file.
    pub bytes: Vec<u8>,
    /// Statistics of the file. For shared meshes in external buffers they include only the drawn triangles.
    pub statistics: Statistics,
}

impl SharedMesh {
    /// Returns the bytes of the buffer that files refer to by its URI.
    pub fn bytes(&self) -> Result<Vec<u8>> {
        self.encoded.bytes()
    }

    /// Returns sizes, counts and errors. Drawn triangles are counted in the files that place the mesh.
    pub fn statistics(&self) -> &Statistics {
        &self.encoded.statistics
    }
}

impl Export {
    /// Divides a scene and encodes the meshes with several placements.
    ///
    /// `groups` has the group of each object; its last entry is for faces without an object. Groups are below `count`.
    /// `names` are the objects' names, which become node names of moving objects. `images` has the URI of each
    /// texture's image, `None` to omit the texture.
    pub fn new(
        scene: &Scene,
        groups: &[u16],
        count: usize,
        names: Vec<String>,
        images: Vec<Option<String>>,
        settings: Settings,
        progress: &Progress,
    ) -> Result<Self> {
        let expected = format!("metres from {} to {}", number(MIN_STEP), number(MAX_STEP));
        ensure!((MIN_STEP..=MAX_STEP).contains(&settings.step), "step", expected, number(settings.step));
        let surfaces = Surfaces::new(scene, images)?;
        let plan = Plan::new(scene, groups, count, settings.step, progress)?;
        progress.expect(room_to_encode(plan.shared.iter().map(|plan| plan.mesh.faces.len()))?);
        let encode = |plan: &SharedPlan| {
            let part = Part { mesh: &plan.mesh, frame: Frame::Own { flipped: plan.flipped }, faces: None };
            let mut encoded = EncodedMesh::new(&[part], plan.grid, &surfaces, settings.compressed, progress)?;
            encoded.statistics.position_error *= plan.stretch;
            Ok(SharedMesh { encoded, groups: plan.groups.clone() })
        };
        let shared = plan.shared.par_iter().map(encode).collect::<Result<_>>()?;
        Ok(Self { scene: scene.clone(), settings, names, surfaces, plan, shared })
    }

    /// Returns the file of a group. `uris` has the URI of each shared mesh's buffer, or none to write it into the file.
    pub fn glb(&self, group: u16, uris: &[Option<String>], progress: &Progress) -> Result<Glb> {
        let Some(contents) = self.plan.groups.get(usize::from(group)) else {
            return Err(Error::value("group", format!("a number below {}", self.plan.groups.len()), group));
        };
        let count = self.shared.len();
        ensure!(uris.len() == count, "uris", format!("a URI or none for each of {count} shared meshes"), uris.len());
        let (merged, moving) = self.encode_unshared(contents, progress)?;
        let embedded = self.shared.iter().zip(uris).filter(|(_, uri)| uri.is_none()).map(|(shared, _)| &shared.encoded);
        let meshes = moving.iter().flatten().chain([&merged]).chain(embedded);
        let bytes = meshes.map(EncodedMesh::byte_count).sum::<usize>() + contents.placed.len() * PLACEMENT_BYTES;
        let document = Document::with_room(self.settings.compressed, bytes)?;
        let mut file = FileWriter { export: self, document, statistics: Statistics::default(), progress };
        file.add_merged(&merged)?;
        let numbers = file.add_shared(contents, uris);
        file.add_placed(contents, &numbers)?;
        file.add_moving(contents, &moving, &numbers)?;
        file.finish()
    }

    /// Encodes the merged mesh of a group, and the meshes of its moving objects; `None` for shared meshes.
    fn encode_unshared(
        &self,
        contents: &Contents,
        progress: &Progress,
    ) -> Result<(EncodedMesh, Vec<Option<EncodedMesh>>)> {
        let merged: Vec<Part<'_>> = contents
            .merged
            .iter()
            .map(|faces| Part { frame: Frame::Scene(self.scene.instance(faces.instance)), ..self.mesh_part(faces) })
            .collect();
        let unshared = contents.moving.iter().filter(|moving| moving.shared.is_none());
        let face_counts =
            merged.iter().map(Part::count).chain(unshared.map(|moving| self.mesh_part(&moving.faces).count()));
        progress.expect(room_to_encode(face_counts)?);
        let encode = |parts: &[Part<'_>], grid| {
            EncodedMesh::new(parts, grid, &self.surfaces, self.settings.compressed, progress)
        };
        let encode_moving = |Moving { faces, shared, .. }: &Moving| {
            if shared.is_some() {
                return Ok(None);
            }
            let part = self.mesh_part(faces);
            // A placement multiplies errors by at most this factor.
            let stretch = greatest_stretch(&self.scene.instance(faces.instance).to_scene.matrix3);
            let grid = Grid::new(self.settings.step / stretch, f64::from(part.mesh.bounds().max_coordinate()));
            let mut encoded = encode(&[part], grid)?;
            encoded.statistics.position_error *= stretch;
            Ok(Some(encoded))
        };
        let merged = encode(&merged, self.plan.merged_grid)?;
        Ok((merged, contents.moving.par_iter().map(encode_moving).collect::<Result<_>>()?))
    }

    fn mesh_part<'a>(&'a self, faces: &'a InstanceFaces) -> Part<'a> {
        let instance = self.scene.instance(faces.instance);
        let frame = Frame::Own { flipped: is_mirror(&instance.to_scene) };
        Part { mesh: &instance.mesh, frame, faces: faces.faces.as_deref() }
    }
}

/// A file being written.
struct FileWriter<'a> {
    export: &'a Export,
    document: Document,
    statistics: Statistics,
    progress: &'a Progress,
}

impl FileWriter<'_> {
    fn add_merged(&mut self, merged: &EncodedMesh) -> Result<()> {
        self.statistics.add(&merged.statistics);
        self.statistics.drawn += merged.statistics.triangles;
        if !merged.primitives.is_empty() {
            let mesh = self.document.add_mesh(merged, None);
            self.document.add_node(mesh, Some("static"), &glam::DAffine3::IDENTITY)?;
        }
        Ok(())
    }

    /// Adds the shared meshes of a group, except those without faces; returns their numbers in the file.
    fn add_shared(&mut self, contents: &Contents, uris: &[Option<String>]) -> BTreeMap<usize, usize> {
        let placed = contents.placed.iter().map(|&(shared, _)| shared);
        let moving = contents.moving.iter().filter_map(|moving| moving.shared);
        let needed: BTreeSet<usize> = placed.chain(moving).collect();
        let mut numbers = BTreeMap::new();
        for shared in needed {
            let encoded = &self.export.shared[shared].encoded;
            if encoded.primitives.is_empty() {
                continue;
            }
            if uris[shared].is_none() {
                self.statistics.add(&encoded.statistics);
            }
            numbers.insert(shared, self.document.add_mesh(encoded, uris[shared].as_deref()));
        }
        numbers
    }

    fn add_placed(&mut self, contents: &Contents, numbers: &BTreeMap<usize, usize>) -> Result<()> {
        let mut by_mesh: BTreeMap<usize, Vec<u32>> = BTreeMap::new();
        contents.placed.iter().for_each(|&(shared, instance)| by_mesh.entry(shared).or_default().push(instance));
        for (shared, instances) in by_mesh {
            let Some(&mesh) = numbers.get(&shared) else { continue };
            let plan = &self.export.plan.shared[shared];
            self.count_drawn(shared, instances.len());
            let (bounds, rounding) = (plan.mesh.bounds(), self.export.shared[shared].statistics().position_error);
            let mut placements = Vec::new();
            for (number, instance) in instances.into_iter().enumerate() {
                if number % PLACEMENTS_PER_CHECK == 0 {
                    self.progress.check()?;
                }
                let to_scene = &self.export.scene.instance(instance).to_scene;
                // Viewers flip the winding of mirrored nodes, but not of mirrored instances of an instanced mesh.
                let trs = Some(Trs::decompose(to_scene)).filter(|_| self.export.settings.compressed && !plan.flipped);
                let error = trs.map(|trs| trs.error(to_scene, &bounds));
                match trs.zip(error).filter(|&(_, error)| error <= self.export.settings.step / 2.0) {
                    Some((trs, error)) => {
                        self.statistics.position_error = self.statistics.position_error.max(rounding + error);
                        placements.push(trs);
                    }
                    None => self.document.add_node(mesh, None, to_scene)?,
                }
            }
            if !placements.is_empty() {
                let streams = placement_streams(&placements)?;
                streams.iter().for_each(|stream| stream.add_to(&mut self.statistics));
                self.document.add_placements(mesh, &streams);
            }
        }
        Ok(())
    }

    fn add_moving(
        &mut self,
        contents: &Contents,
        meshes: &[Option<EncodedMesh>],
        numbers: &BTreeMap<usize, usize>,
    ) -> Result<()> {
        for (moving, encoded) in contents.moving.iter().zip(meshes) {
            let mesh = match (moving.shared, encoded) {
                (Some(shared), _) => {
                    self.count_drawn(shared, 1);
                    numbers.get(&shared).copied()
                }
                (None, Some(encoded)) if !encoded.primitives.is_empty() => {
                    self.statistics.add(&encoded.statistics);
                    self.statistics.drawn += encoded.statistics.triangles;
                    Some(self.document.add_mesh(encoded, None))
                }
                (None, _) => None,
            };
            let name = by_number(&self.export.names, moving.object);
            if let Some(mesh) = mesh {
                let to_scene = &self.export.scene.instance(moving.faces.instance).to_scene;
                self.document.add_node(mesh, name.map(String::as_str), to_scene)?;
            }
        }
        Ok(())
    }

    fn count_drawn(&mut self, shared: usize, placements: usize) {
        let statistics = self.export.shared[shared].statistics();
        self.statistics.drawn += statistics.triangles * placements as u64;
        self.statistics.position_error = self.statistics.position_error.max(statistics.position_error);
    }

    fn finish(self) -> Result<Glb> {
        let Self { export, document, mut statistics, .. } = self;
        let bytes = document.encode(export.scene.origin, &export.surfaces)?;
        let arrays: u64 = statistics.bytes.iter().sum();
        statistics.count(Kind::Document, bytes.len() - arrays as usize);
        Ok(Glb { bytes, statistics })
    }
}

fn placement_streams(placements: &[Trs]) -> Result<[Stream; 3]> {
    // Memory for the arrays and for the encoder.
    room_for_values::<[[f32; 10]; 3]>(placements.len())?;
    let translations: Vec<[f32; 3]> = placements.iter().map(|trs| trs.translation).collect();
    let rotations: Vec<[f32; 4]> = placements.iter().map(|trs| trs.rotation).collect();
    let scales: Vec<[f32; 3]> = placements.iter().map(|trs| trs.scale).collect();
    Ok([
        Stream::rows(Attribute::Translation, &translations, true)?,
        Stream::rows(Attribute::Rotation, &rotations, true)?,
        Stream::rows(Attribute::Scale, &scales, true)?,
    ])
}
