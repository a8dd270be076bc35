//! Files on disk as response bodies. Blocking threads are used only for reads that would wait for the disk.

use std::fs::File;
use std::io;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use axum::body::Body;
use bytes::Bytes;
use futures_util::stream;

use crate::open;

/// Bytes per read.
const PIECE_BYTES: u64 = 1 << 18;

/// An open file whose size has been checked.
pub struct Opened(Arc<File>);

/// Opens a file and checks its size.
pub async fn open(path: &Path, bytes: u64) -> io::Result<Opened> {
    let file = match open::open_now(path) {
        Some(opened) => opened?,
        None => {
            let path = path.to_path_buf();
            in_thread(move || open::open(&path)).await?
        }
    };
    let found = file.metadata()?;
    if !found.is_file() || found.len() != bytes {
        let message = format!("{}: expected a file of {bytes} bytes, got {}", path.display(), found.len());
        return Err(io::Error::new(io::ErrorKind::InvalidData, message));
    }
    Ok(Opened(Arc::new(file)))
}

impl Opened {
    /// Reads a range of bytes.
    pub async fn bytes(&self, part: Range<u64>) -> io::Result<Bytes> {
        let count = usize::try_from(part.end - part.start).map_err(io::Error::other)?;
        let mut data = vec![0; count];
        let mut ready = 0;
        while ready < count {
            match open::read_now(&self.0, &mut data[ready..], part.start + ready as u64) {
                Some(length) if length > 0 => ready += length,
                _ => break,
            }
        }
        if ready == count {
            return Ok(data.into());
        }
        let file = Arc::clone(&self.0);
        in_thread(move || read_exact_at(&file, &mut data[ready..], part.start + ready as u64).map(|()| data.into()))
            .await
    }

    /// Creates a body from a range. The first piece is read at once, so that an error can still set the status code.
    pub async fn body(self, part: Range<u64>) -> io::Result<Body> {
        let first = self.bytes(piece(&part)).await?;
        if first.len() as u64 == part.end - part.start {
            return Ok(first.into());
        }
        let remaining = part.start + first.len() as u64..part.end;
        Ok(Body::from_stream(stream::unfold((self, Some(first), remaining), next)))
    }
}

/// State of the stream: the file, the piece that was read already, and the remaining range.
type State = (Opened, Option<Bytes>, Range<u64>);

async fn next((file, first, remaining): State) -> Option<(io::Result<Bytes>, State)> {
    if let Some(first) = first {
        return Some((Ok(first), (file, None, remaining)));
    }
    if remaining.is_empty() {
        return None;
    }
    let piece = piece(&remaining);
    let piece_end = piece.end;
    let data = file.bytes(piece).await;
    // Nothing follows an error.
    let next_start = if data.is_ok() { piece_end } else { remaining.end };
    Some((data, (file, None, next_start..remaining.end)))
}

/// First piece of a range.
fn piece(part: &Range<u64>) -> Range<u64> {
    part.start..part.end.min(part.start + PIECE_BYTES)
}

async fn in_thread<T: Send + 'static>(work: impl FnOnce() -> io::Result<T> + Send + 'static) -> io::Result<T> {
    tokio::task::spawn_blocking(work).await.map_err(io::Error::other)?
}

#[cfg(unix)]
fn read_exact_at(file: &File, buffer: &mut [u8], offset: u64) -> io::Result<()> {
    std::os::unix::fs::FileExt::read_exact_at(file, buffer, offset)
}

#[cfg(not(unix))]
fn read_exact_at(mut file: &File, buffer: &mut [u8], offset: u64) -> io::Result<()> {
    use std::io::{Read, Seek, SeekFrom};
    file.seek(SeekFrom::Start(offset))?;
    file.read_exact(buffer)
}

#[cfg(all(test, unix))]
mod tests;
