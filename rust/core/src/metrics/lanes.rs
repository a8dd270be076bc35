//! Rows of lanes. Metrics use fused multiply-add if the machine has it: half the instructions and one rounding less.
//! Results are otherwise the same on all machines.

/// Number of pixels per vector operation.
pub(super) const LANES: usize = 32;

/// Returns the first lanes of a row.
#[inline(always)]
pub(super) fn lanes<R>(values: &[R]) -> &[R; LANES] {
    &values.as_chunks::<LANES>().0[0]
}
