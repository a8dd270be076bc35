//! Connection of a user, over WebSocket or WebTransport.

use std::net::SocketAddr;

use futures_util::{SinkExt, StreamExt};
use nearfar_serve::rooms::frame::{FromServer, FromUser};
use tokio::io::AsyncWriteExt;
use tokio::net::TcpStream;
use tokio_tungstenite::tungstenite::Message;
use tokio_tungstenite::tungstenite::client::IntoClientRequest;
use tokio_tungstenite::{WebSocketStream, client_async};
use wtransport::endpoint::endpoint_side::Client;
use wtransport::tls::{Sha256Digest, Sha256DigestFmt};
use wtransport::{ClientConfig, Connection, Endpoint, RecvStream, SendStream};

use crate::options::{Failure, Load, Transport};
use crate::server::ServerAddress;

pub enum UserConnection {
    WebSocket(Socket),
    Datagrams(Session),
}

impl UserConnection {
    /// Connects user `number` and joins its room and group.
    pub async fn join(load: &Load, number: usize, server: &ServerAddress) -> Result<Self, Failure> {
        let (room, group) = load.room_and_group(number);
        match load.transport {
            Transport::WebSocket => Ok(UserConnection::WebSocket(Socket::join(server.http, room, group).await?)),
            Transport::Datagrams => Ok(UserConnection::Datagrams(Session::join(server, room, group).await?)),
        }
    }

    /// Sends poses or acknowledgements; lost ones are made up for by later ones.
    pub async fn send(&mut self, frames: &[FromUser<'_>]) -> Result<(), Failure> {
        match self {
            UserConnection::WebSocket(socket) => socket.send(frames).await,
            UserConnection::Datagrams(session) => session.send(frames),
        }
    }

    /// Sends `bye`.
    pub async fn leave(mut self) -> Result<(), Failure> {
        match &mut self {
            UserConnection::WebSocket(socket) => socket.send(&[FromUser::Bye]).await,
            UserConnection::Datagrams(session) => session.say(&[FromUser::Bye]).await,
        }
    }

    /// Receives the next frames.
    pub async fn receive(&mut self) -> Result<Vec<u8>, Failure> {
        match self {
            UserConnection::WebSocket(socket) => socket.receive().await,
            UserConnection::Datagrams(session) => session.receive().await,
        }
    }

    /// Bytes sent and received: WebSocket messages with their headers, or UDP payloads.
    pub fn bytes(&self) -> (usize, usize) {
        match self {
            UserConnection::WebSocket(socket) => (socket.sent, socket.received),
            UserConnection::Datagrams(session) => session.bytes(),
        }
    }
}

/// A WebSocket, with the bytes of its messages including headers.
pub struct Socket {
    stream: WebSocketStream<TcpStream>,
    pub sent: usize,
    pub received: usize,
}

impl Socket {
    pub async fn join(address: SocketAddr, room: usize, group: u16) -> Result<Self, Failure> {
        let stream = TcpStream::connect(address).await?;
        stream.set_nodelay(true)?;
        let request = format!("ws://{address}/rooms/{room}").into_client_request()?;
        let (stream, _) = client_async(request, stream).await?;
        let mut socket = Socket { stream, sent: 0, received: 0 };
        socket.send(&[FromUser::Hello { group, name: "load", ticket: &[] }]).await?;
        Ok(socket)
    }

    /// Sends frames as one message.
    pub async fn send(&mut self, frames: &[FromUser<'_>]) -> Result<(), Failure> {
        self.send_bytes(encode(frames)).await
    }

    pub async fn send_bytes(&mut self, message: Vec<u8>) -> Result<(), Failure> {
        // The masking key adds four bytes.
        self.sent += message.len() + 4 + if message.len() < 126 { 2 } else { 4 };
        Ok(self.stream.send(Message::binary(message)).await?)
    }

    /// Sends raw bytes of an incomplete message.
    pub async fn send_raw(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        Ok(self.stream.get_mut().write_all(bytes).await?)
    }

    /// Receives the next message.
    pub async fn receive(&mut self) -> Result<Vec<u8>, Failure> {
        let message = self.stream.next().await.ok_or("the server ended")??;
        self.received += message.len() + if message.len() < 126 { 2 } else { 4 };
        Ok(message.into_data().into())
    }
}

/// A WebTransport session.
pub struct Session {
    connection: Connection,
    /// Keeps the endpoint alive, which sends the packets.
    _endpoint: Endpoint<Client>,
    send: SendStream,
    receive: RecvStream,
    /// Received bytes of an incomplete frame of the stream.
    incomplete: Vec<u8>,
}

impl Session {
    pub async fn join(server: &ServerAddress, room: usize, group: u16) -> Result<Self, Failure> {
        let (port, hash) = &server.datagrams;
        let pairs: Vec<String> = hash.as_bytes().chunks(2).map(|pair| String::from_utf8_lossy(pair).into()).collect();
        let hash = Sha256Digest::from_str_fmt(pairs.join(":"), Sha256DigestFmt::DottedHex)?;
        let local = SocketAddr::new([0, 0, 0, 0].into(), 0);
        let config = ClientConfig::builder().with_bind_address(local).with_server_certificate_hashes([hash]).build();
        let endpoint = Endpoint::client(config)?;
        let ip = server.http.ip();
        let connection = endpoint.connect(format!("https://{ip}:{port}/rooms/{room}")).await?;
        let (send, receive) = connection.open_bi().await?.await?;
        let mut session = Session { connection, _endpoint: endpoint, send, receive, incomplete: Vec::new() };
        session.say(&[FromUser::Hello { group, name: "load", ticket: &[] }]).await?;
        Ok(session)
    }

    /// Sends frames as a datagram.
    pub fn send(&self, frames: &[FromUser<'_>]) -> Result<(), Failure> {
        Ok(self.connection.send_datagram(encode(frames))?)
    }

    /// Sends frames on the stream.
    pub async fn say(&mut self, frames: &[FromUser<'_>]) -> Result<(), Failure> {
        Ok(self.send.write_all(&encode(frames)).await?)
    }

    /// Returns the frames of the next datagram, or the next complete frames of the stream.
    pub async fn receive(&mut self) -> Result<Vec<u8>, Failure> {
        let mut piece = [0; 4096];
        loop {
            tokio::select! {
                datagram = self.connection.receive_datagram() => return Ok(datagram?.payload().to_vec()),
                read = self.receive.read(&mut piece) => {
                    let length = read?.ok_or("the server ended")?;
                    self.incomplete.extend_from_slice(&piece[..length]);
                    let length = complete_length(&self.incomplete);
                    if length > 0 {
                        return Ok(self.incomplete.drain(..length).collect());
                    }
                }
            }
        }
    }

    /// UDP payload bytes sent and received, including QUIC's own acknowledgements.
    pub fn bytes(&self) -> (usize, usize) {
        let stats = self.connection.quic_connection().stats();
        (stats.udp_tx.bytes as usize, stats.udp_rx.bytes as usize)
    }
}

/// Length of the complete frames at the start of a buffer.
fn complete_length(incomplete: &[u8]) -> usize {
    let mut rest = incomplete;
    while let Ok((_, remaining)) = FromServer::read(rest) {
        rest = remaining;
    }
    incomplete.len() - rest.len()
}

fn encode(frames: &[FromUser<'_>]) -> Vec<u8> {
    let mut out = Vec::new();
    frames.iter().for_each(|frame| frame.write(&mut out));
    out
}
