//! Thread pool of nearfar, created on first use and again in a forked child. `NEARFAR_NUM_THREADS` sets its size.

use std::process;
use std::ptr;
use std::sync::atomic::{AtomicPtr, Ordering};

use rayon::{ThreadPool, ThreadPoolBuilder};

use super::memory::room_for;
use super::{Error, Result};

/// Environment variable that holds the number of threads.
const VARIABLE: &str = "NEARFAR_NUM_THREADS";

/// Address space of a thread, bytes: Rust's stack of 2 MiB and what the system adds to it.
const THREAD_BYTES: u64 = 3 << 20;

struct PoolEntry {
    process: u32,
    pool: ThreadPool,
}

/// Pool of this process. An atomic pointer instead of a lock: a lock held by another thread during a fork would stay
/// locked in the child process for ever.
static CURRENT: AtomicPtr<PoolEntry> = AtomicPtr::new(ptr::null_mut());

/// Runs `work` on the pool, so that every rayon call inside uses it.
pub fn install<R: Send>(work: impl FnOnce() -> R + Send) -> Result<R> {
    Ok(current()?.install(work))
}

/// Runs `work` on the pool like `install`, while the calling thread runs `meanwhile`. Returns after both.
pub fn beside<'s, R>(work: impl FnOnce() + Send + 's, meanwhile: impl FnOnce() -> R) -> Result<R> {
    Ok(current()?.in_place_scope(|scope: &rayon::Scope<'s>| {
        scope.spawn(move |_| work());
        meanwhile()
    }))
}

/// Returns the number of threads of the pool.
pub fn thread_count() -> Result<usize> {
    Ok(current()?.current_num_threads())
}

fn current() -> Result<&'static ThreadPool> {
    let loaded = CURRENT.load(Ordering::Acquire);
    // SAFETY: CURRENT is null or points to a leaked `PoolEntry`, which is never freed.
    if let Some(entry) = unsafe { loaded.as_ref() }
        && entry.process == process::id()
    {
        return Ok(&entry.pool);
    }
    let fresh = Box::into_raw(Box::new(PoolEntry { process: process::id(), pool: build()? }));
    match CURRENT.compare_exchange(loaded, fresh, Ordering::AcqRel, Ordering::Acquire) {
        // SAFETY: the entry was just leaked and is never freed. The entry of the parent process stays leaked in a
        // child, because its threads do not exist there and joining them would hang.
        Ok(_) => Ok(&unsafe { &*fresh }.pool),
        Err(winner) => {
            // SAFETY: this thread's entry was never published; another thread leaked the winner's entry.
            let (_ours, theirs) = unsafe { (Box::from_raw(fresh), &*winner) };
            Ok(&theirs.pool)
        }
    }
}

fn build() -> Result<ThreadPool> {
    let count = match requested_threads(std::env::var(VARIABLE).ok().as_deref())? {
        0 => std::thread::available_parallelism().map_or(1, usize::from),
        count => count,
    };
    // If there is no memory for a thread's stack, starting the thread aborts the process.
    room_for(THREAD_BYTES * count as u64)?;
    ThreadPoolBuilder::new()
        .num_threads(count)
        .thread_name(|index| format!("nearfar-{index}"))
        .build()
        .map_err(|error| Error::value(VARIABLE, "a number of threads that the system grants", error))
}

/// Parses the variable. Returns 0 if it is unset or empty; the pool then has a thread for each available core.
fn requested_threads(value: Option<&str>) -> Result<usize> {
    match value.map(str::trim) {
        None | Some("") => Ok(0),
        Some(text) => match text.parse() {
            Ok(count @ 1..=1024) => Ok(count),
            _ => Err(Error::value(VARIABLE, "a whole number from 1 to 1024", format!("'{text}'"))),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_variable_is_read_strictly() {
        assert_eq!(requested_threads(None), Ok(0));
        assert_eq!(requested_threads(Some(" 3 ")), Ok(3));
        for wrong in ["0", "-1", "two", "1.5", "99999"] {
            assert!(requested_threads(Some(wrong)).is_err(), "{wrong}");
        }
    }

    #[test]
    fn every_call_uses_the_same_pool() {
        let first: *const ThreadPool = current().unwrap();
        let second: *const ThreadPool = current().unwrap();
        assert_eq!(first, second);
        assert_eq!(install(rayon::current_num_threads), thread_count());
    }
}
