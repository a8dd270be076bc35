//! One connection: plain or encrypted, HTTP/1.1 or HTTP/2, within its limits.

use std::convert::Infallible;
use std::io;
use std::net::IpAddr;
use std::pin::{Pin, pin};
use std::sync::{Arc, OnceLock};
use std::time::Duration;

use axum::body::Body;
use axum::http::{Request, Response, StatusCode, Uri};
use futures_util::future::{Either, select};
use hyper::body::Incoming;
use hyper::server::conn::{http1, http2};
use hyper::service::service_fn;
use hyper::upgrade::OnUpgrade;
use hyper_util::rt::{TokioExecutor, TokioIo, TokioTimer};
use tokio::net::TcpStream;
use tokio::sync::watch;
use tokio::time::{sleep, timeout};
use tokio_io_timeout::TimeoutStream;
use tokio_rustls::TlsAcceptor;

use crate::clients::{Entry, Limits};
use crate::record::Flow;
use crate::rooms::{self, Duplex, Entrance, Outbox, Reason, Session};
use crate::router::Router;
use crate::{record, respond};

/// First byte of an encrypted connection: type of the TLS handshake record.
const TLS_HANDSHAKE: u8 = 0x16;
/// ALPN name of HTTP/2.
const H2: &[u8] = b"h2";
/// Concurrent responses on an HTTP/2 connection; browsers request as many.
const MAX_STREAMS: u32 = 100;
/// Send buffer of an HTTP/2 stream, bytes.
const SEND_BUFFER_BYTES: usize = 1 << 16;
/// Bytes that a response passes to the send buffer at once.
const PIECE_BYTES: usize = 1 << 14;
/// Unsent bytes of a user's frames that the kernel buffers (TCP_NOTSENT_LOWAT).
#[cfg(target_os = "linux")]
const UNSENT_BYTES: u32 = 1 << 12;

/// Signals the server's shutdown.
pub type Shutdown = watch::Receiver<()>;

/// State shared by all connections.
pub struct Shared {
    pub router: Arc<Router>,
    pub limits: Limits,
    pub tls: Option<TlsAcceptor>,
}

/// Serves a connection until it ends. The error is the reason, for metrics, if the server ended it.
pub async fn serve(shared: &Shared, stream: TcpStream, client: IpAddr, shutdown: Shutdown) -> Result<(), &'static str> {
    let limits = shared.limits;
    // Without TCP_NODELAY the end of a short response waits for the client's acknowledgement.
    let _ = stream.set_nodelay(true);
    let Some(tls) = &shared.tls else {
        return serve_http1(shared, with_write_timeout(stream, limits), |stream| stream.get_ref(), client, shutdown)
            .await;
    };
    let mut first = [0; 1];
    match timeout(limits.headers, stream.peek(&mut first)).await {
        Err(_) => return Err("headers"),
        Ok(Err(_) | Ok(0)) => return Ok(()),
        Ok(Ok(_)) if first[0] != TLS_HANDSHAKE => {
            return serve_redirect(shared, with_write_timeout(stream, limits), shutdown).await;
        }
        Ok(Ok(_)) => {}
    }
    let accepted =
        timeout(limits.headers, tls.accept(with_write_timeout(stream, limits))).await.map_err(|_| "headers")?;
    let stream = accepted.map_err(|error| handshake_failure(client, &error))?;
    if stream.get_ref().1.alpn_protocol() == Some(H2) {
        serve_http2(shared, stream, client, shutdown).await
    } else {
        serve_http1(shared, stream, |stream| stream.get_ref().0.get_ref(), client, shutdown).await
    }
}

/// Serves an admitted connection in a new task, and counts it, with the reason if the server ended it.
pub fn spawn(
    shared: Arc<Shared>,
    entry: Entry,
    connection: impl Future<Output = Result<(), &'static str>> + Send + 'static,
) {
    tokio::spawn(async move {
        let metrics = &shared.router.metrics;
        metrics.connections.inc();
        if let Err(reason) = connection.await {
            metrics.count_lost(reason);
        }
        metrics.connections.dec();
        drop(entry);
    });
}

/// Logs a failed handshake; returns the reason for metrics.
pub fn handshake_failure(client: IpAddr, error: &dyn std::error::Error) -> &'static str {
    tracing::debug!(%client, %error, "a handshake failed");
    "handshake"
}

/// Runs a connection; calls `finish` at the server's shutdown, so that it accepts no more requests.
async fn run_until_shutdown<C: Future>(
    connection: C,
    mut shutdown: Shutdown,
    finish: impl FnOnce(Pin<&mut C>),
) -> C::Output {
    let mut connection = pin!(connection);
    tokio::select! {
        result = &mut connection => return result,
        _ = shutdown.changed() => {}
    }
    finish(connection.as_mut());
    connection.await
}

type TimedStream = Pin<Box<TimeoutStream<TcpStream>>>;

/// Adds a write timeout to a stream. Reads have none, because a client need not send anything while it waits.
fn with_write_timeout(stream: TcpStream, limits: Limits) -> TimedStream {
    let mut stream = TimeoutStream::new(stream);
    stream.set_write_timeout(Some(limits.silence));
    Box::pin(stream)
}

/// Size in bytes up to which hyper reads headers. The limit itself is half of it; the router checks it, by the same
/// count in all protocols.
fn buffer_bytes(limits: Limits) -> usize {
    2 * limits.header_bytes
}

fn http1_builder(limits: Limits) -> http1::Builder {
    let mut builder = http1::Builder::new();
    builder.timer(TokioTimer::new()).header_read_timeout(limits.headers).max_buf_size(buffer_bytes(limits));
    builder
}

/// Serves HTTP/1.1. `tcp` returns the TCP stream that carries `stream`.
async fn serve_http1<S: Duplex>(
    shared: &Shared,
    stream: S,
    tcp: fn(&S) -> &TcpStream,
    client: IpAddr,
    shutdown: Shutdown,
) -> Result<(), &'static str> {
    let (router, flow, upgraded) = (Arc::clone(&shared.router), Flow::new(), Arc::new(OnceLock::new()));
    let upgrade_slot = Arc::clone(&upgraded);
    let answer = service_fn(move |mut request: Request<Incoming>| {
        let (router, flow, upgrade_slot) = (Arc::clone(&router), Arc::clone(&flow), Arc::clone(&upgrade_slot));
        async move {
            let upgrade = hyper::upgrade::on(&mut request);
            let mut answer = record::answer(router, flow, usize::MAX, client, request).await;
            if let Some(entrance) = answer.extensions_mut().remove::<Entrance>() {
                // A connection is upgraded at most once.
                let _ = upgrade_slot.set((upgrade, entrance));
            }
            Ok::<_, Infallible>(answer)
        }
    });
    let connection = http1_builder(shared.limits).serve_connection(TokioIo::new(stream), answer).with_upgrades();
    let result =
        run_until_shutdown(connection, shutdown.clone(), http1::UpgradeableConnection::graceful_shutdown).await;
    let upgraded = upgraded.get().cloned();
    if let (Ok(()), Some(rooms), Some((upgrade, entrance))) = (&result, shared.router.rooms(), upgraded) {
        let session = Session::new(Arc::clone(rooms), entrance, std::time::Instant::now());
        serve_websocket(session, upgrade, tcp, client, shutdown).await;
    }
    end_reason(client, result)
}

/// Serves a user of a room over a connection upgraded to a WebSocket.
async fn serve_websocket<S: Duplex>(
    session: Session,
    upgrade: OnUpgrade,
    tcp: fn(&S) -> &TcpStream,
    client: IpAddr,
    shutdown: Shutdown,
) {
    let Ok(upgraded) = upgrade.await else { return };
    // The upgraded stream has the type of the original one.
    let Ok(parts) = upgraded.downcast::<TokioIo<S>>() else { return };
    let stream = parts.io.into_inner();
    // A small kernel buffer lets frames wait in the outbox, where newer poses replace older ones.
    #[cfg(target_os = "linux")]
    let _ = socket2::SockRef::from(tcp(&stream)).set_tcp_notsent_lowat(UNSENT_BYTES);
    let outbox = Arc::clone(&session.outbox);
    serve_user(rooms::serve(session, stream, parts.read_buf), &outbox, client, shutdown).await;
}

/// Drives a user's connection to a room until it ends or the server shuts down.
pub async fn serve_user(served: impl Future<Output = Reason>, outbox: &Outbox, client: IpAddr, shutdown: Shutdown) {
    // At shutdown the room notifies its users; the outbox also notifies clients that have not sent `hello`.
    let reason = run_until_shutdown(served, shutdown, |_| outbox.end(rooms::shutdown_end())).await;
    tracing::debug!(%client, reason = reason.name(), "a user's connection has ended");
}

async fn serve_http2<S: Duplex>(
    shared: &Shared,
    stream: S,
    client: IpAddr,
    shutdown: Shutdown,
) -> Result<(), &'static str> {
    let limits = shared.limits;
    let (router, flow) = (Arc::clone(&shared.router), Flow::new());
    let shared_flow = Arc::clone(&flow);
    let answer = service_fn(move |request: Request<Incoming>| {
        let (router, flow) = (Arc::clone(&router), Arc::clone(&shared_flow));
        async move { Ok::<_, Infallible>(record::answer(router, flow, PIECE_BYTES, client, request).await) }
    });
    let connection = http2::Builder::new(TokioExecutor::new())
        .timer(TokioTimer::new())
        .max_concurrent_streams(MAX_STREAMS)
        .max_header_list_size(u32::try_from(buffer_bytes(limits)).unwrap_or(u32::MAX))
        .max_send_buf_size(SEND_BUFFER_BYTES)
        .keep_alive_interval(limits.silence)
        .keep_alive_timeout(limits.silence)
        .serve_connection(TokioIo::new(stream), answer);
    let mut connection = pin!(run_until_shutdown(connection, shutdown, http2::Connection::graceful_shutdown));
    // The loop disconnects clients that answer pings but request nothing or read nothing.
    let pause = (limits.headers.min(limits.silence) / 4).max(Duration::from_millis(50));
    loop {
        // The pause is polled first: a connection with an unanswered ping ends by itself, without a reason.
        if let Either::Right((result, _)) = select(pin!(sleep(pause)), connection.as_mut()).await {
            return end_reason(client, result);
        }
        // The last bytes of a response may still be in the connection's send buffer.
        if let Some(reason) = flow.close_reason(limits.headers + limits.silence, limits.silence) {
            return Err(reason);
        }
    }
}

/// Redirects an unencrypted client to HTTPS.
async fn serve_redirect(shared: &Shared, stream: TimedStream, shutdown: Shutdown) -> Result<(), &'static str> {
    let router = Arc::clone(&shared.router);
    let answer = service_fn(move |request: Request<Incoming>| {
        let answer = redirect_to_https(&router, &request);
        async move { Ok::<_, Infallible>(answer) }
    });
    let mut builder = http1_builder(shared.limits);
    let connection = builder.keep_alive(false).serve_connection(TokioIo::new(stream), answer);
    run_until_shutdown(connection, shutdown, http1::Connection::graceful_shutdown).await.map_err(|_| "error")
}

fn redirect_to_https<B>(router: &Router, request: &Request<B>) -> Response<Body> {
    const REASON: &str = "the server answers only over https";
    if let Err((status, reason)) = router.check(request) {
        return respond::text_response(status, reason);
    }
    let target = router.host(request).and_then(|host| {
        let path = request.uri().path_and_query()?.as_str();
        Uri::builder().scheme("https").authority(host).path_and_query(path).build().ok()
    });
    match target {
        Some(target) => respond::redirection(&target.to_string(), REASON),
        None => respond::text_response(StatusCode::BAD_REQUEST, REASON),
    }
}

/// Returns the reason if the server ended the connection because of a timeout or a malformed request; a client that
/// disconnects is no error.
fn end_reason(client: IpAddr, result: hyper::Result<()>) -> Result<(), &'static str> {
    let Err(error) = result else { return Ok(()) };
    tracing::debug!(%client, %error, "a connection broke off");
    let cause = std::error::Error::source(&error).and_then(|cause| cause.downcast_ref::<io::Error>());
    match cause.map(io::Error::kind) {
        _ if error.is_timeout() => Err("headers"),
        Some(io::ErrorKind::TimedOut) => Err("silence"),
        _ if error.is_parse() => Err("request"),
        _ => Ok(()),
    }
}
