//! Bindings of `scene::Scene`.

use std::sync::Arc;

use glam::{DAffine3, DVec3};
use nearfar_core::base::{Aabb, Buffer, Error, Result};
use nearfar_core::scene::{self, Alpha, Instance, Material, PlacedMesh, Texture};
use nearfar_core::trace::touches;
use numpy::{PyArray1, PyArray2, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;

use super::mesh::{Mesh, affines, rows_of, standing_and_moving};
use crate::convert::{Array1, Array2, Array3, Read1, Read2, Read3, Report, buffer, run, to_python};

/// Meshes placed in the world.
#[pyclass(frozen, module = "nearfar._core")]
pub struct Scene(pub scene::Scene);

/// Part of a scene, and the indices of the moving instances that it has; `None` if it has all.
type Part<'py> = (Scene, Option<Array1<'py, u32>>);

/// Parts of a scene, by the names in the result of `scene_parts`. `placements` are (I, 3, 4) object→scene, relative to
/// the origin, static instances first. Object −1 keeps the mesh's own objects. Of a material, textures are −1 for none,
/// the cutoff is NaN if it is opaque, and the tag is 0 if it is drawn in full.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct SceneArguments<'py> {
    origin: [f64; 3],
    meshes: Vec<Py<Mesh>>,
    placements: Read3<'py, f64>,
    objects: Read1<'py, i32>,
    standing_count: usize,
    material_colors: Read2<'py, f32>,
    material_textures: Read1<'py, i32>,
    material_cutoffs: Read1<'py, f32>,
    material_emissions: Read2<'py, f32>,
    material_emission_textures: Read1<'py, i32>,
    material_unlit: Read1<'py, bool>,
    material_tags: Read1<'py, u64>,
    textures: Vec<Bound<'py, PyArrayDyn<u8>>>,
}

impl SceneArguments<'_> {
    fn materials(&self) -> Vec<Material> {
        let (colors, textures) = (self.material_colors.as_array(), self.material_textures.as_array());
        let (emissions, maps) = (self.material_emissions.as_array(), self.material_emission_textures.as_array());
        let colored = colors.outer_iter().zip(textures).zip(self.material_cutoffs.as_array());
        let lit = emissions.outer_iter().zip(maps).zip(self.material_unlit.as_array());
        let rows = colored.zip(lit).zip(self.material_tags.as_array());
        rows.map(|((((color, &texture), &cutoff), ((emission, &map), &unlit)), &tag)| Material {
            base_color: std::array::from_fn(|i| color[i]),
            texture: u32::try_from(texture).ok(),
            alpha: if cutoff.is_nan() { Alpha::Opaque } else { Alpha::Mask { cutoff } },
            emission: std::array::from_fn(|i| emission[i]),
            emission_texture: u32::try_from(map).ok(),
            unlit,
            tag,
        })
        .collect()
    }
}

#[pymethods]
impl Scene {
    #[new]
    fn new(py: Python<'_>, parts: SceneArguments<'_>) -> PyResult<Self> {
        let meshes: Vec<Arc<scene::Mesh>> = parts.meshes.iter().map(|mesh| Arc::clone(&mesh.get().0)).collect();
        let (placements, objects) = (affines(&parts.placements), parts.objects.as_array());
        let (origin, materials, count) = (DVec3::from_array(parts.origin), parts.materials(), parts.standing_count);
        let textures = parts.textures.iter().map(texture).collect::<PyResult<_>>()?;
        run::short(py, || {
            let (standing, moving) = standing_and_moving(meshes, placements, objects, count)?;
            scene::Scene::new(origin, standing, moving, Arc::new(materials), Arc::new(textures))
        })
        .map(Self)
    }

    /// Merges all instances to one mesh, relative to the origin.
    fn merged(&self, py: Python<'_>) -> PyResult<Mesh> {
        let parts: Vec<PlacedMesh> = self.0.instances().map(PlacedMesh::from_instance).collect();
        run::long(py, None, |progress| scene::merge(&parts, progress)).map(|mesh| Mesh(Arc::new(mesh)))
    }

    /// Creates a scene of one static mesh as object 0, with the same origin, materials and textures.
    fn of_mesh(&self, py: Python<'_>, mesh: &Mesh) -> PyResult<Self> {
        let mesh = Arc::clone(&mesh.0);
        run::short(py, || {
            let standing = vec![Instance::new(mesh, DAffine3::IDENTITY, Some(0))?];
            let (materials, textures) = (Arc::clone(&self.0.materials), Arc::clone(&self.0.textures));
            scene::Scene::new(self.0.origin, standing, vec![], materials, textures)
        })
        .map(Self)
    }

    /// Creates the scene with new placements of the moving instances, in their order.
    fn posed(&self, py: Python<'_>, placements: Read3<'_, f64>) -> PyResult<Self> {
        let placements = affines(&placements);
        run::short(py, || {
            let moving = self.0.moving.instances();
            if placements.len() != moving.len() {
                return Err(Error::value("placements", format!("{} matrices", moving.len()), placements.len()));
            }
            let place = |(old, to_scene): (&Instance, DAffine3)| old.with_transform(to_scene);
            moving.iter().zip(placements).map(place).collect::<Result<Vec<_>>>().map(|moving| self.0.posed(moving))
        })
        .map(Self)
    }

    /// Creates the scene in which the chosen objects also move; `chosen` has a flag for each object.
    fn with_moving(&self, py: Python<'_>, chosen: Read1<'_, bool>) -> PyResult<Self> {
        let chosen = chosen.as_slice()?;
        run::long(py, None, |progress| self.0.with_moving(chosen, progress)).map(Self)
    }

    /// Creates the scene of the chosen objects; `chosen` has a flag for each object.
    fn subset_of_objects(&self, py: Python<'_>, chosen: Read1<'_, bool>) -> PyResult<Self> {
        let chosen = chosen.as_slice()?;
        run::long(py, None, |progress| self.0.subset_of_objects(chosen, progress)).map(Self)
    }

    /// Creates the scene without the chosen objects; `chosen` has a flag for each object.
    fn without_objects(&self, py: Python<'_>, chosen: Read1<'_, bool>) -> PyResult<Self> {
        let chosen = chosen.as_slice()?;
        run::long(py, None, |progress| self.0.without_objects(chosen, progress)).map(Self)
    }

    /// Creates the scene of the chosen triangles; `chosen` has a flag for each triangle.
    fn subset_of_triangles(&self, py: Python<'_>, chosen: Read1<'_, bool>) -> PyResult<Self> {
        let chosen = chosen.as_slice()?;
        run::long(py, None, |progress| self.0.subset_of_triangles(chosen, progress)).map(Self)
    }

    /// Creates the scene of the triangles that touch the world box between two corners; also returns the indices of the
    /// moving instances that remain, None if all do.
    fn query<'py>(&self, py: Python<'py>, least: [f64; 3], greatest: [f64; 3], builds: bool) -> PyResult<Part<'py>> {
        let (least, greatest) = (DVec3::from_array(least), DVec3::from_array(greatest));
        let part = run::long(py, None, |progress| self.0.query(least, greatest, builds, progress))?;
        Ok((Self(part.scene), part.moving.map(|indices| PyArray1::from_vec(py, indices))))
    }

    /// Whether triangles may touch the world box between two corners; False is certain. Builds the trees.
    fn touches(&self, py: Python<'_>, least: [f64; 3], greatest: [f64; 3]) -> PyResult<bool> {
        let (least, greatest) = (DVec3::from_array(least), DVec3::from_array(greatest));
        run::long(py, None, |progress| {
            self.0.build(progress)?;
            Ok(touches(&self.0, &Aabb::from_f64_inside(least - self.0.origin, greatest - self.0.origin)))
        })
    }

    /// Joins scenes in the frame of the first; `objects` has the new numbers of each scene's objects.
    #[staticmethod]
    fn join(py: Python<'_>, scenes: Vec<PyRef<'_, Self>>, objects: Vec<Read1<'_, i32>>) -> PyResult<Self> {
        let numbers = objects.iter().map(|row| Ok(row.as_slice()?)).collect::<PyResult<Vec<&[i32]>>>()?;
        let parts = scenes.iter().map(|scene| &scene.0).zip(numbers);
        let parts: Vec<scene::Joined<'_>> = parts.map(|(scene, objects)| scene::Joined { scene, objects }).collect();
        run::long(py, None, |progress| scene::Scene::join(&parts, progress)).map(Self)
    }

    /// Placements of the moving instances (M, 3, 4), relative to the origin.
    fn moving_placements<'py>(&self, py: Python<'py>) -> PyResult<Array3<'py, f64>> {
        rows_of(py, self.0.moving.instances())
    }

    /// Objects of the moving instances.
    fn moving_objects<'py>(&self, py: Python<'py>) -> Array1<'py, i32> {
        PyArray1::from_iter(py, self.0.moving.instances().iter().map(|instance| instance.object.unwrap_or(-1)))
    }

    #[getter]
    fn origin(&self) -> (f64, f64, f64) {
        self.0.origin.into()
    }

    #[getter]
    fn material_count(&self) -> usize {
        self.0.materials.len()
    }

    #[getter]
    fn texture_count(&self) -> usize {
        self.0.textures.len()
    }

    /// Number of faces without area, counting each mesh once.
    fn degenerate_count(&self, py: Python<'_>) -> PyResult<usize> {
        run::long(py, None, |progress| self.0.degenerate_count(progress))
    }

    /// Identities of the instances' meshes, in order; equal numbers mean a shared mesh.
    fn mesh_ids<'py>(&self, py: Python<'py>) -> Array1<'py, u64> {
        let ids: Vec<u64> = self.0.instances().map(|instance| Arc::as_ptr(&instance.mesh).addr() as u64).collect();
        PyArray1::from_vec(py, ids)
    }

    /// Builds all trees now instead of at the first ray.
    #[pyo3(signature = (report=None))]
    fn build(&self, py: Python<'_>, report: Report) -> PyResult<()> {
        run::long(py, report, |progress| self.0.build(progress))
    }

    /// Memory of instances, meshes, trees and textures, bytes.
    fn bytes(&self) -> usize {
        self.0.bytes()
    }

    #[getter]
    fn triangle_count(&self) -> i64 {
        self.0.triangle_count()
    }

    #[getter]
    fn standing_triangle_count(&self) -> i64 {
        self.0.standing.triangle_count()
    }

    #[getter]
    fn instance_count(&self) -> usize {
        self.0.instance_count()
    }

    /// Number of triangles before each instance, then the total.
    fn triangle_offsets<'py>(&self, py: Python<'py>) -> Array1<'py, i64> {
        let count = self.0.instance_count() as u32;
        PyArray1::from_iter(py, (0..=count).map(|number| self.0.triangle_offset(number)))
    }

    /// World bounding box (2, 3); (+∞, −∞) for an empty scene.
    fn bounds<'py>(&self, py: Python<'py>) -> PyResult<Array2<'py, f64>> {
        let bounds = run::short(py, || Ok(self.0.bounds()))?;
        let world = |corner: glam::Vec3| (corner.as_dvec3() + self.0.origin).to_array().to_vec();
        Ok(PyArray2::from_vec2(py, &[world(bounds.min), world(bounds.max)])?)
    }

    /// Vertices of all triangles (T, 3, 3), relative to the origin.
    fn triangles<'py>(&self, py: Python<'py>) -> PyResult<Array3<'py, f32>> {
        let flat = run::long(py, None, |progress| self.0.triangles(progress))?;
        PyArray1::from_vec(py, flat).reshape([self.0.triangle_count() as usize, 3, 3])
    }
}

pub fn texture(array: &Bound<'_, PyArrayDyn<u8>>) -> PyResult<Texture> {
    let (height, width, _): (u32, u32, u32) = array.getattr("shape")?.extract()?;
    let rows = array.call_method1("reshape", (-1, 4))?;
    let texels: Buffer<[u8; 4]> = buffer(rows.cast::<PyArrayDyn<u8>>()?)?;
    Texture::new(width, height, texels).map_err(to_python)
}
