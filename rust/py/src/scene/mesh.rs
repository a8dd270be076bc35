//! Bindings of `scene::Mesh`.

use std::sync::Arc;

use nearfar_core::base::FaceMap;
use nearfar_core::scene::{self, PlacedMesh};
use numpy::{PyArray2, PyArrayDyn};
use pyo3::prelude::*;

use super::placements::{affines, object_index, same_length};
use crate::convert::{Array2, Read1, Read3, buffer, flat_buffer, one_of, run};

/// Triangles with their attributes, in the memory of the arrays.
#[pyclass(frozen, module = "nearfar._core")]
pub struct Mesh(pub Arc<scene::Mesh>);

one_of! {
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
            same_length(meshes.len(), &placements, objects.len())?;
            let placed = meshes.into_iter().zip(placements).zip(objects.iter().copied().map(object_index));
            let parts: Vec<_> =
                placed.map(|((mesh, to_scene), object)| PlacedMesh { mesh, to_scene, object }).collect();
            scene::merge(&parts, progress)
        })
        .map(|mesh| Self(Arc::new(mesh)))
    }

    /// The mesh with inverted faces, sharing the vertices.
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
