//! Arrays as bytes, with their descriptions for glTF.

use bytemuck::Pod;
use glam::{IVec3, Vec3};
use meshopt::decode_filter_oct;

use super::gather::Primitive;
use super::grid::Grid;
use super::statistics::{Kind, Statistics};
use crate::base::Result;
use crate::scene::meshopt::{encode_rows, encode_triangles};

const BYTE: u32 = 5120;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const FLOAT: u32 = 5126;

/// Maximum number of vertices for 16-bit corners. Some graphics APIs reserve index 65535 for primitive restart.
const MAX_SHORT: usize = u16::MAX as usize;

/// Semantic and type of an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Attribute {
    Position,
    /// Three bytes, padded to four, as `KHR_mesh_quantization` allows.
    ShortNormal,
    Normal,
    Uv,
    Color,
    ShortCorners,
    Corners,
    Translation,
    Rotation,
    Scale,
}

/// Description of an array in a file.
pub(super) struct Layout {
    /// Attribute name in a primitive or an instancing extension; empty for corners.
    pub name: &'static str,
    pub kind: Kind,
    pub component: u32,
    pub shape: &'static str,
    pub normalized: bool,
    /// Bytes per row.
    pub stride: usize,
    /// Filter of `EXT_meshopt_compression`.
    pub filter: &'static str,
}

impl Attribute {
    pub fn layout(self) -> Layout {
        let (name, kind, component, shape, normalized, stride, filter) = match self {
            Self::Position => ("POSITION", Kind::Positions, FLOAT, "VEC3", false, 12, "EXPONENTIAL"),
            Self::ShortNormal => ("NORMAL", Kind::Normals, BYTE, "VEC3", true, 4, "OCTAHEDRAL"),
            Self::Normal => ("NORMAL", Kind::Normals, FLOAT, "VEC3", false, 12, "NONE"),
            Self::Uv => ("TEXCOORD_0", Kind::Uvs, FLOAT, "VEC2", false, 8, "EXPONENTIAL"),
            Self::Color => ("COLOR_0", Kind::Colors, UNSIGNED_SHORT, "VEC4", true, 8, "NONE"),
            Self::ShortCorners => ("", Kind::Corners, UNSIGNED_SHORT, "SCALAR", false, 2, "NONE"),
            Self::Corners => ("", Kind::Corners, UNSIGNED_INT, "SCALAR", false, 4, "NONE"),
            Self::Translation => ("TRANSLATION", Kind::Placements, FLOAT, "VEC3", false, 12, "NONE"),
            Self::Rotation => ("ROTATION", Kind::Placements, FLOAT, "VEC4", false, 16, "NONE"),
            Self::Scale => ("SCALE", Kind::Placements, FLOAT, "VEC3", false, 12, "NONE"),
        };
        Layout { name, kind, component, shape, normalized, stride, filter }
    }
}

/// An array in a file.
#[derive(Clone, Debug)]
pub(super) struct Stream {
    pub attribute: Attribute,
    /// Number of rows.
    pub count: usize,
    pub bytes: Vec<u8>,
    /// Minimum and maximum position.
    pub extent: Option<[[f32; 3]; 2]>,
    /// Maximum error of a position per axis.
    pub error: f64,
}

impl Stream {
    pub fn rows<T: Pod>(attribute: Attribute, rows: &[T], compressed: bool) -> Result<Self> {
        let bytes = if compressed { encode_rows(rows)? } else { bytemuck::cast_slice(rows).to_vec() };
        Ok(Self { attribute, count: rows.len(), bytes, extent: None, error: 0.0 })
    }

    pub fn add_to(&self, statistics: &mut Statistics) {
        let layout = self.attribute.layout();
        statistics.count(layout.kind, self.bytes.len());
        statistics.raw_bytes += (self.count * layout.stride) as u64;
        statistics.position_error = statistics.position_error.max(self.error);
    }

    /// Encodes the corners of triangles as indices below `vertex_count`.
    fn corners(corners: &[u32], vertex_count: usize, compressed: bool) -> Result<Self> {
        let short = vertex_count <= MAX_SHORT;
        let bytes = match (compressed, short) {
            (true, _) => encode_triangles(corners, vertex_count)?,
            (false, true) => corners.iter().flat_map(|&corner| (corner as u16).to_le_bytes()).collect(),
            (false, false) => bytemuck::cast_slice(corners).to_vec(),
        };
        let attribute = if short { Attribute::ShortCorners } else { Attribute::Corners };
        Ok(Self { attribute, count: corners.len(), bytes, extent: None, error: 0.0 })
    }
}

/// Encodes the arrays of a primitive; the last one holds the corners.
pub(super) fn streams(primitive: &Primitive, compressed: bool) -> Result<Vec<Stream>> {
    let mut streams = vec![points(Attribute::Position, &primitive.positions, primitive.grid, compressed)?];
    let extent = extent(&primitive.positions);
    streams[0].extent = Some(extent.map(|corner| corner.map(|steps| primitive.grid.value(steps))));
    streams[0].error = extent.as_flattened().iter().map(|&steps| primitive.grid.error(steps)).fold(0.0, f64::max);
    if let Some(normals) = &primitive.normals {
        streams.push(if compressed {
            Stream::rows(Attribute::ShortNormal, normals, true)?
        } else {
            Stream::rows(Attribute::Normal, &unit_normals(normals), false)?
        });
    }
    if let Some((uvs, grid)) = &primitive.uvs {
        streams.push(points(Attribute::Uv, uvs, *grid, compressed)?);
    }
    if let Some(colors) = &primitive.colors {
        streams.push(Stream::rows(Attribute::Color, colors, compressed)?);
    }
    streams.push(Stream::corners(primitive.faces.as_flattened(), primitive.positions.len(), compressed)?);
    Ok(streams)
}

fn points<const N: usize>(attribute: Attribute, points: &[[i32; N]], grid: Grid, compressed: bool) -> Result<Stream>
where
    [u32; N]: Pod,
    [f32; N]: Pod,
{
    if compressed {
        let packed: Vec<[u32; N]> = points.iter().map(|point| point.map(|steps| grid.pack(steps))).collect();
        return Stream::rows(attribute, &packed, true);
    }
    let values: Vec<[f32; N]> = points.iter().map(|point| point.map(|steps| grid.value(steps))).collect();
    Stream::rows(attribute, &values, false)
}

fn extent(points: &[[i32; 3]]) -> [[i32; 3]; 2] {
    let points = points.iter().copied().map(IVec3::from_array);
    let extend = |[min, max]: [IVec3; 2], point: IVec3| [min.min(point), max.max(point)];
    points.fold([IVec3::MAX, IVec3::MIN], extend).map(|corner| corner.to_array())
}

/// Decodes octahedral coordinates to unit normals, as the OCTAHEDRAL filter does.
fn unit_normals(coordinates: &[[i8; 4]]) -> Vec<[f32; 3]> {
    let mut coordinates = coordinates.to_vec();
    decode_filter_oct(&mut coordinates);
    let unit = |&[x, y, z, _]: &[i8; 4]| Vec3::from_array([x, y, z].map(f32::from)).normalize_or_zero().to_array();
    coordinates.iter().map(unit).collect()
}
