//! Copies of a scene's parts as arrays, for writing to files.

use std::sync::Arc;

use nearfar_core::base::{Buffer, FaceMap};
use nearfar_core::scene::{Alpha, Instance};
use numpy::{Element, PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::mesh::Mesh;
use super::placements::rows_of;
use super::scene::Scene;
use crate::convert::{Array1, Array2, Array3};

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
