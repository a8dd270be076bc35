//! Allocation of page space, so that later meshes share pages: each visible page costs a pass over the whole picture.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};

/// Maximum spare words of a new page: 16 MiB.
const MAX_ROOM_WORDS: u64 = 1 << 22;

/// Minimum spare words of a new page below the size limit: 4 MiB.
const MIN_ROOM_WORDS: u64 = 1 << 20;

/// Page with spare space, alive as long as a mesh in it is referenced.
pub(crate) struct Shelf<P> {
    pages: AtomicU64,
    open: Mutex<Open<P>>,
}

/// Size of a page and its used words.
struct Open<P> {
    page: Weak<P>,
    taken: u64,
    size: u64,
}

impl<P> Default for Shelf<P> {
    fn default() -> Self {
        Self { pages: AtomicU64::new(0), open: Mutex::new(Open { page: Weak::new(), taken: 0, size: 0 }) }
    }
}

impl<P> Shelf<P> {
    /// Returns a new page number.
    pub fn next_number(&self) -> u64 {
        self.pages.fetch_add(1, Ordering::Relaxed)
    }

    /// Allocates words if there is space; returns the page and the first word.
    pub fn take(&self, words: u64) -> Option<(Arc<P>, u64)> {
        let mut open = self.open();
        let page = open.page.upgrade().filter(|_| open.size - open.taken >= words)?;
        let start = open.taken;
        open.taken += words;
        Some((page, start))
    }

    /// Returns the size of a new page that begins with some words: twice as many, or the maximum spare space after
    /// earlier meshes, so that few pages hold many meshes. Large pages have no spare space: a small later mesh would
    /// keep all of one alive.
    pub fn size_of_new(&self, words: u64, limit: u64) -> u64 {
        if words > MAX_ROOM_WORDS {
            return words;
        }
        let is_first = self.open().page.strong_count() == 0;
        let room = if is_first { words.clamp(MIN_ROOM_WORDS, MAX_ROOM_WORDS) } else { MAX_ROOM_WORDS };
        (words + room).min(limit.max(words))
    }

    /// Keeps a new page for allocations if it has more space left than the current one.
    pub fn put(&self, page: &Arc<P>, taken: u64, size: u64) {
        let mut open = self.open();
        let left = if open.page.strong_count() > 0 { open.size - open.taken } else { 0 };
        if size - taken > left {
            *open = Open { page: Arc::downgrade(page), taken, size };
        }
    }

    fn open(&self) -> MutexGuard<'_, Open<P>> {
        self.open.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Adds meshes of these sizes one by one; returns their pages.
    fn pages_of(sizes: impl Iterator<Item = u64>, limit: u64) -> Vec<Arc<()>> {
        let (shelf, mut pages) = (Shelf::default(), Vec::new());
        for words in sizes {
            if shelf.take(words).is_none() {
                let (page, size) = (Arc::new(()), shelf.size_of_new(words, limit));
                assert!((words..=limit).contains(&size) && size <= words + MAX_ROOM_WORDS);
                shelf.put(&page, words, size);
                pages.push(page);
            }
        }
        pages
    }

    #[test]
    fn many_small_meshes_share_few_pages() {
        assert!(pages_of((0..1000).map(|n| 500 + n), 1 << 25).len() <= 2);
        assert_eq!(pages_of((0..50).map(|_| MAX_ROOM_WORDS), MAX_ROOM_WORDS).len(), 50);
        assert_eq!(pages_of([MAX_ROOM_WORDS + 1, 1, 1, MAX_ROOM_WORDS + 1, 1].into_iter(), 1 << 25).len(), 3);
    }

    #[test]
    fn words_are_allocated_once_and_unused_pages_are_freed() {
        let shelf = Shelf::default();
        assert!(shelf.take(0).is_none());
        let page = Arc::new(());
        shelf.put(&page, 10, 30);
        assert_eq!(shelf.take(15).map(|(_, start)| start), Some(10));
        assert_eq!(shelf.take(5).map(|(_, start)| start), Some(25));
        assert!(shelf.take(1).is_none());
        shelf.put(&Arc::new(()), 0, 100);
        assert!(shelf.take(1).is_none());
        assert_eq!([shelf.next_number(), shelf.next_number()], [0, 1]);
    }
}
