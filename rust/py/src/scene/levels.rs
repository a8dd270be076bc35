//! Bindings of `scene::levels`, and copies of a scene's parts as arrays, for writing to files.

use std::sync::Arc;

use nearfar_core::base::{Buffer, FaceMap};
use nearfar_core::scene::{self, Alpha, Instance, LevelMeshes};
use numpy::{Element, PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::mesh::{Mesh, affines, rows_of, standing_and_moving};
use super::scene::Scene;
use crate::convert::{Array1, Array2, Array3, Read1, Read3, run};

/// Placements (K, 3, 4) and objects (K,).
type Placed<'py> = (Array3<'py, f64>, Array1<'py, i32>);

/// Meshes of the models' levels, shared by all scenes that show them.
#[pyclass(frozen, module = "nearfar._core")]
pub struct Levels(Vec<LevelMeshes>);

#[pymethods]
impl Levels {
    /// `models` holds for each model one mesh per level, level 0 first.
    #[new]
    fn new(models: Vec<Vec<PyRef<'_, Mesh>>>) -> Self {
        let shared = |mesh: &PyRef<'_, Mesh>| Arc::clone(&mesh.0);
        Self(models.iter().map(|levels| levels.iter().map(shared).collect()).collect())
    }

    /// Creates the scene with each object at a level of a model; `models` and `chosen` have the numbers of the model
    /// and the level for each object, −1 for none.
    fn choose(&self, py: Python<'_>, scene: &Scene, models: Read1<'_, i32>, chosen: Read1<'_, i32>) -> PyResult<Scene> {
        let (models, chosen) = (models.as_slice()?, chosen.as_slice()?);
        run::short(py, || scene.0.at_levels(&self.0, models, chosen)).map(Scene)
    }
}

/// Adds the materials and textures of other scenes to a scene; also returns each of the other scenes as one mesh
/// that uses them.
#[pyfunction]
pub fn with_surfaces(py: Python<'_>, scene: &Scene, others: Vec<PyRef<'_, Scene>>) -> PyResult<(Scene, Vec<Mesh>)> {
    let others: Vec<&scene::Scene> = others.iter().map(|other| &other.0).collect();
    let (joined, meshes) = run::long(py, None, |progress| scene.0.with_surfaces(&others, progress))?;
    Ok((Scene(joined), meshes.into_iter().map(|mesh| Mesh(Arc::new(mesh))).collect()))
}

/// Adds instances to a scene, the first `standing_count` of them static; `Scene` describes the arrays.
#[pyfunction]
pub fn with_instances(
    py: Python<'_>,
    scene: &Scene,
    meshes: Vec<PyRef<'_, Mesh>>,
    placements: Read3<'_, f64>,
    objects: Read1<'_, i32>,
    standing_count: usize,
) -> PyResult<Scene> {
    let meshes = meshes.iter().map(|mesh| Arc::clone(&mesh.0)).collect();
    let (placements, objects) = (affines(&placements), objects.as_array());
    run::short(py, || {
        let (standing, moving) = standing_and_moving(meshes, placements, objects, standing_count)?;
        Ok(scene.0.with_instances(standing, moving))
    })
    .map(Scene)
}

/// Placements (K, 3, 4) and objects (K,) of the instances of chosen objects; `chosen` has a flag for each object.
#[pyfunction]
pub fn placements_of<'py>(py: Python<'py>, scene: &Scene, chosen: Read1<'py, bool>) -> PyResult<Placed<'py>> {
    let chosen = chosen.as_slice()?;
    let (objects, instances): (Vec<i32>, Vec<&scene::Instance>) = scene.0.instances_of(chosen).unzip();
    Ok((rows_of(py, instances)?, PyArray1::from_vec(py, objects)))
}

/// Arguments of `Scene`, by name.
#[pyfunction]
pub fn scene_parts<'py>(py: Python<'py>, scene: &Scene) -> PyResult<Bound<'py, PyDict>> {
    let scene = &scene.0;
    let instances: Vec<&Instance> = scene.instances().collect();
    let meshes = instances.iter().map(|instance| Py::new(py, Mesh(Arc::clone(&instance.mesh))));
    let colors: Vec<[f32; 4]> = scene.materials.iter().map(|material| material.base_color).collect();
    let link = |texture: Option<u32>| texture.map_or(-1, |number| number as i32);
    let cutoff = |alpha| if let Alpha::Mask { cutoff } = alpha { cutoff } else { f32::NAN };
    let texture = |texture: &nearfar_core::scene::Texture| {
        let texels = PyArray1::from_slice(py, texture.texels.as_flattened());
        texels.reshape([texture.height as usize, texture.width as usize, 4])
    };
    let parts = PyDict::new(py);
    parts.set_item("origin", scene.origin.to_array())?;
    parts.set_item("meshes", meshes.collect::<PyResult<Vec<_>>>()?)?;
    parts.set_item("placements", rows_of(py, instances.iter().copied())?)?;
    parts.set_item("objects", PyArray1::from_iter(py, instances.iter().map(|i| i.object.unwrap_or(-1))))?;
    parts.set_item("standing_count", scene.standing.instances().len())?;
    parts.set_item("material_colors", rows(py, &colors)?)?;
    parts.set_item("material_textures", PyArray1::from_iter(py, scene.materials.iter().map(|m| link(m.texture))))?;
    parts.set_item("material_cutoffs", PyArray1::from_iter(py, scene.materials.iter().map(|m| cutoff(m.alpha))))?;
    let emissions: Vec<[f32; 3]> = scene.materials.iter().map(|material| material.emission).collect();
    let maps = scene.materials.iter().map(|m| link(m.emission_texture));
    parts.set_item("material_emissions", rows(py, &emissions)?)?;
    parts.set_item("material_emission_textures", PyArray1::from_iter(py, maps))?;
    parts.set_item("material_unlit", PyArray1::from_iter(py, scene.materials.iter().map(|m| m.unlit)))?;
    parts.set_item("material_tags", PyArray1::from_iter(py, scene.materials.iter().map(|m| m.tag)))?;
    let textures: Vec<Array3<'py, u8>> = scene.textures.iter().map(texture).collect::<PyResult<_>>()?;
    parts.set_item("textures", textures)?;
    Ok(parts)
}

/// Arguments of `Mesh`, by name; objects and materials have one number per face.
#[pyfunction]
pub fn mesh_parts<'py>(py: Python<'py>, mesh: &Mesh) -> PyResult<Bound<'py, PyDict>> {
    let mesh = &mesh.0;
    let parts = PyDict::new(py);
    parts.set_item("positions", rows(py, &mesh.positions)?)?;
    parts.set_item("faces", rows(py, &mesh.faces)?)?;
    parts.set_item("uvs", mesh.uvs.as_ref().map(|uvs: &Buffer<[f32; 2]>| rows(py, uvs)).transpose()?)?;
    parts.set_item("colors", mesh.colors.as_ref().map(|colors| rows(py, colors)).transpose()?)?;
    parts.set_item("normals", mesh.normals.as_ref().map(|normals| rows(py, normals)).transpose()?)?;
    parts.set_item("objects", per_face(py, &mesh.objects, mesh.faces.len()))?;
    parts.set_item("materials", per_face(py, &mesh.materials, mesh.faces.len()))?;
    Ok(parts)
}

fn rows<'py, T: Element, const N: usize>(py: Python<'py>, values: &[[T; N]]) -> PyResult<Array2<'py, T>> {
    PyArray1::from_slice(py, values.as_flattened()).reshape([values.len(), N])
}

fn per_face<'py>(py: Python<'py>, map: &FaceMap, faces: usize) -> Array1<'py, i32> {
    PyArray1::from_iter(py, (0..faces as u32).map(|face| map.get(face)))
}
