//! OpenEXR images with any number of parts and channels, to and from byte buffers.
//!
//! Images are compressed with ZIP in blocks of 16 rows. This is lossless, also for infinities.

use std::borrow::Cow;
use std::io::{self, Cursor, Read, Seek, SeekFrom, Write};

use ::exr::prelude::*;
use half::f16;

use crate::base::memory::{room_for, try_with_capacity};
use crate::base::{self, Progress};

/// Values of one channel, row 0 on top; decoding returns owned values.
#[derive(Clone, Debug, PartialEq)]
pub enum Values<'a> {
    /// 16-bit floats.
    Half(Cow<'a, [f16]>),
    /// 32-bit floats.
    Float(Cow<'a, [f32]>),
    /// 32-bit unsigned numbers.
    Unsigned(Cow<'a, [u32]>),
}

/// Value of a header's attribute.
#[derive(Clone, Debug, PartialEq)]
pub enum Attribute {
    /// ASCII.
    Text(String),
    /// Three numbers, such as a position.
    Vector([f32; 3]),
}

/// One image of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Part<'a> {
    /// Name, unique in the file.
    pub name: String,
    /// Width, pixels.
    pub width: usize,
    /// Height, pixels.
    pub height: usize,
    /// Channels by name. Decoding returns them sorted by name, as the format requires.
    pub channels: Vec<(String, Values<'a>)>,
    /// Attributes of the header by name. Decoding returns them sorted by name.
    pub attributes: Vec<(String, Attribute)>,
}

/// Upper bound of a part's header, bytes.
const HEAD_BYTES: usize = 1 << 16;

/// Upper bound of a block's head and its entry in the table of offsets, bytes; there is at most one block per row.
const ROW_BYTES: usize = 64;

/// Encodes parts as a file, in this order.
pub fn encode(parts: &[Part<'_>], progress: &Progress) -> base::Result<Vec<u8>> {
    let layers: SmallVec<[Layer<AnyChannels<FlatSamples>>; 2]> =
        parts.iter().map(|part| layer(part, progress)).collect::<base::Result<_>>()?;
    let (width, height) = parts.iter().fold((1, 1), |(w, h), part| (part.width.max(w), part.height.max(h)));
    let image = Image::from_layers(ImageAttributes::new(IntegerBounds::from_dimensions((width, height))), layers);
    // Blocks that would grow by compression are stored uncompressed, so this is enough.
    let mut bytes =
        try_with_capacity(parts.iter().map(|part| part.bytes() + HEAD_BYTES + ROW_BYTES * part.height).sum())?;
    let stream = CancellableStream { inner: Cursor::new(&mut bytes), progress };
    let written = image.write().non_parallel().to_buffered(stream);
    progress.check()?;
    written.map_err(|error| base::Error::value("parts", "images that OpenEXR can hold", error))?;
    sort_headers(&mut bytes, parts.len());
    bytes.shrink_to_fit();
    Ok(bytes)
}

/// Sorts the attributes of each header by name, so that equal images give equal files. The crate exr keeps them in a
/// hash map, whose order changes from run to run.
///
/// A header is a sequence of attributes (name, 0, type, 0, size in four bytes, value) that ends with an empty name.
fn sort_headers(bytes: &mut [u8], headers: usize) {
    /// Bytes of the magic number and the version.
    const PREAMBLE: usize = 8;
    let mut start = PREAMBLE;
    for _ in 0..headers {
        let mut attributes: Vec<&[u8]> = Vec::new();
        let mut header = &bytes[start..];
        while let Some(attribute) = first_attribute(header) {
            attributes.push(attribute);
            header = &header[attribute.len()..];
        }
        // Names end with 0, which precedes every letter, so comparing whole attributes compares names first.
        attributes.sort();
        let sorted = attributes.concat();
        let end = start + sorted.len();
        bytes[start..end].copy_from_slice(&sorted);
        start = end + 1;
    }
}

/// Returns the first attribute of the remaining header; `None` at the header's end.
fn first_attribute(header: &[u8]) -> Option<&[u8]> {
    let name = header.iter().position(|&byte| byte == 0).filter(|&length| length > 0)?;
    let kind = header[name + 1..].iter().position(|&byte| byte == 0)?;
    let value = name + kind + 6;
    let size = header.get(value - 4..value)?.try_into().ok().map(u32::from_le_bytes)?;
    header.get(..value + size as usize)
}

/// Decodes the parts of a file. Attributes of types other than `Attribute` are omitted.
pub fn decode(bytes: &[u8], progress: &Progress) -> base::Result<Vec<Part<'static>>> {
    check_size(bytes)?;
    let image = ::exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .all_layers()
        .all_attributes()
        .non_parallel()
        .from_buffered(CancellableStream { inner: Cursor::new(bytes), progress });
    progress.check()?;
    let image = image.map_err(unreadable)?;
    Ok(image.layer_data.into_iter().map(part).collect())
}

/// A stream in memory that fails after the caller has cancelled. The crate exr reads and writes it block by block.
struct CancellableStream<'a, S> {
    inner: S,
    progress: &'a Progress,
}

impl<S> CancellableStream<'_, S> {
    fn check(&self) -> io::Result<()> {
        self.progress.check().map_err(io::Error::other)
    }
}

impl<S: Read> Read for CancellableStream<'_, S> {
    fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
        self.check()?;
        self.inner.read(to)
    }
}

impl<S: Write> Write for CancellableStream<'_, S> {
    fn write(&mut self, from: &[u8]) -> io::Result<usize> {
        self.check()?;
        self.inner.write(from)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.inner.flush()
    }
}

impl<S: Seek> Seek for CancellableStream<'_, S> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.inner.seek(to)
    }
}

/// Fails before memory is allocated if headers declare more data than the file can contain.
fn check_size(bytes: &[u8]) -> base::Result<()> {
    /// Maximum ratio of data to file size: deflate's maximum of 1032, plus a margin.
    const MAX_EXPANSION: u128 = 1100;
    let meta = MetaData::read_from_buffered(Cursor::new(bytes), false).map_err(unreadable)?;
    let declared = meta.headers.iter().map(|header| {
        let pixels = header.layer_size.width() as u128 * header.layer_size.height() as u128;
        pixels * header.channels.bytes_per_pixel as u128
    });
    let (declared, length) = (declared.sum::<u128>(), bytes.len());
    if declared > length as u128 * MAX_EXPANSION {
        return Err(unreadable(format!("{length} bytes cannot hold the {declared} bytes that its header declares")));
    }
    room_for(declared as u64)
}

fn unreadable(error: impl std::fmt::Display) -> base::Error {
    base::Error::Format(format!("no readable OpenEXR image: {error}"))
}

fn layer(part: &Part<'_>, progress: &Progress) -> base::Result<Layer<AnyChannels<FlatSamples>>> {
    let pixels = part.width * part.height;
    let channels = part.channels.iter().map(|(name, values)| {
        let (width, height) = (part.width, part.height);
        base::ensure!(
            values.len() == pixels,
            "channels",
            format!("{width} x {height} values for '{name}'"),
            values.len()
        );
        Ok(AnyChannel::new(text("channels", name)?, values.to_samples(progress)?))
    });
    let channels = AnyChannels::sort(channels.collect::<base::Result<_>>()?);
    let mut attributes = LayerAttributes::named(text("name", &part.name)?);
    for (name, value) in &part.attributes {
        let value = match value {
            Attribute::Text(value) => AttributeValue::Text(text("attributes", value)?),
            &Attribute::Vector([x, y, z]) => AttributeValue::FloatVec3((x, y, z)),
        };
        attributes.other.insert(text("attributes", name)?, value);
    }
    let encoding = Encoding { compression: Compression::ZIP16, ..Encoding::SMALL_LOSSLESS };
    Ok(Layer::new((part.width, part.height), attributes, encoding, channels))
}

fn part(layer: Layer<AnyChannels<FlatSamples>>) -> Part<'static> {
    let attributes = layer.attributes.other.iter().filter_map(|(name, value)| match value {
        AttributeValue::Text(value) => Some((name.to_string(), Attribute::Text(value.to_string()))),
        &AttributeValue::FloatVec3((x, y, z)) => Some((name.to_string(), Attribute::Vector([x, y, z]))),
        _ => None,
    });
    let mut attributes: Vec<_> = attributes.collect();
    attributes.sort_by(|a, b| a.0.cmp(&b.0));
    let channels = layer.channel_data.list.into_iter();
    Part {
        name: layer.attributes.layer_name.map(|name| name.to_string()).unwrap_or_default(),
        width: layer.size.width(),
        height: layer.size.height(),
        channels: channels.map(|channel| (channel.name.to_string(), Values::from(channel.sample_data))).collect(),
        attributes,
    }
}

fn text(argument: &'static str, value: &str) -> base::Result<Text> {
    Text::new_or_none(value).ok_or_else(|| base::Error::value(argument, "ASCII text", format!("'{value}'")))
}

impl Part<'_> {
    /// Returns the size of all channels, bytes.
    fn bytes(&self) -> usize {
        let value_bytes = |values: &Values<'_>| if matches!(values, Values::Half(_)) { 2 } else { 4 };
        self.channels.iter().map(|(_, values)| values.len() * value_bytes(values)).sum()
    }
}

impl Values<'_> {
    fn len(&self) -> usize {
        match self {
            Self::Half(values) => values.len(),
            Self::Float(values) => values.len(),
            Self::Unsigned(values) => values.len(),
        }
    }

    fn to_samples(&self, progress: &Progress) -> base::Result<FlatSamples> {
        Ok(match self {
            Self::Half(values) => FlatSamples::F16(copy(values, progress)?),
            Self::Float(values) => FlatSamples::F32(copy(values, progress)?),
            Self::Unsigned(values) => FlatSamples::U32(copy(values, progress)?),
        })
    }
}

/// Copies values, because the crate exr has to own them.
fn copy<T: Copy>(values: &[T], progress: &Progress) -> base::Result<Vec<T>> {
    /// Values between two checks for cancellation: milliseconds of copying.
    const CHUNK: usize = 1 << 20;
    let mut owned = try_with_capacity(values.len())?;
    for chunk in values.chunks(CHUNK) {
        progress.check()?;
        owned.extend_from_slice(chunk);
    }
    Ok(owned)
}

impl From<FlatSamples> for Values<'_> {
    fn from(samples: FlatSamples) -> Self {
        match samples {
            FlatSamples::F16(values) => Self::Half(values.into()),
            FlatSamples::F32(values) => Self::Float(values.into()),
            FlatSamples::U32(values) => Self::Unsigned(values.into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn example(name: &str, width: usize, height: usize) -> Part<'static> {
        let wild = [f32::INFINITY, -0.0, f32::MIN_POSITIVE, 1e-45, f32::MAX, 1.0 / 3.0];
        let pixels = width * height;
        Part {
            name: name.into(),
            width,
            height,
            channels: vec![
                ("B".into(), Values::Half((0..pixels).map(|i| f16::from_f32(i as f32 / 7.0)).collect())),
                ("object_id".into(), Values::Unsigned((0..pixels).map(|i| (i as u32).wrapping_sub(1)).collect())),
                ("range".into(), Values::Float((0..pixels).map(|i| wild[i % 6]).collect())),
            ],
            attributes: vec![
                ("center".into(), Attribute::Vector([1.0, -2.5, 1e30])),
                ("format".into(), Attribute::Text("a test".into())),
            ],
        }
    }

    #[test]
    fn parts_are_restored_bit_for_bit() {
        let parts = [example("px", 5, 3), example("nx", 33, 40), example("one", 1, 1)];
        assert_eq!(decode(&encode(&parts, &Progress::new()).unwrap(), &Progress::new()).unwrap(), parts);
        let single = [example("frame", 17, 9)];
        assert_eq!(decode(&encode(&single, &Progress::new()).unwrap(), &Progress::new()).unwrap(), single);
    }

    #[test]
    fn one_image_is_one_file() {
        let mut parts = [example("px", 5, 3), example("nx", 33, 40)];
        for part in &mut parts {
            part.attributes = (0..9).map(|i| (format!("a{i}"), Attribute::Vector([i as f32; 3]))).collect();
        }
        let bytes = encode(&parts, &Progress::new()).unwrap();
        // Nine attributes have the same order by chance once in 362,880 cases.
        assert!((0..6).all(|_| encode(&parts, &Progress::new()).unwrap() == bytes));
        assert_eq!(decode(&bytes, &Progress::new()).unwrap(), parts);
    }

    #[test]
    fn invalid_images_are_refused() {
        let good = encode(&[example("a", 8, 8)], &Progress::new()).unwrap();
        for cut in [0, 3, 40, good.len() / 2, good.len() - 1] {
            assert!(matches!(decode(&good[..cut], &Progress::new()), Err(base::Error::Format(_))), "{cut}");
        }
        let mut short = example("a", 8, 8);
        short.height = 9;
        assert!(encode(&[short], &Progress::new()).is_err());
        assert!(encode(&[example("twice", 2, 2), example("twice", 2, 2)], &Progress::new()).is_err());
    }

    #[test]
    fn damaged_files_neither_panic_nor_allocate_much() {
        let good = encode(&[example("a", 16, 20)], &Progress::new()).unwrap();
        for round in 0..2000 {
            let mut bytes = good.clone();
            for flip in 0..3 {
                let draw = crate::base::random::bits(1, round, flip);
                // Every other round changes the header, which contains the sizes.
                let reach = if round % 2 == 0 { 400.min(bytes.len()) } else { bytes.len() };
                bytes[draw as usize % reach] = (draw >> 40) as u8;
            }
            if let Ok(parts) = decode(&bytes, &Progress::new()) {
                assert!(parts.iter().map(|part| part.width * part.height).sum::<usize>() < 1 << 22);
            }
        }
    }
}
