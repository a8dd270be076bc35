//! Bindings of `scene::Mesh`.

use std::sync::Arc;

use nearfar_core::base::FaceMap;
use nearfar_core::scene::{self, PlacedMesh};
use numpy::{PyArray2, PyArrayDyn, PyReadonlyArray1, PyReadonlyArray3};
use pyo3::prelude::*;

use super::placements::{affines, object_index, same_length};
use crate::convert::arrays::{buffer, flat_buffer};
use crate::convert::one_of::one_of;
use crate::convert::run;

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
    #[expect(clippy::too_many_arguments, reason = "keywords of a Python class")]
    fn new<'py>(
        py: Python<'py>,
        positions: &Bound<'py, PyArrayDyn<f32>>,
        faces: &Bound<'py, PyArrayDyn<u32>>,
        uvs: Option<&Bound<'py, PyArrayDyn<f32>>>,
        colors: Option<&Bound<'py, PyArrayDyn<u8>>>,
        normals: Option<&Bound<'py, PyArrayDyn<f32>>>,
        objects: FaceMapArgument<'py>,
        materials: FaceMapArgument<'py>,
    ) -> PyResult<Self> {
        let (positions, faces) = (buffer(positions)?, buffer(faces)?);
        let (uvs, colors) = (uvs.map(buffer).transpose()?, colors.map(buffer).transpose()?);
        let normals = normals.map(buffer).transpose()?;
        let (objects, materials) = (objects.convert()?, materials.convert()?);
        run::short(py, || scene::Mesh::new(positions, faces, uvs, colors, objects, materials)?.with_normals(normals))
            .map(|mesh| Self(Arc::new(mesh)))
    }

    /// Merges meshes, each placed by a row of `placements` (I, 3, 4); object −1 keeps the mesh's own objects.
    #[staticmethod]
    fn merged<'py>(
        py: Python<'py>,
        meshes: Vec<PyRef<'py, Self>>,
        placements: PyReadonlyArray3<'py, f64>,
        objects: PyReadonlyArray1<'py, i32>,
    ) -> PyResult<Self> {
        let meshes: Vec<Arc<scene::Mesh>> = meshes.iter().map(|mesh| Arc::clone(&mesh.0)).collect();
        let (placements, objects) = (affines(&placements), objects.as_array());
        run::long(py, None, |progress| {
            same_length(meshes.len(), &placements, objects.len())?;
            let part = |((mesh, to_scene), &object): ((_, _), &i32)| PlacedMesh {
                mesh,
                to_scene,
                object: object_index(object),
            };
            let parts: Vec<PlacedMesh> = meshes.into_iter().zip(placements).zip(&objects).map(part).collect();
            scene::merge(&parts, progress)
        })
        .map(|mesh| Self(Arc::new(mesh)))
    }

    /// The mesh with inverted faces, sharing the vertices.
    fn flip_faces(&self, py: Python<'_>) -> PyResult<Self> {
        run::short(py, || Ok(self.0.flipped())).map(|mesh| Self(Arc::new(mesh)))
    }

    /// Bounding box of all faces (2, 3) in the mesh's own frame; (+∞, −∞) without faces.
    fn bounds<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
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
