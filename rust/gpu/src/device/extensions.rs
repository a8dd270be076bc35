//! State that other modules keep on a device between frames, one value per type, so that a device depends on none of
//! them.

use std::any::Any;
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

/// An append-only list: values are created on first use and never move, so no lock is held while they are used.
#[derive(Default)]
pub(super) struct Extensions(OnceLock<Box<Extension>>);

struct Extension {
    value: Box<dyn Any + Send + Sync>,
    next: Extensions,
}

impl Extensions {
    /// Returns the value of a type.
    pub fn get<T: Default + Send + Sync + 'static>(&self) -> &T {
        let mut list = self;
        loop {
            // If another thread has just stored a value of another type here, the loop goes on to the next entry.
            let create = || Box::new(Extension { value: Box::<T>::default(), next: Extensions::default() });
            let extension = list.0.get_or_init(create);
            if let Some(value) = extension.value.downcast_ref() {
                return value;
            }
            list = &extension.next;
        }
    }
}

/// Locks a mutex whose value stays valid if a thread panics.
pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};
    use std::thread;

    use super::Extensions;

    #[test]
    fn threads_share_one_value_of_each_type() {
        let extensions = Extensions::default();
        thread::scope(|scope| {
            for _ in 0..8 {
                scope.spawn(|| {
                    for _ in 0..100 {
                        extensions.get::<AtomicU32>().fetch_add(1, Ordering::Relaxed);
                        extensions.get::<AtomicU64>().fetch_add(2, Ordering::Relaxed);
                    }
                });
            }
        });
        assert_eq!(extensions.get::<AtomicU32>().load(Ordering::Relaxed), 800);
        assert_eq!(extensions.get::<AtomicU64>().load(Ordering::Relaxed), 1600);
    }
}
