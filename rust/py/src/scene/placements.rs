//! Instances as arrays: placements (I, 3, 4) object→scene and objects (I,).

use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3};
use nearfar_core::base::{Error, Result};
use nearfar_core::scene::{Instance, Mesh};
use numpy::ndarray::ArrayView1;
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;

use crate::convert::{Array3, Read3};

/// Fails unless there are one placement and one object per mesh.
pub fn same_length(meshes: usize, placements: &[DAffine3], objects: usize) -> Result<()> {
    if meshes != placements.len() || objects != placements.len() {
        return Err(Error::value("placements", "one for each mesh and object", placements.len()));
    }
    Ok(())
}

/// Number of an object; `None` for negative numbers.
pub fn object_index(object: i32) -> Option<i32> {
    (object >= 0).then_some(object)
}

/// Transforms of placements (I, 3, 4).
pub fn affines(placements: &Read3<'_, f64>) -> Vec<DAffine3> {
    placements
        .as_array()
        .outer_iter()
        .map(|m| {
            let column = |j: usize| DVec3::new(m[[0, j]], m[[1, j]], m[[2, j]]);
            DAffine3 { matrix3: DMat3::from_cols(column(0), column(1), column(2)), translation: column(3) }
        })
        .collect()
}

/// Creates placed meshes, the first `standing_count` of them static, the others moving. `placements` are (I, 3, 4)
/// object→scene; object −1 keeps the mesh's own objects.
pub fn standing_and_moving(
    meshes: Vec<Arc<Mesh>>,
    placements: Vec<DAffine3>,
    objects: ArrayView1<'_, i32>,
    standing_count: usize,
) -> Result<(Vec<Instance>, Vec<Instance>)> {
    same_length(meshes.len(), &placements, objects.len())?;
    let placed = meshes.into_iter().zip(placements).zip(objects);
    let placed = placed.map(|((mesh, to_scene), &object)| Instance::new(mesh, to_scene, object_index(object)));
    let mut standing = placed.collect::<Result<Vec<_>>>()?;
    if standing_count > standing.len() {
        return Err(Error::value("standing_count", "at most the number of instances", standing_count));
    }
    let moving = standing.split_off(standing_count);
    Ok((standing, moving))
}

/// Placements (I, 3, 4) of instances.
pub fn rows_of<'py, 'a>(
    py: Python<'py>,
    instances: impl IntoIterator<Item = &'a Instance>,
) -> PyResult<Array3<'py, f64>> {
    let rows = instances.into_iter().flat_map(|instance| {
        let (m, t) = (instance.to_scene.matrix3.transpose(), instance.to_scene.translation);
        [(m.x_axis, t.x), (m.y_axis, t.y), (m.z_axis, t.z)]
    });
    let flat: Vec<f64> = rows.flat_map(|(row, t)| [row.x, row.y, row.z, t]).collect();
    let count = flat.len() / 12;
    PyArray1::from_vec(py, flat).reshape([count, 3, 4])
}
