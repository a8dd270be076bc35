//! Meshes placed in the world.

use std::sync::{Arc, OnceLock};

use glam::{DAffine3, Vec3};

use super::mesh::Mesh;
use crate::base::{Aabb, MAX_COORDINATE, Progress, Result, ensure};
use crate::bvh::Tlas;

/// A placed mesh. Positions are relative to the scene's origin.
#[derive(Clone, Debug)]
pub struct Instance {
    /// The mesh.
    pub mesh: Arc<Mesh>,
    /// Transform object→scene.
    pub to_scene: DAffine3,
    /// Transform scene→object.
    pub to_object: DAffine3,
    /// Object of all faces; `None` if the mesh's face map names the objects.
    pub object: Option<i32>,
    /// Whether the transform is the identity; vertices are then used without rounding.
    pub in_place: bool,
    /// Box of the placed mesh; tight if the transform maps axes to axes.
    pub bounds: Aabb,
}

impl Instance {
    /// Places a mesh. The transform must be finite and invertible.
    pub fn new(mesh: Arc<Mesh>, to_scene: DAffine3, object: Option<i32>) -> Result<Self> {
        let to_object = to_scene.inverse();
        let is_valid = to_scene.is_finite() && to_object.is_finite();
        ensure!(is_valid, "transform", "a finite, invertible 4x4 matrix", to_scene);
        let bounds = mesh.bounds().transformed(&to_scene);
        ensure!(
            bounds.max_coordinate() <= MAX_COORDINATE as f32,
            "transform",
            format!("a placement within ±{MAX_COORDINATE:e} m"),
            to_scene
        );
        Ok(Self { in_place: to_scene == DAffine3::IDENTITY, mesh, to_scene, to_object, object, bounds })
    }

    /// Returns the corners of a face relative to the scene's origin, rounded once to float32.
    #[inline]
    pub fn corners(&self, face: u32) -> [Vec3; 3] {
        let corners = self.mesh.corners(face);
        if self.in_place {
            return corners;
        }
        corners.map(|corner| self.to_scene.transform_point3(corner.as_dvec3()).as_vec3())
    }

    /// Returns the object of a face.
    #[inline]
    pub fn object_of(&self, face: u32) -> i32 {
        self.object.unwrap_or_else(|| self.mesh.objects.get(face))
    }
}

/// Instances below one top-level tree. A scene has two sets: static instances, shared by all poses, and moving ones.
#[derive(Debug, Default)]
pub struct InstanceSet {
    instances: Vec<Instance>,
    /// Number of triangles before each instance; the last entry is the total.
    offsets: Vec<i64>,
    tlas: OnceLock<Tlas>,
}

impl InstanceSet {
    /// Creates a set and numbers the triangles in the order of the instances.
    pub fn new(instances: Vec<Instance>) -> Self {
        let mut offsets = vec![0];
        offsets.extend(instances.iter().scan(0, |total, instance| {
            *total += instance.mesh.faces.len() as i64;
            Some(*total)
        }));
        Self { instances, offsets, ..Self::default() }
    }

    /// Returns the instances, in order.
    pub fn instances(&self) -> &[Instance] {
        &self.instances
    }

    /// Returns the number of triangles before an instance; for the instance count, the total.
    pub fn offset(&self, instance: usize) -> i64 {
        self.offsets.get(instance).copied().unwrap_or(0)
    }

    /// Returns the number of triangles of all instances.
    pub fn triangle_count(&self) -> i64 {
        self.offset(self.instances.len())
    }

    /// Returns the instance and face of a triangle number.
    pub fn locate(&self, triangle: i64) -> Option<(usize, u32)> {
        (0..self.triangle_count()).contains(&triangle).then(|| {
            let instance = self.offsets.partition_point(|&offset| offset <= triangle) - 1;
            (instance, (triangle - self.offsets[instance]) as u32)
        })
    }

    /// Returns the top-level tree, if it has been built.
    #[inline]
    pub fn tlas(&self) -> Option<&Tlas> {
        self.tlas.get()
    }

    /// Builds the trees of all meshes and the top-level tree, each on first use. No lock is held during the build.
    pub fn build(&self, progress: &Progress) -> Result<()> {
        if self.tlas.get().is_some() {
            return Ok(());
        }
        for instance in &self.instances {
            instance.mesh.build_bvh(progress)?;
        }
        let boxes: Vec<Aabb> = self.instances.iter().map(|instance| instance.bounds).collect();
        let tlas = Tlas::build(&boxes, progress)?;
        self.tlas.get_or_init(|| tlas);
        Ok(())
    }
}
