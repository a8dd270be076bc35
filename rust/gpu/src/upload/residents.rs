//! Which meshes lie on the device already, by their identity; those that nobody holds any more are let go.

use std::collections::HashMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError, Weak};

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
    pub fn scene(&self, device: &Device, scene: &Scene) -> Result<Arc<SceneTables>> {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        known.scenes.retain(|(key, _)| key.is_alive());
        if let Some((_, tables)) = known.scenes.iter().find(|(key, _)| key.is_of(scene)) {
            return Ok(Arc::clone(tables));
        }
        known.meshes.retain(|_, (mesh, _)| mesh.strong_count() > 0);
        let mut missing: Vec<Arc<Mesh>> = Vec::new();
        for mesh in scene.instances().map(|instance| &instance.mesh) {
            let address = address(mesh);
            if !known.meshes.contains_key(&address) {
                missing.push(Arc::clone(mesh));
                known.meshes.insert(address, (Arc::downgrade(mesh), Parts::default()));
            }
        }
        let packed = pack(device, &missing, || self.pages.fetch_add(1, Ordering::Relaxed));
        let packed = match packed {
            Ok(packed) => packed,
            Err(error) => {
                missing.iter().for_each(|mesh| drop(known.meshes.remove(&self::address(mesh))));
                return Err(error);
            }
        };
        for (mesh, parts) in missing.iter().zip(packed) {
            known.meshes.insert(address(mesh), (Arc::downgrade(mesh), Arc::new(parts)));
        }
        let parts = |mesh: &Arc<Mesh>| known.meshes.get(&address(mesh)).map(|(_, parts)| Arc::clone(parts));
        let tables = Arc::new(SceneTables::new(device, scene, |mesh| parts(mesh).unwrap_or_default())?);
        known.scenes.push((Key::of(scene), Arc::clone(&tables)));
        Ok(tables)
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

fn address(mesh: &Arc<Mesh>) -> usize {
    Arc::as_ptr(mesh) as usize
}
