//! Sizes, counts and errors of encoded geometry.

/// Kind of the bytes of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Positions of vertices.
    Positions,
    /// Normals of vertices.
    Normals,
    /// Texture coordinates of vertices.
    Uvs,
    /// Colours of vertices.
    Colors,
    /// Corners of faces.
    Corners,
    /// Placements of shared meshes.
    Placements,
    /// JSON document, headers and padding of the file.
    Document,
}

impl Kind {
    /// All kinds with their public names.
    pub const ALL: [(Self, &str); 7] = [
        (Self::Positions, "positions"),
        (Self::Normals, "normals"),
        (Self::Uvs, "uvs"),
        (Self::Colors, "colors"),
        (Self::Corners, "corners"),
        (Self::Placements, "placements"),
        (Self::Document, "document"),
    ];
}

/// Sizes, counts and errors of encoded geometry.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statistics {
    pub(super) bytes: [u64; Kind::ALL.len()],
    /// Bytes of the same arrays without compression.
    pub raw_bytes: u64,
    /// Triangles stored.
    pub triangles: u64,
    /// Vertices stored.
    pub vertices: u64,
    /// Triangles drawn; those of a shared mesh count once for each placement.
    pub drawn: u64,
    /// Triangles that are left out because they have no area after rounding.
    pub dropped: u64,
    /// Maximum error of a position per axis, metres.
    pub position_error: f64,
}

impl Statistics {
    /// Returns the bytes of a kind.
    pub fn bytes(&self, kind: Kind) -> u64 {
        self.bytes[kind as usize]
    }

    pub(super) fn count(&mut self, kind: Kind, bytes: usize) {
        self.bytes[kind as usize] += bytes as u64;
    }

    /// Adds the statistics of other geometry.
    pub(super) fn add(&mut self, other: &Self) {
        self.bytes.iter_mut().zip(other.bytes).for_each(|(sum, bytes)| *sum += bytes);
        self.raw_bytes += other.raw_bytes;
        self.triangles += other.triangles;
        self.vertices += other.vertices;
        self.drawn += other.drawn;
        self.dropped += other.dropped;
        self.position_error = self.position_error.max(other.position_error);
    }
}
