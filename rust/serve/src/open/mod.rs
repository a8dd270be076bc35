//! Opens files without following links, in the file's place or in a folder above: a link may lead anywhere.

use std::fs::{self, File};
use std::io;
use std::path::Path;

/// Opens a file by its absolute path. May wait for the disk.
pub fn open(path: &Path) -> io::Result<File> {
    system::open(path).unwrap_or_else(|| open_checked(path))
}

/// Opens a file if its path is in the kernel's cache; none if unknown.
pub fn open_now(path: &Path) -> Option<io::Result<File>> {
    system::open_now(path)
}

/// Reads bytes from the page cache; none if that would wait for the disk.
pub fn read_now(file: &File, into: &mut [u8], place: u64) -> Option<usize> {
    system::read_now(file, into, place)
}

/// Fallback for systems that cannot refuse links in a path: checks each folder first.
fn open_checked(path: &Path) -> io::Result<File> {
    for above in path.ancestors().filter(|above| !above.as_os_str().is_empty()) {
        if fs::symlink_metadata(above)?.is_symlink() {
            return Err(io::Error::other(format!("{}: expected no link", above.display())));
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
    use std::fs::File;
    use std::io::{self, IoSliceMut};
    use std::path::Path;

    use rustix::fs::{CWD, Mode, OFlags, ResolveFlags, openat2};
    use rustix::io::{Errno, ReadWriteFlags, preadv2};

    /// None if the kernel or a sandbox does not support the call.
    pub fn open(path: &Path) -> Option<io::Result<File>> {
        match resolved(path, ResolveFlags::empty()) {
            Err(Errno::NOSYS | Errno::PERM) => None,
            found => Some(found.map_err(io::Error::from)),
        }
    }

    pub fn open_now(path: &Path) -> Option<io::Result<File>> {
        match resolved(path, ResolveFlags::CACHED) {
            Err(Errno::AGAIN | Errno::INVAL | Errno::NOSYS | Errno::PERM) => None,
            found => Some(found.map_err(io::Error::from)),
        }
    }

    /// Non-blocking, so that opening a pipe in place of a file does not hang.
    fn resolved(path: &Path, how: ResolveFlags) -> Result<File, Errno> {
        let flags = OFlags::RDONLY | OFlags::CLOEXEC | OFlags::NOCTTY | OFlags::NONBLOCK;
        openat2(CWD, path, flags, Mode::empty(), how | ResolveFlags::NO_SYMLINKS).map(File::from)
    }

    pub fn read_now(file: &File, into: &mut [u8], place: u64) -> Option<usize> {
        preadv2(file, &mut [IoSliceMut::new(into)], place, ReadWriteFlags::NOWAIT).ok()
    }
}

#[cfg(not(target_os = "linux"))]
mod system {
    use std::fs::File;
    use std::io;
    use std::path::Path;

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
