//! Bindings of `scene::levels`.

use std::sync::Arc;

use nearfar_core::scene::{self, LevelMeshes};
use numpy::PyArray1;
use pyo3::prelude::*;

use super::mesh::Mesh;
use super::placements::{affines, rows_of, standing_and_moving};
use super::scene::Scene;
use crate::convert::{Array1, Array3, Read1, Read3, run};

/// Placements (K, 3, 4) and objects (K,).
type Placed<'py> = (Array3<'py, f64>, Array1<'py, i32>);

/// Meshes of the models' levels, shared by all scenes that show them.
#[pyclass(frozen, module = "nearfar._core")]
pub struct Levels(LevelMeshes);

#[pymethods]
impl Levels {
    /// `models` holds for each model one mesh per level, level 0 first.
    #[new]
    fn new(models: Vec<Vec<PyRef<'_, Mesh>>>) -> Self {
        let shared = |mesh: &PyRef<'_, Mesh>| Arc::clone(&mesh.0);
        Self(LevelMeshes(models.iter().map(|levels| levels.iter().map(shared).collect()).collect()))
    }

    /// Creates the scene with its objects at levels: `models` and `chosen` have one number per object, −1 for none.
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
