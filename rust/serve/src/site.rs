//! Served documents in a table by name, so that no request is ever turned into a file path.

use std::collections::HashMap;
use std::sync::Arc;

use bytes::Bytes;
use data_encoding::HEXLOWER;
use sha2::{Digest, Sha256};

use crate::demand::Demand;
use crate::gzip;

pub use crate::file::{Content, Read};

/// Suffixes of files whose content is compressed already. Files without a suffix, the shards of Zarr, are compressed,
/// too.
const COMPRESSED_SUFFIXES: [&str; 2] = [".webp", ".range"];
/// Number of hexadecimal digits of a hash in a tag.
const DIGITS: usize = 32;

/// A served document.
#[derive(Clone)]
pub struct Document {
    /// Location of the content.
    pub content: Content,
    /// Media type.
    pub media: String,
    /// Whether the name identifies the content, so that clients may cache it for ever.
    pub is_immutable: bool,
    /// Whether the content is uncompressed.
    pub is_compressible: bool,
    /// Entity tag, which identifies the version.
    pub tag: String,
}

impl Document {
    /// Creates a document whose name identifies its content. The tag is the full path, because leaves of a tree have
    /// files of the same name in different folders.
    pub fn immutable(name: &str, content: Content, media: &str) -> Self {
        let last = name.rsplit('/').next().unwrap_or(name);
        let tag = format!("\"{name}\"");
        let is_compressible = last.contains('.') && !COMPRESSED_SUFFIXES.iter().any(|end| name.ends_with(end));
        Document { content, media: media.to_owned(), is_immutable: true, is_compressible, tag }
    }

    /// Creates a document whose tag identifies its content, but whose name may have another content later.
    pub fn revalidated(tag: &str, content: Content, media: &str) -> Self {
        Document { is_immutable: false, ..Self::immutable(tag, content, media) }
    }

    /// Creates a document that may change.
    pub fn mutable(data: Bytes, media: &str) -> Self {
        let tag = format!("\"{}\"", HEXLOWER.encode(&Sha256::digest(&data)[..DIGITS / 2]));
        let (content, media) = (Content::Bytes(data), media.to_owned());
        Document { content, media, is_immutable: false, is_compressible: true, tag }
    }

    /// Whether a compressed copy may be worthwhile.
    pub fn is_worth_compressing(&self) -> bool {
        let bytes = match &self.content {
            Content::Bytes(data) => data.len() as u64,
            Content::File(_, bytes) => *bytes,
            // The size is unknown before reading.
            Content::Elsewhere(_) => gzip::MIN_BYTES,
        };
        self.is_compressible && (gzip::MIN_BYTES..=gzip::MAX_BYTES).contains(&bytes)
    }
}

/// One bundle or scene, with its page.
#[derive(Clone, Default)]
pub struct Site {
    /// Documents by their path below the site.
    pub documents: HashMap<String, Document>,
    /// Makes regions of the scene on demand.
    pub demand: Option<Arc<Demand>>,
}

/// Sites by the first segment of their paths; the site with the empty name serves all other paths.
pub type Sites = HashMap<String, Site>;

/// Finds the site of a path without its leading slash; also returns the rest of the path.
pub fn find_site<'a, 'b>(sites: &'a Sites, path: &'b str) -> Option<(&'a Site, &'b str)> {
    let named = path.split_once('/').and_then(|(name, rest)| Some((sites.get(name)?, rest)));
    named.filter(|_| !path.starts_with('/')).or_else(|| Some((sites.get("")?, path)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_lead_to_sites() {
        let one: Sites = [(String::new(), Site::default()), ("c".to_owned(), Site::default())].into();
        for (path, name) in [("a/b", "a/b"), ("c/b", "b"), ("/c/b", "/c/b"), ("", "")] {
            assert_eq!(find_site(&one, path).map(|found| found.1), Some(name));
        }
        let two: Sites = [("a".to_owned(), Site::default()), ("b c".to_owned(), Site::default())].into();
        assert_eq!(find_site(&two, "a/x/y").map(|found| found.1), Some("x/y"));
        assert_eq!(find_site(&two, "b c/").map(|found| found.1), Some(""));
        for path in ["", "a", "c/x", "../a/x", "/a/x", "A/x"] {
            assert!(find_site(&two, path).is_none(), "{path}");
        }
    }

    #[test]
    fn tags_distinguish_content() {
        let [first, second] =
            ["one", "two"].map(|text| Document::mutable(Bytes::from_static(text.as_bytes()), "text/plain"));
        assert_ne!(first.tag, second.tag);
        assert_eq!(first.tag.len(), DIGITS + 2);
        let named = Document::immutable("files/0123.glb", first.content, "model/gltf-binary");
        assert_eq!(named.tag, "\"files/0123.glb\"");
        assert!(named.is_compressible);
        let [one, other] =
            ["0/7.glb", "1/7.glb"].map(|name| Document::immutable(name, named.content.clone(), "model/gltf-binary"));
        assert_ne!(one.tag, other.tag);
        // Compressed copies are cached by tag, which all versions of a shard's path share.
        let shard = Document::immutable("0/py/depth/c/0/0/0/0/0/0", named.content, "application/octet-stream");
        assert!(!shard.is_compressible);
    }
}
