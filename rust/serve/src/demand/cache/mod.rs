//! Disk cache of complete regions with a limit in bytes; evicts the least recently used region.
//!
//! `at/` has the manifest of each region, named by its place; `files/` has the files of all regions, named by their
//! content. A manifest is written after its files, so that listed files are complete even after a crash. A file is
//! checked against its hash before its first use.

mod manifest;

use std::collections::HashMap;
use std::fs::{self, File, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use bytes::Bytes;
use parking_lot::Mutex;

use self::manifest::{DIGITS, FILES, ListedFile, TILESET, hash, parse_files, read, read_manifest};
use crate::file::Content;

/// Name of a region's manifest.
const MANIFEST: &str = "manifest.json";
/// Folder of manifests.
const PLACES: &str = "at";
/// File that is locked while the cache is open.
const LOCK: &str = "lock";
/// Suffix of incomplete files.
const PARTIAL: &str = ".part";

/// Cache of regions on disk.
pub struct Cache {
    folder: PathBuf,
    budget: u64,
    index: Mutex<Index>,
    /// Locked while the cache is open: a second server would remove files that this one is writing.
    lock: File,
}

#[derive(Default)]
struct Index {
    regions: HashMap<String, CachedRegion>,
    files: HashMap<String, CachedFile>,
}

struct CachedRegion {
    manifest: PathBuf,
    manifest_bytes: u64,
    files: Vec<String>,
    last_use: SystemTime,
}

#[derive(Clone)]
struct CachedFile {
    bytes: u64,
    sha256: String,
    /// Number of regions that have the file.
    region_count: usize,
    /// Whether the content has been compared with the hash since the start.
    is_checked: bool,
}

impl Cache {
    /// Opens the cache of a scene and cleans it up; creates the folder if necessary. None if another server uses it.
    /// Errors name the folder.
    pub fn open(folder: &Path, budget: u64) -> io::Result<Option<Self>> {
        let named = |error: io::Error| {
            io::Error::new(error.kind(), format!("{}: the cache cannot be opened: {error}", folder.display()))
        };
        Self::open_folder(folder, budget).map_err(named)
    }

    fn open_folder(folder: &Path, budget: u64) -> io::Result<Option<Self>> {
        for name in [FILES, PLACES] {
            fs::create_dir_all(folder.join(name))?;
        }
        // Links in the given path are resolved here; files below it are opened without following links.
        let folder = &fs::canonicalize(folder)?;
        let lock = File::create(folder.join(LOCK))?;
        match lock.try_lock() {
            Err(TryLockError::WouldBlock) => {
                tracing::warn!(folder = %folder.display(), "another server uses this cache: regions stay in memory");
                return Ok(None);
            }
            // Some file systems do not support locks.
            Ok(()) | Err(TryLockError::Error(_)) => {}
        }
        let cache = Cache { folder: folder.to_path_buf(), budget, index: Mutex::default(), lock };
        let mut index = cache.index.lock();
        for found in fs::read_dir(folder.join(PLACES))? {
            let path = found?.path();
            if cache.restore_region(&mut index, &path).is_none() {
                fs::remove_file(&path)?;
            }
        }
        // Files that no manifest lists are incomplete ones of an earlier run.
        for found in fs::read_dir(folder.join(FILES))? {
            let found = found?;
            if !found.file_name().to_str().is_some_and(|name| index.files.contains_key(&format!("{FILES}/{name}"))) {
                fs::remove_file(found.path())?;
            }
        }
        cache.trim(&mut index, None)?;
        drop(index);
        Ok(Some(cache))
    }

    /// Manifest of a place, if its region is cached and undamaged.
    pub fn find(&self, key: &str) -> Option<Bytes> {
        let mut index = self.index.lock();
        for name in index.regions.get(key)?.files.clone() {
            self.verify_file(&mut index, &name)?;
        }
        let region = index.regions.get_mut(key)?;
        let Some(manifest) = read_manifest(&region.manifest) else {
            tracing::warn!(place = key, "a manifest of the cache is damaged: its region is made again");
            self.remove_damaged(&mut index, key);
            return None;
        };
        region.last_use = SystemTime::now();
        // The modification time stores the last use across restarts; a failure to write it is harmless.
        let manifest_file = File::options().append(true).open(&region.manifest);
        let _ = manifest_file.and_then(|file| file.set_modified(region.last_use));
        Some(manifest)
    }

    /// A file of a cached region.
    pub fn file(&self, name: &str) -> Option<Content> {
        let bytes = self.verify_file(&mut self.index.lock(), name)?;
        Some(Content::File(self.folder.join(name), bytes))
    }

    /// Tileset of a cached region, found by its manifest.
    pub fn tileset(&self, manifest: &[u8]) -> Option<Content> {
        let listed = parse_files(manifest)?;
        self.file(&listed.iter().find(|file| file.name_in_region() == TILESET)?.name)
    }

    /// Size of a file, checked against its hash at first use. A damaged file is removed with all regions that need
    /// it.
    fn verify_file(&self, index: &mut Index, name: &str) -> Option<u64> {
        let stored = index.files.get_mut(name)?;
        let path = self.folder.join(name);
        let has_hash = |path| read(path).is_ok_and(|data| hash(&data) == stored.sha256);
        if is_file_of_size(&path, stored.bytes) && (stored.is_checked || has_hash(&path)) {
            stored.is_checked = true;
            return Some(stored.bytes);
        }
        tracing::warn!(file = name, "a file of the cache is damaged: its regions are made again");
        let needs_file = |region: &CachedRegion| region.files.iter().any(|file| file == name);
        let damaged = index.regions.iter().filter(|(_, region)| needs_file(region)).map(|(key, _)| key.clone());
        for key in damaged.collect::<Vec<_>>() {
            self.remove_damaged(index, &key);
        }
        None
    }

    /// Stores a region: its manifest, and the files that it lists.
    pub fn store(&self, key: &str, content: &HashMap<String, Bytes>) -> io::Result<()> {
        let missing = |what: &str| io::Error::new(io::ErrorKind::InvalidData, format!("{what} of a region is missing"));
        let manifest = content.get(MANIFEST).ok_or_else(|| missing("the manifest"))?;
        let listed = parse_files(manifest).ok_or_else(|| missing("the list of files"))?;
        let mut index = self.index.lock();
        let path = self.folder.join(PLACES).join(format!("{key}.{}.json", &hash(manifest)[..DIGITS]));
        let new: Vec<&ListedFile> = listed.iter().filter(|file| !index.files.contains_key(&file.name)).collect();
        let written = new.iter().try_for_each(|file| {
            let data = content.get(file.name_in_region()).ok_or_else(|| missing(&file.name))?;
            write_atomically(&self.folder.join(&file.name), data)
        });
        if let Err(error) = written.and_then(|()| write_atomically(&path, manifest)) {
            for file in new {
                // Incomplete regions must not fill a full disk.
                let _ = fs::remove_file(self.folder.join(&file.name));
            }
            return Err(error);
        }
        index.add(key, path, manifest.len() as u64, listed, None);
        self.trim(&mut index, Some(key))
    }

    /// Unlocks the folder for other servers; the system unlocks it at process exit at the latest.
    pub fn close(&self) {
        let _ = self.lock.unlock();
    }

    /// Bytes on disk.
    pub fn bytes(&self) -> u64 {
        self.index.lock().bytes()
    }

    /// Adds the region of a manifest that an earlier run wrote; none if the manifest is damaged, or a file is missing
    /// or has another size.
    fn restore_region(&self, index: &mut Index, path: &Path) -> Option<()> {
        let name = path.file_name()?.to_str()?.strip_suffix(".json")?;
        let (key, _) = name.rsplit_once('.')?;
        let manifest = read_manifest(path)?;
        let listed = parse_files(&manifest)?;
        if !listed.iter().all(|file| is_file_of_size(&self.folder.join(&file.name), file.bytes)) {
            return None;
        }
        let last_use = fs::metadata(path).ok()?.modified().ok()?;
        index.add(key, path.to_path_buf(), manifest.len() as u64, listed, Some(last_use));
        Some(())
    }

    /// Evicts the least recently used regions, except `newest`, until the rest fits the budget.
    fn trim(&self, index: &mut Index, newest: Option<&str>) -> io::Result<()> {
        while index.bytes() > self.budget {
            let others = index.regions.iter().filter(|(key, _)| Some(key.as_str()) != newest);
            let Some(key) = others.min_by_key(|(_, region)| region.last_use).map(|(key, _)| key.clone()) else { break };
            self.remove(index, &key)?;
        }
        Ok(())
    }

    fn remove(&self, index: &mut Index, key: &str) -> io::Result<()> {
        let Some(region) = index.regions.remove(key) else { return Ok(()) };
        // The manifest is removed first, so that no manifest lists missing files.
        ignore_missing(fs::remove_file(&region.manifest))?;
        for name in region.files {
            let Some(file) = index.files.get_mut(&name) else { continue };
            file.region_count -= 1;
            if file.region_count == 0 {
                index.files.remove(&name);
                ignore_missing(fs::remove_file(self.folder.join(&name)))?;
            }
        }
        Ok(())
    }

    fn remove_damaged(&self, index: &mut Index, key: &str) {
        if let Err(error) = self.remove(index, key) {
            tracing::warn!(place = key, %error, "a damaged region cannot be removed from the cache");
        }
    }
}

impl Index {
    /// Adds a region. `last_use` is known for regions of an earlier run, whose files are yet to be checked; none if the
    /// files were just written.
    fn add(&mut self, key: &str, manifest: PathBuf, bytes: u64, listed: Vec<ListedFile>, last_use: Option<SystemTime>) {
        for ListedFile { name, bytes, sha256 } in &listed {
            let (bytes, sha256, is_checked) = (*bytes, sha256.clone(), last_use.is_none());
            let file = CachedFile { bytes, sha256, region_count: 0, is_checked };
            self.files.entry(name.clone()).or_insert(file).region_count += 1;
        }
        let files = listed.into_iter().map(|file| file.name).collect();
        let last_use = last_use.unwrap_or_else(SystemTime::now);
        self.regions.insert(key.to_owned(), CachedRegion { manifest, manifest_bytes: bytes, files, last_use });
    }

    fn bytes(&self) -> u64 {
        let manifests: u64 = self.regions.values().map(|region| region.manifest_bytes).sum();
        manifests + self.files.values().map(|file| file.bytes).sum::<u64>()
    }
}

fn is_file_of_size(path: &Path, bytes: u64) -> bool {
    fs::symlink_metadata(path).is_ok_and(|found| found.is_file() && found.len() == bytes)
}

/// Writes a file under a temporary name and renames it, without fsync: hashes detect data that the disk has lost.
fn write_atomically(path: &Path, data: &[u8]) -> io::Result<()> {
    let mut temporary = path.as_os_str().to_owned();
    temporary.push(PARTIAL);
    let written = File::create(&temporary).and_then(|mut file| file.write_all(data));
    written.and_then(|()| fs::rename(&temporary, path)).inspect_err(|_| _ = fs::remove_file(&temporary))
}

/// Counts a file that does not exist as removed.
fn ignore_missing(removed: io::Result<()>) -> io::Result<()> {
    match removed {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests;
