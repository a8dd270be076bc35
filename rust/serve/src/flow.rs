//! Progress of an HTTP/2 connection: its socket may be idle while every response waits for the client.

use std::collections::HashMap;
use std::sync::Arc;
use std::time::{Duration, Instant};

use parking_lot::Mutex;

/// Responses in progress on one connection.
pub struct Flow(Mutex<State>);

struct State {
    /// For each response, the time since which its bytes wait for the client; none while bytes are being made.
    answers: HashMap<u64, Option<Instant>>,
    begun: u64,
    /// End of the last response.
    ended: Instant,
}

impl Flow {
    pub fn new() -> Arc<Self> {
        Arc::new(Flow(Mutex::new(State { answers: HashMap::new(), begun: 0, ended: Instant::now() })))
    }

    /// Registers a response, which ends when the returned value is dropped.
    pub fn begin(self: &Arc<Self>) -> Answer {
        let mut state = self.0.lock();
        state.begun += 1;
        let number = state.begun;
        state.answers.insert(number, None);
        drop(state);
        Answer { flow: Arc::clone(self), number }
    }

    /// Reason to end the connection: no request for `idle`, or no bytes read for `silence`.
    pub fn end(&self, idle: Duration, silence: Duration) -> Option<&'static str> {
        let state = self.0.lock();
        if state.answers.is_empty() {
            return (state.ended.elapsed() > idle).then_some("idle");
        }
        let is_silent = |pending: &Option<Instant>| pending.is_some_and(|since| since.elapsed() > silence);
        state.answers.values().any(is_silent).then_some("silence")
    }
}

/// A response in progress.
pub struct Answer {
    flow: Arc<Flow>,
    number: u64,
}

impl Answer {
    /// Records that bytes are waiting for the client.
    pub fn mark_pending(&self) {
        self.flow.0.lock().answers.insert(self.number, Some(Instant::now()));
    }

    /// Records that the client has read them.
    pub fn mark_read(&self) {
        self.flow.0.lock().answers.insert(self.number, None);
    }
}

impl Drop for Answer {
    fn drop(&mut self) {
        let mut state = self.flow.0.lock();
        state.answers.remove(&self.number);
        state.ended = Instant::now();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LONG: Duration = Duration::from_secs(3600);

    #[test]
    fn connections_without_requests_or_reads_are_closed() {
        let flow = Flow::new();
        assert_eq!(flow.end(Duration::ZERO, LONG), Some("idle"));
        assert_eq!(flow.end(LONG, Duration::ZERO), None);
        let (first, second) = (flow.begin(), flow.begin());
        assert_eq!(flow.end(Duration::ZERO, Duration::ZERO), None, "bytes are being made");
        first.mark_pending();
        assert_eq!(flow.end(Duration::ZERO, Duration::ZERO), Some("silence"));
        assert_eq!(flow.end(Duration::ZERO, LONG), None);
        first.mark_read();
        assert_eq!(flow.end(Duration::ZERO, Duration::ZERO), None);
        second.mark_pending();
        drop(second);
        assert_eq!(flow.end(Duration::ZERO, Duration::ZERO), None);
        drop(first);
        assert_eq!(flow.end(Duration::ZERO, LONG), Some("idle"));
    }
}
