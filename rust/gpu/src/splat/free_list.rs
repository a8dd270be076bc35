//! Free-list allocator for the words of a page.

use std::collections::BTreeMap;

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
                // No gap is as long.
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
