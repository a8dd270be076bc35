//! Arrays as bytes, with the descriptions that glTF readers need.

use bytemuck::Pod;
use meshopt::{decode_filter_oct, encode_index_buffer, encode_vertex_buffer_level};

use super::gather::Primitive;
use super::grid::Grid;
use super::statistics::Kind;
use crate::base::{Error, Result};

const BYTE: u32 = 5120;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const FLOAT: u32 = 5126;

/// Compression level: meshoptimizer's default, used only by version 1 of the codec.
const CODEC_LEVEL: i32 = 2;
/// `EXT_meshopt_compression` requires version 0.
const CODEC_VERSION: Option<i32> = Some(0);

/// Maximum number of vertices for 16-bit corners: index 65535 restarts strips in some graphics APIs.
const MAX_SHORT: usize = u16::MAX as usize;

/// Semantic and type of an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Attribute {
    Position,
    /// Bytes padded to four, which `KHR_mesh_quantization` allows.
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

/// Type of an accessor.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    pub component: u32,
    pub shape: &'static str,
    pub normalized: bool,
    /// Bytes per row.
    pub stride: usize,
}

impl Attribute {
    /// Returns the attribute name in a primitive or an instancing extension; empty for corners.
    pub fn name(self) -> &'static str {
        match self {
            Self::Position => "POSITION",
            Self::ShortNormal | Self::Normal => "NORMAL",
            Self::Uv => "TEXCOORD_0",
            Self::Color => "COLOR_0",
            Self::ShortCorners | Self::Corners => "",
            Self::Translation => "TRANSLATION",
            Self::Rotation => "ROTATION",
            Self::Scale => "SCALE",
        }
    }

    pub fn kind(self) -> Kind {
        match self {
            Self::Position => Kind::Positions,
            Self::ShortNormal | Self::Normal => Kind::Normals,
            Self::Uv => Kind::Uvs,
            Self::Color => Kind::Colors,
            Self::ShortCorners | Self::Corners => Kind::Corners,
            Self::Translation | Self::Rotation | Self::Scale => Kind::Placements,
        }
    }

    pub fn layout(self) -> Layout {
        let (component, shape, normalized, stride) = match self {
            Self::Position | Self::Normal | Self::Translation | Self::Scale => (FLOAT, "VEC3", false, 12),
            Self::ShortNormal => (BYTE, "VEC3", true, 4),
            Self::Uv => (FLOAT, "VEC2", false, 8),
            Self::Color => (UNSIGNED_SHORT, "VEC4", true, 8),
            Self::ShortCorners => (UNSIGNED_SHORT, "SCALAR", false, 2),
            Self::Corners => (UNSIGNED_INT, "SCALAR", false, 4),
            Self::Rotation => (FLOAT, "VEC4", false, 16),
        };
        Layout { component, shape, normalized, stride }
    }

    /// Returns the filter with which the array is compressed.
    pub fn filter(self) -> &'static str {
        match self {
            Self::Position | Self::Uv => "EXPONENTIAL",
            Self::ShortNormal => "OCTAHEDRAL",
            _ => "NONE",
        }
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
    /// Encodes rows of numbers.
    pub fn rows<T: Pod>(attribute: Attribute, rows: &[T], compressed: bool) -> Result<Self> {
        let bytes = if compressed {
            encode_vertex_buffer_level(rows, CODEC_LEVEL, CODEC_VERSION).map_err(refused)?
        } else {
            bytemuck::cast_slice(rows).to_vec()
        };
        Ok(Self { attribute, count: rows.len(), bytes, extent: None, error: 0.0 })
    }

    /// Encodes corners of triangles between `vertex_count` vertices.
    fn corners(corners: &[u32], vertex_count: usize, compressed: bool) -> Result<Self> {
        let short = vertex_count <= MAX_SHORT;
        let bytes = match (compressed, short) {
            (true, _) => encode_index_buffer(corners, vertex_count).map_err(refused)?,
            (false, true) => corners.iter().flat_map(|&corner| (corner as u16).to_le_bytes()).collect(),
            (false, false) => bytemuck::cast_slice(corners).to_vec(),
        };
        let attribute = if short { Attribute::ShortCorners } else { Attribute::Corners };
        Ok(Self { attribute, count: corners.len(), bytes, extent: None, error: 0.0 })
    }

    /// Returns the bytes of the array without compression.
    pub fn raw_bytes(&self) -> usize {
        self.count * self.attribute.layout().stride
    }
}

/// Encodes the arrays of a primitive; the last one holds the corners.
pub(super) fn streams(primitive: &Primitive, corners: &[u32], compressed: bool) -> Result<Vec<Stream>> {
    let mut streams = vec![points(Attribute::Position, &primitive.positions, primitive.grid, compressed)?];
    let extent = extent(&primitive.positions);
    streams[0].extent = Some(extent.map(|corner| corner.map(|steps| primitive.grid.value(steps))));
    streams[0].error = extent.as_flattened().iter().map(|&steps| primitive.grid.error(steps)).fold(0.0, f64::max);
    if let Some(normals) = &primitive.normals {
        streams.push(match compressed {
            true => Stream::rows(Attribute::ShortNormal, normals, true)?,
            false => Stream::rows(Attribute::Normal, &unit_normals(normals.clone()), false)?,
        });
    }
    if let Some((uvs, grid)) = &primitive.uvs {
        streams.push(points(Attribute::Uv, uvs, *grid, compressed)?);
    }
    if let Some(colors) = &primitive.colors {
        streams.push(Stream::rows(Attribute::Color, colors, compressed)?);
    }
    streams.push(Stream::corners(corners, primitive.positions.len(), compressed)?);
    Ok(streams)
}

/// Encodes points of a grid.
fn points<const N: usize>(attribute: Attribute, points: &[[i32; N]], grid: Grid, compressed: bool) -> Result<Stream>
where
    [u32; N]: Pod,
    [f32; N]: Pod,
{
    if compressed {
        let packed: Vec<[u32; N]> = points.iter().map(|point| point.map(|number| grid.packed(number))).collect();
        return Stream::rows(attribute, &packed, true);
    }
    let values: Vec<[f32; N]> = points.iter().map(|point| point.map(|number| grid.value(number))).collect();
    Stream::rows(attribute, &values, false)
}

fn extent(points: &[[i32; 3]]) -> [[i32; 3]; 2] {
    let mut extent = [[i32::MAX; 3], [i32::MIN; 3]];
    for point in points {
        for axis in 0..3 {
            extent[0][axis] = extent[0][axis].min(point[axis]);
            extent[1][axis] = extent[1][axis].max(point[axis]);
        }
    }
    extent
}

/// Returns the unit normals that the OCTAHEDRAL filter decodes from its coordinates.
fn unit_normals(mut coordinates: Vec<[i8; 4]>) -> Vec<[f32; 3]> {
    decode_filter_oct(&mut coordinates);
    let unit =
        |&[x, y, z, _]: &[i8; 4]| glam::Vec3::from_array([x, y, z].map(f32::from)).normalize_or_zero().to_array();
    coordinates.iter().map(unit).collect()
}

fn refused(error: meshopt::Error) -> Error {
    Error::value("mesh", "arrays that meshoptimizer can encode", error)
}
