//! Bindings of `scene::Mesh`, and instances as arrays: placements (I, 3, 4) object→scene and objects (I,).

use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3};
use nearfar_core::base::{Error, FaceMap, Result};
use nearfar_core::scene::{self, Instance, PlacedMesh};
use numpy::ndarray::ArrayView1;
use numpy::{PyArray1, PyArray2, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;

use crate::convert::{Array2, Array3, Read1, Read3, argument_enum, buffer, flat_buffer, run};

/// Triangles with their attributes, which share memory with the NumPy arrays.
#[pyclass(frozen, module = "nearfar._core")]
pub struct Mesh(pub Arc<scene::Mesh>);

argument_enum! {
    enum FaceMapArgument<'py> {
        Uniform(i32),
        PerFace(Bound<'py, PyArrayDyn<i32>>),
        Ranges((Bound<'py, PyArrayDyn<u32>>, Bound<'py, PyArrayDyn<i32>>)),
    }
}

impl FaceMapArgument<'_> {
    fn convert(&self) -> PyResult<FaceMap> {
        Ok(match self {
            Self::Uniform(value) => FaceMap::Uniform(*value),
            Self::PerFace(values) => {
                let values = flat_buffer(values)?;
                let count = values.len();
                FaceMap::PerFace(values).compacted(count)
            }
            Self::Ranges((starts, values)) => {
                FaceMap::Ranges { starts: flat_buffer(starts)?, values: flat_buffer(values)? }
            }
        })
    }
}

#[pymethods]
impl Mesh {
    #[new]
    #[pyo3(signature = (positions, faces, *, uvs=None, colors=None, normals=None, objects, materials))]
    fn new(
        positions: &Bound<'_, PyArrayDyn<f32>>,
        faces: &Bound<'_, PyArrayDyn<u32>>,
        uvs: Option<&Bound<'_, PyArrayDyn<f32>>>,
        colors: Option<&Bound<'_, PyArrayDyn<u8>>>,
        normals: Option<&Bound<'_, PyArrayDyn<f32>>>,
        objects: FaceMapArgument<'_>,
        materials: FaceMapArgument<'_>,
    ) -> PyResult<Self> {
        let (py, positions, faces) = (positions.py(), buffer(positions)?, buffer(faces)?);
        let (uvs, colors) = (uvs.map(buffer).transpose()?, colors.map(buffer).transpose()?);
        let normals = normals.map(buffer).transpose()?;
        let (objects, materials) = (objects.convert()?, materials.convert()?);
        run::short(py, || scene::Mesh::new(positions, faces, uvs, colors, objects, materials)?.with_normals(normals))
            .map(|mesh| Self(Arc::new(mesh)))
    }

    /// Merges meshes, each placed by a row of `placements` (I, 3, 4); object −1 keeps the mesh's own objects.
    #[staticmethod]
    fn merged(
        py: Python<'_>,
        meshes: Vec<PyRef<'_, Self>>,
        placements: Read3<'_, f64>,
        objects: Read1<'_, i32>,
    ) -> PyResult<Self> {
        let meshes: Vec<Arc<scene::Mesh>> = meshes.iter().map(|mesh| Arc::clone(&mesh.0)).collect();
        let (placements, objects) = (affines(&placements), objects.as_array());
        run::long(py, None, |progress| {
            check_lengths(meshes.len(), &placements, objects.len())?;
            let placed = meshes.into_iter().zip(placements).zip(objects.iter().copied().map(object_index));
            let parts: Vec<_> =
                placed.map(|((mesh, to_scene), object)| PlacedMesh { mesh, to_scene, object }).collect();
            scene::merge(&parts, progress)
        })
        .map(|mesh| Self(Arc::new(mesh)))
    }

    /// Creates the mesh with inverted faces, which shares the vertices.
    fn flip_faces(&self, py: Python<'_>) -> PyResult<Self> {
        run::short(py, || Ok(self.0.flipped())).map(|mesh| Self(Arc::new(mesh)))
    }

    /// Bounding box of all faces (2, 3) in the mesh's own frame; (+∞, −∞) without faces.
    fn bounds<'py>(&self, py: Python<'py>) -> PyResult<Array2<'py, f64>> {
        let bounds = self.0.bounds();
        let rows = [bounds.min, bounds.max].map(|corner| corner.as_dvec3().to_array().to_vec());
        Ok(PyArray2::from_vec2(py, &rows)?)
    }

    #[getter]
    fn vertex_count(&self) -> usize {
        self.0.positions.len()
    }

    #[getter]
    fn face_count(&self) -> usize {
        self.0.faces.len()
    }
}

/// Fails unless there is one placement and one object for each mesh.
pub fn check_lengths(meshes: usize, placements: &[DAffine3], objects: usize) -> Result<()> {
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
    meshes: Vec<Arc<scene::Mesh>>,
    placements: Vec<DAffine3>,
    objects: ArrayView1<'_, i32>,
    standing_count: usize,
) -> Result<(Vec<Instance>, Vec<Instance>)> {
    check_lengths(meshes.len(), &placements, objects.len())?;
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
