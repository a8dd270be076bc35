//! Manifests of cached regions, and the files that they list.

use std::collections::BTreeMap;
use std::io::{self, Read};
use std::path::Path;

use bytes::Bytes;
use data_encoding::HEXLOWER;
use sha2::{Digest, Sha256};

use crate::file::open;

/// Name of a region's tileset.
pub const TILESET: &str = "tileset.json";
/// Folder of files in the cache.
pub const FILES: &str = "files";
/// Number of hexadecimal digits of a hash in the name of a manifest or a tileset.
pub const DIGITS: usize = 16;

/// A file that a manifest lists, or its tileset.
pub struct ListedFile {
    /// Path below the cache's folder.
    pub name: String,
    pub bytes: u64,
    pub sha256: String,
}

impl ListedFile {
    /// Name of the file within its region.
    pub fn name_in_region(&self) -> &str {
        if self.name.ends_with(TILESET) { TILESET } else { &self.name }
    }

    /// Whether the path is a plain file name below `files/`, without further folders.
    fn is_plain(&self) -> bool {
        let file = self.name.strip_prefix("files/").unwrap_or_default();
        let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || b".-_".contains(&byte);
        !file.starts_with('.') && !file.is_empty() && file.bytes().all(is_plain)
    }
}

/// All files that a manifest lists, and its tileset; none if the manifest is invalid.
pub fn parse_files(manifest: &[u8]) -> Option<Vec<ListedFile>> {
    #[derive(serde::Deserialize)]
    struct Entry {
        bytes: u64,
        sha256: String,
    }
    #[derive(serde::Deserialize)]
    struct Manifest {
        files: BTreeMap<String, Entry>,
        tileset: Option<Entry>,
    }
    let Manifest { mut files, tileset } = serde_json::from_slice(manifest).ok()?;
    if let Some(tileset) = tileset {
        // All regions name their tileset alike, so the cache names it by its hash.
        files.insert(format!("{FILES}/{}.{TILESET}", tileset.sha256.get(..DIGITS)?), tileset);
    }
    let listed = files.into_iter().map(|(name, Entry { bytes, sha256 })| ListedFile { name, bytes, sha256 });
    listed.map(|file| file.is_plain().then_some(file)).collect()
}

/// Reads a manifest, whose file name contains its hash; none if it is missing or damaged.
pub fn read_manifest(path: &Path) -> Option<Bytes> {
    let manifest = read(path).ok()?;
    let is_intact = path.to_string_lossy().ends_with(&format!(".{}.json", &hash(&manifest)[..DIGITS]));
    is_intact.then(|| manifest.into())
}

pub fn read(path: &Path) -> io::Result<Vec<u8>> {
    let mut data = Vec::new();
    open(path)?.read_to_end(&mut data)?;
    Ok(data)
}

pub fn hash(data: &[u8]) -> String {
    HEXLOWER.encode(&Sha256::digest(data))
}
