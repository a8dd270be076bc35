//! Tables of a scene on the device: parts of its meshes, materials, and records. A record is a transform and the part
//! that it places; an instance has one record for each part of its mesh.

use std::collections::HashMap;
use std::sync::{Arc, Weak};

use nearfar_core::base::Result;
use nearfar_core::scene::{Instance, InstanceSet, Material, Mesh, Scene, Texture};
use wgpu::BufferUsages;

use super::pages::{Part, Parts};
use super::texels::MaterialTable;
use crate::device::Device;

/// Words of a part in its table.
pub(crate) const PART_WORDS: usize = 8;

/// Words of a record: three rows of a matrix mesh→scene, and the part.
pub(crate) const RECORD_WORDS: usize = 16;
/// Index of the part in a record.
const PART_WORD: usize = 12;

/// Cache key of a scene's tables; it does not include poses of moving instances.
pub(super) struct Key {
    static_set: Weak<InstanceSet>,
    materials: Weak<Vec<Material>>,
    textures: Weak<Vec<Texture>>,
    moving: Vec<Weak<Mesh>>,
}

impl Key {
    pub fn new(scene: &Scene) -> Self {
        Self {
            static_set: Arc::downgrade(&scene.standing),
            materials: Arc::downgrade(&scene.materials),
            textures: Arc::downgrade(&scene.textures),
            moving: scene.moving.instances().iter().map(|instance| Arc::downgrade(&instance.mesh)).collect(),
        }
    }

    pub fn is_alive(&self) -> bool {
        self.static_set.strong_count() > 0
            && self.materials.strong_count() > 0
            && self.moving.iter().all(|mesh| mesh.strong_count() > 0)
    }

    pub fn matches(&self, scene: &Scene) -> bool {
        let moving = scene.moving.instances();
        is_same(&self.static_set, &scene.standing)
            && is_same(&self.materials, &scene.materials)
            && is_same(&self.textures, &scene.textures)
            && self.moving.len() == moving.len()
            && self.moving.iter().zip(moving).all(|(mesh, instance)| is_same(mesh, &instance.mesh))
    }
}

/// Returns whether a weak reference points to an allocation.
pub(super) fn is_same<T>(reference: &Weak<T>, allocation: &Arc<T>) -> bool {
    std::ptr::eq(reference.as_ptr(), Arc::as_ptr(allocation))
}

/// Parts of an instance and their records in its set.
#[derive(Clone, Debug)]
pub(crate) struct InstanceParts {
    /// First record; one per part, in order.
    pub first_record: u32,
    pub parts: Parts,
}

/// Instances of a set, static or moving.
pub(crate) struct SetTables {
    pub instances: Vec<InstanceParts>,
    /// For each record: number of its instance in the set, and first face of its part.
    pub record_faces: Vec<(u32, u32)>,
    /// Part number of each record.
    parts: Vec<u32>,
}

pub(crate) struct SceneTables {
    pub static_set: SetTables,
    pub moving_set: SetTables,
    /// Records of the static instances; those of moving ones are uploaded with each pose.
    pub records: Vec<Records>,
    pub parts: wgpu::Buffer,
    part_words: Vec<u32>,
    /// Whether some mesh has vertex colours.
    pub colored: bool,
    /// Whether some mesh has vertex normals.
    pub smooth: bool,
    pub materials: Arc<MaterialTable>,
}

impl SceneTables {
    pub fn new(
        device: &Device,
        scene: &Scene,
        materials: Arc<MaterialTable>,
        mut parts_of: impl FnMut(&Arc<Mesh>) -> Parts,
    ) -> Result<Self> {
        let mut words: Vec<u32> = Vec::new();
        let default_material = scene.materials.len() as i32;
        let mut numbered: HashMap<*const Mesh, (u32, Parts)> = HashMap::new();
        let mut number_of = |mesh: &Arc<Mesh>| {
            let number = || {
                let (first, parts) = ((words.len() / PART_WORDS) as u32, parts_of(mesh));
                parts.iter().for_each(|part| words.extend(part_words(part, default_material)));
                (first, parts)
            };
            numbered.entry(Arc::as_ptr(mesh)).or_insert_with(number).clone()
        };
        let [static_set, moving_set] = scene.sets().map(|set| SetTables::new(set.instances(), &mut number_of));
        let record_words = static_set.record_words(scene.standing.instances());
        Ok(Self {
            static_set,
            moving_set,
            records: Records::upload(device, &record_words)?,
            parts: device.filled_buffer("parts", &words, BufferUsages::STORAGE)?,
            part_words: words,
            colored: scene.instances().any(|instance| instance.mesh.colors.is_some()),
            smooth: scene.instances().any(|instance| instance.mesh.normals.is_some()),
            materials,
        })
    }

    /// Returns the words of a record's part.
    pub fn part_of(&self, record: &[u32; RECORD_WORDS]) -> [u32; PART_WORDS] {
        self.part_words.as_chunks().0[record[PART_WORD] as usize]
    }
}

impl SetTables {
    fn new(instances: &[Instance], number_of: &mut impl FnMut(&Arc<Mesh>) -> (u32, Parts)) -> Self {
        let mut set = Self { instances: Vec::new(), record_faces: Vec::new(), parts: Vec::new() };
        for (instance, number) in instances.iter().zip(0..) {
            let (first_part, parts) = number_of(&instance.mesh);
            let first_record = set.record_faces.len() as u32;
            set.record_faces.extend(parts.iter().map(|part| (number, part.first_face)));
            set.parts.extend((first_part..).take(parts.len()));
            set.instances.push(InstanceParts { first_record, parts });
        }
        set
    }

    /// Returns the records of all instances in their current poses.
    pub fn record_words(&self, instances: &[Instance]) -> Vec<u32> {
        (0..self.parts.len()).flat_map(|record| self.record(instances, record)).collect()
    }

    pub fn record(&self, instances: &[Instance], record: usize) -> [u32; RECORD_WORDS] {
        record_words(&instances[self.record_faces[record].0 as usize], self.parts[record])
    }
}

fn part_words(part: &Part, default_material: i32) -> [u32; PART_WORDS] {
    let [positions, faces, uvs, colors, materials, normals] = part.words;
    let material = if part.material < 0 { default_material } else { part.material };
    [positions, faces, uvs, colors, materials, material as u32, part.page.number as u32, normals]
}

/// Records of static instances that fit into one binding.
pub(crate) struct Records {
    pub buffer: Arc<wgpu::Buffer>,
    /// First record of the set.
    pub first: u32,
    pub count: u32,
}

impl Records {
    /// Uploads records in as many buffers as they need.
    pub fn upload(device: &Device, words: &[u32]) -> Result<Vec<Self>> {
        let max_count = device.largest_binding() as usize / (4 * RECORD_WORDS);
        let batches = words.chunks(max_count * RECORD_WORDS).enumerate().map(|(n, words)| {
            let buffer = Arc::new(device.filled_buffer("records", words, BufferUsages::STORAGE)?);
            Ok(Self { buffer, first: (n * max_count) as u32, count: (words.len() / RECORD_WORDS) as u32 })
        });
        batches.collect()
    }
}

/// Returns the record that places a part, given by its number, as an instance.
fn record_words(instance: &Instance, part: u32) -> [u32; RECORD_WORDS] {
    let (m, t) = (instance.to_scene.matrix3, instance.to_scene.translation);
    let row = |i: usize| [m.x_axis[i], m.y_axis[i], m.z_axis[i], t[i]].map(|x| (x as f32).to_bits());
    let mut words = [0; RECORD_WORDS];
    words[..PART_WORD].copy_from_slice([0, 1, 2].map(row).as_flattened());
    words[PART_WORD] = part;
    words
}
