//! Compressed copies of documents, made at the first request and cached in memory with a limit in bytes.

use std::collections::HashMap;
use std::io::{self, Write};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use bytes::Bytes;
use flate2::Compression;
use flate2::write::GzEncoder;
use tokio::sync::{OnceCell, Semaphore};

/// Larger documents, in bytes, are sent uncompressed: compression would take too long.
pub const MAX: u64 = 1 << 26;
/// Smaller documents, in bytes, are sent uncompressed: they fit into one packet.
pub const MIN: u64 = 1 << 10;
/// Greatest ratio of compressed to original size for which the copy is used.
const WORTH: f64 = 0.95;
/// Greatest number of concurrent compressions.
const AT_ONCE: usize = 2;

/// Approximate memory of a cache entry in addition to its copy, bytes.
const ENTRY: u64 = 200;

/// A compressed copy; none if compression saves too little.
type Copy = Option<Bytes>;

/// Cache of compressed copies, by the tags of their documents.
pub struct Packed {
    budget: u64,
    state: Mutex<State>,
    at_once: Semaphore,
}

#[derive(Default)]
struct State {
    copies: HashMap<String, Entry>,
    /// Total size of all entries, bytes.
    held: u64,
    uses: u64,
}

#[derive(Default)]
struct Entry {
    cell: Arc<OnceCell<Copy>>,
    /// Number of the last use.
    used: u64,
    /// Size of the entry in bytes; 0 until its copy is made.
    bytes: u64,
}

impl Packed {
    /// Creates a cache with a limit in bytes.
    pub fn new(budget: u64) -> Self {
        Packed { budget, state: Mutex::default(), at_once: Semaphore::new(AT_ONCE) }
    }

    /// Compressed copy of a document; calls `read` for its content if there is none yet. None if it saves too little.
    pub async fn get(&self, tag: &str, read: impl Future<Output = io::Result<Bytes>>) -> io::Result<Copy> {
        let cell = self.state().cell(tag);
        let copy = cell.get_or_try_init(|| async {
            let _place = self.at_once.acquire().await.map_err(io::Error::other)?;
            let data = read.await?;
            tokio::task::spawn_blocking(move || packed(&data)).await.map_err(io::Error::other)?
        });
        let copy = copy.await.cloned();
        let mut state = self.state();
        match &copy {
            Ok(copy) => state.hold(self.budget, tag, copy),
            Err(_) => state.forget(tag),
        }
        copy
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl State {
    fn cell(&mut self, tag: &str) -> Arc<OnceCell<Copy>> {
        self.uses += 1;
        let entry = self.copies.entry(tag.to_owned()).or_default();
        entry.used = self.uses;
        Arc::clone(&entry.cell)
    }

    /// Adds a finished copy to the total size, and evicts others if necessary.
    fn hold(&mut self, budget: u64, tag: &str, copy: &Copy) {
        let Some(entry) = self.copies.get_mut(tag).filter(|entry| entry.bytes == 0) else { return };
        entry.bytes = ENTRY + copy.as_ref().map_or(0, |copy| copy.len() as u64);
        self.held += entry.bytes;
        self.trim(budget, tag);
    }

    fn forget(&mut self, tag: &str) {
        self.held -= self.copies.remove(tag).map_or(0, |entry| entry.bytes);
    }

    /// Evicts the least recently used documents, except `but`, until the rest fits the budget.
    fn trim(&mut self, budget: u64, but: &str) {
        while self.held > budget {
            let others = self.copies.iter().filter(|(tag, entry)| tag.as_str() != but && entry.bytes > 0);
            let Some(tag) = others.min_by_key(|(_, entry)| entry.used).map(|(tag, _)| tag.clone()) else { break };
            self.forget(&tag);
        }
    }
}

fn packed(data: &[u8]) -> io::Result<Copy> {
    let mut writer = GzEncoder::new(Vec::new(), Compression::default());
    writer.write_all(data)?;
    let copy = writer.finish()?;
    let is_worth = (copy.len() as f64) < WORTH * data.len() as f64;
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
        let packed = Packed::new(2 * ENTRY);
        let copy = get(&packed, "a", &TEXT).await.expect("equal letters are packed");
        let mut read = Vec::new();
        io::copy(&mut flate2::read::GzDecoder::new(&copy[..]), &mut read).expect("what was packed is unpacked");
        assert_eq!(read, TEXT);
        assert_eq!(get(&packed, "a", b"another content").await, Some(copy), "it is not read again");
        for tag in ["b", "c", "d", "e"] {
            get(&packed, tag, &TEXT).await;
        }
        let held: Vec<_> = packed.state().copies.keys().cloned().collect();
        assert!(held.contains(&"e".to_owned()) && !held.contains(&"a".to_owned()), "{held:?}");
        // An entry without a copy takes memory, too.
        for tag in ["short", "shorter", "shortest"] {
            assert_eq!(get(&packed, tag, b"unlike").await, None);
        }
        let state = packed.state();
        assert_eq!(state.held, state.copies.values().map(|entry| entry.bytes).sum::<u64>());
        assert!(state.held <= 2 * ENTRY && state.copies.len() <= 2, "{} {}", state.held, state.copies.len());
    }

    #[tokio::test]
    async fn failed_reads_are_repeated_next_time() {
        let packed = Packed::new(100);
        let failed = packed.get("a", async { Err(io::Error::other("no")) }).await;
        assert!(failed.is_err());
        assert!(packed.state().copies.is_empty());
        assert!(get(&packed, "a", &[b'a'; 2000]).await.is_some());
    }
}
