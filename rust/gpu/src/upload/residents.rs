//! Which meshes lie on the device already, by their identity; those that nobody holds any more are let go.

use std::collections::{HashMap, HashSet};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};

use glam::DVec3;
use nearfar_core::base::Result;
use nearfar_core::scene::{Mesh, Scene};
use wgpu::BufferUsages;

use super::pages::{Part, pack};
use super::tables::{Key, SceneTables};
use super::{EnvTexels, Page};
use crate::device::Device;

/// A mesh's parts.
pub(crate) type Parts = Arc<Vec<Part>>;

/// Meshes and scenes on the device.
#[derive(Default)]
pub(crate) struct Residents {
    known: Mutex<Known>,
    pages: AtomicU64,
    nothing: Mutex<Option<Arc<Nothing>>>,
}

/// What stands in where nothing is drawn or looked up.
pub(crate) struct Nothing {
    pub tables: Arc<SceneTables>,
    pub page: Page,
    pub map: EnvTexels,
}

#[derive(Default)]
struct Known {
    meshes: HashMap<usize, (Weak<Mesh>, Parts)>,
    scenes: Vec<(Key, Arc<SceneTables>)>,
}

impl Residents {
    /// A scene's tables: those of any pose of it, whose meshes are the same. What is missing is sent.
    ///
    /// Nothing is locked meanwhile: packing runs on the pool, whose threads take up other frames while they wait, which
    /// would wait for the lock of their own thread. Of two frames that send the same at a time one is let go.
    pub fn scene(&self, device: &Device, scene: &Scene) -> Result<Arc<SceneTables>> {
        device.check()?;
        let (mut parts, missing) = {
            let mut known = self.lock();
            known.scenes.retain(|(key, _)| key.is_alive());
            if let Some(tables) = known.tables_of(scene) {
                return Ok(tables);
            }
            known.meshes.retain(|_, (mesh, _)| mesh.strong_count() > 0);
            known.parts_of(scene)
        };
        let packed = pack(device, &missing, || self.pages.fetch_add(1, Ordering::Relaxed))?;
        parts.extend(missing.iter().map(address).zip(packed.into_iter().map(Arc::new)));
        let of_mesh = |mesh: &Arc<Mesh>| parts.get(&address(mesh)).map(Arc::clone).unwrap_or_default();
        let tables = Arc::new(SceneTables::new(device, scene, of_mesh)?);
        let mut known = self.lock();
        if let Some(tables) = known.tables_of(scene) {
            return Ok(tables);
        }
        for mesh in &missing {
            known.meshes.insert(address(mesh), (Arc::downgrade(mesh), of_mesh(mesh)));
        }
        known.scenes.push((Key::of(scene), Arc::clone(&tables)));
        Ok(tables)
    }

    fn lock(&self) -> MutexGuard<'_, Known> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What stands in where nothing is.
    pub fn nothing(&self, device: &Device) -> Result<Arc<Nothing>> {
        let mut known = self.nothing.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(nothing) = &*known {
            return Ok(Arc::clone(nothing));
        }
        let empty = Scene::new(DVec3::ZERO, Vec::new(), Vec::new(), Arc::default(), Arc::default())?;
        let nothing = Arc::new(Nothing {
            tables: Arc::new(SceneTables::new(device, &empty, |_| Parts::default())?),
            page: Page { buffer: device.buffer("page", 0, BufferUsages::STORAGE)?, number: u64::from(u32::MAX) },
            map: EnvTexels::new(device, None)?,
        });
        *known = Some(Arc::clone(&nothing));
        Ok(nothing)
    }
}

impl Known {
    fn tables_of(&self, scene: &Scene) -> Option<Arc<SceneTables>> {
        self.scenes.iter().find(|(key, _)| key.is_of(scene)).map(|(_, tables)| Arc::clone(tables))
    }

    /// Parts of a scene's meshes that are on the device, by address, and the meshes that are not.
    fn parts_of(&self, scene: &Scene) -> (HashMap<usize, Parts>, Vec<Arc<Mesh>>) {
        let (mut parts, mut missing, mut seen) = (HashMap::new(), Vec::new(), HashSet::new());
        for mesh in scene.instances().map(|instance| &instance.mesh) {
            if seen.insert(address(mesh)) {
                match self.meshes.get(&address(mesh)) {
                    Some((_, known)) => drop(parts.insert(address(mesh), Arc::clone(known))),
                    None => missing.push(Arc::clone(mesh)),
                }
            }
        }
        (parts, missing)
    }
}

fn address(mesh: &Arc<Mesh>) -> usize {
    Arc::as_ptr(mesh) as usize
}
