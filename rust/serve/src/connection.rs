//! One connection: plain or encrypted, HTTP/1.1 or HTTP/2, within its limits.

use std::convert::Infallible;
use std::io;
use std::net::IpAddr;
use std::pin::{Pin, pin};
use std::sync::{Arc, OnceLock};
use std::time::Duration;

use axum::body::Body;
use axum::http::{Request, Response, StatusCode, Uri, header};
use hyper::body::Incoming;
use hyper::server::conn::{http1, http2};
use hyper::service::service_fn;
use hyper::upgrade::OnUpgrade;
use hyper_util::rt::{TokioExecutor, TokioIo, TokioTimer};
use tokio::io::{AsyncRead, AsyncWrite};
use tokio::net::TcpStream;
use tokio::sync::watch;
use tokio::time::timeout;
use tokio_io_timeout::TimeoutStream;
use tokio_rustls::TlsAcceptor;
use tokio_rustls::server::TlsStream;

use crate::flow::Flow;
use crate::limits::Limits;
use crate::rooms::{self, Entering, Session};
use crate::router::Router;
use crate::{record, respond};

/// First byte of an encrypted connection: type of the TLS handshake record.
const HANDSHAKE: u8 = 0x16;
/// ALPN name of HTTP/2.
const H2: &[u8] = b"h2";
/// Concurrent responses on an HTTP/2 connection; browsers request as many.
const STREAMS: u32 = 100;
/// Send buffer of an HTTP/2 stream, bytes.
const WAITING: usize = 1 << 16;
/// Bytes that a response passes to the send buffer at once.
const PIECE: usize = 1 << 14;
/// Unsent bytes of a user's frames that the kernel buffers (TCP_NOTSENT_LOWAT).
#[cfg(target_os = "linux")]
const UNSENT: u32 = 1 << 12;

/// Signals the server's shutdown.
pub type Ends = watch::Receiver<()>;

/// State shared by all connections.
pub struct Shared {
    pub router: Arc<Router>,
    pub limits: Limits,
    pub tls: Option<TlsAcceptor>,
}

/// Serves a connection until it ends; an error is the reason why the server ended it.
pub async fn serve(shared: &Shared, stream: TcpStream, client: IpAddr, ends: Ends) -> Result<(), &'static str> {
    let limits = shared.limits;
    // Without TCP_NODELAY the end of a short response waits for the client's acknowledgement.
    let _ = stream.set_nodelay(true);
    let Some(tls) = &shared.tls else { return http1(shared, limited(stream, limits), client, ends).await };
    let mut first = [0; 1];
    match timeout(limits.headers, stream.peek(&mut first)).await {
        Err(_) => return Err("headers"),
        Ok(Err(_) | Ok(0)) => return Ok(()),
        Ok(Ok(_)) if first[0] != HANDSHAKE => return to_https(shared, limited(stream, limits), ends).await,
        Ok(Ok(_)) => {}
    }
    let stream = match timeout(limits.headers, tls.accept(limited(stream, limits))).await {
        Err(_) => return Err("headers"),
        Ok(Err(error)) => {
            tracing::debug!(%client, %error, "a handshake failed");
            return Err("handshake");
        }
        Ok(Ok(stream)) => stream,
    };
    if stream.get_ref().1.alpn_protocol() == Some(H2) {
        http2(shared, stream, client, ends).await
    } else {
        http1(shared, stream, client, ends).await
    }
}

/// Runs a connection; calls `finish` at the server's shutdown, so that it accepts no more requests.
pub async fn watched<C: Future>(connection: C, mut ends: Ends, finish: impl FnOnce(Pin<&mut C>)) -> C::Output {
    let mut connection = pin!(connection);
    tokio::select! {
        result = &mut connection => return result,
        _ = ends.changed() => {}
    }
    finish(connection.as_mut());
    connection.await
}

type Limited = Pin<Box<TimeoutStream<TcpStream>>>;

/// A stream over TCP.
trait OverTcp: AsyncRead + AsyncWrite + Unpin + Send + 'static {
    /// Underlying TCP stream.
    fn tcp(&self) -> &TcpStream;
}

impl OverTcp for Limited {
    fn tcp(&self) -> &TcpStream {
        self.get_ref()
    }
}

impl OverTcp for TlsStream<Limited> {
    fn tcp(&self) -> &TcpStream {
        self.get_ref().0.tcp()
    }
}

/// Adds a write timeout to a stream. Reads have none, because a client need not send anything while it waits.
fn limited(stream: TcpStream, limits: Limits) -> Limited {
    let mut stream = TimeoutStream::new(stream);
    stream.set_write_timeout(Some(limits.silence));
    Box::pin(stream)
}

fn http1_within(limits: Limits) -> http1::Builder {
    let mut builder = http1::Builder::new();
    builder.timer(TokioTimer::new()).header_read_timeout(limits.headers).max_buf_size(limits.header_bytes);
    builder
}

async fn http1<S: OverTcp>(shared: &Shared, stream: S, client: IpAddr, ends: Ends) -> Result<(), &'static str> {
    let (router, flow, entered) = (Arc::clone(&shared.router), Flow::new(), Arc::new(OnceLock::new()));
    let enters = Arc::clone(&entered);
    let answer = service_fn(move |mut request: Request<Incoming>| {
        let (router, flow, enters) = (Arc::clone(&router), Arc::clone(&flow), Arc::clone(&enters));
        async move {
            let upgrade = hyper::upgrade::on(&mut request);
            let mut answer = record::answer(router, flow, usize::MAX, client, request).await;
            if let Some(entering) = answer.extensions_mut().remove::<Entering>() {
                // A connection is upgraded at most once.
                let _ = enters.set((upgrade, entering));
            }
            Ok::<_, Infallible>(answer)
        }
    });
    let connection = http1_within(shared.limits).serve_connection(TokioIo::new(stream), answer).with_upgrades();
    let result = watched(connection, ends.clone(), http1::UpgradeableConnection::graceful_shutdown).await;
    if let (Ok(()), Some(rooms), Some((upgrade, entering))) = (&result, shared.router.rooms(), entered.get().cloned()) {
        let session = Session::new(Arc::clone(rooms), entering, std::time::Instant::now());
        enter::<S>(session, upgrade, client, ends).await;
    }
    ended(client, result)
}

/// Serves a user of a room over a connection upgraded to a WebSocket.
async fn enter<S: OverTcp>(session: Session, upgrade: OnUpgrade, client: IpAddr, ends: Ends) {
    let Ok(upgraded) = upgrade.await else { return };
    // The type is that of the original stream.
    let Ok(parts) = upgraded.downcast::<TokioIo<S>>() else { return };
    let stream = parts.io.into_inner();
    // A small kernel buffer lets frames wait in the outbox, where newer poses replace older ones.
    #[cfg(target_os = "linux")]
    let _ = socket2::SockRef::from(stream.tcp()).set_tcp_notsent_lowat(UNSENT);
    let outbox = Arc::clone(&session.outbox);
    let served = rooms::serve(session, stream, parts.read_buf);
    // The room notifies its users; the outbox reaches also those who have not sent hello.
    let reason = watched(served, ends, |_| outbox.end(rooms::ending())).await;
    tracing::debug!(%client, reason = reason.name(), "a user's connection has ended");
}

async fn http2<S>(shared: &Shared, stream: S, client: IpAddr, ends: Ends) -> Result<(), &'static str>
where
    S: AsyncRead + AsyncWrite + Unpin + Send + 'static,
{
    let limits = shared.limits;
    let (router, flow) = (Arc::clone(&shared.router), Flow::new());
    let shown = Arc::clone(&flow);
    let answer = service_fn(move |request: Request<Incoming>| {
        let (router, flow) = (Arc::clone(&router), Arc::clone(&flow));
        async move { Ok::<_, Infallible>(record::answer(router, flow, PIECE, client, request).await) }
    });
    let connection = http2::Builder::new(TokioExecutor::new())
        .timer(TokioTimer::new())
        .max_concurrent_streams(STREAMS)
        .max_header_list_size(u32::try_from(limits.header_bytes).unwrap_or(u32::MAX))
        .max_send_buf_size(WAITING)
        .keep_alive_interval(limits.silence)
        .keep_alive_timeout(limits.silence)
        .serve_connection(TokioIo::new(stream), answer);
    let mut connection = pin!(watched(connection, ends, http2::Connection::graceful_shutdown));
    // Disconnects clients that answer pings but request nothing or read nothing.
    let pause = (limits.headers.min(limits.silence) / 4).max(Duration::from_millis(50));
    loop {
        match timeout(pause, &mut connection).await {
            Ok(result) => return ended(client, result),
            Err(_) => {
                // The last bytes of a response may still be in the connection's send buffer.
                if let Some(reason) = shown.end(limits.headers + limits.silence, limits.silence) {
                    return Err(reason);
                }
            }
        }
    }
}

/// Redirects unencrypted clients to HTTPS.
async fn to_https(shared: &Shared, stream: Limited, ends: Ends) -> Result<(), &'static str> {
    let router = Arc::clone(&shared.router);
    let answer = service_fn(move |request: Request<Incoming>| {
        let answer = redirect_to_https(&router, &request);
        async move { Ok::<_, Infallible>(answer) }
    });
    let mut builder = http1_within(shared.limits);
    let connection = builder.keep_alive(false).serve_connection(TokioIo::new(stream), answer);
    watched(connection, ends, http1::Connection::graceful_shutdown).await.map_err(|_| "error")
}

fn redirect_to_https<B>(router: &Router, request: &Request<B>) -> Response<Body> {
    let host = router.host(request).filter(|_| router.is_called_by_its_name(request)).map(str::to_owned);
    let target = host.and_then(|host| {
        let path = request.uri().path_and_query()?.as_str();
        Uri::builder().scheme("https").authority(host).path_and_query(path).build().ok()
    });
    match target {
        Some(target) => {
            let mut answer = respond::refusal(StatusCode::PERMANENT_REDIRECT, "the server answers only over https");
            if let Ok(value) = target.to_string().parse() {
                answer.headers_mut().insert(header::LOCATION, value);
            }
            answer
        }
        None => respond::refusal(StatusCode::BAD_REQUEST, "the server answers only over https"),
    }
}

/// Disconnected clients are no error; timeouts and malformed requests are returned as reasons.
fn ended(client: IpAddr, result: hyper::Result<()>) -> Result<(), &'static str> {
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
