//! Allocation of page space, so that later meshes share pages: each visible page costs a pass over the whole picture.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, Weak};

use crate::device::lock;

/// Maximum spare words of a new page: 16 MiB.
const MAX_SPARE_WORDS: u64 = 1 << 22;
/// Minimum spare words of a new page below the size limit: 4 MiB.
const MIN_SPARE_WORDS: u64 = 1 << 20;

/// Page with spare space, alive as long as a mesh in it is referenced.
pub(crate) struct PageAllocator<P> {
    pages: AtomicU64,
    open: Mutex<OpenPage<P>>,
}

/// Size of a page and its used words.
struct OpenPage<P> {
    page: Weak<P>,
    used: u64,
    size: u64,
}

impl<P> Default for PageAllocator<P> {
    fn default() -> Self {
        Self { pages: AtomicU64::new(0), open: Mutex::new(OpenPage { page: Weak::new(), used: 0, size: 0 }) }
    }
}

impl<P> PageAllocator<P> {
    /// Returns a new page number.
    pub fn next_number(&self) -> u64 {
        self.pages.fetch_add(1, Ordering::Relaxed)
    }

    /// Allocates words if there is space; returns the page and the first word.
    pub fn allocate(&self, words: u64) -> Option<(Arc<P>, u64)> {
        let mut open = lock(&self.open);
        let page = open.page.upgrade().filter(|_| open.size - open.used >= words)?;
        let start = open.used;
        open.used += words;
        Some((page, start))
    }

    /// Returns the size of a new page that begins with some words: twice as many, or the maximum spare space after
    /// earlier meshes, so that few pages hold many meshes. Large pages have no spare space: a small later mesh would
    /// keep all of one alive.
    pub fn size_of_new(&self, words: u64, limit: u64) -> u64 {
        if words > MAX_SPARE_WORDS {
            return words;
        }
        let is_first = lock(&self.open).page.strong_count() == 0;
        let spare = if is_first { words.clamp(MIN_SPARE_WORDS, MAX_SPARE_WORDS) } else { MAX_SPARE_WORDS };
        (words + spare).min(limit.max(words))
    }

    /// Keeps a new page for allocations if it has more space left than the current one.
    pub fn keep_open(&self, page: &Arc<P>, used: u64, size: u64) {
        let mut open = lock(&self.open);
        let spare = if open.page.strong_count() > 0 { open.size - open.used } else { 0 };
        if size - used > spare {
            *open = OpenPage { page: Arc::downgrade(page), used, size };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Adds meshes of these sizes one by one; returns their pages.
    fn pages_of(sizes: impl Iterator<Item = u64>, limit: u64) -> Vec<Arc<()>> {
        let (allocator, mut pages) = (PageAllocator::default(), Vec::new());
        for words in sizes {
            if allocator.allocate(words).is_none() {
                let (page, size) = (Arc::new(()), allocator.size_of_new(words, limit));
                assert!((words..=limit).contains(&size) && size <= words + MAX_SPARE_WORDS);
                allocator.keep_open(&page, words, size);
                pages.push(page);
            }
        }
        pages
    }

    #[test]
    fn many_small_meshes_share_few_pages() {
        assert!(pages_of((0..1000).map(|n| 500 + n), 1 << 25).len() <= 2);
        assert_eq!(pages_of((0..50).map(|_| MAX_SPARE_WORDS), MAX_SPARE_WORDS).len(), 50);
        assert_eq!(pages_of([MAX_SPARE_WORDS + 1, 1, 1, MAX_SPARE_WORDS + 1, 1].into_iter(), 1 << 25).len(), 3);
    }

    #[test]
    fn words_are_allocated_once_and_unused_pages_are_freed() {
        let allocator = PageAllocator::default();
        assert!(allocator.allocate(0).is_none());
        let page = Arc::new(());
        allocator.keep_open(&page, 10, 30);
        assert_eq!(allocator.allocate(15).map(|(_, start)| start), Some(10));
        assert_eq!(allocator.allocate(5).map(|(_, start)| start), Some(25));
        assert!(allocator.allocate(1).is_none());
        allocator.keep_open(&Arc::new(()), 0, 100);
        assert!(allocator.allocate(1).is_none());
        assert_eq!([allocator.next_number(), allocator.next_number()], [0, 1]);
    }
}
