//! Checks that results fit into memory. Rust aborts the process when an allocation fails, so a kernel asks for room
//! before it allocates an array whose size depends on an argument. The room is not reserved: other threads may take it
//! before the allocation.
//!
//! Small arrays, in total less than 1 MiB between two calls of `Progress::check`, need no request. If the process
//! has a memory limit (ulimit), the first 64 of these calls, and then every 64th, test whether `HEADROOM` remains.

use std::collections::HashMap;
use std::hash::Hash;
use std::hint::black_box;
use std::sync::atomic::{AtomicU32, Ordering};
use std::{process, thread};

use rayon::prelude::*;

use super::{Error, Result};

/// Bytes that must remain available after an allocation, for small allocations of kernels and their threads. More than
/// glibc's maximum mmap threshold (32 MiB), so that freeing a probe does not change where glibc puts later arrays.
pub const HEADROOM: u64 = 64 << 20;

/// Bytes below which arrays are not checked, because `HEADROOM` covers them.
const UNCHECKED: u64 = 1 << 20;

/// Id of the process that is probing; 0 if none is. Simultaneous probes of several threads would add up. A mutex that
/// another thread holds during a fork would stay locked in the child; the parent's id does not block the child.
static PROBING: AtomicU32 = AtomicU32::new(0);

/// Fails if the system cannot allocate this many bytes plus `HEADROOM`. The test allocation, called the probe, is freed
/// at once and its pages are never touched.
pub fn room_for(bytes: u64) -> Result<()> {
    let process = process::id();
    while !begin_probe(process) {
        thread::yield_now();
    }
    probe(bytes)
}

/// Fails if less than `HEADROOM` remains. If another thread is probing, its probe suffices.
pub fn check_headroom() -> Result<()> {
    if begin_probe(process::id()) { probe(0).map_err(|_| Error::Memory { bytes: HEADROOM }) } else { Ok(()) }
}

/// Registers the calling thread as the probing one; returns false if another thread of the process is probing.
fn begin_probe(process: u32) -> bool {
    let before = PROBING.load(Ordering::Relaxed);
    before != process && PROBING.compare_exchange(before, process, Ordering::Acquire, Ordering::Relaxed).is_ok()
}

/// Allocates and frees the probe, and unregisters the thread.
fn probe(bytes: u64) -> Result<()> {
    let refused = Error::Memory { bytes };
    let outcome = usize::try_from(bytes.saturating_add(HEADROOM)).map_err(|_| refused.clone()).and_then(|size| {
        let mut probe = Vec::<u8>::new();
        // Without the black box the compiler may remove the unused allocation and assume that it succeeded.
        black_box(&mut probe).try_reserve_exact(size).map_err(|_| refused)
    });
    PROBING.store(0, Ordering::Release);
    outcome
}

/// Fails if there is no room for `count` values of type T. If T is a tuple or array of several arrays' elements, the
/// request is for all these arrays together.
pub fn room_for_values<T>(count: usize) -> Result<()> {
    let bytes = (count as u64).saturating_mul(size_of::<T>() as u64);
    if bytes < UNCHECKED { Ok(()) } else { room_for(bytes) }
}

/// Returns the error for `count` values of type T without room.
fn refusal<T>(count: usize) -> Error {
    Error::Memory { bytes: (count as u64).saturating_mul(size_of::<T>() as u64) }
}

/// Returns `count` equal values.
pub fn try_vec<T: Clone>(value: T, count: usize) -> Result<Vec<T>> {
    room_for_values::<T>(count)?;
    // For zeros, `vec!` takes zeroed pages from the system; after `try_reserve` they would have to be written.
    Ok(vec![value; count])
}

/// Returns an empty vector with room for `count` values.
pub fn try_with_capacity<T>(count: usize) -> Result<Vec<T>> {
    room_for_values::<T>(count)?;
    let mut values = Vec::new();
    // Other threads may have taken the room in the meantime.
    values.try_reserve_exact(count).map_err(|_| refusal::<T>(count))?;
    Ok(values)
}

/// Makes room for `count` more values of a vector that grows.
pub fn try_grow<T>(values: &mut Vec<T>, count: usize) -> Result<()> {
    let all = values.len().saturating_add(count);
    // A vector that grows doubles its capacity.
    if all > values.capacity() {
        room_for_values::<T>(all.max(values.capacity().saturating_mul(2)))?
    }
    values.try_reserve(count).map_err(|_| refusal::<T>(all))
}

/// Makes room for `count` more entries of a hash map that grows.
pub fn try_grow_map<K: Eq + Hash, V>(map: &mut HashMap<K, V>, count: usize) -> Result<()> {
    let all = map.len().saturating_add(count);
    if all > map.capacity() {
        // The new table has a power of two of slots, at most 7/8 of them in use, and a byte for each; the old one remains
        // until its entries have moved.
        let slots = all.max(map.capacity() + 1).saturating_mul(8).div_ceil(7).next_power_of_two();
        room_for_values::<((K, V), u8)>(slots)?;
    }
    map.try_reserve(count).map_err(|_| refusal::<(K, V)>(all))
}

/// Returns a copy of an array.
pub fn try_copy<T: Copy>(values: &[T]) -> Result<Vec<T>> {
    try_concat(&[values])
}

/// Concatenates arrays.
pub fn try_concat<T: Clone>(parts: &[impl AsRef<[T]>]) -> Result<Vec<T>> {
    let mut all = try_with_capacity(parts.iter().map(|part| part.as_ref().len()).sum())?;
    parts.iter().for_each(|part| all.extend_from_slice(part.as_ref()));
    Ok(all)
}

/// Appends the values of an array.
pub fn try_append<T: Clone>(values: &mut Vec<T>, more: &[T]) -> Result<()> {
    try_grow(values, more.len())?;
    values.extend_from_slice(more);
    Ok(())
}

/// Appends a value.
pub fn try_push<T>(values: &mut Vec<T>, value: T) -> Result<()> {
    try_grow(values, 1)?;
    values.push(value);
    Ok(())
}

/// Appends the values of an iterator of unknown length. Requests room for one piece after the other.
pub fn try_extend<T>(values: &mut Vec<T>, more: impl IntoIterator<Item = T>) -> Result<()> {
    const PIECE: usize = 1 << 14;
    let mut more = more.into_iter().peekable();
    while more.peek().is_some() {
        try_grow(values, more.size_hint().0.clamp(1, PIECE))?;
        let room = (values.capacity() - values.len()).min(PIECE);
        values.extend(more.by_ref().take(room));
    }
    Ok(())
}

/// Collects an iterator of known length.
pub fn try_list<T>(values: impl ExactSizeIterator<Item = T>) -> Result<Vec<T>> {
    let mut listed = try_with_capacity(values.len())?;
    listed.extend(values);
    Ok(listed)
}

/// Collects a parallel iterator of known length.
pub fn try_collect<I: IndexedParallelIterator>(values: I) -> Result<Vec<I::Item>> {
    let mut collected = try_with_capacity(values.len())?;
    values.collect_into_vec(&mut collected);
    Ok(collected)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn impossible_sizes_are_refused() {
        assert_eq!(room_for(0), Ok(()));
        assert_eq!(room_for(1 << 20), Ok(()));
        for bytes in [1 << 62, u64::MAX] {
            assert_eq!(room_for(bytes), Err(Error::Memory { bytes }));
        }
    }

    #[test]
    fn impossible_arrays_are_refused() {
        let refused = Error::Memory { bytes: 1 << 62 };
        assert_eq!(try_vec(0u8, 1 << 62), Err(refused.clone()));
        assert_eq!(try_with_capacity::<u64>(1 << 59), Err(refused.clone()));
        assert_eq!(try_collect((0..1usize << 59).into_par_iter().map(|_| 0u64)), Err(refused));
        assert_eq!(room_for_values::<u64>(usize::MAX), Err(Error::Memory { bytes: u64::MAX }));
        let mut map = HashMap::<u64, u64>::new();
        assert_eq!(try_grow_map(&mut map, 1 << 58), Err(Error::Memory { bytes: 24 << 59 }));
        assert_eq!(try_grow_map(&mut map, 10), Ok(()));
        assert!(map.capacity() >= 10);
    }

    #[test]
    fn arrays_hold_their_values() {
        assert_eq!(try_vec([1u8; 2], 3), Ok(vec![[1; 2]; 3]));
        assert_eq!(try_collect((0..1000usize).into_par_iter()), Ok((0..1000).collect()));
        assert_eq!(try_list(0..1000), Ok((0..1000).collect()));
        let mut all = try_concat(&[vec![1], vec![], vec![2, 3]]).unwrap();
        assert_eq!(try_append(&mut all, &[4]), Ok(()));
        assert_eq!(try_extend(&mut all, (5..100_000).filter(|n| n % 2 == 1)), Ok(()));
        assert!(all.into_iter().eq((1..5).chain((5..100_000).step_by(2))));
        assert!(try_with_capacity::<u64>(7).unwrap().capacity() >= 7);
    }
}
