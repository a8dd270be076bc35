//! Test server with rooms, and test users.

use std::collections::VecDeque;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use futures_util::{SinkExt, StreamExt};
use tokio::net::TcpStream;
use tokio::time::timeout;
use tokio_tungstenite::tungstenite::client::IntoClientRequest;
use tokio_tungstenite::tungstenite::{Error, Message};
use tokio_tungstenite::{WebSocketStream, client_async};

use crate::rooms::frame::{FromServer, FromUser, To};
use crate::rooms::pose::{Placement, Pose};
use crate::rooms::{Key, Limits, Reason, Rooms};
use crate::{Router, Server, ServerContent, Settings};

/// Creates a function for `wait_for`: it returns a value for frames that match a pattern, and none for others.
macro_rules! pick {
    ($pattern:pat $(if $guard:expr)? => $value:expr) => {
        |frame: FromServer<'_>| match frame {
            $pattern $(if $guard)? => Some($value),
            _ => None,
        }
    };
}
pub(crate) use pick;

/// Timeout of a test that hangs.
pub const TEST_TIMEOUT: Duration = Duration::from_secs(60);

/// Longer than any test.
pub const HOURS: Duration = Duration::from_secs(10_000);

/// Limits that tests exceed only deliberately.
pub fn limits() -> Limits {
    Limits {
        messages_per_second: 1e9,
        bytes_per_second: 1e12,
        said_bytes_per_second: 1e12,
        poses_per_second: 1e9,
        ..Limits::default()
    }
}

/// A server that has only rooms.
pub fn server(limits: Limits, key: Option<Key>) -> Server {
    start(server_content(limits, key), None)
}

/// Settings with rooms only, for any host name.
pub fn server_content(limits: Limits, key: Option<Key>) -> ServerContent {
    let rooms = Some(Arc::new(Rooms::new(limits, key).expect("limits that fit")));
    ServerContent { sites: [].into(), hosts: None, headers: Vec::new(), origin: None, rooms }
}

/// Starts a server with these settings, and files of a certificate and its key.
pub fn start(server_content: ServerContent, certificate: Option<(PathBuf, PathBuf)>) -> Server {
    start_within(server_content, certificate, crate::Limits::default())
}

/// Like `start`, with limits on connections.
pub fn start_within(
    server_content: ServerContent,
    certificate: Option<(PathBuf, PathBuf)>,
    limits: crate::Limits,
) -> Server {
    start_at(([127, 0, 0, 1], 0).into(), server_content, certificate, limits)
}

/// Like `start_within`, at an address.
pub fn start_at(
    address: SocketAddr,
    server_content: ServerContent,
    certificate: Option<(PathBuf, PathBuf)>,
    limits: crate::Limits,
) -> Server {
    let settings = Settings { address, limits, certificate, router: Router::new(server_content) };
    // Started outside the test's runtime.
    std::thread::spawn(|| Server::start(settings)).join().expect("no panic").expect("it listens")
}

/// Channel on which a frame arrived.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Channel {
    Stream,
    Datagram,
}

/// Transport of a user's frames.
pub trait Transport {
    /// Sends bytes of frames reliably.
    async fn send_bytes(&mut self, bytes: Vec<u8>);

    /// Receives some frames; none at the end.
    async fn receive(&mut self) -> Option<(Channel, Vec<Vec<u8>>)>;

    /// Asserts that the connection is closed for a reason.
    async fn expect_close(&self, reason: Reason);
}

impl<S: tokio::io::AsyncRead + tokio::io::AsyncWrite + Unpin> Transport for WebSocketStream<S> {
    async fn send_bytes(&mut self, bytes: Vec<u8>) {
        self.send(Message::Binary(bytes.into())).await.expect("the server reads");
    }

    async fn receive(&mut self) -> Option<(Channel, Vec<Vec<u8>>)> {
        match self.next().await?.ok()? {
            Message::Binary(bytes) => Some((Channel::Stream, split(&bytes))),
            _ => Some((Channel::Stream, Vec::new())),
        }
    }

    async fn expect_close(&self, _: Reason) {}
}

/// A user, by default over a WebSocket.
pub struct User<T = WebSocketStream<TcpStream>> {
    pub transport: T,
    frames: VecDeque<(Channel, Vec<u8>)>,
    /// Channel of the last frame.
    pub channel: Channel,
    /// Number that the server assigned.
    pub number: u16,
    pub ticket: Vec<u8>,
}

/// Connects to a path without joining the room.
pub async fn connect(address: SocketAddr, path: &str) -> Result<User, Error> {
    let stream = TcpStream::connect(address).await?;
    upgrade(stream, address, path).await
}

/// Upgrades a connection to a WebSocket.
pub async fn upgrade(stream: TcpStream, address: SocketAddr, path: &str) -> Result<User, Error> {
    stream.set_nodelay(true)?;
    let request = format!("ws://{address}{path}").into_client_request()?;
    let (socket, _) = client_async(request, stream).await?;
    Ok(User::new(socket))
}

pub async fn join(server: &Server, room: &str, group: u16, name: &str) -> User {
    let mut user = connect(server.address(), &format!("/rooms/{room}")).await.expect("a connection");
    user.hello(group, name, &[]).await;
    user
}

impl<T: Transport> User<T> {
    pub fn new(transport: T) -> Self {
        User { transport, frames: VecDeque::new(), channel: Channel::Stream, number: 0, ticket: Vec::new() }
    }

    /// Sends hello and waits for the welcome.
    pub async fn hello(&mut self, group: u16, name: &str, ticket: &[u8]) {
        self.send(&[FromUser::Hello { group, name, ticket }]).await;
        let welcome = pick!(FromServer::Welcome { user, ticket, .. } => (user, ticket.to_vec()));
        (self.number, self.ticket) = self.wait_for(welcome).await;
    }

    /// Sends frames as one message.
    pub async fn send(&mut self, frames: &[FromUser<'_>]) {
        self.transport.send_bytes(encode(frames)).await;
    }

    /// Next frame, encoded; none at the end.
    pub async fn next(&mut self) -> Option<Vec<u8>> {
        // One timeout for all messages: the server's pings are messages without frames.
        let wait = async {
            while self.frames.is_empty() {
                let (channel, frames) = self.transport.receive().await?;
                self.frames.extend(frames.into_iter().map(|frame| (channel, frame)));
            }
            Some(())
        };
        timeout(TEST_TIMEOUT, wait).await.expect("a frame")?;
        let (channel, frame) = self.frames.pop_front()?;
        self.channel = channel;
        Some(frame)
    }

    /// Waits for the first frame that `pick` accepts.
    pub async fn wait_for<R>(&mut self, pick: impl Fn(FromServer<'_>) -> Option<R>) -> R {
        loop {
            let bytes = self.next().await.expect("a frame before the end");
            let (frame, _) = FromServer::read(&bytes).expect("a frame");
            if let Some(picked) = pick(frame) {
                return picked;
            }
        }
    }

    /// Asserts that the next frame equals `expected`.
    pub async fn expect_frame(&mut self, expected: FromServer<'_>) {
        let bytes = self.next().await.expect("a frame before the end");
        assert_eq!(FromServer::read(&bytes).expect("a frame").0, expected);
    }

    /// Asserts that the server ends the connection for the given reason; returns the sentence in which it explains it.
    pub async fn expect_refusal(&mut self, reason: Reason) -> String {
        let refusal = pick!(FromServer::Refused { code, sentence } => (code, sentence.to_owned()));
        let (code, sentence) = self.wait_for(refusal).await;
        assert_eq!(code, reason.code(), "{sentence}");
        assert!(self.next().await.is_none());
        self.transport.expect_close(reason).await;
        sentence
    }

    /// Next pose of another user.
    pub async fn next_pose_of(&mut self, other: u16) -> Pose {
        self.wait_for(pick!(FromServer::Pose { user, pose } if user == other => pose)).await
    }

    /// Waits until another user has left.
    pub async fn wait_until_left(&mut self, other: u16) {
        self.wait_for(pick!(FromServer::Left { user } if user == other => ())).await;
    }
}

/// Sends messages to a group until the server drops `silent_user`, who does not read; a friend receives all messages in
/// order.
pub async fn say_until_left(sender: &mut User, friend: &mut User, silent_user: u16) {
    let say_all = async {
        let (mut round, mut has_left) = (0u32, false);
        while !has_left {
            let payload = [&round.to_le_bytes()[..], &[0; 4000]].concat();
            sender.send(&[FromUser::Say { to: To::Group, payload: &payload }]).await;
            has_left = friend
                .wait_for(|frame| match frame {
                    FromServer::Say { payload, .. } => {
                        assert_eq!(payload[..4], round.to_le_bytes());
                        Some(false)
                    }
                    FromServer::Left { user } => (user == silent_user).then_some(true),
                    _ => None,
                })
                .await;
            round += u32::from(!has_left);
        }
    };
    timeout(TEST_TIMEOUT, say_all).await.expect("the user leaves");
}

pub fn encode(frames: &[FromUser<'_>]) -> Vec<u8> {
    let mut bytes = Vec::new();
    frames.iter().for_each(|frame| frame.write(&mut bytes));
    bytes
}

pub fn encode_each(frames: &[FromServer<'_>]) -> Vec<Vec<u8>> {
    let encode = |frame: &FromServer<'_>| {
        let mut bytes = Vec::new();
        frame.write(&mut bytes);
        bytes
    };
    frames.iter().map(encode).collect()
}

/// Splits a message into frames.
pub fn split(mut message: &[u8]) -> Vec<Vec<u8>> {
    let mut frames = Vec::new();
    while !message.is_empty() {
        let (_, rest) = FromServer::read(message).expect("a frame");
        frames.push(message[..message.len() - rest.len()].to_vec());
        message = rest;
    }
    frames
}

/// A pose with a head only.
pub fn pose(sequence: u32) -> Pose {
    let head = Placement { position: [1.0, 1.7, -2.5], rotation: [0, 0, 0, 32767] };
    let (hands, pointer) = ([None; 2], None);
    Pose { sequence, clock: u64::from(sequence) * 13_889, is_acknowledged: false, stops: false, head, hands, pointer }
}

/// A pose whose receivers acknowledge it.
pub fn pose_to_acknowledge(sequence: u32) -> Pose {
    Pose { is_acknowledged: true, ..pose(sequence) }
}

/// Pseudorandom numbers, the same in each run.
pub struct Random(pub u64);

impl Random {
    /// Overwrites 1 to `max_count` of the bytes.
    pub fn change(&mut self, max_count: u64, bytes: &mut [u8]) {
        for _ in 0..1 + self.below(max_count) {
            let index = self.below(bytes.len() as u64) as usize;
            bytes[index] = self.below(256) as u8;
        }
    }

    pub fn below(&mut self, end: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % end
    }
}
