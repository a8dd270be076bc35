//! The scene: static and moving instances with their materials and textures.

use std::collections::HashSet;
use std::sync::Arc;

use glam::DVec3;
use rayon::prelude::*;

use super::instance::{Instance, InstanceSet};
use super::material::Material;
use super::mesh::{self, Mesh};
use super::texture::Texture;
use crate::base::mapped::pieces;
use crate::base::memory::try_vec;
use crate::base::{Aabb, Error, Progress, Result, ensure};

/// An immutable scene. Copies share meshes, textures and trees; only instance lists differ.
///
/// Static instances are numbered first, then moving ones; triangles are numbered in the order of instances.
#[derive(Clone, Debug)]
pub struct Scene {
    /// World position of the origin of the float32 geometry.
    pub origin: DVec3,
    /// Instances that never move.
    pub standing: Arc<InstanceSet>,
    /// Instances whose poses may change.
    pub moving: Arc<InstanceSet>,
    /// Materials, indexed by the meshes' material maps.
    pub materials: Arc<Vec<Material>>,
    /// Textures, indexed by the materials.
    pub textures: Arc<Vec<Texture>>,
}

impl Scene {
    /// Creates a scene and checks its references.
    pub fn new(
        origin: DVec3,
        standing: Vec<Instance>,
        moving: Vec<Instance>,
        materials: Arc<Vec<Material>>,
        textures: Arc<Vec<Texture>>,
    ) -> Result<Self> {
        ensure!(origin.is_finite(), "origin", "three finite numbers", origin);
        let texture_count = textures.len();
        if let Some(wrong) = materials.iter().flat_map(Material::textures).find(|&t| t as usize >= texture_count) {
            return Err(Error::value("materials", format!("texture numbers below {texture_count}"), wrong));
        }
        let is_light = |emission: &[f32; 3]| emission.iter().all(|x| x.is_finite() && *x >= 0.0);
        if let Some(wrong) = materials.iter().find(|material| !is_light(&material.emission)) {
            let expected = "emission of three finite numbers of at least 0";
            return Err(Error::value("materials", expected, format!("{:?}", wrong.emission)));
        }
        for mesh in distinct_meshes(standing.iter().chain(&moving)) {
            mesh.materials.validate("materials", mesh.faces.len(), materials.len() as i32)?;
        }
        let count = standing.len() + moving.len();
        ensure!(count < u32::MAX as usize, "instances", "fewer than 2^32 - 1", count);
        let (standing, moving) = (Arc::new(InstanceSet::new(standing)), Arc::new(InstanceSet::new(moving)));
        Ok(Self { origin, standing, moving, materials, textures })
    }

    /// Returns the scene with its moving instances replaced.
    pub fn posed(&self, moving: Vec<Instance>) -> Self {
        self.with_sets(None, Some(InstanceSet::new(moving)))
    }

    /// Returns the scene with other static and moving instances; `None` shares those of this scene.
    pub(crate) fn with_sets(&self, standing: Option<InstanceSet>, moving: Option<InstanceSet>) -> Self {
        let replaced = |old: &Arc<InstanceSet>, new: Option<InstanceSet>| new.map_or_else(|| Arc::clone(old), Arc::new);
        let (standing, moving) = (replaced(&self.standing, standing), replaced(&self.moving, moving));
        Self { standing, moving, ..self.clone() }
    }

    /// Returns both sets: static, moving.
    pub fn sets(&self) -> [&InstanceSet; 2] {
        [&self.standing, &self.moving]
    }

    /// Returns all instances, ordered by number.
    pub fn instances(&self) -> impl Iterator<Item = &Instance> {
        self.standing.instances().iter().chain(self.moving.instances())
    }

    /// Returns an instance by its number.
    #[inline]
    pub fn instance(&self, number: u32) -> &Instance {
        let standing = self.standing.instances();
        match standing.get(number as usize) {
            Some(instance) => instance,
            None => &self.moving.instances()[number as usize - standing.len()],
        }
    }

    /// Returns the number of instances, static and moving.
    pub fn instance_count(&self) -> usize {
        self.standing.instances().len() + self.moving.instances().len()
    }

    /// Returns the number of triangles before an instance.
    pub fn triangle_offset(&self, number: u32) -> i64 {
        let standing = self.standing.instances().len();
        match (number as usize).checked_sub(standing) {
            None => self.standing.offset(number as usize),
            Some(moving) => self.standing.triangle_count() + self.moving.offset(moving),
        }
    }

    /// Returns the number of triangles of all instances.
    pub fn triangle_count(&self) -> i64 {
        self.standing.triangle_count() + self.moving.triangle_count()
    }

    /// Returns the instance and face of a triangle number.
    pub fn locate(&self, triangle: i64) -> Option<(u32, u32)> {
        let standing = self.standing.triangle_count();
        if triangle < standing {
            return self.standing.locate(triangle).map(|(instance, face)| (instance as u32, face));
        }
        let (instance, face) = self.moving.locate(triangle - standing)?;
        Some(((instance + self.standing.instances().len()) as u32, face))
    }

    /// Builds all trees that rays need; each is built once and shared by all copies of the scene.
    pub fn build(&self, progress: &Progress) -> Result<()> {
        self.sets().into_iter().try_for_each(|set| set.build(progress))
    }

    /// Builds all trees and, under a memory limit, the coarser levels of textures. Shading would build these on first
    /// use, several at once, and cannot report that memory does not suffice.
    pub fn build_to_shade(&self, progress: &Progress) -> Result<()> {
        self.build(progress)?;
        if progress.watches_memory() { self.build_levels(progress) } else { Ok(()) }
    }

    /// Builds missing coarser levels of the materials' textures in sequence. Fails if memory does not suffice.
    pub fn build_levels(&self, progress: &Progress) -> Result<()> {
        let has_cutouts = self.has_cutouts();
        for number in self.materials.iter().flat_map(Material::textures) {
            self.textures[number as usize].build_coarser(has_cutouts, progress)?;
        }
        Ok(())
    }

    /// Returns the corners of all triangles ordered by number, nine floats each, relative to the origin. For export,
    /// not for kernels.
    pub fn triangles(&self, progress: &Progress) -> Result<Vec<f32>> {
        let mut flat = try_vec(0.0, self.triangle_count() as usize * 9)?;
        let lengths = self.instances().map(|instance| instance.mesh.faces.len() * 9);
        for (instance, coordinates) in self.instances().zip(pieces(&mut flat, lengths)) {
            coordinates.par_chunks_mut(9 * mesh::CHUNK).enumerate().try_for_each(|(chunk, faces)| {
                let first = chunk * mesh::CHUNK;
                for (face, coordinates) in faces.as_chunks_mut::<9>().0.iter_mut().enumerate() {
                    let corners = instance.corners((first + face) as u32);
                    coordinates.copy_from_slice(corners.map(|corner| corner.to_array()).as_flattened());
                }
                progress.check()
            })?;
        }
        Ok(flat)
    }

    /// Returns the size of instances, meshes, their trees and textures, bytes; shared ones count once.
    pub fn bytes(&self) -> usize {
        let meshes: usize = distinct_meshes(self.instances()).map(Mesh::bytes).sum();
        let textures: usize = self.textures.iter().map(Texture::bytes).sum();
        self.instance_count() * size_of::<Instance>() + meshes + textures
    }

    /// Returns the number of faces without area, counting each mesh once.
    pub fn degenerate_count(&self, progress: &Progress) -> Result<usize> {
        distinct_meshes(self.instances()).map(|mesh| mesh.degenerate_count(progress)).sum()
    }

    /// Returns the tight box of all placed triangles, relative to the origin.
    pub fn bounds(&self) -> Aabb {
        let mut tight = Aabb::EMPTY;
        for instance in self.instances() {
            // An instance whose loose box already lies inside adds nothing.
            if tight.union(&instance.bounds) == tight {
                continue;
            }
            if instance.in_place {
                tight = tight.union(&instance.bounds);
                continue;
            }
            let faces = instance.mesh.faces.par_chunks(mesh::CHUNK).enumerate();
            let chunk_bounds = |(chunk, faces): (usize, &[[u32; 3]])| {
                let first = chunk * mesh::CHUNK;
                Aabb::of_points((first..first + faces.len()).flat_map(|face| instance.corners(face as u32)))
            };
            tight = tight.union(&faces.map(chunk_bounds).reduce(|| Aabb::EMPTY, |a, b| a.union(&b)));
        }
        tight
    }
}

fn distinct_meshes<'a>(instances: impl Iterator<Item = &'a Instance>) -> impl Iterator<Item = &'a Mesh> {
    let mut addresses = HashSet::new();
    instances.map(|instance| &*instance.mesh).filter(move |&mesh| addresses.insert(std::ptr::from_ref(mesh)))
}
