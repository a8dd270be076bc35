//! Rows of numbers in a block of bytes, described by a type, a start and a stride.

use crate::base::Buffer;

/// Type of the numbers in rows, little-endian.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names of Rust's types")]
pub enum ComponentType {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl ComponentType {
    /// Returns the bytes of a number.
    pub fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }
}

/// Location and layout of rows.
#[derive(Clone, Copy, Debug)]
pub struct Rows {
    /// Index of the block of bytes.
    pub block: usize,
    /// First byte of the first row.
    pub start: usize,
    /// Bytes from one row to the next.
    pub step: usize,
    /// Number of rows.
    pub count: usize,
    /// Numbers in a row.
    pub width: usize,
    /// Type of the numbers.
    pub component: ComponentType,
    /// Whether integers are normalised: fractions of their type's maximum.
    pub is_fraction: bool,
}

impl Rows {
    /// Returns the bytes of a row.
    pub fn size(&self) -> usize {
        self.width * self.component.size()
    }

    /// Returns the end of the last row; `None` if it overflows.
    pub fn end(&self) -> Option<usize> {
        let Some(before) = self.count.checked_sub(1) else { return Some(self.start) };
        before.checked_mul(self.step)?.checked_add(self.start)?.checked_add(self.size())
    }

    /// Returns the byte range of some rows; `None` if there are gaps between rows.
    pub fn tight(&self, first: usize, count: usize) -> Option<std::ops::Range<usize>> {
        let start = self.start + first * self.step;
        (self.step == self.size()).then(|| start..start + count * self.step)
    }
}

/// A number type in a file.
trait Stored: Copy {
    const SIZE: usize;
    /// Reads a number from the first bytes of a slice.
    fn first_of(bytes: &[u8]) -> Self;
    /// Converts the number to float32.
    fn plain(self) -> f32;
    /// Converts a normalised integer to a fraction, at least −1 (glTF 2.0, 3.6.2.2).
    fn fraction(self) -> f32;
}

macro_rules! stored {
    ($($number:ty),+: $fraction:expr) => {
        $(impl Stored for $number {
            const SIZE: usize = size_of::<$number>();
            #[inline]
            fn first_of(bytes: &[u8]) -> Self {
                Self::from_le_bytes(bytes.first_chunk().copied().unwrap_or_default())
            }
            #[inline]
            fn plain(self) -> f32 {
                self as f32
            }
            #[inline]
            fn fraction(self) -> f32 {
                $fraction(self, Self::MAX)
            }
        })+
    };
}

stored!(i8, u8, i16, u16, u32: |number, greatest| (f64::from(number) / f64::from(greatest)).max(-1.0) as f32);
stored!(f32: |number, _| number);

/// Evaluates an expression with `$type` bound to a number type.
macro_rules! with_number {
    ($number:expr, $type:ident => $body:expr) => {
        with_number!(@each $number, $type, $body, I8: i8, U8: u8, I16: i16, U16: u16, U32: u32, F32: f32)
    };
    (@each $number:expr, $type:ident, $body:expr, $($variant:ident: $primitive:ty),+) => {
        match $number {
            $(ComponentType::$variant => {
                type $type = $primitive;
                $body
            })+
        }
    };
}

/// Rows and the bytes that hold them.
#[derive(Clone, Copy)]
pub struct Table<'a> {
    pub rows: Rows,
    bytes: &'a [u8],
}

impl<'a> Table<'a> {
    /// Creates a table; the rows must lie within their block.
    pub fn new(rows: Rows, blocks: &'a [Buffer<u8>]) -> Self {
        Self { rows, bytes: &blocks[rows.block] }
    }

    /// Returns one column of the rows.
    pub fn column(&self, column: usize) -> Self {
        let rows = Rows { start: self.rows.start + column * self.rows.component.size(), width: 1, ..self.rows };
        Self { rows, bytes: self.bytes }
    }

    /// Converts rows of `W` 16-bit numbers from number `first` on.
    pub fn shorts<R, const W: usize>(&self, first: usize, slots: &mut [R], convert: impl Fn([u16; W]) -> R) {
        self.each_row(first, slots, convert);
    }

    /// Writes rows from number `first` on as float32; normalised integers become fractions.
    pub fn floats<const W: usize>(&self, first: usize, slots: &mut [[f32; W]]) {
        with_number!(self.rows.component, T => {
            if self.rows.is_fraction {
                self.map_rows(first, slots, T::fraction);
            } else {
                self.map_rows(first, slots, T::plain);
            }
        });
    }

    /// Writes faces from number `first` on; a face consists of three rows of one integer.
    pub fn corners(&self, first: usize, slots: &mut [[u32; 3]]) {
        let faces = Self { rows: Rows { step: 3 * self.rows.step, width: 3, ..self.rows }, bytes: self.bytes };
        match self.rows.component {
            ComponentType::U8 => faces.map_rows(first, slots, |number: u8| u32::from(number)),
            ComponentType::U16 => faces.map_rows(first, slots, |number: u16| u32::from(number)),
            _ => faces.map_rows(first, slots, |number: u32| number),
        }
    }

    /// Writes rows of `W` numbers; integers are always normalised to fractions.
    pub fn fractions<const W: usize>(&self, first: usize, slots: &mut [[f32; W]]) {
        with_number!(self.rows.component, T => self.map_rows(first, slots, T::fraction));
    }

    fn map_rows<T: Stored, R, const W: usize>(&self, first: usize, slots: &mut [[R; W]], convert: impl Fn(T) -> R) {
        self.each_row(first, slots, |row: [T; W]| row.map(&convert));
    }

    fn each_row<T: Stored, R, const W: usize>(&self, first: usize, slots: &mut [R], convert: impl Fn([T; W]) -> R) {
        let start = self.rows.start + first * self.rows.step;
        for (row, slot) in slots.iter_mut().enumerate() {
            let row_start = start + row * self.rows.step;
            let bytes = &self.bytes[row_start..row_start + W * T::SIZE];
            *slot = convert(std::array::from_fn(|column| T::first_of(&bytes[column * T::SIZE..])));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_every_type_are_read_and_normalised() {
        let blocks = [Buffer::from(vec![0u8, 0x80, 0x7f, 0xff, 0, 0, 0x80, 0x3f])];
        let one = |start, component, is_fraction| {
            let rows = Rows { block: 0, start, step: 4, count: 1, width: 1, component, is_fraction };
            let mut slot = [[0.0]];
            Table::new(rows, &blocks).floats(0, &mut slot);
            slot[0][0]
        };
        assert_eq!((one(1, ComponentType::I8, false), one(1, ComponentType::I8, true)), (-128.0, -1.0));
        assert_eq!((one(2, ComponentType::U8, false), one(3, ComponentType::U8, true)), (127.0, 1.0));
        assert_eq!((one(0, ComponentType::I16, false), one(0, ComponentType::I16, true)), (-32768.0, -1.0));
        assert_eq!(one(2, ComponentType::U16, true), 0xff7f as f32 / 65535.0);
        assert_eq!((one(4, ComponentType::F32, false), one(4, ComponentType::U32, false)), (1.0, 1_065_353_216.0));
    }

    #[test]
    fn ends_do_not_overflow() {
        let rows = Rows {
            block: 0,
            start: 4,
            step: 12,
            count: 3,
            width: 2,
            component: ComponentType::U16,
            is_fraction: false,
        };
        assert_eq!((rows.size(), rows.end()), (4, Some(32)));
        assert_eq!(Rows { count: 0, ..rows }.end(), Some(4));
        assert_eq!(Rows { count: usize::MAX, ..rows }.end(), None);
        assert_eq!((rows.tight(1, 1), Rows { step: 4, ..rows }.tight(1, 2)), (None, Some(8..16)));
    }
}
