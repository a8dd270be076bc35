//! Content of documents: in memory, in files, or elsewhere. Blocking threads are used only for reads that would wait
//! for the disk. No link in a file's path is followed, because it may lead out of the served folder.

use std::fs::{self, File};
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use axum::body::Body;
use bytes::Bytes;
use futures_util::stream;

use self::system::{open_cached, read_cached};

/// Bytes per read.
const PIECE_BYTES: u64 = 1 << 18;

/// Reads a document that is neither in memory nor on a local disk.
pub type Read = dyn Fn() -> io::Result<Bytes> + Send + Sync;

/// Location of a document's content.
#[derive(Clone)]
pub enum Content {
    /// In memory.
    Bytes(Bytes),
    /// Path and size of a file.
    File(PathBuf, u64),
    /// Elsewhere, for example on a remote store.
    Elsewhere(Arc<Read>),
}

/// Content that is ready to be read.
pub enum Opened {
    Bytes(Bytes),
    /// A file whose size has been checked.
    File(Arc<File>),
}

impl Content {
    /// Text that differs after each change of a file; empty for other content.
    pub async fn version(&self) -> io::Result<String> {
        let Content::File(path, bytes) = self else { return Ok(String::new()) };
        version(&open_of_size(path, *bytes).await?.metadata()?)
    }

    /// Opens the content; also returns its size in bytes.
    pub async fn open(&self) -> io::Result<(u64, Opened)> {
        match self {
            Content::Bytes(data) => Ok((data.len() as u64, Opened::Bytes(data.clone()))),
            Content::File(path, bytes) => Ok((*bytes, Opened::File(open_of_size(path, *bytes).await?))),
            Content::Elsewhere(read) => {
                let read = Arc::clone(read);
                let data = run_blocking(move || read()).await?;
                Ok((data.len() as u64, Opened::Bytes(data)))
            }
        }
    }
}

impl Opened {
    /// Reads a range of bytes.
    pub async fn bytes(&self, part: Range<u64>) -> io::Result<Bytes> {
        let file = match self {
            Opened::Bytes(data) => {
                let index = |offset: u64| usize::try_from(offset).unwrap_or(usize::MAX).min(data.len());
                return Ok(data.slice(index(part.start)..index(part.end)));
            }
            Opened::File(file) => file,
        };
        let count = usize::try_from(part.end - part.start).map_err(io::Error::other)?;
        let mut data = vec![0; count];
        let mut read_count = 0;
        while read_count < count {
            match read_cached(file, &mut data[read_count..], part.start + read_count as u64) {
                Some(length) if length > 0 => read_count += length,
                _ => break,
            }
        }
        if read_count == count {
            return Ok(data.into());
        }
        let file = Arc::clone(file);
        run_blocking(move || {
            read_exact_at(&file, &mut data[read_count..], part.start + read_count as u64)?;
            Ok(data.into())
        })
        .await
    }

    /// Creates a body from a range. The first piece is read at once, so that an error can still set the status code.
    pub async fn body(self, part: Range<u64>) -> io::Result<Body> {
        let first_part = if let Opened::File(_) = self { first_piece(&part) } else { part.clone() };
        let first = self.bytes(first_part).await?;
        if first.len() as u64 == part.end - part.start {
            return Ok(first.into());
        }
        let remaining = part.start + first.len() as u64..part.end;
        Ok(Body::from_stream(stream::unfold((self, Some(first), remaining), next_piece)))
    }
}

/// State of the stream: the file, a piece that was read already, and the range that remains.
type State = (Opened, Option<Bytes>, Range<u64>);

async fn next_piece((file, first, remaining): State) -> Option<(io::Result<Bytes>, State)> {
    if let Some(first) = first {
        return Some((Ok(first), (file, None, remaining)));
    }
    if remaining.is_empty() {
        return None;
    }
    let piece = first_piece(&remaining);
    let piece_end = piece.end;
    let data = file.bytes(piece).await;
    // An error ends the stream.
    let next_start = if data.is_ok() { piece_end } else { remaining.end };
    Some((data, (file, None, next_start..remaining.end)))
}

/// First piece of a range.
fn first_piece(part: &Range<u64>) -> Range<u64> {
    part.start..part.end.min(part.start + PIECE_BYTES)
}

async fn run_blocking<T: Send + 'static>(work: impl FnOnce() -> io::Result<T> + Send + 'static) -> io::Result<T> {
    tokio::task::spawn_blocking(work).await.map_err(io::Error::other)?
}

#[cfg(unix)]
fn version(metadata: &fs::Metadata) -> io::Result<String> {
    use std::os::unix::fs::MetadataExt;
    // A copy may keep its original's mtime, but not its ctime. Files written within one clock tick differ by their
    // inodes.
    Ok(format!("{}.{}.{}", metadata.ctime(), metadata.ctime_nsec(), metadata.ino()))
}

#[cfg(not(unix))]
fn version(metadata: &fs::Metadata) -> io::Result<String> {
    let since_epoch = metadata.modified()?.duration_since(std::time::SystemTime::UNIX_EPOCH);
    Ok(since_epoch.unwrap_or_default().as_nanos().to_string())
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

/// Opens a file and checks its size.
async fn open_of_size(path: &Path, bytes: u64) -> io::Result<Arc<File>> {
    let file = match open_cached(path) {
        Some(opened) => opened?,
        None => {
            let path = path.to_path_buf();
            run_blocking(move || open(&path)).await?
        }
    };
    let metadata = file.metadata()?;
    if !metadata.is_file() || metadata.len() != bytes {
        let message = format!("{}: expected a file of {bytes} bytes, got {}", path.display(), metadata.len());
        return Err(io::Error::new(io::ErrorKind::InvalidData, message));
    }
    Ok(Arc::new(file))
}

/// Opens a file by its absolute path. May wait for the disk.
pub fn open(path: &Path) -> io::Result<File> {
    system::open(path).unwrap_or_else(|| open_checked(path))
}

/// Fallback for systems that cannot refuse links in a path: checks each folder first.
fn open_checked(path: &Path) -> io::Result<File> {
    for ancestor in path.ancestors().filter(|ancestor| !ancestor.as_os_str().is_empty()) {
        if fs::symlink_metadata(ancestor)?.is_symlink() {
            return Err(io::Error::other(format!("{}: expected a path without links", ancestor.display())));
        }
    }
    let mut options = File::options();
    options.read(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::custom_flags(&mut options, libc::O_NOFOLLOW | libc::O_NONBLOCK);
    options.open(path)
}

#[cfg(target_os = "linux")]
mod system {
    use std::io::IoSliceMut;

    use rustix::fs::{CWD, Mode, OFlags, ResolveFlags, openat2};
    use rustix::io::{Errno, ReadWriteFlags, preadv2};

    use super::{File, Path, io};

    /// Opens a file without following links; none if the kernel or a sandbox does not support the call.
    pub fn open(path: &Path) -> Option<io::Result<File>> {
        match open_with(path, ResolveFlags::empty()) {
            Err(Errno::NOSYS | Errno::PERM) => None,
            opened => Some(opened.map_err(io::Error::from)),
        }
    }

    /// Like `open`, but only if the path is in the kernel's cache, so that the call does not wait for the disk.
    pub fn open_cached(path: &Path) -> Option<io::Result<File>> {
        match open_with(path, ResolveFlags::CACHED) {
            Err(Errno::AGAIN | Errno::INVAL | Errno::NOSYS | Errno::PERM) => None,
            opened => Some(opened.map_err(io::Error::from)),
        }
    }

    /// `NONBLOCK`, so that opening a pipe in place of a file does not hang.
    fn open_with(path: &Path, extra_flags: ResolveFlags) -> Result<File, Errno> {
        let flags = OFlags::RDONLY | OFlags::CLOEXEC | OFlags::NOCTTY | OFlags::NONBLOCK;
        openat2(CWD, path, flags, Mode::empty(), extra_flags | ResolveFlags::NO_SYMLINKS).map(File::from)
    }

    /// Reads bytes from the page cache; none if that would wait for the disk.
    pub fn read_cached(file: &File, buffer: &mut [u8], offset: u64) -> Option<usize> {
        preadv2(file, &mut [IoSliceMut::new(buffer)], offset, ReadWriteFlags::NOWAIT).ok()
    }
}

#[cfg(not(target_os = "linux"))]
mod system {
    use super::{File, Path, io};

    pub fn open(_: &Path) -> Option<io::Result<File>> {
        None
    }

    pub fn open_cached(_: &Path) -> Option<io::Result<File>> {
        None
    }

    pub fn read_cached(_: &File, _: &mut [u8], _: u64) -> Option<usize> {
        None
    }
}

#[cfg(all(test, unix))]
mod tests;
