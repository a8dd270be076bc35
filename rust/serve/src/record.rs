//! Metrics and log entry for each finished response.

use std::net::IpAddr;
use std::pin::Pin;
use std::sync::Arc;
use std::task::{Context, Poll, ready};
use std::time::Instant;

use axum::body::Body;
use axum::http::{Request, Response, Version};
use bytes::Bytes;
use http_body::{Body as HttpBody, Frame, SizeHint};

use crate::flow::{Answer, Flow};
use crate::router::Router;

/// Greatest number of a path's characters in the log.
const MAX_PATH_CHARS: usize = 400;

/// Responds to a request; the response is recorded when its last byte is read, or when it is aborted. The body is
/// sent in pieces of at most `piece` bytes.
pub async fn answer<B>(
    router: Arc<Router>,
    flow: Arc<Flow>,
    piece: usize,
    client: IpAddr,
    request: Request<B>,
) -> Response<Recorded> {
    let flow_entry = flow.begin();
    let started = Instant::now();
    let (method, version) = (request.method().to_string(), request.version());
    let path: String = request.uri().path().chars().take(MAX_PATH_CHARS).collect();
    let answer = Arc::clone(&router).answer(client, request).await;
    let code = answer.status().as_u16();
    answer.map(|body| {
        flow_entry.mark_pending();
        let is_whole = body.is_end_stream();
        let exchange = Exchange { router, client, method, path, version, code, started, sent: 0, is_whole };
        Recorded { body, unsent: Bytes::new(), piece, exchange, flow_entry }
    })
}

/// Response body that records its end.
pub struct Recorded {
    body: Body,
    /// Bytes of the body that are not sent yet.
    unsent: Bytes,
    piece: usize,
    exchange: Exchange,
    flow_entry: Answer,
}

impl HttpBody for Recorded {
    type Data = Bytes;
    type Error = axum::Error;

    fn poll_frame(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
    ) -> Poll<Option<Result<Frame<Bytes>, axum::Error>>> {
        let this = &mut *self;
        this.flow_entry.mark_read();
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
        this.flow_entry.mark_pending();
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
        let took = self.started.elapsed();
        self.router.metrics.answered(self.code, took, self.sent);
        tracing::info!(
            target: "nearfar_serve::answers",
            client = %self.client,
            method = %self.method,
            path = self.path.as_str(),
            version = ?self.version,
            code = self.code,
            bytes = self.sent,
            whole = self.is_whole,
            seconds = took.as_secs_f64(),
            "answered"
        );
    }
}
