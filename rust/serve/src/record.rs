//! Records responses: their progress on a connection, and metrics and a log entry for each finished one.

use std::collections::HashMap;
use std::net::IpAddr;
use std::pin::Pin;
use std::sync::Arc;
use std::task::{Context, Poll, ready};
use std::time::{Duration, Instant};

use axum::body::Body;
use axum::http::{Request, Response, Version};
use bytes::Bytes;
use http_body::{Body as HttpBody, Frame, SizeHint};
use parking_lot::Mutex;

use crate::router::Router;

/// Maximum number of a path's characters in the log.
const MAX_PATH_CHARS: usize = 400;

/// Answers a request. The response is recorded when its last byte is read, or when it is aborted. Its body is sent in
/// pieces of at most `piece` bytes.
pub async fn answer<B>(
    router: Arc<Router>,
    flow: Arc<Flow>,
    piece: usize,
    client: IpAddr,
    request: Request<B>,
) -> Response<RecordedBody> {
    let progress = flow.add();
    let started = Instant::now();
    let (method, version) = (request.method().to_string(), request.version());
    let path: String = request.uri().path().chars().take(MAX_PATH_CHARS).collect();
    let answer = Arc::clone(&router).answer(client, request).await;
    let code = answer.status().as_u16();
    answer.map(|body| {
        progress.mark_pending();
        let is_whole = body.is_end_stream();
        let exchange = Exchange { router, client, method, path, version, code, started, sent: 0, is_whole };
        RecordedBody { body, unsent: Bytes::new(), piece, exchange, progress }
    })
}

/// Response body that records its end.
pub struct RecordedBody {
    body: Body,
    /// Bytes of the body that are not sent yet.
    unsent: Bytes,
    piece: usize,
    exchange: Exchange,
    progress: ResponseProgress,
}

impl HttpBody for RecordedBody {
    type Data = Bytes;
    type Error = axum::Error;

    fn poll_frame(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
    ) -> Poll<Option<Result<Frame<Bytes>, axum::Error>>> {
        let this = &mut *self;
        this.progress.mark_read();
        if this.unsent.is_empty() {
            let Some(frame) = ready!(Pin::new(&mut this.body).poll_frame(context)?) else {
                this.exchange.is_whole = true;
                return Poll::Ready(None);
            };
            match frame.into_data() {
                Ok(data) => this.unsent = data,
                // Responses have no trailers.
                Err(frame) => return Poll::Ready(Some(Ok(frame))),
            }
        }
        let piece = this.unsent.split_to(this.piece.min(this.unsent.len()));
        this.exchange.sent += piece.len() as u64;
        this.exchange.is_whole = this.is_end_stream();
        this.progress.mark_pending();
        Poll::Ready(Some(Ok(Frame::data(piece))))
    }

    fn is_end_stream(&self) -> bool {
        self.unsent.is_empty() && self.body.is_end_stream()
    }

    fn size_hint(&self) -> SizeHint {
        let (body, unsent) = (self.body.size_hint(), self.unsent.len() as u64);
        let mut hint = SizeHint::new();
        if let Some(upper) = body.upper() {
            hint.set_upper(upper + unsent);
        }
        hint.set_lower(body.lower() + unsent);
        hint
    }
}

/// A request and its outcome.
struct Exchange {
    router: Arc<Router>,
    client: IpAddr,
    method: String,
    path: String,
    version: Version,
    code: u16,
    started: Instant,
    sent: u64,
    is_whole: bool,
}

impl Drop for Exchange {
    fn drop(&mut self) {
        let duration = self.started.elapsed();
        self.router.metrics.count_response(self.code, duration, self.sent);
        tracing::info!(
            target: "nearfar_serve::answers",
            client = %self.client,
            method = %self.method,
            path = self.path.as_str(),
            version = ?self.version,
            code = self.code,
            bytes = self.sent,
            whole = self.is_whole,
            seconds = duration.as_secs_f64(),
            "answered"
        );
    }
}

/// Responses in progress on one connection, to detect an HTTP/2 client that reads nothing: HTTP/2 flow control then
/// stops all writes to the socket, so a write timeout of the socket never starts.
pub struct Flow(Mutex<State>);

struct State {
    /// Time at which each response's bytes began to wait for the client; none while the server prepares bytes.
    pending_since: HashMap<u64, Option<Instant>>,
    count: u64,
    /// End of the last response.
    last_end: Instant,
}

impl Flow {
    pub fn new() -> Arc<Self> {
        Arc::new(Flow(Mutex::new(State { pending_since: HashMap::new(), count: 0, last_end: Instant::now() })))
    }

    /// Adds a response, which ends when the returned value is dropped.
    pub fn add(self: &Arc<Self>) -> ResponseProgress {
        let mut state = self.0.lock();
        state.count += 1;
        let number = state.count;
        state.pending_since.insert(number, None);
        drop(state);
        ResponseProgress { flow: Arc::clone(self), number }
    }

    /// Reason to close the connection, if any: no request for `idle`, or no bytes read for `silence`.
    pub fn close_reason(&self, idle: Duration, silence: Duration) -> Option<&'static str> {
        let state = self.0.lock();
        if state.pending_since.is_empty() {
            return (state.last_end.elapsed() > idle).then_some("idle");
        }
        let is_silent = |pending: &Option<Instant>| pending.is_some_and(|since| since.elapsed() > silence);
        state.pending_since.values().any(is_silent).then_some("silence")
    }
}

/// A response in progress.
pub struct ResponseProgress {
    flow: Arc<Flow>,
    number: u64,
}

impl ResponseProgress {
    /// Records that bytes are waiting for the client.
    pub fn mark_pending(&self) {
        self.flow.0.lock().pending_since.insert(self.number, Some(Instant::now()));
    }

    /// Records that the client has read the waiting bytes.
    pub fn mark_read(&self) {
        self.flow.0.lock().pending_since.insert(self.number, None);
    }
}

impl Drop for ResponseProgress {
    fn drop(&mut self) {
        let mut state = self.flow.0.lock();
        state.pending_since.remove(&self.number);
        state.last_end = Instant::now();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LONG: Duration = Duration::from_secs(3600);

    #[test]
    fn connections_without_requests_or_reads_are_closed() {
        let flow = Flow::new();
        assert_eq!(flow.close_reason(Duration::ZERO, LONG), Some("idle"));
        assert_eq!(flow.close_reason(LONG, Duration::ZERO), None);
        let (first, second) = (flow.add(), flow.add());
        assert_eq!(flow.close_reason(Duration::ZERO, Duration::ZERO), None, "the server prepares bytes");
        first.mark_pending();
        assert_eq!(flow.close_reason(Duration::ZERO, Duration::ZERO), Some("silence"));
        assert_eq!(flow.close_reason(Duration::ZERO, LONG), None);
        first.mark_read();
        assert_eq!(flow.close_reason(Duration::ZERO, Duration::ZERO), None);
        second.mark_pending();
        drop(second);
        assert_eq!(flow.close_reason(Duration::ZERO, Duration::ZERO), None);
        drop(first);
        assert_eq!(flow.close_reason(Duration::ZERO, LONG), Some("idle"));
    }
}
