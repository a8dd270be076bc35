//! Coarse maps of complete regions, which manifests do not list: slow clients may fetch them after the full maps are
//! made.

use std::collections::{HashMap, VecDeque};

use bytes::Bytes;

/// Greatest total size in bytes, a few dozen regions' worth.
const BUDGET: usize = 32 << 20;

/// Unlisted files by name, of the most recently completed regions.
#[derive(Default)]
pub struct Leftover {
    /// Oldest first.
    regions: VecDeque<HashMap<String, Bytes>>,
    bytes: usize,
}

impl Leftover {
    /// Adds the unlisted files of a region; evicts the oldest ones if the budget is exceeded.
    pub fn add(&mut self, files: HashMap<String, Bytes>) {
        self.bytes += size(&files);
        self.regions.push_back(files);
        while self.bytes > BUDGET {
            self.bytes -= self.regions.pop_front().map_or(self.bytes, |files| size(&files));
        }
    }

    /// Content of a file.
    pub fn file(&self, name: &str) -> Option<Bytes> {
        self.regions.iter().find_map(|files| files.get(name).cloned())
    }
}

fn size(files: &HashMap<String, Bytes>) -> usize {
    files.values().map(Bytes::len).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_oldest_are_evicted_when_the_budget_is_full() {
        let mut leftover = Leftover::default();
        let third = Bytes::from(vec![1; BUDGET / 3]);
        for name in ["a", "b", "c", "d"] {
            leftover.add(HashMap::from([(name.to_owned(), third.clone())]));
        }
        assert_eq!(leftover.file("a"), None);
        assert!(["b", "c", "d"].iter().all(|name| leftover.file(name).is_some()));
        leftover.add(HashMap::from([("large".to_owned(), Bytes::from(vec![1; BUDGET + 1]))]));
        assert_eq!((leftover.file("d"), leftover.file("large"), leftover.bytes), (None, None, 0));
    }
}
