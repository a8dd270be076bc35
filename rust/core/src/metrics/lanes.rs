//! Rows of lanes. Metrics fuse multiplications and additions where the machine can: half the instructions, and one
//! rounding less. Machines without it round once more; everything else about the results is the same.

/// Pixels side by side.
pub(super) const LANES: usize = 32;

/// The first of a row of lanes.
#[inline(always)]
pub(super) fn lanes<R>(values: &[R]) -> &[R; LANES] {
    &values.as_chunks::<LANES>().0[0]
}
