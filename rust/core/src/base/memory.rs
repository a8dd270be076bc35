//! Refusal of results that are too large for memory. Rust aborts the process when an allocation fails, so kernels
//! check caller-chosen sizes before they allocate.

use std::hint::black_box;

use super::{Error, Result};

/// Fails if the system refuses an allocation of this many bytes. The probe is freed at once and its pages are never
/// touched.
pub fn room_for(bytes: u64) -> Result<()> {
    let refused = Error::Memory { bytes };
    let Ok(size) = usize::try_from(bytes) else { return Err(refused) };
    let mut probe = Vec::<u8>::new();
    // Without the black box the compiler may remove the unused allocation and assume that it succeeded.
    black_box(&mut probe).try_reserve_exact(size).map_err(|_| refused)
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
}
