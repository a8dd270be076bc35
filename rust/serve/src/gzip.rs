//! Documents compressed with gzip at the first request, and cached in memory with a limit in bytes.

use std::collections::HashMap;
use std::io::{self, Write};
use std::sync::Arc;

use bytes::Bytes;
use flate2::Compression;
use flate2::write::GzEncoder;
use parking_lot::Mutex;
use tokio::sync::{OnceCell, Semaphore};

/// Larger documents, in bytes, are sent uncompressed: compression would take too long.
pub const MAX_BYTES: u64 = 1 << 26;
/// Smaller documents, in bytes, are sent uncompressed: they fit into one packet.
pub const MIN_BYTES: u64 = 1 << 10;
/// Maximum ratio of compressed to original size at which the compressed copy is used.
const MAX_RATIO: f64 = 0.95;
/// Maximum number of concurrent compressions.
const MAX_CONCURRENT: usize = 2;
/// Approximate memory of a cache entry in addition to its copy, bytes.
const ENTRY_BYTES: u64 = 200;

/// A compressed copy; none if compression saves too little.
type CompressedCopy = Option<Bytes>;

/// Cache of compressed copies, by the tags of their documents.
pub struct GzipCache {
    budget: u64,
    state: Mutex<State>,
    compressions: Semaphore,
}

#[derive(Default)]
struct State {
    copies: HashMap<String, Entry>,
    /// Total size of all entries, bytes.
    total_bytes: u64,
    use_count: u64,
}

#[derive(Default)]
struct Entry {
    cell: Arc<OnceCell<CompressedCopy>>,
    /// Number of the last use, in the order of all uses.
    last_use: u64,
    /// Size of the entry in bytes; 0 until its copy is made.
    bytes: u64,
}

impl GzipCache {
    /// Creates a cache with a limit in bytes.
    pub fn new(budget: u64) -> Self {
        GzipCache { budget, state: Mutex::default(), compressions: Semaphore::new(MAX_CONCURRENT) }
    }

    /// Returns the compressed copy of a document, or none if compression saves too little. Awaits `read` for the
    /// content if there is no copy yet.
    pub async fn get(&self, tag: &str, read: impl Future<Output = io::Result<Bytes>>) -> io::Result<CompressedCopy> {
        let cell = self.state.lock().cell(tag);
        let copy = cell.get_or_try_init(|| async {
            let _permit = self.compressions.acquire().await.map_err(io::Error::other)?;
            let data = read.await?;
            tokio::task::spawn_blocking(move || compress(&data)).await.map_err(io::Error::other)?
        });
        let copy = copy.await.cloned();
        let mut state = self.state.lock();
        match &copy {
            Ok(copy) => state.add_size(self.budget, tag, copy),
            Err(_) => state.remove(tag),
        }
        copy
    }
}

impl State {
    /// Returns the cell of a copy, which is empty until the copy is made.
    fn cell(&mut self, tag: &str) -> Arc<OnceCell<CompressedCopy>> {
        self.use_count += 1;
        let entry = self.copies.entry(tag.to_owned()).or_default();
        entry.last_use = self.use_count;
        Arc::clone(&entry.cell)
    }

    fn remove(&mut self, tag: &str) {
        self.total_bytes -= self.copies.remove(tag).map_or(0, |entry| entry.bytes);
    }

    /// Adds the size of a new copy to the total, and evicts the least recently used others until all fit the budget.
    fn add_size(&mut self, budget: u64, tag: &str, copy: &CompressedCopy) {
        let Some(entry) = self.copies.get_mut(tag).filter(|entry| entry.bytes == 0) else { return };
        entry.bytes = ENTRY_BYTES + copy.as_ref().map_or(0, |copy| copy.len() as u64);
        self.total_bytes += entry.bytes;
        while self.total_bytes > budget {
            let others = self.copies.iter().filter(|(other, entry)| *other != tag && entry.bytes > 0);
            let Some(oldest) = others.min_by_key(|(_, entry)| entry.last_use).map(|(tag, _)| tag.clone()) else {
                break;
            };
            self.remove(&oldest);
        }
    }
}

fn compress(data: &[u8]) -> io::Result<CompressedCopy> {
    let mut writer = GzEncoder::new(Vec::new(), Compression::default());
    writer.write_all(data)?;
    let copy = writer.finish()?;
    let is_worthwhile = (copy.len() as f64) < MAX_RATIO * data.len() as f64;
    Ok(is_worthwhile.then(|| copy.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    async fn get(cache: &GzipCache, tag: &str, data: &'static [u8]) -> CompressedCopy {
        cache.get(tag, async { Ok(Bytes::from_static(data)) }).await.expect("it is in memory")
    }

    #[tokio::test]
    async fn copies_are_made_once_and_the_oldest_are_evicted() {
        static TEXT: [u8; 5000] = [b'a'; 5000];
        let cache = GzipCache::new(2 * ENTRY_BYTES);
        let copy = get(&cache, "a", &TEXT).await.expect("equal letters are compressible");
        let mut read = Vec::new();
        io::copy(&mut flate2::read::GzDecoder::new(&copy[..]), &mut read).expect("a valid copy");
        assert_eq!(read, TEXT);
        assert_eq!(get(&cache, "a", b"another content").await, Some(copy), "it is not read again");
        for tag in ["b", "c", "d", "e"] {
            get(&cache, tag, &TEXT).await;
        }
        let tags: Vec<_> = cache.state.lock().copies.keys().cloned().collect();
        assert!(tags.contains(&"e".to_owned()) && !tags.contains(&"a".to_owned()), "{tags:?}");
        // An entry without a copy takes memory, too.
        for tag in ["short", "shorter", "shortest"] {
            assert_eq!(get(&cache, tag, b"unlike").await, None);
        }
        let state = cache.state.lock();
        let (total_bytes, count) = (state.total_bytes, state.copies.len());
        assert_eq!(total_bytes, state.copies.values().map(|entry| entry.bytes).sum::<u64>());
        assert!(total_bytes <= 2 * ENTRY_BYTES && count <= 2, "{total_bytes} {count}");
    }

    #[tokio::test]
    async fn failed_reads_are_repeated_next_time() {
        let cache = GzipCache::new(100);
        assert!(cache.get("a", async { Err(io::Error::other("no")) }).await.is_err());
        assert!(cache.state.lock().copies.is_empty());
        assert!(get(&cache, "a", &[b'a'; 2000]).await.is_some());
    }
}
