//! Runs kernels with the interpreter released, while the caller polls signals.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use nearfar_core::base::memory::check_headroom;
use nearfar_core::base::{Progress, Result, pool};
use pyo3::prelude::*;

use super::errors::{from_panic, to_python};

/// A Python function that is called as `report(done, total)`.
pub type Report = Option<Py<PyAny>>;

/// Interval of signal checks and progress reports while the caller waits.
const POLL_INTERVAL: Duration = Duration::from_millis(50);

/// Returns whether the process has a limit of its address space, which makes allocations fail. Without one, kernels need
/// not ask for headroom, which takes 10 µs each time.
#[cfg(unix)]
fn is_memory_limited() -> bool {
    rustix::process::getrlimit(rustix::process::Resource::As).current.is_some()
}

/// Returns false: Windows has no such limit, and requests for headroom would slow every kernel there.
#[cfg(not(unix))]
fn is_memory_limited() -> bool {
    false
}

/// Fails if a limit of the process leaves no headroom; returns whether there is a limit.
fn begin() -> PyResult<bool> {
    let is_limited = is_memory_limited();
    if is_limited {
        check_headroom().map_err(to_python)?;
    }
    Ok(is_limited)
}

/// Runs a kernel on the pool without checking signals meanwhile: for kernels that take milliseconds, and for kernels
/// that Python calls in `background.run`.
pub fn short<R: Send>(py: Python<'_>, kernel: impl FnOnce() -> Result<R> + Send) -> PyResult<R> {
    begin()?;
    py.detach(|| catch_unwind(AssertUnwindSafe(|| pool::install(kernel).and_then(|result| result))))
        .map_err(|payload| from_panic(payload.as_ref()))?
        .map_err(to_python)
}

/// Runs a kernel on the pool. Every 50 ms the calling thread polls signals and calls `report(done, total)`. An
/// exception from either cancels the kernel and is raised after the kernel has stopped. A kernel that ends within 50 ms
/// costs no more than with `short`.
pub fn long<R: Send>(
    py: Python<'_>,
    report: Report,
    kernel: impl FnOnce(&Progress) -> Result<R> + Send,
) -> PyResult<R> {
    let progress = Progress::watching_memory(begin()?);
    let (outcome, exception) = py.detach(|| {
        let (sender, receiver) = channel();
        let (progress, mut exception) = (&progress, None);
        let run = move || {
            let outcome = catch_unwind(AssertUnwindSafe(|| kernel(progress)));
            // Sending cannot fail: the receiver waits for the outcome and so outlives this task.
            let _ = sender.send(outcome);
        };
        let outcome = pool::beside(run, || {
            loop {
                match receiver.recv_timeout(POLL_INTERVAL) {
                    Ok(outcome) => break Some(outcome),
                    Err(RecvTimeoutError::Disconnected) => break None,
                    Err(RecvTimeoutError::Timeout) if exception.is_none() => {
                        if let Err(error) = Python::attach(|py| poll(py, report.as_ref(), progress)) {
                            progress.cancel();
                            exception = Some(error);
                        }
                    }
                    Err(RecvTimeoutError::Timeout) => {}
                }
            }
        });
        (outcome, exception)
    });
    if let Some(error) = exception {
        return Err(error);
    }
    match outcome.map_err(to_python)? {
        Some(Ok(Ok(value))) => {
            poll(py, report.as_ref(), &progress)?;
            Ok(value)
        }
        Some(Ok(Err(error))) => Err(to_python(error)),
        Some(Err(payload)) => Err(from_panic(payload.as_ref())),
        None => Err(from_panic(&"a kernel ended without an outcome")),
    }
}

/// Raises a pending signal's exception, and calls `report`.
fn poll(py: Python<'_>, report: Option<&Py<PyAny>>, progress: &Progress) -> PyResult<()> {
    py.check_signals()?;
    match report {
        Some(report) => report.call1(py, progress.state()).map(drop),
        None => Ok(()),
    }
}
