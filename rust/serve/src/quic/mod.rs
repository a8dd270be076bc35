//! Accepts WebTransport sessions over QUIC, within the limits on connections.

mod greeters;

#[cfg(test)]
mod tests;

use std::error::Error;
use std::io;
use std::net::{IpAddr, SocketAddr, UdpSocket};
use std::sync::Arc;
use std::time::Duration;

use axum::http::header::{self, HeaderMap, HeaderValue};
use quinn::crypto::rustls::QuicServerConfig;
use quinn::{Connection, Endpoint, EndpointConfig, IdleTimeout, Incoming, ServerConfig, TokioRuntime, TransportConfig};
use rustls::crypto::ring;
use rustls::server::ResolvesServerCert;
use time::OffsetDateTime;
use tokio::time::{Instant, timeout_at};

use crate::clients::Gate;
use crate::connection::{Ends, Shared, watched};
use crate::offer::Offer;
use crate::pinned::Pinned;
use crate::rooms::{self, Limits, Session};
use crate::router;
use crate::tls::Current;
use crate::webtransport::session::{self, Asking, Broken, Link};
use greeters::{Found, GREETINGS, Greeters};

/// Number of ports to try after the TCP port; then any free port is used.
const PORTS: u16 = 16;
/// Receive window of a stream, and send window of a connection, bytes.
const WINDOW: u32 = 1 << 15;
/// Unidirectional streams of a client: control stream, and two for QPACK.
const ONE_WAY: u32 = 3;
/// Bidirectional streams: the request for a session, and the stream of frames.
const TWO_WAY: u32 = 2;
/// Receive buffer for datagrams, bytes; the oldest ones are dropped.
const READ: usize = 1 << 14;
/// Bytes that QUIC adds to a buffered datagram.
const AROUND: usize = 64;
/// Buffer for connections that are not accepted yet, bytes.
const UNTAKEN: u64 = 1 << 20;

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
    pub fn bind(address: SocketAddr, limits: Limits, current: Option<&Arc<Current>>) -> io::Result<(Self, Offer)> {
        let socket = socket(address)?;
        let signed = current.filter(|current| !current.identity().is_self_signed);
        let (pinned, resolver): (_, Arc<dyn ResolvesServerCert>) = match signed {
            Some(current) => (None, Arc::clone(current) as _),
            None => {
                let made = Arc::new(Pinned::new(OffsetDateTime::now_utc()).map_err(io::Error::other)?);
                (Some(Arc::clone(&made)), made)
            }
        };
        let config = config(resolver, limits).map_err(io::Error::other)?;
        let offer = Offer { port: socket.local_addr()?.port(), pinned };
        let endpoint = Endpoint::new(EndpointConfig::default(), Some(config), socket, Arc::new(TokioRuntime))?;
        Ok((Listener { endpoint, port: address.port(), limits }, offer))
    }

    /// Accepts connections until shutdown.
    pub async fn listen(self: Arc<Self>, shared: Arc<Shared>, gate: Gate, mut ends: Ends) {
        let greeters = Greeters::new();
        loop {
            let incoming = tokio::select! {
                incoming = self.endpoint.accept() => incoming,
                _ = ends.changed() => break,
            };
            let Some(incoming) = incoming else { break };
            let client = incoming.remote_address().ip().to_canonical();
            let greeter = match greeters.find(client, incoming.remote_address_validated()) {
                Found::Place(greeter) => Some(greeter),
                Found::Unproven => {
                    // A retry fails only for clients that were asked before.
                    let _ = incoming.retry();
                    continue;
                }
                Found::Full => None,
            };
            let (Some(greeter), Some(place)) = (greeter, gate.enter(client)) else {
                shared.router.metrics.lost("connections");
                incoming.refuse();
                continue;
            };
            let (this, shared, ends) = (Arc::clone(&self), Arc::clone(&shared), ends.clone());
            tokio::spawn(async move {
                shared.router.metrics.connections.inc();
                let greeted = this.greet(&shared, incoming, client).await;
                drop(greeter);
                match greeted {
                    Ok((session, link)) => follow(session, link, shared.limits.silence, client, ends).await,
                    Err(reason) => shared.router.metrics.lost(reason),
                }
                shared.router.metrics.connections.dec();
                drop(place);
            });
        }
        self.endpoint.set_server_config(None);
    }

    /// Waits until the last packets of closed connections are sent.
    pub async fn finish(&self) {
        self.endpoint.wait_idle().await;
    }

    /// Accepts a connection and admits it to a room; an error is the reason for rejection.
    async fn greet(
        &self,
        shared: &Shared,
        incoming: Incoming,
        client: IpAddr,
    ) -> Result<(Session, Link), &'static str> {
        let until = Instant::now() + self.limits.hello;
        let connection = match timeout_at(until, async { incoming.accept()?.await }).await {
            Ok(Ok(connection)) => connection,
            Ok(Err(error)) => {
                tracing::debug!(%client, %error, "a handshake failed");
                return Err("handshake");
            }
            Err(_) => return Err("headers"),
        };
        match timeout_at(until, self.enter(shared, &connection, client)).await {
            Ok(entered) => entered,
            Err(_) => {
                session::break_off(&connection);
                Err("headers")
            }
        }
    }

    /// Responds to a connection's request for a session.
    async fn enter(
        &self,
        shared: &Shared,
        connection: &Connection,
        client: IpAddr,
    ) -> Result<(Session, Link), &'static str> {
        let mut asking = Asking::read(connection).await.map_err(|Broken| "request")?;
        self.rename(asking.request.headers_mut(), shared.tls.is_some());
        let (Some(rooms), found) = (shared.router.rooms(), shared.router.entering(client, &asking.request)) else {
            return Err("request");
        };
        match found {
            Ok(entering) => {
                let link = asking.accept().await.map_err(|Broken| "request")?;
                Ok((Session::new(Arc::clone(rooms), entering, std::time::Instant::now()), link))
            }
            Err(status) => {
                tracing::debug!(%client, code = status.as_u16(), "a session is refused");
                asking.refuse(status, self.limits.linger).await;
                Err("request")
            }
        }
    }

    /// Replaces the Host header by the pages' host: the HTTP port may differ from the UDP port.
    fn rename(&self, headers: &mut HeaderMap, is_encrypted: bool) {
        let named = headers.get(header::HOST).and_then(|named| named.to_str().ok()).unwrap_or_default();
        let name = router::without_port(named);
        let usual = if is_encrypted { 443 } else { 80 };
        let own = if self.port == usual { name.to_owned() } else { format!("{name}:{}", self.port) };
        if let Ok(own) = HeaderValue::try_from(own) {
            headers.insert(header::HOST, own);
        }
    }
}

/// Serves a user of a room during its session.
async fn follow(session: Session, link: Link, silence: Duration, client: IpAddr, ends: Ends) {
    let outbox = Arc::clone(&session.outbox);
    let served = rooms::serve_datagrams(session, link, silence);
    // The room notifies its users; the outbox reaches also those who have not sent hello.
    let reason = watched(served, ends, |_| outbox.end(rooms::ending())).await;
    tracing::debug!(%client, reason = reason.name(), "a user's session has ended");
}

/// Binds a UDP socket at a TCP address, or at the next free port.
fn socket(address: SocketAddr) -> io::Result<UdpSocket> {
    let ports = (0..=PORTS).filter_map(|further| address.port().checked_add(further)).chain([0]);
    let mut taken = io::ErrorKind::AddrInUse.into();
    for port in ports {
        match UdpSocket::bind(SocketAddr::new(address.ip(), port)) {
            Ok(socket) => return Ok(socket),
            Err(error) => taken = error,
        }
    }
    Err(taken)
}

/// TLS and transport settings of connections.
fn config(resolver: Arc<dyn ResolvesServerCert>, limits: Limits) -> Result<ServerConfig, Box<dyn Error + Send + Sync>> {
    let builder = rustls::ServerConfig::builder_with_provider(Arc::new(ring::default_provider()));
    let builder = builder.with_protocol_versions(&[&rustls::version::TLS13])?.with_no_client_auth();
    let mut tls = builder.with_cert_resolver(resolver);
    tls.alpn_protocols = vec![b"h3".to_vec()];
    let mut transport = TransportConfig::default();
    let streams = ONE_WAY + TWO_WAY;
    transport
        .max_concurrent_uni_streams(ONE_WAY.into())
        .max_concurrent_bidi_streams(TWO_WAY.into())
        .stream_receive_window(WINDOW.into())
        .receive_window((streams * WINDOW).into())
        .send_window(WINDOW.into())
        .datagram_receive_buffer_size(Some(READ))
        .datagram_send_buffer_size(rooms::DATAGRAM + AROUND)
        .max_idle_timeout(Some(IdleTimeout::try_from(limits.silence)?))
        .keep_alive_interval(Some(limits.ping));
    let mut config = ServerConfig::with_crypto(Arc::new(QuicServerConfig::try_from(tls)?));
    config.transport_config(Arc::new(transport)).max_incoming(GREETINGS).incoming_buffer_size_total(UNTAKEN);
    Ok(config)
}
