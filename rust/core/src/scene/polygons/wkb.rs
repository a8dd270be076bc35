//! Reader for polygons in well-known binary (WKB) of OGC and ISO, also with the flags of PostGIS.

use super::outlines::check_offsets;
use crate::base::mapped::in_ranges;
use crate::base::memory::{try_extend, try_grow};
use crate::base::{Error, Progress, Result};

/// Rows per task: a few milliseconds.
const ROWS_PER_TASK: usize = 4096;
/// Maximum nesting depth of geometry collections.
const MAX_DEPTH: usize = 16;
/// Flags of PostGIS in the type field.
const HAS_Z: u32 = 1 << 31;
const HAS_M: u32 = 1 << 30;
const HAS_SRID: u32 = 1 << 29;

/// Polygons of many rows, in the layout of `Polygons`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Outlines {
    /// Points, without the closing point of each ring.
    pub points: Vec<[f64; 2]>,
    /// Ring r is `points[rings[r]..rings[r + 1]]`.
    pub rings: Vec<i64>,
    /// Polygon p has the rings `polygons[p]..polygons[p + 1]`.
    pub polygons: Vec<i64>,
    /// Row n has the polygons `rows[n]..rows[n + 1]`.
    pub rows: Vec<i64>,
    /// Number of skipped geometries that are not polygons.
    pub skipped: u64,
}

/// Reads the geometries `bytes[offsets[n]..offsets[n + 1]]`; empty rows have no polygons. Errors name the row.
pub fn read(bytes: &[u8], offsets: &[i64], progress: &Progress) -> Result<Outlines> {
    check_offsets("offsets", offsets, bytes.len())?;
    let count = offsets.len() - 1;
    progress.expect(count as u64);
    let parts = in_ranges(count, ROWS_PER_TASK, |rows| {
        let (mut outlines, size) = (Outlines::default(), rows.len() as u64);
        for row in rows {
            let range = offsets[row] as usize..offsets[row + 1] as usize;
            if !range.is_empty() {
                let mut reader = Reader { bytes_left: &bytes[range], outlines: &mut outlines };
                reader.row().map_err(|flaw| Error::Scene(format!("row {row}: {flaw}")))?;
            }
            outlines.rows.push(outlines.polygons.len() as i64);
        }
        progress.report(size)?;
        Ok(outlines)
    })?;
    concat(&parts)
}

/// Concatenates parts and their offsets. A part's offsets lack the leading 0.
fn concat(parts: &[Outlines]) -> Result<Outlines> {
    let mut all = Outlines { rings: vec![0], polygons: vec![0], rows: vec![0], ..Outlines::default() };
    try_grow(&mut all.points, parts.iter().map(|part| part.points.len()).sum())?;
    for part in parts {
        let [points, rings, polygons] =
            [all.points.len(), all.rings.len() - 1, all.polygons.len() - 1].map(|count| count as i64);
        all.points.extend_from_slice(&part.points);
        try_extend(&mut all.rings, part.rings.iter().map(|end| points + end))?;
        try_extend(&mut all.polygons, part.polygons.iter().map(|end| rings + end))?;
        try_extend(&mut all.rows, part.rows.iter().map(|end| polygons + end))?;
        all.skipped += part.skipped;
    }
    Ok(all)
}

/// Header of a geometry.
struct Header {
    is_little: bool,
    /// Geometry type of OGC, such as 1 for a point, 3 for a polygon and 7 for a collection.
    kind: u32,
    /// Coordinates per point, 2 to 4.
    columns: usize,
}

struct Reader<'a, 'f> {
    bytes_left: &'a [u8],
    outlines: &'f mut Outlines,
}

type Parsed<T> = std::result::Result<T, String>;

impl<'a> Reader<'a, '_> {
    fn row(&mut self) -> Parsed<()> {
        self.geometry(0)?;
        match self.bytes_left.len() {
            0 => Ok(()),
            count => Err(format!("{count} bytes follow its geometry")),
        }
    }

    fn geometry(&mut self, depth: usize) -> Parsed<()> {
        let header = self.header()?;
        match header.kind {
            1 => self.take(8 * header.columns).map(drop),
            2 => self.point_run(&header).map(drop),
            3 => return self.polygon(&header),
            // Multi-geometries and collections; their parts have their own headers.
            4..=7 if depth < MAX_DEPTH => {
                for _ in 0..self.count(&header, 5)? {
                    self.geometry(depth + 1)?;
                }
                return Ok(());
            }
            4..=7 => return Err(format!("its geometries are nested deeper than {MAX_DEPTH}")),
            kind => return Err(format!("geometry type {kind} is not read, only points, lines and polygons are")),
        }?;
        self.outlines.skipped += 1;
        Ok(())
    }

    fn header(&mut self) -> Parsed<Header> {
        let is_little = match self.take(1)? {
            [0] => false,
            [1] => true,
            other => return Err(format!("its byte order is {}, not 0 or 1", other[0])),
        };
        let type_field = self.number(is_little)?;
        let type_code = type_field & !(HAS_Z | HAS_M | HAS_SRID);
        let (dimensions, kind) = (type_code / 1000, type_code % 1000);
        if dimensions > 3 {
            return Err(format!("geometry type {type_code} is not known"));
        }
        if type_field & HAS_SRID != 0 {
            self.number(is_little)?;
        }
        let has_z = type_field & HAS_Z != 0 || dimensions & 1 != 0;
        let has_m = type_field & HAS_M != 0 || dimensions & 2 != 0;
        Ok(Header { is_little, kind, columns: 2 + usize::from(has_z) + usize::from(has_m) })
    }

    fn polygon(&mut self, header: &Header) -> Parsed<()> {
        for _ in 0..self.count(header, 4)? {
            let (is_little, columns) = (header.is_little, header.columns);
            let run = self.point_run(header)?;
            let start = self.outlines.points.len();
            self.outlines.points.extend(run.chunks_exact(8 * columns).map(|row| {
                let value = |offset: usize| {
                    let bytes: [u8; 8] = std::array::from_fn(|byte| row[offset + byte]);
                    if is_little { f64::from_le_bytes(bytes) } else { f64::from_be_bytes(bytes) }
                };
                [value(0), value(8)]
            }));
            let points = &mut self.outlines.points;
            if points.len() > start + 1 && points.last() == points.get(start) {
                points.pop();
            }
            self.outlines.rings.push(points.len() as i64);
        }
        self.outlines.polygons.push(self.outlines.rings.len() as i64);
        Ok(())
    }

    /// Returns the bytes of a length-prefixed run of points.
    fn point_run(&mut self, header: &Header) -> Parsed<&'a [u8]> {
        let count = self.count(header, 8 * header.columns)?;
        self.take(count * 8 * header.columns)
    }

    /// Reads a count of items of at least `min_size` bytes each; fails if the remaining bytes cannot hold them.
    fn count(&mut self, header: &Header, min_size: usize) -> Parsed<usize> {
        let count = self.number(header.is_little)? as usize;
        if count > self.bytes_left.len() / min_size {
            return Err(format!("it claims {count} parts, more than its bytes can hold"));
        }
        Ok(count)
    }

    fn number(&mut self, is_little: bool) -> Parsed<u32> {
        let taken = self.take(4)?;
        let bytes: [u8; 4] = std::array::from_fn(|byte| taken[byte]);
        Ok(if is_little { u32::from_le_bytes(bytes) } else { u32::from_be_bytes(bytes) })
    }

    fn take(&mut self, size: usize) -> Parsed<&'a [u8]> {
        let (taken, bytes_left) = self.bytes_left.split_at_checked(size).ok_or_else(|| "it is cut off".to_owned())?;
        self.bytes_left = bytes_left;
        Ok(taken)
    }
}

#[cfg(test)]
mod tests;
