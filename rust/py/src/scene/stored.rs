//! Bindings of `scene::stored`.

use std::sync::Arc;

use nearfar_core::base::Error;
use nearfar_core::scene::stored::{self, Attributes, ComponentType, Rows, StoredFaces, StoredPart};
use numpy::ndarray::{self, ArrayView1};
use numpy::{IntoPyArray, PyArrayDyn};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::mesh::{Mesh, affines, check_lengths};
use crate::convert::{Array1, Array3, Read1, Read2, Read3, flat_buffer, run, to_python};

/// Meshes in the bytes of files.
#[pyclass(frozen, module = "nearfar._core")]
pub struct StoredMeshes(Arc<stored::StoredMeshes>);

/// Parses a table row: block, first byte, step, count, width, glTF component type, whether values are normalised.
fn parse_rows(row: ArrayView1<'_, i64>) -> PyResult<Rows> {
    let component = match row[5] {
        5120 => ComponentType::I8,
        5121 => ComponentType::U8,
        5122 => ComponentType::I16,
        5123 => ComponentType::U16,
        5125 => ComponentType::U32,
        5126 => ComponentType::F32,
        other => return Err(PyValueError::new_err(format!("rows: expected a component type of glTF, got {other}"))),
    };
    let unsigned = |column: usize| {
        usize::try_from(row[column]).map_err(|_| PyValueError::new_err("rows: expected numbers of at least 0"))
    };
    Ok(Rows {
        block: unsigned(0)?,
        start: unsigned(1)?,
        step: unsigned(2)?,
        count: unsigned(3)?,
        width: unsigned(4)?,
        component,
        is_fraction: row[6] != 0,
    })
}

/// Parses a table row: mesh, positions, normals, texture coordinates, colours, indices (−1 for none) and material.
fn parse_faces(row: ArrayView1<'_, i64>) -> StoredFaces {
    let number = |column: usize| usize::try_from(row[column]).ok();
    StoredFaces {
        mesh: number(0).unwrap_or(usize::MAX),
        attributes: Attributes {
            positions: number(1).unwrap_or(usize::MAX),
            normals: number(2),
            uvs: number(3),
            colors: number(4),
        },
        corners: number(5),
        material: row[6] as i32,
    }
}

fn box_array<'py>(py: Python<'py>, boxes: &[[[f64; 3]; 2]]) -> Array3<'py, f64> {
    ndarray::Array3::from_shape_fn((boxes.len(), 2, 3), |(mesh, side, axis)| boxes[mesh][side][axis]).into_pyarray(py)
}

impl StoredMeshes {
    /// Converts numbers of meshes; fails unless these are usable.
    fn mesh_indices(&self, meshes: &Read1<'_, i64>) -> PyResult<Vec<usize>> {
        let number =
            |&mesh: &i64| usize::try_from(mesh).ok().filter(|&mesh| mesh < self.0.len() && self.0.is_usable(mesh));
        meshes
            .as_array()
            .iter()
            .map(|mesh| {
                number(mesh).ok_or_else(|| {
                    PyValueError::new_err(format!("meshes: expected numbers of usable meshes, got {mesh}"))
                })
            })
            .collect()
    }

    fn per_mesh<'py, T: numpy::Element>(&self, py: Python<'py>, value: impl Fn(usize) -> T) -> Array1<'py, T> {
        (0..self.0.len()).map(value).collect::<Vec<_>>().into_pyarray(py)
    }
}

#[pymethods]
impl StoredMeshes {
    #[new]
    fn new(
        py: Python<'_>,
        blocks: Vec<Bound<'_, PyArrayDyn<u8>>>,
        rows: Read2<'_, i64>,
        faces: Read2<'_, i64>,
    ) -> PyResult<Self> {
        let blocks = blocks.iter().map(flat_buffer).collect::<PyResult<Vec<_>>>()?;
        let rows = rows.as_array().outer_iter().map(parse_rows).collect::<PyResult<Vec<_>>>()?;
        let faces: Vec<StoredFaces> = faces.as_array().outer_iter().map(parse_faces).collect();
        run::long(py, None, |progress| stored::StoredMeshes::new(blocks, rows, &faces, progress))
            .map(|meshes| Self(Arc::new(meshes)))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self(Arc::new(self.0.scaled(factor)))
    }

    /// Creates the subset of the chosen meshes (K,), which must be usable.
    fn only(&self, chosen: Read1<'_, i64>) -> PyResult<Self> {
        Ok(Self(Arc::new(self.0.only(&self.mesh_indices(&chosen)?))))
    }

    fn with_materials(&self, numbers: Read1<'_, i32>) -> PyResult<Self> {
        self.0.with_materials(numbers.as_slice()?).map(|meshes| Self(Arc::new(meshes))).map_err(to_python)
    }

    /// Whether each mesh is usable (M,).
    fn usable<'py>(&self, py: Python<'py>) -> Array1<'py, bool> {
        self.per_mesh(py, |mesh| self.0.is_usable(mesh))
    }

    /// Numbers of vertices (M,).
    fn vertex_counts<'py>(&self, py: Python<'py>) -> Array1<'py, i64> {
        self.per_mesh(py, |mesh| self.0.vertex_count(mesh) as i64)
    }

    /// Numbers of faces (M,).
    fn face_counts<'py>(&self, py: Python<'py>) -> Array1<'py, i64> {
        self.per_mesh(py, |mesh| self.0.face_count(mesh) as i64)
    }

    /// Bounding boxes of the meshes' vertices (M, 2, 3), each in its own frame.
    fn bounds<'py>(&self, py: Python<'py>) -> Array3<'py, f64> {
        box_array(py, &(0..self.0.len()).map(|mesh| self.0.bounds(mesh)).collect::<Vec<_>>())
    }

    /// Bounding boxes of the meshes' faces (M, 2, 3), each in its own frame.
    fn face_bounds<'py>(&self, py: Python<'py>) -> PyResult<Array3<'py, f64>> {
        let boxes = run::long(py, None, |progress| self.0.face_bounds(progress))?;
        Ok(box_array(py, &boxes))
    }

    /// For each row of `faces`, whether some vertex has an alpha below 1.
    fn see_through<'py>(&self, py: Python<'py>) -> PyResult<Array1<'py, bool>> {
        Ok(run::short(py, || Ok(self.0.see_through()))?.into_pyarray(py))
    }

    /// Returns the chosen meshes (K,) in their own frames.
    fn meshes(&self, py: Python<'_>, chosen: Read1<'_, i64>) -> PyResult<Vec<Mesh>> {
        let chosen = self.mesh_indices(&chosen)?;
        let meshes = run::long(py, None, |progress| self.0.meshes(&chosen, progress))?;
        Ok(meshes.into_iter().map(|mesh| Mesh(Arc::new(mesh))).collect())
    }

    /// Merges chosen meshes (K,), each placed by a row of `placements` (K, 3, 4), as faces of `objects` (K,).
    fn merge(
        &self,
        py: Python<'_>,
        chosen: Read1<'_, i64>,
        placements: Read3<'_, f64>,
        objects: Read1<'_, i32>,
    ) -> PyResult<Mesh> {
        let chosen = self.mesh_indices(&chosen)?;
        let (placements, objects) = (affines(&placements)?, objects.as_array());
        let mesh = run::long(py, None, |progress| -> Result<_, Error> {
            check_lengths(chosen.len(), &placements, objects.len())?;
            let part = |((&mesh, to_scene), &object): ((&usize, _), &i32)| StoredPart { mesh, to_scene, object };
            let parts: Vec<StoredPart> = chosen.iter().zip(placements).zip(objects).map(part).collect();
            self.0.join(&parts, progress)
        })?;
        Ok(Mesh(Arc::new(mesh)))
    }
}
