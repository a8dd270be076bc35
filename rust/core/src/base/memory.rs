//! Refusal of results that are too large for memory. Rust aborts the process when an allocation fails, so kernels
//! ask for room before they allocate what depends on an argument's size.

use std::hint::black_box;

use rayon::prelude::*;

use super::{Error, Result};

/// Bytes that stay available after each request, for the small allocations of kernels and of their threads. More than
/// glibc's greatest threshold for mappings (32 MiB), so that a request does not change where later arrays lie.
pub const HEADROOM: u64 = 64 << 20;

/// Bytes below which arrays are not checked, because `HEADROOM` covers them.
const UNCHECKED: u64 = 1 << 20;

/// Fails if the system refuses an allocation of this many bytes, or leaves less than `HEADROOM`. The probe is freed at
/// once and its pages are never touched.
pub fn room_for(bytes: u64) -> Result<()> {
    let refused = Error::Memory { bytes };
    let Ok(size) = usize::try_from(bytes.saturating_add(HEADROOM)) else { return Err(refused) };
    let mut probe = Vec::<u8>::new();
    // Without the black box the compiler may remove the unused allocation and assume that it succeeded.
    black_box(&mut probe).try_reserve_exact(size).map_err(|_| refused)
}

/// Fails if there is no room for `count` values of type T.
pub fn room_for_values<T>(count: usize) -> Result<()> {
    let bytes = (count as u64).saturating_mul(size_of::<T>() as u64);
    if bytes < UNCHECKED { Ok(()) } else { room_for(bytes) }
}

/// Error for `count` values of type T without room.
fn refusal<T>(count: usize) -> Error {
    Error::Memory { bytes: (count as u64).saturating_mul(size_of::<T>() as u64) }
}

/// Returns `count` equal values.
pub fn try_vec<T: Clone>(value: T, count: usize) -> Result<Vec<T>> {
    room_for_values::<T>(count)?;
    // The macro obtains zeros from the system, which a fallible reservation would have to write.
    Ok(vec![value; count])
}

/// Returns an empty vector with room for `count` values.
pub fn try_with_capacity<T>(count: usize) -> Result<Vec<T>> {
    room_for_values::<T>(count)?;
    let mut values = Vec::new();
    // Other threads may have taken the room since.
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

/// Returns a copy of an array.
pub fn try_copy<T: Copy>(values: &[T]) -> Result<Vec<T>> {
    let mut copy = try_with_capacity(values.len())?;
    copy.extend_from_slice(values);
    Ok(copy)
}

/// Collects a parallel iterator.
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
    }

    #[test]
    fn arrays_hold_their_values() {
        assert_eq!(try_vec([1u8; 2], 3), Ok(vec![[1; 2]; 3]));
        assert_eq!(try_collect((0..1000usize).into_par_iter()), Ok((0..1000).collect()));
        assert!(try_with_capacity::<u64>(7).unwrap().capacity() >= 7);
    }
}
