//! Compressed copies of documents, made at the first request and cached in memory with a limit in bytes.

use std::collections::HashMap;
use std::io::{self, Write};
use std::sync::Arc;

use bytes::Bytes;
use flate2::Compression;
use flate2::write::GzEncoder;
use parking_lot::Mutex;
use tokio::sync::{OnceCell, Semaphore};

/// Larger documents, in bytes, are sent uncompressed: compression would take too long.
pub const MAX: u64 = 1 << 26;
/// Smaller documents, in bytes, are sent uncompressed: they fit into one packet.
pub const MIN: u64 = 1 << 10;
/// Greatest ratio of compressed to original size for which the copy is used.
const MAX_RATIO: f64 = 0.95;
/// Greatest number of concurrent compressions.
const MAX_CONCURRENT: usize = 2;
/// Approximate memory of a cache entry in addition to its copy, bytes.
const ENTRY_BYTES: u64 = 200;

/// A compressed copy; none if compression saves too little.
type Copy = Option<Bytes>;

/// Cache of compressed copies, by the tags of their documents.
pub struct Packed {
    budget: u64,
    state: Mutex<State>,
    compressions: Semaphore,
}

#[derive(Default)]
struct State {
    copies: HashMap<String, Entry>,
    /// Total size of all entries, bytes.
    total_bytes: u64,
    uses: u64,
}

#[derive(Default)]
struct Entry {
    cell: Arc<OnceCell<Copy>>,
    /// Number of the last use.
    last_use: u64,
    /// Size of the entry in bytes; 0 until its copy is made.
    bytes: u64,
}

impl Packed {
    /// Creates a cache with a limit in bytes.
    pub fn new(budget: u64) -> Self {
        Packed { budget, state: Mutex::default(), compressions: Semaphore::new(MAX_CONCURRENT) }
    }

    /// Compressed copy of a document; calls `read` for its content if there is none yet. None if it saves too little.
    pub async fn get(&self, tag: &str, read: impl Future<Output = io::Result<Bytes>>) -> io::Result<Copy> {
        let cell = self.state.lock().cell(tag);
        let copy = cell.get_or_try_init(|| async {
            let _permit = self.compressions.acquire().await.map_err(io::Error::other)?;
            let data = read.await?;
            tokio::task::spawn_blocking(move || packed(&data)).await.map_err(io::Error::other)?
        });
        let copy = copy.await.cloned();
        let mut state = self.state.lock();
        match &copy {
            Ok(copy) => state.hold(self.budget, tag, copy),
            Err(_) => state.remove(tag),
        }
        copy
    }
}

impl State {
    fn cell(&mut self, tag: &str) -> Arc<OnceCell<Copy>> {
        self.uses += 1;
        let entry = self.copies.entry(tag.to_owned()).or_default();
        entry.last_use = self.uses;
        Arc::clone(&entry.cell)
    }

    fn remove(&mut self, tag: &str) {
        self.total_bytes -= self.copies.remove(tag).map_or(0, |entry| entry.bytes);
    }

    /// Adds a finished copy to the total size, and evicts the least recently used others until all fit the budget.
    fn hold(&mut self, budget: u64, tag: &str, copy: &Copy) {
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

fn packed(data: &[u8]) -> io::Result<Copy> {
    let mut writer = GzEncoder::new(Vec::new(), Compression::default());
    writer.write_all(data)?;
    let copy = writer.finish()?;
    let is_worth = (copy.len() as f64) < MAX_RATIO * data.len() as f64;
    Ok(is_worth.then(|| copy.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    async fn get(packed: &Packed, tag: &str, data: &'static [u8]) -> Copy {
        packed.get(tag, async { Ok(Bytes::from_static(data)) }).await.expect("it is in memory")
    }

    #[tokio::test]
    async fn copies_are_made_once_and_the_oldest_are_evicted() {
        static TEXT: [u8; 5000] = [b'a'; 5000];
        let packed = Packed::new(2 * ENTRY_BYTES);
        let copy = get(&packed, "a", &TEXT).await.expect("equal letters are packed");
        let mut read = Vec::new();
        io::copy(&mut flate2::read::GzDecoder::new(&copy[..]), &mut read).expect("what was packed is unpacked");
        assert_eq!(read, TEXT);
        assert_eq!(get(&packed, "a", b"another content").await, Some(copy), "it is not read again");
        for tag in ["b", "c", "d", "e"] {
            get(&packed, tag, &TEXT).await;
        }
        let held: Vec<_> = packed.state.lock().copies.keys().cloned().collect();
        assert!(held.contains(&"e".to_owned()) && !held.contains(&"a".to_owned()), "{held:?}");
        // An entry without a copy takes memory, too.
        for tag in ["short", "shorter", "shortest"] {
            assert_eq!(get(&packed, tag, b"unlike").await, None);
        }
        let state = packed.state.lock();
        assert_eq!(state.total_bytes, state.copies.values().map(|entry| entry.bytes).sum::<u64>());
        assert!(
            state.total_bytes <= 2 * ENTRY_BYTES && state.copies.len() <= 2,
            "{} {}",
            state.total_bytes,
            state.copies.len()
        );
    }

    #[tokio::test]
    async fn failed_reads_are_repeated_next_time() {
        let packed = Packed::new(100);
        assert!(packed.get("a", async { Err(io::Error::other("no")) }).await.is_err());
        assert!(packed.state.lock().copies.is_empty());
        assert!(get(&packed, "a", &[b'a'; 2000]).await.is_some());
    }
}
