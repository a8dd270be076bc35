//! Refusal of results too large for memory. An allocation that fails ends the process, so sizes that a caller chooses are
//! asked for first.

use std::hint::black_box;

use super::{Error, Result};

/// An error where the system refuses so many bytes at once. Nothing is kept: the pages are never touched.
pub fn room_for(bytes: u64) -> Result<()> {
    let refused = Error::Memory { bytes };
    let Ok(size) = usize::try_from(bytes) else { return Err(refused) };
    let mut probe = Vec::<u8>::new();
    // Without the black box the compiler may drop an allocation that nobody uses, and assume that it succeeded.
    black_box(&mut probe).try_reserve_exact(size).map_err(|_| refused)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_no_machine_has_is_refused() {
        assert_eq!(room_for(0), Ok(()));
        assert_eq!(room_for(1 << 20), Ok(()));
        for bytes in [1 << 62, u64::MAX] {
            assert_eq!(room_for(bytes), Err(Error::Memory { bytes }));
        }
    }
}
