//! Meshes and scenes on the device, by identity; unreferenced ones are dropped.

use std::collections::{HashMap, HashSet};
use std::sync::{Arc, Mutex, Weak};

use glam::DVec3;
use nearfar_core::base::Result;
use nearfar_core::scene::{Material, Mesh, Scene, Texture};
use wgpu::BufferUsages;

use super::pages::{Page, PageAllocator, Parts, pack};
use super::tables::{Key, SceneTables, is_same};
use super::texels::{EnvTexels, MaterialTable};
use crate::device::{Device, lock};

/// Maximum number of scenes with cached tables; each selection of moving objects is another scene.
const MAX_SCENES: usize = 64;

/// Identity of a material list and a texture list.
type MaterialKey = (Weak<Vec<Material>>, Weak<Vec<Texture>>);

/// Meshes and scenes on the device.
#[derive(Default)]
pub(crate) struct Residents {
    cache: Mutex<Cache>,
    allocator: PageAllocator<Page>,
    placeholders: Mutex<Option<Arc<Placeholders>>>,
}

#[derive(Default)]
struct Cache {
    meshes: HashMap<usize, (Weak<Mesh>, Parts)>,
    scenes: Vec<(Key, Arc<SceneTables>)>,
    /// Material tables by the identities of their lists, which derived scenes share.
    materials: Vec<(MaterialKey, Arc<MaterialTable>)>,
}

impl Cache {
    /// Drops tables whose scenes, meshes or materials no longer exist.
    fn purge(&mut self) {
        self.scenes.retain(|(key, _)| key.is_alive());
        self.meshes.retain(|_, (mesh, _)| mesh.strong_count() > 0);
        let is_alive = |key: &MaterialKey| key.0.strong_count() > 0 && key.1.strong_count() > 0;
        self.materials.retain(|(key, _)| is_alive(key));
    }

    fn materials_of(&self, scene: &Scene) -> Option<Arc<MaterialTable>> {
        let matches = |key: &MaterialKey| is_same(&key.0, &scene.materials) && is_same(&key.1, &scene.textures);
        self.materials.iter().find(|(key, _)| matches(key)).map(|(_, table)| Arc::clone(table))
    }

    /// Returns a scene's tables and marks them as most recently used.
    fn tables_of(&mut self, scene: &Scene) -> Option<Arc<SceneTables>> {
        let index = self.scenes.iter().position(|(key, _)| key.matches(scene))?;
        self.scenes[index..].rotate_left(1);
        self.scenes.last().map(|(_, tables)| Arc::clone(tables))
    }

    /// Returns the meshes that are not on the device, without duplicates.
    fn missing_meshes(&self, scene: &Scene) -> Vec<Arc<Mesh>> {
        let mut seen = HashSet::new();
        let meshes = scene.instances().map(|instance| &instance.mesh);
        let is_new = |mesh: &&Arc<Mesh>| !self.meshes.contains_key(&address(mesh)) && seen.insert(address(mesh));
        meshes.filter(is_new).cloned().collect()
    }
}

/// Empty tables and maps, bound where nothing is drawn or looked up.
pub(crate) struct Placeholders {
    pub tables: Arc<SceneTables>,
    pub page: Page,
    pub map: EnvTexels,
}

impl Residents {
    /// Returns a scene's tables, shared by all of its poses. Uploads meshes and materials that the device lacks.
    ///
    /// No lock is held during parallel work: a thread that waits inside rayon may run another frame, which needs the
    /// same lock. If two frames upload the same data concurrently, the first result is kept.
    pub fn scene(&self, device: &Device, scene: &Scene) -> Result<Arc<SceneTables>> {
        device.check()?;
        let missing = {
            let mut cache = lock(&self.cache);
            cache.purge();
            if let Some(tables) = cache.tables_of(scene) {
                return Ok(tables);
            }
            cache.missing_meshes(scene)
        };
        let packed = pack(device, &missing, &self.allocator)?;
        let parts: HashMap<usize, Parts> = {
            let mut cache = lock(&self.cache);
            for (mesh, parts) in missing.iter().zip(packed) {
                cache.meshes.entry(address(mesh)).or_insert_with(|| (Arc::downgrade(mesh), Arc::new(parts)));
            }
            let entry_of = |mesh: &Arc<Mesh>| {
                cache.meshes.get(&address(mesh)).map(|(_, parts)| (address(mesh), Arc::clone(parts)))
            };
            scene.instances().filter_map(|instance| entry_of(&instance.mesh)).collect()
        };
        let parts_of = |mesh: &Arc<Mesh>| parts.get(&address(mesh)).cloned().unwrap_or_default();
        let materials = self.materials(device, scene)?;
        let tables = Arc::new(SceneTables::new(device, scene, materials, parts_of)?);
        let mut cache = lock(&self.cache);
        if let Some(earlier) = cache.tables_of(scene) {
            return Ok(earlier);
        }
        if cache.scenes.len() == MAX_SCENES {
            cache.scenes.remove(0);
        }
        cache.scenes.push((Key::new(scene), Arc::clone(&tables)));
        Ok(tables)
    }

    fn materials(&self, device: &Device, scene: &Scene) -> Result<Arc<MaterialTable>> {
        if let Some(table) = lock(&self.cache).materials_of(scene) {
            return Ok(table);
        }
        let table = Arc::new(MaterialTable::new(device, scene)?);
        let mut cache = lock(&self.cache);
        if let Some(earlier) = cache.materials_of(scene) {
            return Ok(earlier);
        }
        let (materials, textures) = (Arc::downgrade(&scene.materials), Arc::downgrade(&scene.textures));
        cache.materials.push(((materials, textures), Arc::clone(&table)));
        Ok(table)
    }

    pub fn placeholders(&self, device: &Device) -> Result<Arc<Placeholders>> {
        let mut created = lock(&self.placeholders);
        if let Some(placeholders) = &*created {
            return Ok(Arc::clone(placeholders));
        }
        let empty = Scene::new(DVec3::ZERO, Vec::new(), Vec::new(), Arc::default(), Arc::default())?;
        let materials = Arc::new(MaterialTable::new(device, &empty)?);
        let placeholders = Arc::new(Placeholders {
            tables: Arc::new(SceneTables::new(device, &empty, materials, |_| Parts::default())?),
            page: Page { buffer: device.buffer("page", 0, BufferUsages::STORAGE)?, number: u64::from(u32::MAX) },
            map: EnvTexels::new(device, None)?,
        });
        *created = Some(Arc::clone(&placeholders));
        Ok(placeholders)
    }
}

fn address(mesh: &Arc<Mesh>) -> usize {
    Arc::as_ptr(mesh) as usize
}
