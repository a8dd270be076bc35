//! Opens files without following links, in the file's place or in a folder above: a link may lead anywhere.

use std::fs::{self, File};
use std::io;
use std::path::Path;

pub use system::{open_now, read_now};

/// Opens a file by its absolute path. May wait for the disk.
pub fn open(path: &Path) -> io::Result<File> {
    system::open(path).unwrap_or_else(|| open_checked(path))
}

/// Fallback for systems that cannot refuse links in a path: checks each folder first.
fn open_checked(path: &Path) -> io::Result<File> {
    for ancestor in path.ancestors().filter(|ancestor| !ancestor.as_os_str().is_empty()) {
        if fs::symlink_metadata(ancestor)?.is_symlink() {
            return Err(io::Error::other(format!("{}: expected no link", ancestor.display())));
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

    /// None if the kernel or a sandbox does not support the call.
    pub fn open(path: &Path) -> Option<io::Result<File>> {
        match resolved(path, ResolveFlags::empty()) {
            Err(Errno::NOSYS | Errno::PERM) => None,
            found => Some(found.map_err(io::Error::from)),
        }
    }

    /// Opens a file if its path is in the kernel's cache; none if unknown.
    pub fn open_now(path: &Path) -> Option<io::Result<File>> {
        match resolved(path, ResolveFlags::CACHED) {
            Err(Errno::AGAIN | Errno::INVAL | Errno::NOSYS | Errno::PERM) => None,
            found => Some(found.map_err(io::Error::from)),
        }
    }

    /// Non-blocking, so that opening a pipe in place of a file does not hang.
    fn resolved(path: &Path, extra_flags: ResolveFlags) -> Result<File, Errno> {
        let flags = OFlags::RDONLY | OFlags::CLOEXEC | OFlags::NOCTTY | OFlags::NONBLOCK;
        openat2(CWD, path, flags, Mode::empty(), extra_flags | ResolveFlags::NO_SYMLINKS).map(File::from)
    }

    /// Reads bytes from the page cache; none if that would wait for the disk.
    pub fn read_now(file: &File, buffer: &mut [u8], offset: u64) -> Option<usize> {
        preadv2(file, &mut [IoSliceMut::new(buffer)], offset, ReadWriteFlags::NOWAIT).ok()
    }
}

#[cfg(not(target_os = "linux"))]
mod system {
    use super::{File, Path, io};

    pub fn open(_: &Path) -> Option<io::Result<File>> {
        None
    }

    pub fn open_now(_: &Path) -> Option<io::Result<File>> {
        None
    }

    pub fn read_now(_: &File, _: &mut [u8], _: u64) -> Option<usize> {
        None
    }
}

#[cfg(all(test, unix))]
mod tests;
