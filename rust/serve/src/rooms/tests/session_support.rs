//! WebTransport users for tests.

use std::net::{Ipv4Addr, SocketAddr};

use data_encoding::HEXLOWER;
use tokio::time::timeout;
use wtransport::endpoint::ConnectOptions;
use wtransport::endpoint::endpoint_side::Client;
use wtransport::error::{ConnectingError, ConnectionError};
use wtransport::tls::Sha256Digest;
use wtransport::{ClientConfig, Connection, Endpoint, RecvStream, SendStream};

use super::support::{Channel, TEST_TIMEOUT, Transport, User, encode, split};
use crate::Server;
use crate::rooms::frame::{FromServer, FromUser};
use crate::rooms::{Datagrams, Reason};

/// A user's session.
pub struct Session {
    pub connection: Connection,
    /// Keeps the endpoint alive, which sends the packets.
    _endpoint: Endpoint<Client>,
    pub send: SendStream,
    receive: RecvStream,
    /// Received bytes of an incomplete frame of the stream.
    incomplete: Vec<u8>,
}

/// A user over WebTransport.
pub type Guest = User<Session>;

/// A session's connection and its endpoint.
type SessionResult = Result<(Connection, Endpoint<Client>), ConnectingError>;

/// A client that trusts the server's certificate by its hash.
fn client(datagrams: &Datagrams) -> Endpoint<Client> {
    let [hash] = &datagrams.hashes[..] else { panic!("one hash") };
    let hash = HEXLOWER.decode(hash.as_bytes()).expect("digits").try_into().expect("32 bytes");
    let address = SocketAddr::from((Ipv4Addr::LOCALHOST, 0));
    let config = ClientConfig::builder()
        .with_bind_address(address)
        .with_server_certificate_hashes([Sha256Digest::new(hash)])
        .build();
    Endpoint::client(config).expect("a socket")
}

/// Requests a session.
pub async fn request_session(server: &Server, path: &str, origin: Option<&str>) -> SessionResult {
    request_session_at(server.datagrams().expect("datagrams"), path, origin).await
}

async fn request_session_at(datagrams: Datagrams, path: &str, origin: Option<&str>) -> SessionResult {
    let endpoint = client(&datagrams);
    let mut options = ConnectOptions::builder(format!("https://127.0.0.1:{}{path}", datagrams.port));
    if let Some(origin) = origin {
        options = options.add_header("origin", origin);
    }
    let connection = timeout(TEST_TIMEOUT, endpoint.connect(options.build())).await.expect("an answer")?;
    Ok((connection, endpoint))
}

/// Starts a session with its stream, without joining the room.
pub async fn connect(server: &Server, path: &str) -> Guest {
    connect_at(server.datagrams().expect("datagrams"), path).await
}

/// Like `connect`, for given datagram settings.
pub async fn connect_at(datagrams: Datagrams, path: &str) -> Guest {
    let (connection, endpoint) = request_session_at(datagrams, path, None).await.expect("a session");
    let (send, receive) = connection.open_bi().await.expect("a stream").await.expect("a stream");
    User::new(Session { connection, _endpoint: endpoint, send, receive, incomplete: Vec::new() })
}

pub async fn join(server: &Server, room: &str, group: u16, name: &str) -> Guest {
    let mut user = connect(server, &format!("/rooms/{room}")).await;
    user.hello(group, name, &[]).await;
    user
}

impl Transport for Session {
    async fn send_bytes(&mut self, bytes: Vec<u8>) {
        self.send.write_all(&bytes).await.expect("the server reads");
    }

    async fn receive(&mut self) -> Option<(Channel, Vec<Vec<u8>>)> {
        let mut piece = [0; 4096];
        tokio::select! {
            // Frames that arrived before the end are read first.
            biased;
            read = self.receive.read(&mut piece) => {
                let length = read.ok().flatten()?;
                self.incomplete.extend_from_slice(&piece[..length]);
            }
            datagram = self.connection.receive_datagram() => {
                return Some((Channel::Datagram, split(&datagram.ok()?)));
            }
        }
        let mut frames = Vec::new();
        while let Ok((_, rest)) = FromServer::read(&self.incomplete) {
            let length = self.incomplete.len() - rest.len();
            frames.push(self.incomplete.drain(..length).collect());
        }
        Some((Channel::Stream, frames))
    }

    async fn expect_close(&self, reason: Reason) {
        // `closed` would report that wtransport closes the connection in turn.
        let closed = timeout(TEST_TIMEOUT, async {
            loop {
                if let Err(error) = self.connection.receive_datagram().await {
                    return error;
                }
            }
        });
        match closed.await.expect("an end") {
            ConnectionError::ApplicationClosed(closed) => {
                assert_eq!(closed.code().into_inner(), u64::from(reason.close_code()));
            }
            error => panic!("{error}"),
        }
    }
}

impl Guest {
    pub fn send_datagram(&self, frames: &[FromUser<'_>]) {
        self.transport.connection.send_datagram(encode(frames)).expect("the server takes datagrams");
    }
}
