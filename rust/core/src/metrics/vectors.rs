//! Rows of lanes. Metrics fuse multiplications and additions where the machine can: half the instructions, and one
//! rounding less. Machines without it round once more; everything else about the results is the same.

/// Pixels side by side.
pub(super) const LANES: usize = 32;

/// The first of a row of lanes.
#[inline(always)]
pub(super) fn lanes<R>(values: &[R]) -> &[R; LANES] {
    &values.as_chunks::<LANES>().0[0]
}

/// Asks for values that are read soon.
#[inline(always)]
pub(super) fn prefetch<P>(values: &[P]) {
    #[cfg(target_arch = "x86_64")]
    for from in (0..size_of_val(values)).step_by(64) {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: prefetching reads nothing; the address lies within the slice.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(values.as_ptr().cast::<i8>().add(from)) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = values;
}
