//! WebTransport users for tests.

use std::collections::VecDeque;
use std::net::{Ipv4Addr, SocketAddr};

use data_encoding::HEXLOWER;
use tokio::time::timeout;
use wtransport::endpoint::ConnectOptions;
use wtransport::endpoint::endpoint_side::Client;
use wtransport::error::{ConnectingError, ConnectionError};
use wtransport::tls::Sha256Digest;
use wtransport::{ClientConfig, Connection, Endpoint, RecvStream, SendStream};

use super::support::{HANGS, encode, pick, split};
use crate::Server;
use crate::rooms::frame::{FromServer, FromUser};
use crate::rooms::pose::Pose;
use crate::rooms::{Datagrams, Reason};

/// Channel on which a frame arrived.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum By {
    Stream,
    Datagram,
}

/// A user's session.
pub struct Guest {
    pub connection: Connection,
    /// Keeps the endpoint alive, which sends the packets.
    _endpoint: Endpoint<Client>,
    pub send: SendStream,
    receive: RecvStream,
    came: Vec<u8>,
    frames: VecDeque<(By, Vec<u8>)>,
    /// Number that the server assigned.
    pub number: u16,
}

/// A session's connection and its endpoint.
type Asked = Result<(Connection, Endpoint<Client>), ConnectingError>;

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
pub async fn ask(server: &Server, path: &str, origin: Option<&str>) -> Asked {
    ask_at(server.datagrams().expect("datagrams"), path, origin).await
}

async fn ask_at(datagrams: Datagrams, path: &str, origin: Option<&str>) -> Asked {
    let endpoint = client(&datagrams);
    let mut options = ConnectOptions::builder(format!("https://127.0.0.1:{}{path}", datagrams.port));
    if let Some(origin) = origin {
        options = options.add_header("origin", origin);
    }
    let connection = timeout(HANGS, endpoint.connect(options.build())).await.expect("an answer")?;
    Ok((connection, endpoint))
}

/// Starts a session with its stream, without join_request.
pub async fn connect(server: &Server, path: &str) -> Guest {
    connect_at(server.datagrams().expect("datagrams"), path).await
}

/// Like `connect`, for given datagram settings.
pub async fn connect_at(datagrams: Datagrams, path: &str) -> Guest {
    let (connection, endpoint) = ask_at(datagrams, path, None).await.expect("a session");
    let (send, receive) = connection.open_bi().await.expect("a stream").await.expect("a stream");
    let (came, frames) = (Vec::new(), VecDeque::new());
    Guest { connection, _endpoint: endpoint, send, receive, came, frames, number: 0 }
}

/// Joins a room.
pub async fn join(server: &Server, room: &str, group: u16, name: &str) -> Guest {
    let mut user = connect(server, &format!("/rooms/{room}")).await;
    user.hello(group, name).await;
    user
}

impl Guest {
    /// Sends hello and waits for the welcome.
    pub async fn hello(&mut self, group: u16, name: &str) {
        self.say(&[FromUser::Hello { group, name, ticket: &[] }]).await;
        (_, self.number) = self.until(pick!(FromServer::Welcome { user, .. } => user)).await;
    }

    /// Sends frames on the stream.
    pub async fn say(&mut self, frames: &[FromUser<'_>]) {
        self.send.write_all(&encode(frames)).await.expect("the server reads");
    }

    /// Sends frames as a datagram.
    pub fn send_datagram(&self, frames: &[FromUser<'_>]) {
        self.connection.send_datagram(encode(frames)).expect("the server takes datagrams");
    }

    /// Next frame, and the channel on which it arrived; none at the end.
    pub async fn next(&mut self) -> Option<(By, Vec<u8>)> {
        let mut piece = [0; 4096];
        while self.frames.is_empty() {
            let came = async {
                tokio::select! {
                    // Frames that arrived before the end are read first.
                    biased;
                    read = self.receive.read(&mut piece) => read.ok().flatten().map(|length| (By::Stream, length)),
                    datagram = self.connection.receive_datagram() => {
                        let datagram = datagram.ok()?;
                        self.frames.extend(split(&datagram).into_iter().map(|frame| (By::Datagram, frame)));
                        Some((By::Datagram, 0))
                    }
                }
            };
            let (_, length) = timeout(HANGS, came).await.expect("a frame")?;
            self.came.extend_from_slice(&piece[..length]);
            while let Ok((_, rest)) = FromServer::read(&self.came) {
                let whole = self.came.len() - rest.len();
                self.frames.push_back((By::Stream, self.came.drain(..whole).collect()));
            }
        }
        self.frames.pop_front()
    }

    /// Waits for the first frame that `pick` accepts; also returns its channel.
    pub async fn until<T>(&mut self, pick: impl Fn(FromServer<'_>) -> Option<T>) -> (By, T) {
        loop {
            let (by, bytes) = self.next().await.expect("a frame before the end");
            let (frame, _) = FromServer::read(&bytes).expect("a frame");
            if let Some(picked) = pick(frame) {
                return (by, picked);
            }
        }
    }

    /// Next pose of another user, and its channel.
    pub async fn pose_of(&mut self, other: u16) -> (By, Pose) {
        self.until(pick!(FromServer::Pose { user, pose } if user == other => pose)).await
    }

    /// Asserts that the server ends the session for a reason, on the stream and with the session's code; returns the
    /// sentence.
    pub async fn is_refused(&mut self, reason: Reason) -> String {
        let refusal = pick!(FromServer::Refused { code, sentence } => (code, sentence.to_owned()));
        let (_, (code, sentence)) = self.until(refusal).await;
        assert_eq!(code, reason.code(), "{sentence}");
        assert!(self.next().await.is_none());
        self.is_closed(reason).await;
        sentence
    }

    /// Asserts that the session's close code is that of a reason.
    pub async fn is_closed(&self, reason: Reason) {
        // `closed` would report that wtransport closes the connection in turn.
        let closed = timeout(HANGS, async {
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
