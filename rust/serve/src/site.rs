//! Documents that are served, in a table by name, so that no request becomes a path.

use std::collections::HashMap;
use std::fmt::Write;
use std::io;
use std::path::PathBuf;
use std::sync::Arc;

use bytes::Bytes;
use sha2::{Digest, Sha256};

use crate::demand::Demand;
use crate::packed;

/// Ends of names of files whose content is compressed; that of files without an end, the shards of Zarr, is, too.
const COMPRESSED: [&str; 2] = [".webp", ".range"];
/// Hexadecimal digits of a hash in a tag.
const DIGITS: usize = 32;

/// Reads a document that lies neither in memory nor on this machine's disk.
pub type Read = dyn Fn() -> io::Result<Bytes> + Send + Sync;

/// Where a document's content is.
#[derive(Clone)]
pub enum Content {
    /// In memory.
    Bytes(Bytes),
    /// In a file, which has so many bytes.
    File(PathBuf, u64),
    /// Elsewhere.
    Elsewhere(Arc<Read>),
}

/// A document that is served.
#[derive(Clone)]
pub struct Document {
    /// Where its content is.
    pub content: Content,
    /// Media type.
    pub media: String,
    /// Its name is that of its content: clients may keep it for ever.
    pub is_immutable: bool,
    /// Its content is not compressed yet.
    pub is_compressible: bool,
    /// Tells versions of it apart.
    pub tag: String,
}

impl Document {
    /// A document whose name is that of its content. All of the name is its tag: leaves of a tree have files of one name
    /// in different folders.
    pub fn named(name: &str, content: Content, media: &str) -> Self {
        let last = name.rsplit('/').next().unwrap_or(name);
        let tag = format!("\"{name}\"");
        let is_compressible = last.contains('.') && !COMPRESSED.iter().any(|end| name.ends_with(end));
        Document { content, media: media.to_owned(), is_immutable: true, is_compressible, tag }
    }

    /// A document that may change.
    pub fn changing(data: Bytes, media: &str) -> Self {
        let mut tag = String::from("\"");
        for byte in &Sha256::digest(&data)[..DIGITS / 2] {
            let _ = write!(tag, "{byte:02x}");
        }
        tag.push('"');
        Document {
            content: Content::Bytes(data),
            media: media.to_owned(),
            is_immutable: false,
            is_compressible: true,
            tag,
        }
    }

    /// Whether a compressed copy may be worth making.
    pub fn is_worth_packing(&self) -> bool {
        let bytes = match &self.content {
            Content::Bytes(data) => data.len() as u64,
            Content::File(_, bytes) => *bytes,
            // Not known until it is read.
            Content::Elsewhere(_) => packed::LEAST,
        };
        self.is_compressible && (packed::LEAST..=packed::MOST).contains(&bytes)
    }
}

/// One bundle or scene, with the page that shows it.
#[derive(Clone, Default)]
pub struct Site {
    /// Documents by their path below the site.
    pub documents: HashMap<String, Document>,
    /// Makes regions of the scene on demand.
    pub demand: Option<Arc<Demand>>,
}

/// Sites by the first part of their paths; the one with the empty name has all other paths.
pub type Sites = HashMap<String, Site>;

/// The site of a path without its leading slash, and the rest of the path.
pub fn find<'a, 'b>(sites: &'a Sites, path: &'b str) -> Option<(&'a Site, &'b str)> {
    let below = path.split_once('/').and_then(|(name, rest)| Some((sites.get(name)?, rest)));
    below.filter(|_| !path.starts_with('/')).or_else(|| Some((sites.get("")?, path)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_lead_to_sites() {
        let one: Sites = [(String::new(), Site::default()), ("c".to_owned(), Site::default())].into();
        for (path, name) in [("a/b", "a/b"), ("c/b", "b"), ("/c/b", "/c/b"), ("", "")] {
            assert_eq!(find(&one, path).map(|found| found.1), Some(name));
        }
        let two: Sites = [("a".to_owned(), Site::default()), ("b c".to_owned(), Site::default())].into();
        assert_eq!(find(&two, "a/x/y").map(|found| found.1), Some("x/y"));
        assert_eq!(find(&two, "b c/").map(|found| found.1), Some(""));
        for path in ["", "a", "c/x", "../a/x", "/a/x", "A/x"] {
            assert!(find(&two, path).is_none(), "{path}");
        }
    }

    #[test]
    fn tags_tell_content_apart() {
        let [first, second] =
            ["one", "two"].map(|text| Document::changing(Bytes::from_static(text.as_bytes()), "text/plain"));
        assert_ne!(first.tag, second.tag);
        assert_eq!(first.tag.len(), DIGITS + 2);
        let named = Document::named("files/0123.glb", first.content, "model/gltf-binary");
        assert_eq!(named.tag, "\"files/0123.glb\"");
        assert!(named.is_compressible);
        let [one, other] =
            ["0/7.glb", "1/7.glb"].map(|name| Document::named(name, named.content.clone(), "model/gltf-binary"));
        assert_ne!(one.tag, other.tag);
        // Copies that are packed are kept by their tags, which shards share.
        let shard = Document::named("0/py/depth/c/0/0/0/0/0/0", named.content, "application/octet-stream");
        assert!(!shard.is_compressible);
    }
}
