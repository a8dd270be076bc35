//! Device memory for views: pages of words, from which unreferenced and then least recently used views are evicted.

use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::sync::{Arc, Mutex, Weak};

use nearfar_core::base::{Error, Progress, Result};
use nearfar_core::orthoview::splat::{Compressed, HEAD, Splats};
use rayon::prelude::*;
use wgpu::{Buffer, BufferUsages};

use crate::compute::programs::Work;
use crate::device::{Counter, Device, Scope, lock};

/// Sizes of the pages in words; a pass binds all pages.
const PAGES: [u64; 4] = [1 << 24, 1 << 26, 1 << 28, 1 << 28];
const WORD: u64 = 4;

/// Location of a view: its page, and the first words of its block headers and of their bits.
pub(super) type Place = [u32; 3];

/// Views as words, by identity.
pub(super) type Words = HashMap<usize, Compressed>;

/// Views on a device.
#[derive(Default)]
pub(super) struct Arena {
    pages: Vec<Page>,
    residents: HashMap<usize, Resident>,
    /// Views of the last picture.
    last_picture: HashSet<usize>,
    /// Whether allocating another page has failed.
    is_full: bool,
    /// Number of calls so far.
    calls: u64,
}

struct Page {
    buffer: Buffer,
    free: FreeList,
}

struct Resident {
    view: Weak<Splats>,
    page: usize,
    first: u32,
    words: u32,
    blocks: u32,
    /// Number of the last call that used it.
    last_call: u64,
}

impl Arena {
    /// Returns the locations of a picture's views; uploads those that are not on the device.
    pub fn show(&mut self, device: &Device, views: &[Arc<Splats>], compressed: &Words) -> Result<Vec<Place>> {
        self.begin();
        self.last_picture = views.iter().map(identity).collect();
        let pinned = self.last_picture.clone();
        match self.place_all(device, views, compressed, &pinned) {
            // Free space may be fragmented, so placement is retried with empty pages.
            Err(Error::Device(_)) if device.check().is_ok() => {
                self.evict(|_| true);
                self.place_all(device, views, compressed, &pinned)
            }
            placed => placed,
        }
    }

    /// Uploads views before a picture shows them; views of the last picture are not evicted.
    pub fn keep(&mut self, device: &Device, views: &[Arc<Splats>], compressed: &Words) -> Result<()> {
        self.begin();
        let pinned = self.last_picture.iter().copied().chain(views.iter().map(identity)).collect();
        self.place_all(device, views, compressed, &pinned).map(|_| ())
    }

    /// Counts a call, and evicts unreferenced views.
    fn begin(&mut self) {
        self.calls += 1;
        self.evict(|resident| resident.view.strong_count() == 0);
    }

    /// Returns the views that are not on the device, without duplicates.
    pub fn missing(&self, views: &[Arc<Splats>]) -> Vec<Arc<Splats>> {
        let mut seen = HashSet::new();
        let is_resident = |view: &Arc<Splats>| {
            self.residents.get(&identity(view)).is_some_and(|resident| resident.view.strong_count() > 0)
        };
        views.iter().filter(|view| !is_resident(view) && seen.insert(identity(view))).cloned().collect()
    }

    pub fn bytes(&self) -> u64 {
        self.residents.values().map(|resident| WORD * u64::from(resident.words)).sum()
    }

    /// Returns the buffers of all pages, at least one.
    pub fn buffers(&mut self, device: &Device) -> Result<Vec<&Buffer>> {
        if self.pages.is_empty() {
            self.add_page(device, 1)?;
        }
        Ok(self.pages.iter().map(|page| &page.buffer).collect())
    }

    fn place_all(
        &mut self,
        device: &Device,
        views: &[Arc<Splats>],
        compressed: &Words,
        pinned: &HashSet<usize>,
    ) -> Result<Vec<Place>> {
        let place = |view: &Arc<Splats>| {
            let key = identity(view);
            if let Some(resident) = self.residents.get_mut(&key) {
                resident.last_call = self.calls;
                return Ok(resident.place());
            }
            let content = compressed.get(&key).map_or_else(|| Cow::Owned(view.compressed()), Cow::Borrowed);
            let (words, blocks) = (content.words.len() as u32, content.blocks as u32);
            let (page, first) = self.allocate(device, content.words.len() as u64, pinned)?;
            let (buffer, offset) = (&self.pages[page].buffer, WORD * u64::from(first));
            let scope = Scope::open(device);
            device.with_queue(|queue| queue.write_buffer(buffer, offset, bytemuck::cast_slice(&content.words)));
            if let Err(error) = scope.close() {
                self.pages[page].free.free(first, words);
                return Err(error);
            }
            device.count(Counter::UploadedBytes, WORD * u64::from(words));
            let resident = Resident { view: Arc::downgrade(view), page, first, words, blocks, last_call: self.calls };
            let place = resident.place();
            self.residents.insert(key, resident);
            Ok(place)
        };
        views.iter().map(place).collect()
    }

    /// Allocates words; returns the page and the first word.
    fn allocate(&mut self, device: &Device, words: u64, pinned: &HashSet<usize>) -> Result<(usize, u32)> {
        loop {
            let first_of = |page: &mut Page| page.free.allocate(words as u32);
            if let Some(place) = self.pages.iter_mut().enumerate().find_map(|(n, page)| Some((n, first_of(page)?))) {
                return Ok(place);
            }
            if !self.is_full && self.pages.len() < PAGES.len() && words <= device.largest_binding() / WORD {
                let added = self.add_page(device, words);
                device.check()?;
                // If there is no memory for another page, the next iteration evicts views.
                self.is_full = added.is_err();
                continue;
            }
            let unpinned = self.residents.iter().filter(|(key, _)| !pinned.contains(key));
            let Some((&key, _)) = unpinned.min_by_key(|(_, resident)| resident.last_call) else {
                return Err(device.error("the splats of this picture exceed its memory; use backend='cpu'"));
            };
            self.evict_keys(&[key]);
        }
    }

    fn add_page(&mut self, device: &Device, words: u64) -> Result<()> {
        let limit = device.largest_binding() / WORD;
        let size = PAGES[self.pages.len()].min(limit).max(words);
        let buffer = device.buffer("views", WORD * size, BufferUsages::STORAGE | BufferUsages::COPY_DST)?;
        self.pages.push(Page { buffer, free: FreeList::new(size as u32) });
        Ok(())
    }

    fn evict(&mut self, is_unused: impl Fn(&Resident) -> bool) {
        let unused = self.residents.iter().filter(|(_, resident)| is_unused(resident));
        self.evict_keys(&unused.map(|(key, _)| *key).collect::<Vec<_>>());
    }

    fn evict_keys(&mut self, keys: &[usize]) {
        for resident in keys.iter().filter_map(|key| self.residents.remove(key)) {
            self.pages[resident.page].free.free(resident.first, resident.words);
        }
    }
}

impl Resident {
    fn place(&self) -> Place {
        [self.page as u32, self.first, self.first + HEAD as u32 * self.blocks]
    }
}

/// Returns a number that identifies a view while it is referenced.
fn identity(view: &Arc<Splats>) -> usize {
    Arc::as_ptr(view) as usize
}

/// Returns the views on a device.
pub(super) fn arena_of(device: &Device) -> &Mutex<Arena> {
    device.state()
}

/// Packs the views that are not yet on a device into words. No lock is held during parallel work.
pub(super) fn compress_missing(device: &Device, views: &[Arc<Splats>]) -> Words {
    let missing = lock(arena_of(device)).missing(views);
    missing.par_iter().map(|view| (identity(view), view.compressed())).collect()
}

/// Uploads views to a device before a picture shows them.
pub fn keep(device: &Device, views: &[Arc<Splats>], progress: &Progress) -> Result<()> {
    device.check()?;
    let compressed = compress_missing(device, views);
    lock(arena_of(device)).keep(device, views, &compressed)?;
    // Until a submission, copies of the words stay in the processor's memory.
    Work::new(device).submit(progress).map(|_| ())
}

/// Returns the bytes of the views on a device.
pub fn kept_bytes(device: &Device) -> u64 {
    lock(arena_of(device)).bytes()
}

/// Free runs: lengths by start; adjacent runs are merged.
pub(super) struct FreeList(BTreeMap<u32, u32>);

impl FreeList {
    /// Creates a page of free words.
    pub fn new(words: u32) -> Self {
        Self(BTreeMap::from([(0, words)]))
    }

    /// Allocates words; returns the first one.
    pub fn allocate(&mut self, words: u32) -> Option<u32> {
        let (&first, &length) = self.0.iter().find(|(_, length)| **length >= words)?;
        self.0.remove(&first);
        if length > words {
            self.0.insert(first + words, length - words);
        }
        Some(first)
    }

    /// Frees allocated words.
    pub fn free(&mut self, mut first: u32, mut words: u32) {
        if let Some((&start, &length)) = self.0.range(..first).next_back()
            && start + length == first
        {
            self.0.remove(&start);
            (first, words) = (start, length + words);
        }
        if let Some(length) = self.0.remove(&(first + words)) {
            words += length;
        }
        self.0.insert(first, words);
    }
}

#[cfg(test)]
mod tests {
    use nearfar_core::base::random;

    use super::*;

    #[test]
    fn words_are_allocated_once_and_merged_when_freed() {
        let mut list = FreeList::new(1000);
        let mut owner = vec![None; 1000];
        let mut allocated: Vec<(u32, u32)> = Vec::new();
        for n in 0..2000u64 {
            let draw = |salt, most| random::bits(3, salt, n) as u32 % most;
            if draw(1, 2) == 0 && !allocated.is_empty() {
                let (first, words) = allocated.swap_remove(draw(2, allocated.len() as u32) as usize);
                owner[first as usize..(first + words) as usize].fill(None);
                list.free(first, words);
                continue;
            }
            let words = 1 + draw(3, 100);
            let Some(first) = list.allocate(words) else {
                // No free run is as long.
                let gaps = owner.split(Option::is_some).map(<[Option<u64>]>::len).max();
                assert!(gaps.is_some_and(|longest| longest < words as usize));
                continue;
            };
            for slot in &mut owner[first as usize..(first + words) as usize] {
                assert_eq!(slot.replace(n), None);
            }
            allocated.push((first, words));
        }
        allocated.into_iter().for_each(|(first, words)| list.free(first, words));
        assert_eq!(list.allocate(1000), Some(0));
    }
}
