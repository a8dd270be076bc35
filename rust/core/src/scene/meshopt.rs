//! Encoder and decoder of streams compressed by meshoptimizer: it writes `EXT_meshopt_compression` of glTF, and reads
//! also `KHR_meshopt_compression`.

use bytemuck::{Pod, cast_slice_mut};
use meshopt::{
    decode_filter_color, decode_filter_exp, decode_filter_oct, decode_filter_quat, encode_index_buffer,
    encode_vertex_buffer_level, ffi,
};

use crate::base::memory::room_for;
use crate::base::{Error, Result, ensure};

/// Compression level: meshoptimizer's default. Only version 1 of the codec uses it.
const CODEC_LEVEL: i32 = 2;
/// `EXT_meshopt_compression` requires version 0.
const CODEC_VERSION: Option<i32> = Some(0);

/// Maximum bytes of rows in one attribute block.
const BLOCK_BYTES: usize = 8192;
/// Maximum rows in one attribute block.
const BLOCK_ROWS: usize = 256;
/// Row counts of attribute blocks are multiples of this number.
const GROUP_ROWS: usize = 16;
/// Minimum bytes after the blocks of an attribute stream, in any version of the codec.
const ATTRIBUTES_TAIL: usize = 24;
/// Bytes of the table at the end of a triangle stream.
const TRIANGLES_TAIL: usize = 16;
/// Bytes at the end of an index stream.
const INDICES_TAIL: usize = 4;

/// Codec of a stream, by the kind of its rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// Vertex attributes.
    Attributes,
    /// Triangle corners, three per triangle.
    Triangles,
    /// Any other indices.
    Indices,
}

/// Filter that turns decoded rows into attributes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Filter {
    /// No filter.
    None,
    /// Octahedral unit vectors to normalised integers.
    Octahedral,
    /// Three components of unit quaternions to four.
    Quaternion,
    /// Exponents and mantissas to float32.
    Exponential,
    /// Luma and chroma to RGBA.
    Color,
}

/// Size and kind of a decoded stream.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layout {
    /// Number of rows.
    pub count: usize,
    /// Bytes per row: a multiple of 4 up to 256 for attributes, 2 or 4 for indices.
    pub stride: usize,
    /// Kind of the rows.
    pub mode: Mode,
    /// Filter of attributes; `None` for other modes.
    pub filter: Filter,
}

/// Encodes rows of vertex attributes, to which a filter has been applied. Rows have a multiple of 4 bytes, up to 256.
pub fn encode_rows<T: Pod>(rows: &[T]) -> Result<Vec<u8>> {
    encode_vertex_buffer_level(rows, CODEC_LEVEL, CODEC_VERSION).map_err(encoding_error)
}

/// Encodes rows of 1 to 4 words of vertex attributes, to which a filter has been applied.
pub fn encode_words(words: &[u32], width: usize) -> Result<Vec<u8>> {
    match width {
        1 => encode_rows(words.as_chunks::<1>().0),
        2 => encode_rows(words.as_chunks::<2>().0),
        3 => encode_rows(words.as_chunks::<3>().0),
        4 => encode_rows(words.as_chunks::<4>().0),
        _ => Err(Error::value("rows", "1 to 4 words in each", width)),
    }
}

/// Encodes the corners of triangles. The stream is smallest if vertices are numbered in the order of their first use.
pub fn encode_triangles(corners: &[u32], vertex_count: usize) -> Result<Vec<u8>> {
    ensure!(corners.len().is_multiple_of(3), "corners", "three for each triangle", corners.len());
    let largest = corners.iter().max().map_or(0, |&corner| corner as usize + 1);
    ensure!(largest <= vertex_count, "corners", format!("numbers below {vertex_count}"), largest - 1);
    encode_index_buffer(corners, vertex_count).map_err(encoding_error)
}

fn encoding_error(error: meshopt::Error) -> Error {
    Error::value("mesh", "arrays that meshoptimizer can encode", error)
}

/// Decodes a stream to `count * stride` bytes, as words for alignment; the last word may have two unused bytes.
///
/// Damaged bytes give an error or wrong rows; indices are not range-checked.
pub fn decode(bytes: &[u8], layout: Layout) -> Result<Vec<u32>> {
    layout.check()?;
    let size = layout.count.checked_mul(layout.stride).filter(|_| layout.min_bytes() <= bytes.len());
    let size = size.ok_or_else(|| {
        let Layout { count, stride, .. } = layout;
        Error::Scene(format!("{count} rows of {stride} bytes cannot come from {} bytes", bytes.len()))
    })?;
    room_for(size as u64)?;
    let mut words = vec![0u32; size.div_ceil(4)];
    let decoder = match layout.mode {
        Mode::Attributes => ffi::meshopt_decodeVertexBuffer,
        Mode::Triangles => ffi::meshopt_decodeIndexBuffer,
        Mode::Indices => ffi::meshopt_decodeIndexSequence,
    };
    // SAFETY: each decoder reads within `bytes`, even if they are damaged, and writes at most `count` rows of `stride`
    // bytes, for which `words` has room and alignment. `check` accepts only strides and counts that the decoder allows:
    // a multiple of 4 bytes up to 256 for attributes, 2 or 4 bytes for indices, and three indices per triangle.
    let failure =
        unsafe { decoder(words.as_mut_ptr().cast(), layout.count, layout.stride, bytes.as_ptr(), bytes.len()) };
    if failure != 0 {
        return Err(Error::Scene("its compressed bytes are damaged".to_owned()));
    }
    filter(&mut words, layout);
    Ok(words)
}

impl Layout {
    fn check(&self) -> Result<()> {
        let Self { count, stride, mode, filter } = *self;
        let has_rows = match mode {
            Mode::Attributes => (4..=256).contains(&stride) && stride.is_multiple_of(4),
            Mode::Triangles | Mode::Indices => matches!(stride, 2 | 4),
        };
        let has_filter = match filter {
            Filter::None => true,
            Filter::Octahedral | Filter::Color => mode == Mode::Attributes && matches!(stride, 4 | 8),
            Filter::Quaternion => mode == Mode::Attributes && stride == 8,
            Filter::Exponential => mode == Mode::Attributes,
        };
        let what = format!("{mode:?}").to_uppercase();
        if !has_rows {
            return Err(Error::Scene(format!("{what} have no rows of {stride} bytes")));
        }
        if !has_filter {
            let name = format!("{filter:?}").to_uppercase();
            return Err(Error::Scene(format!("{what} of {stride} bytes have no filter {name}")));
        }
        if mode == Mode::Triangles && !count.is_multiple_of(3) {
            return Err(Error::Scene(format!("expected three corners for each triangle, got {count}")));
        }
        Ok(())
    }

    /// Returns the size of the shortest possible stream. Shorter streams are refused before memory for their rows is
    /// allocated, so that a small file cannot claim much. One byte encodes at most 1024 bytes of attributes or three
    /// indices.
    fn min_bytes(&self) -> usize {
        let (body, tail) = match self.mode {
            Mode::Attributes => {
                let rows = (BLOCK_BYTES / self.stride / GROUP_ROWS * GROUP_ROWS).min(BLOCK_ROWS);
                // Four columns of a block take at least one byte, even if all are zero.
                (self.count.div_ceil(rows).saturating_mul(self.stride / 4), ATTRIBUTES_TAIL.max(self.stride))
            }
            Mode::Triangles => (self.count / 3, TRIANGLES_TAIL),
            Mode::Indices => (self.count, INDICES_TAIL),
        };
        body.saturating_add(tail + 1)
    }
}

fn filter(words: &mut [u32], layout: Layout) {
    match (layout.filter, layout.stride) {
        (Filter::None, _) => {}
        (Filter::Octahedral, 4) => decode_filter_oct::<i8>(cast_slice_mut(words)),
        (Filter::Octahedral, _) => decode_filter_oct::<i16>(cast_slice_mut(words)),
        (Filter::Quaternion, _) => decode_filter_quat(cast_slice_mut(words)),
        (Filter::Exponential, _) => decode_filter_exp::<1>(cast_slice_mut(words)),
        (Filter::Color, 4) => decode_filter_color::<u8>(cast_slice_mut(words)),
        (Filter::Color, _) => decode_filter_color::<u16>(cast_slice_mut(words)),
    }
}

#[cfg(test)]
mod tests {
    use bytemuck::cast_slice;
    use meshopt::{encode_filter_color, encode_index_sequence};

    use super::*;

    const VERSIONS: [i32; 2] = [0, 1];

    fn attributes(count: usize, stride: usize, filter: Filter) -> Layout {
        Layout { count, stride, mode: Mode::Attributes, filter }
    }

    fn indices(count: usize, stride: usize, mode: Mode) -> Layout {
        Layout { count, stride, mode, filter: Filter::None }
    }

    /// Words that are partly repetitive and partly noise (Knuth's multiplier).
    fn noise(count: usize) -> Vec<u32> {
        (0..count as u32).map(|n| if n % 7 < 3 { n / 90 } else { n.wrapping_mul(2_654_435_761) }).collect()
    }

    fn decoded<T>(rows: &[T], filter: Filter) -> Vec<u32> {
        let streams = VERSIONS.map(|version| {
            let bytes = encode_vertex_buffer_level(rows, 2, Some(version)).unwrap();
            decode(&bytes, attributes(rows.len(), size_of::<T>(), filter)).unwrap()
        });
        assert_eq!(streams[0], streams[1]);
        streams[0].clone()
    }

    fn check_rows<const N: usize>() {
        for count in [0, 1, 15, 17, 255, 257, 1000] {
            let words = noise(count * N);
            let rows: &[[u32; N]] = words.as_chunks().0;
            assert_eq!(decoded(rows, Filter::None), words, "{count} rows of {N} words");
        }
    }

    #[test]
    fn attributes_are_decoded_bit_for_bit() {
        check_rows::<1>();
        check_rows::<2>();
        check_rows::<3>();
        check_rows::<5>();
        check_rows::<16>();
        check_rows::<64>();
    }

    #[test]
    fn indices_are_decoded() {
        let corners: Vec<u32> = (0..300u32).flat_map(|n| [n, n + 1, n + 2, n + 2, n + 1, 302 + n * 7 % 300]).collect();
        let bytes = encode_index_buffer(&corners, 602).unwrap();
        // The codec may rotate a triangle's corners.
        let canonical = |corners: &[u32]| -> Vec<[u32; 3]> {
            let least = |&[a, b, c]: &[u32; 3]| [[a, b, c], [b, c, a], [c, a, b]].into_iter().min().unwrap();
            corners.as_chunks::<3>().0.iter().map(least).collect()
        };
        let long = decode(&bytes, indices(corners.len(), 4, Mode::Triangles)).unwrap();
        assert_eq!(canonical(&long), canonical(&corners));
        let short = decode(&bytes, indices(corners.len(), 2, Mode::Triangles)).unwrap();
        assert!(cast_slice::<_, u16>(&short).iter().copied().map(u32::from).eq(long));

        let any = [5, 5, 0, 65_535, 1, 3, 9_000];
        let bytes = encode_index_sequence(&any, 65_536).unwrap();
        assert_eq!(decode(&bytes, indices(any.len(), 4, Mode::Indices)).unwrap(), any);
        let short = decode(&bytes, indices(any.len(), 2, Mode::Indices)).unwrap();
        assert_eq!(short.len(), 4);
        assert!(cast_slice::<_, u16>(&short)[..any.len()].iter().copied().map(u32::from).eq(any));
    }

    #[test]
    fn encoded_words_and_triangles_are_decoded_and_bad_ones_refused() {
        for width in 1..=4 {
            let words = noise(300 * width);
            let bytes = encode_words(&words, width).unwrap();
            assert_eq!(bytes[0], 0xa0, "version 0, which the extension of glTF requires");
            assert_eq!(decode(&bytes, attributes(300, 4 * width, Filter::None)).unwrap(), words);
        }
        let corners: Vec<u32> =
            (0..50u32).flat_map(|n| [4 * n, 4 * n + 1, 4 * n + 2, 4 * n + 2, 4 * n + 1, 4 * n + 3]).collect();
        let bytes = encode_triangles(&corners, 200).unwrap();
        assert!(bytes.len() < 150, "a byte and a half for each of 100 triangles: {}", bytes.len());
        assert_eq!(decode(&bytes, indices(300, 4, Mode::Triangles)).unwrap().len(), 300);
        assert!(encode_words(&[0; 5], 5).unwrap_err().to_string().contains("1 to 4 words"));
        assert!(encode_triangles(&[0, 1], 2).unwrap_err().to_string().contains("three for each"));
        assert!(encode_triangles(&[0, 1, 2], 2).unwrap_err().to_string().contains("below 2"));
    }

    /// Values from meshoptimizer's own tests (demo/tests.cpp: decodeFilterOct8, Oct12, Quat12, Exp).
    #[test]
    fn filters_give_the_published_numbers() {
        let bytes: [[u8; 4]; 4] = [[0, 1, 127, 0], [0, 187, 127, 1], [255, 1, 127, 0], [14, 130, 127, 1]];
        let expected: [[u8; 4]; 4] = [[0, 1, 127, 0], [0, 159, 82, 1], [255, 1, 127, 0], [1, 130, 241, 1]];
        assert_eq!(cast_slice::<_, [u8; 4]>(&decoded(&bytes, Filter::Octahedral)), expected);

        let shorts: [[u16; 4]; 4] = [[0, 1, 2047, 0], [0, 1870, 2047, 1], [2017, 1, 2047, 0], [14, 1300, 2047, 1]];
        let expected: [[u16; 4]; 4] =
            [[0, 16, 32767, 0], [0, 32621, 3088, 1], [32764, 16, 471, 0], [307, 28541, 16093, 1]];
        assert_eq!(cast_slice::<_, [u16; 4]>(&decoded(&shorts, Filter::Octahedral)), expected);

        let shorts: [[i16; 4]; 4] = [[0, 1, 0, 0x7fc], [0, 1870, 0, 0x7fd], [2017, 1, 0, 0x7fe], [14, 1300, 0, 0x7ff]];
        let expected: [[i16; 4]; 4] =
            [[32767, 0, 11, 0], [0, 25013, 0, 21166], [11, 0, 23504, 22830], [158, 14715, 0, 29277]];
        assert_eq!(cast_slice::<_, [i16; 4]>(&decoded(&shorts, Filter::Quaternion)), expected);

        let words = [[0, 0xff00_0003, 0x02ff_fff7, 0xfe7f_ffff_u32]];
        assert_eq!(decoded(&words, Filter::Exponential), [0, 0x3fc0_0000, 0xc210_0000, 0x49ff_fffe]);
    }

    #[test]
    fn colours_are_decoded() {
        let colors = [[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 0.5], [0.0, 0.0, 1.0, 0.25], [0.4, 0.4, 0.4, 0.75]];
        // Tolerance: half a quantisation step, and as much for the sum of luma and chroma.
        let near = |values: &[f32], bits: i32| {
            colors.as_flattened().iter().zip(values).all(|(a, b)| (a - b).abs() < 2.0 / (1 << (bits - 1)) as f32)
        };
        let words = decoded(&encode_filter_color::<u8>(&colors, 8), Filter::Color);
        assert!(near(&cast_slice::<_, u8>(&words).iter().map(|&byte| f32::from(byte) / 255.0).collect::<Vec<_>>(), 8));
        let words = decoded(&encode_filter_color::<u16>(&colors, 12), Filter::Color);
        assert!(near(&cast_slice::<_, u16>(&words).iter().map(|&n| f32::from(n) / 65_535.0).collect::<Vec<_>>(), 12));
    }

    /// A stream of each mode with its layout.
    fn streams() -> Vec<(Vec<u8>, Layout)> {
        let rows: Vec<[u32; 3]> = noise(900).as_chunks().0.to_vec();
        let corners: Vec<u32> = (0..200).flat_map(|n| [n, n + 1, n + 2]).collect();
        let mut streams: Vec<_> = VERSIONS
            .iter()
            .map(|&version| {
                let bytes = encode_vertex_buffer_level(&rows, 2, Some(version)).unwrap();
                (bytes, attributes(rows.len(), 12, Filter::Exponential))
            })
            .collect();
        streams.push((encode_index_buffer(&corners, 202).unwrap(), indices(corners.len(), 2, Mode::Triangles)));
        streams.push((encode_index_sequence(&corners, 202).unwrap(), indices(corners.len(), 4, Mode::Indices)));
        streams
    }

    #[test]
    fn truncated_streams_are_errors() {
        for (bytes, layout) in streams() {
            for length in 0..bytes.len() {
                assert!(decode(&bytes[..length], layout).is_err(), "{layout:?} {length}");
            }
            assert!(decode(&[&bytes[..], &[0]].concat(), layout).is_err(), "{layout:?}");
        }
    }

    #[test]
    fn damaged_bytes_are_an_error_or_rows() {
        for (bytes, layout) in streams() {
            for (number, word) in noise(2_000).into_iter().enumerate() {
                let mut damaged = bytes.clone();
                damaged[(word.wrapping_mul(31) as usize + number) % bytes.len()] ^= 1 << (word % 8);
                if let Ok(words) = decode(&damaged, layout) {
                    assert_eq!(words.len(), (layout.count * layout.stride).div_ceil(4));
                }
            }
        }
    }

    #[test]
    fn impossible_layouts_are_errors() {
        let (bytes, rows) = streams().swap_remove(0);
        let corners = indices(3, 2, Mode::Triangles);
        for (layout, words) in [
            (Layout { stride: 0, ..rows }, "ATTRIBUTES have no rows of 0 bytes"),
            (Layout { stride: 6, ..rows }, "ATTRIBUTES have no rows of 6 bytes"),
            (Layout { stride: 260, ..rows }, "ATTRIBUTES have no rows of 260 bytes"),
            (Layout { stride: 1, ..corners }, "TRIANGLES have no rows of 1 bytes"),
            (Layout { filter: Filter::Octahedral, ..rows }, "ATTRIBUTES of 12 bytes have no filter OCTAHEDRAL"),
            (Layout { filter: Filter::Quaternion, ..rows }, "ATTRIBUTES of 12 bytes have no filter QUATERNION"),
            (Layout { filter: Filter::Color, ..rows }, "ATTRIBUTES of 12 bytes have no filter COLOR"),
            (Layout { filter: Filter::Exponential, ..corners }, "TRIANGLES of 2 bytes have no filter EXPONENTIAL"),
            (Layout { count: 4, ..corners }, "expected three corners for each triangle, got 4"),
            (corners, "its compressed bytes are damaged"),
        ] {
            assert_eq!(decode(&bytes, layout), Err(Error::Scene(words.to_owned())));
        }
    }

    #[test]
    fn counts_that_the_bytes_cannot_encode_are_errors_before_memory_is_allocated() {
        for (bytes, layout) in streams() {
            for count in [3 << 30, usize::MAX / layout.stride / 3 * 3, usize::MAX / 3 * 3] {
                let error = decode(&bytes, Layout { count, ..layout }).unwrap_err();
                assert!(error.to_string().starts_with(&format!("{count} rows of")), "{error}");
            }
        }
    }

    /// Decodes the densest stream: a block of zeros has one byte for four columns. `min_bytes` must not refuse it.
    #[test]
    fn zeros_in_many_rows_are_decoded() {
        let rows = vec![[0u32; 2]; 100_000];
        let bytes = encode_vertex_buffer_level(&rows, 3, Some(1)).unwrap();
        let layout = attributes(rows.len(), 8, Filter::None);
        assert!(bytes.len() < layout.min_bytes() + 16, "{} bytes", bytes.len());
        assert_eq!(decode(&bytes, layout).unwrap(), vec![0; 200_000]);
    }
}
