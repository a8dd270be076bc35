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
    let (mut kernel, mut outcome) = (Some(kernel), None);
    run(py, &mut || outcome = kernel.take().map(|kernel| catch_unwind(AssertUnwindSafe(kernel))))?;
    value_of(outcome)
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
    let (mut kernel, mut outcome) = (Some(kernel), None);
    let mut work = || outcome = kernel.take().map(|kernel| catch_unwind(AssertUnwindSafe(|| kernel(&progress))));
    run_watched(py, report.as_ref(), &progress, &mut work)?;
    let value = value_of(outcome)?;
    poll(py, report.as_ref(), &progress)?;
    Ok(value)
}

/// Result of a kernel, or the payload of its panic.
type Outcome<R> = std::thread::Result<Result<R>>;

/// A kernel without its type. The functions that run it would otherwise be compiled for each kernel, which took half of
/// this crate's compile time.
type Work<'a> = &'a mut (dyn FnMut() + Send);

fn value_of<R>(outcome: Option<Outcome<R>>) -> PyResult<R> {
    match outcome {
        Some(Ok(result)) => result.map_err(to_python),
        Some(Err(payload)) => Err(from_panic(payload.as_ref())),
        None => Err(from_panic(&"a kernel ended without an outcome")),
    }
}

fn run(py: Python<'_>, work: Work<'_>) -> PyResult<()> {
    py.detach(|| pool::install(work)).map_err(to_python)
}

fn run_watched(py: Python<'_>, report: Option<&Py<PyAny>>, progress: &Progress, work: Work<'_>) -> PyResult<()> {
    let exception = py.detach(|| {
        let (sender, receiver) = channel();
        let run = move || {
            work();
            // Sending cannot fail: the receiver waits for the end and so outlives this task.
            let _ = sender.send(());
        };
        let mut exception = None;
        pool::beside(run, || {
            while receiver.recv_timeout(POLL_INTERVAL) == Err(RecvTimeoutError::Timeout) {
                if exception.is_none()
                    && let Err(error) = Python::attach(|py| poll(py, report, progress))
                {
                    progress.cancel();
                    exception = Some(error);
                }
            }
        })?;
        Ok(exception)
    });
    match exception.map_err(to_python)? {
        Some(error) => Err(error),
        None => Ok(()),
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
