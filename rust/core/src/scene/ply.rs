//! Data of PLY files: numbers in text, and binary rows with lists of different lengths.
//!
//! G. Turk: The PLY Polygon File Format.

use rayon::prelude::*;

use crate::base::memory::{try_append, try_concat, try_push, try_with_capacity};
use crate::base::{Error, Progress, Result};

/// Bytes of text per task.
const TEXT_PER_TASK: usize = 1 << 20;
/// Rows between two checks for cancellation.
const ROWS_PER_CHECK: usize = 1 << 16;
/// Maximum characters of a word quoted in a message.
const MAX_QUOTED: usize = 60;

/// Type of a list's length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the names of Rust's types")]
pub enum ScalarType {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

/// Property of an element's rows.
#[derive(Clone, Copy, Debug)]
pub struct Property {
    /// Bytes of a value.
    pub size: usize,
    /// Type of the length that precedes the values of a list; `None` for a single value.
    pub length: Option<ScalarType>,
}

/// Values of a property in all rows.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Column {
    /// Bytes of the values, as in the file.
    pub bytes: Vec<u8>,
    /// Row r of a list has the values from `offsets[r]` to `offsets[r + 1]`; empty for single values.
    pub offsets: Vec<i64>,
}

/// Bytes of numbers in the file.
#[derive(Clone, Copy, Debug)]
pub struct Data<'a> {
    /// Content of the file without its header.
    pub bytes: &'a [u8],
    /// Whether the most significant byte of a number comes first.
    pub is_big_endian: bool,
}

/// Reads `count` rows that begin at byte `start`; returns the columns and the end of the rows.
pub fn read_rows(
    data: Data<'_>,
    start: usize,
    count: usize,
    properties: &[Property],
    progress: &Progress,
) -> Result<(Vec<Column>, usize)> {
    let cut_off = || Error::Scene("it is cut off".to_owned());
    // A list may be empty, so a row has at least the bytes of its lengths and single values.
    let min_row: usize =
        properties.iter().map(|property| property.length.map_or(property.size, ScalarType::size)).sum();
    if count.saturating_mul(min_row) > data.bytes.len().saturating_sub(start) {
        return Err(cut_off());
    }
    let new_column = |property: &Property| {
        let (values, offsets) = if property.length.is_some() { (0, count + 1) } else { (count, 0) };
        let mut column =
            Column { bytes: try_with_capacity(values * property.size)?, offsets: try_with_capacity(offsets)? };
        column.offsets.extend(property.length.map(|_| 0));
        Ok(column)
    };
    let mut columns: Vec<Column> = properties.iter().map(new_column).collect::<Result<_>>()?;
    let mut position = start;
    for row in 0..count {
        if row % ROWS_PER_CHECK == 0 {
            progress.check()?;
        }
        for (property, column) in properties.iter().zip(&mut columns) {
            let mut values = 1;
            if let Some(number) = property.length {
                let bytes =
                    data.bytes.get(position..).and_then(|rest| rest.get(..number.size())).ok_or_else(cut_off)?;
                let length = number.read(bytes, data.is_big_endian);
                if !(0.0..=data.bytes.len() as f64).contains(&length) {
                    return Err(Error::Scene(format!("it has a list of {length} numbers")));
                }
                position += number.size();
                values = length as usize;
                let end = column.offsets.last().copied().unwrap_or_default() + values as i64;
                try_push(&mut column.offsets, end)?;
            }
            let end = position.saturating_add(values.saturating_mul(property.size));
            try_append(&mut column.bytes, data.bytes.get(position..end).ok_or_else(cut_off)?)?;
            position = end;
        }
    }
    Ok((columns, position))
}

impl ScalarType {
    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// Reads a number from its bytes.
    fn read(self, bytes: &[u8], is_big_endian: bool) -> f64 {
        let mut word = [0; 8];
        word[..bytes.len()].copy_from_slice(bytes);
        if is_big_endian {
            word[..bytes.len()].reverse();
        }
        let bits = u64::from_le_bytes(word);
        match self {
            Self::I8 => f64::from(bits as i8),
            Self::I16 => f64::from(bits as i16),
            Self::I32 => f64::from(bits as i32),
            Self::I64 => bits as i64 as f64,
            Self::U8 | Self::U16 | Self::U32 | Self::U64 => bits as f64,
            Self::F32 => f64::from(f32::from_bits(bits as u32)),
            Self::F64 => f64::from_bits(bits),
        }
    }
}

/// Parses numbers separated by white space; an error quotes the first word that is not a number.
pub fn parse_numbers(text: &[u8], progress: &Progress) -> Result<Vec<f64>> {
    let mut parts = Vec::new();
    let mut rest = text;
    while !rest.is_empty() {
        let tail = rest.iter().skip(TEXT_PER_TASK).position(u8::is_ascii_whitespace);
        let (part, remainder) = rest.split_at(tail.map_or(rest.len(), |tail| TEXT_PER_TASK + tail));
        parts.push(part);
        rest = remainder;
    }
    let parse = |part: &&[u8]| {
        progress.check()?;
        let words = part.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        let mut numbers = Vec::new();
        for word in words {
            try_push(&mut numbers, parse_number(word)?)?;
        }
        Ok(numbers)
    };
    // Collected in order, so that the error is that of the first wrong word.
    let parsed: Vec<Result<Vec<f64>>> = parts.par_iter().map(parse).collect();
    let parsed: Vec<Vec<f64>> = parsed.into_iter().collect::<Result<_>>()?;
    try_concat(&parsed)
}

fn parse_number(word: &[u8]) -> Result<f64> {
    str::from_utf8(word).ok().and_then(|word| word.parse().ok()).ok_or_else(|| {
        let word: String = String::from_utf8_lossy(word).chars().take(MAX_QUOTED).collect();
        Error::Scene(format!("it cannot be read: {word} stands where a number belongs"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_any_length_are_read_in_both_byte_orders() {
        let properties = [
            Property { size: 1, length: None },
            Property { size: 2, length: Some(ScalarType::U8) },
            Property { size: 4, length: Some(ScalarType::I32) },
        ];
        // Rows: 7, (258, 515), (); 9, (), (1).
        let little = [&[7u8, 2, 2, 1, 3, 2][..], &[0; 4], &[9, 0], &[1, 0, 0, 0, 1, 0, 0, 0], &[99]].concat();
        let big = [&[7u8, 2, 1, 2, 2, 3][..], &[0; 4], &[9, 0], &[0, 0, 0, 1, 0, 0, 0, 1], &[99]].concat();
        for (bytes, is_big_endian) in [(&little, false), (&big, true)] {
            let data = Data { bytes, is_big_endian };
            let (columns, end) = read_rows(data, 0, 2, &properties, &Progress::new()).unwrap();
            assert_eq!(end, bytes.len() - 1);
            assert_eq!(columns[0], Column { bytes: vec![7, 9], offsets: vec![] });
            assert_eq!(columns[1], Column { bytes: bytes[2..6].to_vec(), offsets: vec![0, 2, 2] });
            assert_eq!(columns[2], Column { bytes: bytes[16..20].to_vec(), offsets: vec![0, 0, 1] });
            for length in 0..end {
                let data = Data { bytes: &bytes[..length], ..data };
                assert!(read_rows(data, 0, 2, &properties, &Progress::new()).is_err(), "{length}");
            }
        }
    }

    #[test]
    fn lengths_of_every_type_are_read_and_impossible_ones_refused() {
        let read = |number: ScalarType, bytes: &[u8]| number.read(bytes, false);
        assert_eq!((read(ScalarType::I8, &[0xfe]), read(ScalarType::U8, &[0xfe])), (-2.0, 254.0));
        assert_eq!((read(ScalarType::I16, &[0xfe, 0xff]), read(ScalarType::U16, &[0xfe, 0xff])), (-2.0, 65534.0));
        assert_eq!(ScalarType::I16.read(&[0x01, 0x02], true), 258.0);
        assert_eq!((read(ScalarType::I64, &[0xff; 8]), read(ScalarType::U64, &[1, 0, 0, 0, 0, 0, 0, 0])), (-1.0, 1.0));
        assert_eq!(
            (read(ScalarType::F32, &3f32.to_le_bytes()), read(ScalarType::F64, &5f64.to_le_bytes())),
            (3.0, 5.0)
        );
        for length in [-1.0, f64::NAN, f64::INFINITY, 1e300] {
            let bytes = length.to_le_bytes();
            let data = Data { bytes: &bytes, is_big_endian: false };
            let properties = [Property { size: 8, length: Some(ScalarType::F64) }];
            assert!(read_rows(data, 0, 1, &properties, &Progress::new()).is_err(), "{length}");
            // More rows than bytes are refused before room for them is reserved.
            assert!(read_rows(data, 0, usize::MAX, &properties, &Progress::new()).is_err());
        }
    }

    #[test]
    fn numbers_do_not_depend_on_tasks() {
        let text: String =
            (0..200_000).map(|n| format!("{}{n}.5e-1\t{n}\r\n", if n % 3 == 0 { "-" } else { "" })).collect();
        assert!(text.len() > 2 * TEXT_PER_TASK);
        let expected: Vec<f64> = text.split_whitespace().map(|word| word.parse().unwrap()).collect();
        assert_eq!(parse_numbers(text.as_bytes(), &Progress::new()).unwrap(), expected);
        assert_eq!(parse_numbers(b" \n", &Progress::new()).unwrap(), [0.0; 0]);
        let words = "it cannot be read: 0x1 stands where a number belongs";
        let wrong = format!("{text} 0x1 zwei");
        assert_eq!(parse_numbers(wrong.as_bytes(), &Progress::new()), Err(Error::Scene(words.to_owned())));
    }
}
