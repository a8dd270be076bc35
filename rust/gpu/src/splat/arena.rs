//! Device memory for views: pages of words, from which unreferenced and then least recently used views are evicted.

use std::collections::{HashMap, HashSet};
use std::sync::{Arc, Weak};

use nearfar_core::base::{Error, Result};
use nearfar_core::orthoview::splat::{Compressed, HEAD, Splats};
use wgpu::{Buffer, BufferUsages};

use super::room::Room;
use crate::device::{Counter, Device, Scope};

/// Words of the pages; a pass binds all of them.
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
    known: HashMap<usize, Resident>,
    /// Views of the last picture.
    shown: HashSet<usize>,
    /// Whether allocating another page has failed.
    is_full: bool,
    /// Number of calls so far.
    now: u64,
}

struct Page {
    buffer: Buffer,
    room: Room,
}

struct Resident {
    view: Weak<Splats>,
    page: usize,
    first: u32,
    words: u32,
    blocks: u32,
    used: u64,
}

impl Arena {
    /// Returns the locations of a picture's views; uploads those that are not on the device.
    pub fn show(&mut self, device: &Device, views: &[Arc<Splats>], compressed: &Words) -> Result<Vec<Place>> {
        self.begin();
        self.shown = views.iter().map(identity).collect();
        let wanted = self.shown.clone();
        match self.place_all(device, views, compressed, &wanted) {
            // Free space may be fragmented: retries with empty pages.
            Err(Error::Device(_)) if device.check().is_ok() => {
                self.forget(|_| true);
                self.place_all(device, views, compressed, &wanted)
            }
            placed => placed,
        }
    }

    /// Uploads views before a picture shows them; those of the last picture stay.
    pub fn keep(&mut self, device: &Device, views: &[Arc<Splats>], compressed: &Words) -> Result<()> {
        self.begin();
        let wanted = self.shown.iter().copied().chain(views.iter().map(identity)).collect();
        self.place_all(device, views, compressed, &wanted).map(|_| ())
    }

    /// Counts a call, and evicts unreferenced views.
    fn begin(&mut self) {
        self.now += 1;
        self.forget(|resident| resident.view.strong_count() == 0);
    }

    /// Returns the views that are not on the device, without duplicates.
    pub fn missing(&self, views: &[Arc<Splats>]) -> Vec<Arc<Splats>> {
        let mut seen = HashSet::new();
        let is_known = |view: &Arc<Splats>| {
            self.known.get(&identity(view)).is_some_and(|resident| resident.view.strong_count() > 0)
        };
        views.iter().filter(|view| !is_known(view) && seen.insert(identity(view))).cloned().collect()
    }

    /// Returns the bytes of all views.
    pub fn bytes(&self) -> u64 {
        self.known.values().map(|resident| WORD * u64::from(resident.words)).sum()
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
        wanted: &HashSet<usize>,
    ) -> Result<Vec<Place>> {
        let one = |view: &Arc<Splats>| {
            let key = identity(view);
            if let Some(resident) = self.known.get_mut(&key) {
                resident.used = self.now;
                return Ok(resident.place());
            }
            let own;
            let content = match compressed.get(&key) {
                Some(content) => content,
                None => {
                    own = view.compressed();
                    &own
                }
            };
            let (page, first) = self.room(device, content.words.len() as u64, wanted)?;
            let (buffer, at) = (&self.pages[page].buffer, WORD * u64::from(first));
            let scope = Scope::open(device);
            device.with_queue(|queue| queue.write_buffer(buffer, at, bytemuck::cast_slice(&content.words)));
            if let Err(error) = scope.close() {
                self.pages[page].room.give_back(first, content.words.len() as u32);
                return Err(error);
            }
            device.count(Counter::UploadedBytes, WORD * content.words.len() as u64);
            let (words, blocks) = (content.words.len() as u32, content.blocks as u32);
            let resident = Resident { view: Arc::downgrade(view), page, first, words, blocks, used: self.now };
            let place = resident.place();
            self.known.insert(key, resident);
            Ok(place)
        };
        views.iter().map(one).collect()
    }

    /// Allocates words; returns the page and the first word.
    fn room(&mut self, device: &Device, words: u64, wanted: &HashSet<usize>) -> Result<(usize, u32)> {
        loop {
            let take = |page: &mut Page| page.room.take(words as u32);
            if let Some(found) = self.pages.iter_mut().enumerate().find_map(|(n, page)| Some((n, take(page)?))) {
                return Ok(found);
            }
            if !self.is_full && self.pages.len() < PAGES.len() && words <= device.largest_binding() / WORD {
                let added = self.add_page(device, words);
                device.check()?;
                // If there is no memory for a page, other views are evicted.
                self.is_full = added.is_err();
                continue;
            }
            let spare = self.known.iter().filter(|(key, _)| !wanted.contains(key)).min_by_key(|(_, one)| one.used);
            let Some((&key, _)) = spare else { return Err(too_many(device)) };
            self.forget_keys(&HashSet::from([key]));
        }
    }

    fn add_page(&mut self, device: &Device, words: u64) -> Result<()> {
        let most = device.largest_binding() / WORD;
        let size = PAGES[self.pages.len()].min(most).max(words);
        let buffer = device.buffer("views", WORD * size, BufferUsages::STORAGE | BufferUsages::COPY_DST)?;
        self.pages.push(Page { buffer, room: Room::new(size as u32) });
        Ok(())
    }

    fn forget(&mut self, is_over: impl Fn(&Resident) -> bool) {
        let over: HashSet<usize> = self.known.iter().filter(|(_, one)| is_over(one)).map(|(key, _)| *key).collect();
        self.forget_keys(&over);
    }

    fn forget_keys(&mut self, keys: &HashSet<usize>) {
        for resident in keys.iter().filter_map(|key| self.known.remove(key)) {
            self.pages[resident.page].room.give_back(resident.first, resident.words);
        }
    }
}

impl Resident {
    fn place(&self) -> Place {
        [self.page as u32, self.first, self.first + HEAD as u32 * self.blocks]
    }
}

/// Returns a number that identifies a view while it is referenced.
pub(super) fn identity(view: &Arc<Splats>) -> usize {
    Arc::as_ptr(view) as usize
}

fn too_many(device: &Device) -> Error {
    let label = device.report().label();
    Error::Device(format!("{label}: the splats of this picture exceed its memory; use backend='cpu'"))
}
