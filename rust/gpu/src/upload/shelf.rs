//! Free room in pages, so that meshes that come later share one: each visible page costs a pass over the whole picture.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};

/// Words of room that a page has at most beyond what it begins with: 16 MiB.
const MAX_ROOM_WORDS: u64 = 1 << 22;

/// Words of room that it has at least, but for pages as large as they may be: 4 MiB.
const MIN_ROOM_WORDS: u64 = 1 << 20;

/// The page with room, which lives as long as a mesh in it is referenced.
pub(crate) struct Shelf<P> {
    pages: AtomicU64,
    open: Mutex<Open<P>>,
}

/// Words of a page, and how many of them are taken.
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
    /// A page's number.
    pub fn next_number(&self) -> u64 {
        self.pages.fetch_add(1, Ordering::Relaxed)
    }

    /// Takes words where there is room: the page and the first word.
    pub fn take(&self, words: u64) -> Option<(Arc<P>, u64)> {
        let mut open = self.open();
        let page = open.page.upgrade().filter(|_| open.size - open.taken >= words)?;
        let start = open.taken;
        open.taken += words;
        Some((page, start))
    }

    /// Words of a new page that begins with some: as many again, or all the room where meshes came before, so that few
    /// pages hold many meshes. Large pages have no room: a small mesh that came later would keep all of one.
    pub fn size_of_new(&self, words: u64, limit: u64) -> u64 {
        if words > MAX_ROOM_WORDS {
            return words;
        }
        let is_first = self.open().page.strong_count() == 0;
        let room = if is_first { words.clamp(MIN_ROOM_WORDS, MAX_ROOM_WORDS) } else { MAX_ROOM_WORDS };
        (words + room).min(limit.max(words))
    }

    /// Offers what is left of a new page, where that is more than there is.
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

    /// Meshes of as many words come one by one: the pages that hold them.
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
    fn words_are_given_once_and_pages_that_nobody_holds_are_gone() {
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
