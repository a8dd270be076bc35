//! Stored meshes: sets of vertices and of faces, as rows of numbers in blocks of bytes.

use std::collections::HashMap;

use super::rows::{ComponentType, Rows, Table};
use crate::base::{Aabb, Buffer, Error, Progress, Result, by_number, ensure};

/// Row numbers of a vertex set's attributes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Attributes {
    /// Positions, three numbers.
    pub positions: usize,
    /// Outward normals, three numbers.
    pub normals: Option<usize>,
    /// Texture coordinates, two numbers, v downwards.
    pub uvs: Option<usize>,
    /// Linear colours, three or four components; integers are always normalised.
    pub colors: Option<usize>,
}

/// Triangles of one material.
#[derive(Clone, Copy, Debug)]
pub struct StoredFaces {
    /// Mesh of these faces; mesh numbers ascend.
    pub mesh: usize,
    /// Attributes of their vertices.
    pub attributes: Attributes,
    /// Rows of the corners' vertex numbers; `None` if every three successive vertices form a triangle.
    pub corners: Option<usize>,
    /// Material of all faces.
    pub material: i32,
}

/// Vertices shared by faces of one mesh.
#[derive(Clone, Debug)]
pub(super) struct VertexSet {
    pub attributes: Attributes,
    /// First vertex that is used.
    pub first: usize,
    /// Number of vertices that are used.
    pub count: usize,
    /// Whether other sets have the same positions. If so, only the range of vertices that faces use is read.
    pub is_shared: bool,
}

/// Triangles between the vertices of a set.
#[derive(Clone, Debug)]
pub(super) struct FaceSet {
    /// Index of the vertex set in the mesh.
    pub set: usize,
    pub corners: Option<usize>,
    pub count: usize,
    pub material: i32,
}

#[derive(Clone, Debug)]
pub(super) struct StoredMesh {
    pub vertices: Vec<VertexSet>,
    pub faces: Vec<FaceSet>,
    /// Whether the mesh is usable; see `StoredMeshes::is_usable`.
    pub is_usable: bool,
    /// Box of the vertices.
    pub bounds: Aabb,
}

/// Meshes stored in the bytes of files.
#[derive(Clone, Debug)]
pub struct StoredMeshes {
    pub(super) blocks: Vec<Buffer<u8>>,
    pub(super) rows: Vec<Rows>,
    pub(super) meshes: Vec<StoredMesh>,
    /// Scale factor of all coordinates.
    pub(super) scale: f64,
}

impl StoredMeshes {
    /// Creates meshes. Checks that all rows lie within their blocks and are consistent, and finds which meshes are usable.
    pub fn new(blocks: Vec<Buffer<u8>>, rows: Vec<Rows>, faces: &[StoredFaces], progress: &Progress) -> Result<Self> {
        for (number, row) in rows.iter().enumerate() {
            let length = blocks.get(row.block).map(|block| block.len());
            let fits = row.step >= row.size() && row.end().zip(length).is_some_and(|(end, length)| end <= length);
            let got = || format!("{} of {} bytes from byte {} of block {}", row.count, row.step, row.start, row.block);
            ensure!(fits, "rows", "rows within their blocks", format!("{} at index {number}", got()));
        }
        let mut stored = Self { blocks, rows, meshes: Vec::new(), scale: 1.0 };
        let mut sets = HashMap::new();
        for part in faces {
            stored.add(part, &mut sets)?;
        }
        stored.find_shared();
        stored.find_usable(progress)?;
        Ok(stored)
    }

    /// Returns the meshes with all coordinates scaled in float64.
    pub fn scaled(&self, factor: f64) -> Self {
        Self { scale: self.scale * factor, ..self.clone() }
    }

    /// Returns a subset of the meshes; ranges of shared vertices do not change.
    pub fn only(&self, meshes: &[usize]) -> Self {
        let (blocks, rows) = (self.blocks.clone(), self.rows.clone());
        Self { blocks, rows, meshes: meshes.iter().map(|&mesh| self.meshes[mesh].clone()).collect(), scale: self.scale }
    }

    /// Returns the meshes with `numbers[m]` in place of each material m.
    pub fn with_materials(&self, numbers: &[i32]) -> Result<Self> {
        let mut changed = self.clone();
        for faces in changed.meshes.iter_mut().flat_map(|mesh| &mut mesh.faces) {
            let missing = || Error::value("numbers", "one for each material", numbers.len());
            faces.material = *by_number(numbers, faces.material).ok_or_else(missing)?;
        }
        Ok(changed)
    }

    /// Adds faces to their mesh; `sets` maps attributes to vertex sets of the last mesh.
    fn add(&mut self, part: &StoredFaces, sets: &mut HashMap<Attributes, usize>) -> Result<()> {
        let count = self.check_faces(part)?;
        let is_next = part.mesh.saturating_add(1) >= self.meshes.len() && part.mesh <= self.meshes.len();
        ensure!(is_next, "faces", "meshes that ascend without gaps", part.mesh);
        if part.mesh == self.meshes.len() {
            let (vertices, faces) = (Vec::new(), Vec::new());
            self.meshes.push(StoredMesh { vertices, faces, is_usable: false, bounds: Aabb::EMPTY });
            sets.clear();
        }
        let vertex_count = self.rows[part.attributes.positions].count;
        let mesh = &mut self.meshes[part.mesh];
        let set = *sets.entry(part.attributes).or_insert_with(|| {
            let attributes = part.attributes;
            mesh.vertices.push(VertexSet { attributes, first: 0, count: vertex_count, is_shared: false });
            mesh.vertices.len() - 1
        });
        mesh.faces.push(FaceSet { set, corners: part.corners, count, material: part.material });
        Ok(())
    }

    /// Returns the number of faces, after checking that rows have the right widths and types.
    fn check_faces(&self, part: &StoredFaces) -> Result<usize> {
        let wrong = |expected: &'static str| Error::value("faces", expected, format!("others in mesh {}", part.mesh));
        let attributes = &part.attributes;
        let row = |number: usize| self.rows.get(number).ok_or_else(|| wrong("numbers of rows"));
        let vertex_count = row(attributes.positions)?.count;
        for (number, widths) in [
            (Some(attributes.positions), 3..=3),
            (attributes.normals, 3..=3),
            (attributes.uvs, 2..=2),
            (attributes.colors, 3..=4),
        ] {
            if let Some(rows) = number.map(row).transpose()?
                && (!widths.contains(&rows.width) || rows.count != vertex_count)
            {
                return Err(wrong("one row of the right width for each vertex"));
            }
        }
        let corners = match part.corners.map(row).transpose()? {
            None => vertex_count,
            Some(rows) => {
                let is_whole = matches!(rows.component, ComponentType::U8 | ComponentType::U16 | ComponentType::U32);
                if !is_whole || rows.width != 1 || rows.step != rows.size() {
                    return Err(wrong("corners as whole numbers without gaps"));
                }
                rows.count
            }
        };
        if corners.is_multiple_of(3) { Ok(corners / 3) } else { Err(wrong("three corners for each face")) }
    }

    /// Marks vertex sets that share their positions with other sets.
    fn find_shared(&mut self) {
        let mut uses: HashMap<usize, usize> = HashMap::new();
        for set in self.meshes.iter().flat_map(|mesh| &mesh.vertices) {
            *uses.entry(set.attributes.positions).or_default() += 1;
        }
        for set in self.meshes.iter_mut().flat_map(|mesh| &mut mesh.vertices) {
            set.is_shared = uses[&set.attributes.positions] > 1;
        }
    }

    /// Returns the number of meshes.
    pub fn len(&self) -> usize {
        self.meshes.len()
    }

    /// Returns whether there are no meshes.
    pub fn is_empty(&self) -> bool {
        self.meshes.is_empty()
    }

    /// Returns whether a mesh is usable: its coordinates are finite, all corners name vertices, and the vertices that
    /// it shares with other meshes lie close together in the file.
    pub fn is_usable(&self, mesh: usize) -> bool {
        self.meshes[mesh].is_usable
    }

    /// Returns the number of a mesh's vertices.
    pub fn vertex_count(&self, mesh: usize) -> usize {
        self.meshes[mesh].vertices.iter().map(|set| set.count).sum()
    }

    /// Returns the number of a mesh's faces.
    pub fn face_count(&self, mesh: usize) -> usize {
        self.meshes[mesh].faces.iter().map(|faces| faces.count).sum()
    }

    /// Returns the box of the vertices of a usable mesh, in its own frame.
    pub fn bounds(&self, mesh: usize) -> [[f64; 3]; 2] {
        self.sides(&self.meshes[mesh].bounds)
    }

    pub(super) fn sides(&self, bounds: &Aabb) -> [[f64; 3]; 2] {
        [bounds.min, bounds.max].map(|corner| (corner.as_dvec3() * self.scale).to_array())
    }

    pub(super) fn table(&self, rows: usize) -> Table<'_> {
        Table::new(self.rows[rows], &self.blocks)
    }
}
