//! Meshes as words in pages, which are buffers no larger than one binding. Small meshes share a page; large ones are
//! split into runs of faces, each with its vertices. Pages have spare space for later meshes, because each visible page
//! costs a pass over the whole picture.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, Weak};

use nearfar_core::base::{Aabb, Error, Result};
use nearfar_core::scene::Mesh;
use wgpu::BufferUsages;

use super::runs::{NONE, Run, gather_pieces, split_into_runs};
use crate::device::{Counter, Device, Scope, lock};

const WORD: u64 = 4;

/// A buffer of meshes.
#[derive(Debug)]
pub(crate) struct Page {
    pub buffer: wgpu::Buffer,
    /// Number that identifies the page.
    pub number: u64,
}

/// Consecutive faces of a mesh in a page.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub page: Arc<Page>,
    /// First face in the mesh.
    pub first_face: u32,
    pub face_count: u32,
    /// Offsets in the page, in words: positions, faces, texture coordinates, colours, materials, normals.
    pub words: [u32; 6],
    /// Material of all faces, if they share one.
    pub material: i32,
    /// Boxes of `CHUNK` faces each, in the mesh's frame.
    pub chunks: Arc<[Aabb]>,
}

/// A mesh's parts, in order of faces.
pub(crate) type Parts = Arc<Vec<Part>>;

/// Writes meshes to pages, first to those with space. Returns a list of parts for each mesh, in order of faces.
pub(crate) fn pack(device: &Device, meshes: &[Arc<Mesh>], allocator: &PageAllocator<Page>) -> Result<Vec<Vec<Part>>> {
    let limit = device.largest_binding() / WORD;
    let gathered = meshes.iter().map(|mesh| gather_pieces(mesh, limit)).collect::<Result<Vec<_>>>()?;
    let mut runs: Vec<MeshRun<'_>> = Vec::new();
    for (number, (mesh, pieces)) in meshes.iter().zip(&gathered).enumerate() {
        let Some(pieces) = pieces else {
            runs.extend(
                split_into_runs(mesh, limit).into_iter().flatten().map(|run| (number, run.faces.start as u32, run)),
            );
            continue;
        };
        let mut first_face = 0;
        for piece in pieces {
            runs.push((number, first_face, Run::whole(piece)));
            first_face += piece.faces.len() as u32;
        }
    }
    let mut parts: Vec<Vec<Part>> = vec![Vec::new(); meshes.len()];
    let mut remaining = &runs[..];
    while !remaining.is_empty() {
        let mut size = 0;
        let fitting = remaining.iter().take_while(|(_, _, run)| {
            size += run.words();
            size <= limit
        });
        let (fitting, others) = remaining.split_at(fitting.count().max(1));
        write_to_page(device, fitting, allocator, limit, &mut parts)?;
        remaining = others;
    }
    Ok(parts)
}

/// Number of a mesh, first face, and the run of faces.
type MeshRun<'a> = (usize, u32, Run<'a>);

/// Writes runs to a page with space, or else to a new page.
fn write_to_page(
    device: &Device,
    runs: &[MeshRun<'_>],
    allocator: &PageAllocator<Page>,
    limit: u64,
    parts: &mut [Vec<Part>],
) -> Result<()> {
    let words: u64 = runs.iter().map(|(_, _, run)| run.words()).sum();
    if let Some((page, start)) = allocator.allocate(words) {
        write(runs, &page, start, parts, |offset, bytes| {
            let scope = Scope::open(device);
            device.with_queue(|queue| queue.write_buffer(&page.buffer, offset, bytes));
            scope.close()
        })?;
    } else {
        let size = allocator.size_of_new(words, limit);
        let usage = BufferUsages::STORAGE | BufferUsages::COPY_DST;
        let buffer = device.mapped_buffer("page", size * WORD, usage)?;
        let page = Arc::new(Page { buffer, number: allocator.next_number() });
        let mut view = page.buffer.get_mapped_range_mut(..).map_err(|error| device.failure(error))?;
        write(runs, &page, 0, parts, |offset, bytes| {
            view.slice(offset as usize..offset as usize + bytes.len()).copy_from_slice(bytes);
            Ok(())
        })?;
        drop(view);
        page.buffer.unmap();
        allocator.keep_open(&page, words, size);
    }
    device.count(Counter::UploadedBytes, words * WORD);
    Ok(())
}

/// Writes the bytes of each run by `put`, consecutively from the word `start` of a page on, and lists their parts.
fn write(
    runs: &[MeshRun<'_>],
    page: &Arc<Page>,
    mut start: u64,
    parts: &mut [Vec<Part>],
    mut put: impl FnMut(u64, &[u8]) -> Result<()>,
) -> Result<()> {
    let mut words: Vec<u32> = Vec::new();
    for (mesh, first_face, run) in runs {
        let (layout, size) = run.layout();
        words.clear();
        let too_many = |_| Error::Memory { bytes: size * WORD };
        words.try_reserve_exact(size as usize).map_err(too_many)?;
        run.write(&mut words);
        put(start * WORD, bytemuck::cast_slice(&words))?;
        parts[*mesh].push(Part {
            page: Arc::clone(page),
            first_face: *first_face,
            face_count: run.faces.len() as u32,
            words: layout.map(|word| if word == NONE { NONE } else { word + start as u32 }),
            material: run.uniform_material().unwrap_or(-1),
            chunks: run.chunk_boxes(),
        });
        start += size;
    }
    Ok(())
}

/// Maximum spare words of a new page: 16 MiB.
const MAX_SPARE_WORDS: u64 = 1 << 22;
/// Minimum spare words of a new page below the size limit: 4 MiB.
const MIN_SPARE_WORDS: u64 = 1 << 20;

/// Allocates words in the spare space of the open page, which lives as long as a mesh in it is referenced.
pub(crate) struct PageAllocator<P> {
    pages: AtomicU64,
    open: Mutex<OpenPage<P>>,
}

/// A page, and its used words and size in words.
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

    /// Returns the size of a new page for some words: about twice as many for the first page; later ones get the
    /// maximum spare space, so that few pages hold many meshes. Large pages get none, because a small later mesh would
    /// keep the whole page alive.
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
