//! Coarse maps of complete regions, which manifests do not list: slow clients may fetch them after the full maps are
//! made.

use std::collections::{HashMap, VecDeque};

use bytes::Bytes;

/// Greatest total size in bytes, a few dozen regions' worth.
const MAX_BYTES: usize = 32 << 20;

/// Unlisted files by name, of the most recently completed regions.
#[derive(Default)]
pub struct Unlisted {
    /// Oldest first.
    regions: VecDeque<HashMap<String, Bytes>>,
    bytes: usize,
}

impl Unlisted {
    /// Adds the unlisted files of a region; evicts the oldest ones if the budget is exceeded.
    pub fn add(&mut self, files: HashMap<String, Bytes>) {
        self.bytes += size(&files);
        self.regions.push_back(files);
        while self.bytes > MAX_BYTES {
            self.bytes -= self.regions.pop_front().map_or(self.bytes, |files| size(&files));
        }
    }

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
        let mut unlisted = Unlisted::default();
        let third = Bytes::from(vec![1; MAX_BYTES / 3]);
        for name in ["a", "b", "c", "d"] {
            unlisted.add(HashMap::from([(name.to_owned(), third.clone())]));
        }
        assert_eq!(unlisted.file("a"), None);
        assert!(["b", "c", "d"].iter().all(|name| unlisted.file(name).is_some()));
        unlisted.add(HashMap::from([("large".to_owned(), Bytes::from(vec![1; MAX_BYTES + 1]))]));
        assert_eq!((unlisted.file("d"), unlisted.file("large"), unlisted.bytes), (None, None, 0));
    }
}
