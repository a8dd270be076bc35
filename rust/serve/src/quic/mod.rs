//! Accepts WebTransport sessions over QUIC, within the limits on connections.

#[cfg(test)]
mod tests;

use std::error::Error;
use std::io;
use std::net::{IpAddr, SocketAddr, UdpSocket};
use std::sync::Arc;

use axum::http::header::{self, HeaderMap, HeaderValue};
use quinn::crypto::rustls::QuicServerConfig;
use quinn::{Connection, Endpoint, EndpointConfig, IdleTimeout, Incoming, ServerConfig, TokioRuntime, TransportConfig};
use rustls::server::ResolvesServerCert;
use time::OffsetDateTime;
use tokio::time::{Instant, timeout_at};

use crate::clients::{Gate, MAX_PENDING, PendingEntry, PendingGate};
use crate::connection::{self, Shared, Shutdown};
use crate::offer::{Offer, Pinned};
use crate::rooms::{self, Limits, Session};
use crate::router;
use crate::tls::{self, CurrentCertificate};
use crate::webtransport::session::{self, Broken, Link, SessionRequest};

/// Number of ports to try after the number of the TCP port; if none is free, the system chooses a port.
const EXTRA_PORTS: u16 = 16;
/// Receive window of a stream, and send window of a connection, bytes.
const WINDOW_BYTES: u32 = 1 << 15;
/// Unidirectional streams of a client: control stream, and two for QPACK.
const UNIDIRECTIONAL: u32 = 3;
/// Bidirectional streams: the request for a session, and the stream of frames.
const BIDIRECTIONAL: u32 = 2;
/// Receive buffer for datagrams, bytes; the oldest ones are dropped.
const RECEIVE_BUFFER_BYTES: usize = 1 << 14;
/// Bytes that QUIC's buffer counts for a datagram in addition to its payload.
const OVERHEAD_BYTES: usize = 64;
/// Buffer for connections that are not accepted yet, bytes.
const INCOMING_BUFFER_BYTES: u64 = 1 << 20;

/// A user's session and its connection, or the reason for rejection.
type Accepted = Result<(Session, Link), &'static str>;

/// Accepts QUIC connections.
pub struct Listener {
    endpoint: Endpoint,
    /// HTTP port, which is part of the pages' origin.
    port: u16,
    limits: Limits,
}

impl Listener {
    /// Binds a UDP socket for a TCP address. Uses the server's certificate if an authority has signed it, else a
    /// self-signed one that pages pin by its hash.
    pub fn bind(
        address: SocketAddr,
        limits: Limits,
        current: Option<&Arc<CurrentCertificate>>,
    ) -> io::Result<(Self, Offer)> {
        let socket = bind_socket(address)?;
        let signed = current.filter(|current| !current.identity().is_self_signed);
        let (pinned, resolver): (_, Arc<dyn ResolvesServerCert>) = match signed {
            Some(current) => (None, Arc::clone(current) as _),
            None => {
                let pinned = Arc::new(Pinned::new(OffsetDateTime::now_utc()).map_err(io::Error::other)?);
                (Some(Arc::clone(&pinned)), pinned)
            }
        };
        let config = config(resolver, limits).map_err(io::Error::other)?;
        let offer = Offer { port: socket.local_addr()?.port(), pinned };
        let endpoint = Endpoint::new(EndpointConfig::default(), Some(config), socket, Arc::new(TokioRuntime))?;
        Ok((Listener { endpoint, port: address.port(), limits }, offer))
    }

    /// Accepts connections until shutdown.
    pub async fn listen(self: Arc<Self>, shared: Arc<Shared>, gate: Gate, mut shutdown: Shutdown) {
        let pending_gate = PendingGate::new();
        loop {
            let incoming = tokio::select! {
                incoming = self.endpoint.accept() => incoming,
                _ = shutdown.changed() => break,
            };
            let Some(incoming) = incoming else { break };
            let client = incoming.remote_address().ip().to_canonical();
            let pending = match pending_gate.enter(client, incoming.remote_address_validated()) {
                PendingEntry::Admitted(pending) => Some(pending),
                PendingEntry::Unvalidated => {
                    // A retry makes the client prove its address. It fails only for clients that have done so.
                    let _ = incoming.retry();
                    continue;
                }
                PendingEntry::Full => None,
            };
            let (Some(pending), Some(entry)) = (pending, gate.enter(client)) else {
                shared.router.metrics.count_lost("connections");
                incoming.refuse();
                continue;
            };
            let (this, state, shutdown) = (Arc::clone(&self), Arc::clone(&shared), shutdown.clone());
            connection::spawn(Arc::clone(&shared), entry, async move {
                let accepted = this.accept(&state, incoming, client).await;
                drop(pending);
                let (session, link) = accepted?;
                let outbox = Arc::clone(&session.outbox);
                let served = rooms::serve_datagrams(session, link, state.limits.silence);
                connection::serve_user(served, &outbox, client, shutdown).await;
                Ok(())
            });
        }
        self.endpoint.set_server_config(None);
    }

    /// Waits until the last packets of closed connections are sent.
    pub async fn finish(&self) {
        self.endpoint.wait_idle().await;
    }

    /// Accepts a connection and admits it to a room.
    async fn accept(&self, shared: &Shared, incoming: Incoming, client: IpAddr) -> Accepted {
        let deadline = Instant::now() + self.limits.hello;
        let accepted = timeout_at(deadline, async { incoming.accept()?.await }).await.map_err(|_| "headers")?;
        let connection = accepted.map_err(|error| connection::handshake_failure(client, &error))?;
        timeout_at(deadline, self.enter(shared, &connection, client)).await.unwrap_or_else(|_| {
            session::reject(&connection);
            Err("headers")
        })
    }

    /// Answers a connection's request for a session.
    async fn enter(&self, shared: &Shared, connection: &Connection, client: IpAddr) -> Accepted {
        let mut session_request = SessionRequest::read(connection).await.map_err(|Broken| "request")?;
        self.set_host(session_request.request.headers_mut(), shared.tls.is_some());
        let rooms = shared.router.rooms().ok_or("request")?;
        match shared.router.entrance(client, &session_request.request) {
            Ok(entrance) => {
                let link = session_request.accept().await.map_err(|Broken| "request")?;
                Ok((Session::new(Arc::clone(rooms), entrance, std::time::Instant::now()), link))
            }
            Err(status) => {
                tracing::debug!(%client, code = status.as_u16(), "a session is refused");
                session_request.refuse(status, self.limits.linger).await;
                Err("request")
            }
        }
    }

    /// Replaces the Host header by the pages' host: the HTTP port may differ from the UDP port.
    fn set_host(&self, headers: &mut HeaderMap, is_encrypted: bool) {
        let host = headers.get(header::HOST).and_then(|host| host.to_str().ok()).unwrap_or_default();
        let name = router::without_port(host);
        let default_port = if is_encrypted { 443 } else { 80 };
        let host = if self.port == default_port { name.to_owned() } else { format!("{name}:{}", self.port) };
        if let Ok(host) = HeaderValue::try_from(host) {
            headers.insert(header::HOST, host);
        }
    }
}

/// Binds a UDP socket at a TCP address, or at the next free port.
fn bind_socket(address: SocketAddr) -> io::Result<UdpSocket> {
    let ports = (0..=EXTRA_PORTS).filter_map(|offset| address.port().checked_add(offset)).chain([0]);
    let mut failure = io::ErrorKind::AddrInUse.into();
    for port in ports {
        match UdpSocket::bind(SocketAddr::new(address.ip(), port)) {
            Ok(socket) => return Ok(socket),
            Err(error) => failure = error,
        }
    }
    Err(failure)
}

/// TLS and transport settings of connections.
fn config(resolver: Arc<dyn ResolvesServerCert>, limits: Limits) -> Result<ServerConfig, Box<dyn Error + Send + Sync>> {
    let tls = tls::server_config(resolver, &[&rustls::version::TLS13], &[b"h3"])?;
    let mut transport = TransportConfig::default();
    transport
        .max_concurrent_uni_streams(UNIDIRECTIONAL.into())
        .max_concurrent_bidi_streams(BIDIRECTIONAL.into())
        .stream_receive_window(WINDOW_BYTES.into())
        .receive_window(((UNIDIRECTIONAL + BIDIRECTIONAL) * WINDOW_BYTES).into())
        .send_window(WINDOW_BYTES.into())
        .datagram_receive_buffer_size(Some(RECEIVE_BUFFER_BYTES))
        .datagram_send_buffer_size(rooms::MAX_DATAGRAM_BYTES + OVERHEAD_BYTES)
        .max_idle_timeout(Some(IdleTimeout::try_from(limits.silence)?))
        .keep_alive_interval(Some(limits.ping));
    let mut config = ServerConfig::with_crypto(Arc::new(QuicServerConfig::try_from(tls)?));
    config
        .transport_config(Arc::new(transport))
        .max_incoming(MAX_PENDING)
        .incoming_buffer_size_total(INCOMING_BUFFER_BYTES);
    Ok(config)
}
