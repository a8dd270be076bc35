//! Tables of a scene on the device: parts of its meshes, materials, and instances as records.

use std::collections::HashMap;
use std::sync::{Arc, Weak};

use nearfar_core::base::Result;
use nearfar_core::scene::{Instance, InstanceSet, Material, Mesh, Scene, Texture};
use wgpu::BufferUsages;

use super::materials::MaterialTable;
use super::pages::{Part, Parts};
use super::records::{PART_WORD, RECORD_WORDS, Records, record_words};
use crate::device::Device;

/// Words of a part in its table.
pub(crate) const PART_WORDS: usize = 8;

/// Cache key of a scene's tables; it does not include poses of moving instances.
pub(super) struct Key {
    standing: Weak<InstanceSet>,
    materials: Weak<Vec<Material>>,
    textures: Weak<Vec<Texture>>,
    moving: Vec<Weak<Mesh>>,
}

impl Key {
    pub fn new(scene: &Scene) -> Self {
        Self {
            standing: Arc::downgrade(&scene.standing),
            materials: Arc::downgrade(&scene.materials),
            textures: Arc::downgrade(&scene.textures),
            moving: scene.moving.instances().iter().map(|instance| Arc::downgrade(&instance.mesh)).collect(),
        }
    }

    pub fn is_alive(&self) -> bool {
        self.standing.strong_count() > 0
            && self.materials.strong_count() > 0
            && self.moving.iter().all(|mesh| mesh.strong_count() > 0)
    }

    pub fn is_of(&self, scene: &Scene) -> bool {
        let moving = scene.moving.instances();
        std::ptr::eq(self.standing.as_ptr(), Arc::as_ptr(&scene.standing))
            && std::ptr::eq(self.materials.as_ptr(), Arc::as_ptr(&scene.materials))
            && std::ptr::eq(self.textures.as_ptr(), Arc::as_ptr(&scene.textures))
            && self.moving.len() == moving.len()
            && self.moving.iter().zip(moving).all(|(mesh, i)| std::ptr::eq(mesh.as_ptr(), Arc::as_ptr(&i.mesh)))
    }
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
    /// Instance number in the set and first face of the part, for each record.
    pub record_faces: Arc<Vec<(u32, u32)>>,
    /// Part number of each record.
    parts: Vec<u32>,
}

/// Tables of a scene.
pub(crate) struct SceneTables {
    pub static_set: SetTables,
    pub moving_set: SetTables,
    /// Records of the static instances; those of moving ones are uploaded with each pose.
    pub records: Vec<Records>,
    /// Table of all parts.
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
        let mut known: HashMap<*const Mesh, (u32, Parts)> = HashMap::new();
        let mut number_of = |mesh: &Arc<Mesh>| {
            let numbered = known.entry(Arc::as_ptr(mesh)).or_insert_with(|| {
                let (first, parts) = ((words.len() / PART_WORDS) as u32, parts_of(mesh));
                parts.iter().for_each(|part| words.extend(part_words(part, default_material)));
                (first, parts)
            });
            numbered.clone()
        };
        let [static_set, moving_set] = scene.sets().map(|set| SetTables::new(set.instances(), &mut number_of));
        let records = Records::of_static(device, &static_set.record_words(scene.standing.instances()))?;
        let parts = device.filled_buffer("parts", &words, BufferUsages::STORAGE)?;
        let colored = scene.instances().any(|instance| instance.mesh.colors.is_some());
        let smooth = scene.instances().any(|instance| instance.mesh.normals.is_some());
        Ok(Self { static_set, moving_set, records, parts, part_words: words, colored, smooth, materials })
    }

    /// Returns a record's part as in its table.
    pub fn part_of(&self, record: &[u32; RECORD_WORDS]) -> [u32; PART_WORDS] {
        let start = record[PART_WORD] as usize * PART_WORDS;
        std::array::from_fn(|i| self.part_words[start + i])
    }
}

impl SetTables {
    fn new(instances: &[Instance], number_of: &mut impl FnMut(&Arc<Mesh>) -> (u32, Parts)) -> Self {
        let (mut placed, mut record_faces, mut numbers) = (Vec::new(), Vec::new(), Vec::new());
        for (number, instance) in instances.iter().enumerate() {
            let (first, parts) = number_of(&instance.mesh);
            let first_record = record_faces.len() as u32;
            for (i, part) in parts.iter().enumerate() {
                record_faces.push((number as u32, part.first_face));
                numbers.push(first + i as u32);
            }
            placed.push(InstanceParts { first_record, parts });
        }
        Self { instances: placed, record_faces: Arc::new(record_faces), parts: numbers }
    }

    /// Returns the records of all instances in their current poses.
    pub fn record_words(&self, instances: &[Instance]) -> Vec<u32> {
        (0..self.parts.len()).flat_map(|record| self.record(instances, record)).collect()
    }

    /// Returns one record.
    pub fn record(&self, instances: &[Instance], record: usize) -> [u32; RECORD_WORDS] {
        record_words(&instances[self.record_faces[record].0 as usize], self.parts[record])
    }
}

fn part_words(part: &Part, default_material: i32) -> [u32; PART_WORDS] {
    let [positions, faces, uvs, colors, materials, normals] = part.words;
    let material = if part.material < 0 { default_material } else { part.material };
    [positions, faces, uvs, colors, materials, material as u32, part.page.number as u32, normals]
}
