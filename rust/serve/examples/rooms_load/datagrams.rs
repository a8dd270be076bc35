//! WebTransport connection of a user: poses, acknowledgements and `settled` frames are sent as datagrams.

use std::net::SocketAddr;

use nearfar_serve::rooms::frame::{FromServer, FromUser};
use wtransport::endpoint::endpoint_side::Client;
use wtransport::tls::{Sha256Digest, Sha256DigestFmt};
use wtransport::{ClientConfig, Connection, Endpoint, RecvStream, SendStream};

use crate::failure::Failure;
use crate::server::Listens;

/// A WebTransport session.
pub struct Session {
    connection: Connection,
    /// Keeps the endpoint alive, which sends the packets.
    _endpoint: Endpoint<Client>,
    send: SendStream,
    receive: RecvStream,
    /// Received bytes of an incomplete frame of the stream.
    came: Vec<u8>,
}

impl Session {
    /// Joins a group of a room.
    pub async fn join(listens: &Listens, room: usize, group: u16) -> Result<Self, Failure> {
        let (port, hash) = &listens.datagrams;
        let pairs: Vec<String> = hash.as_bytes().chunks(2).map(|pair| String::from_utf8_lossy(pair).into()).collect();
        let hash = Sha256Digest::from_str_fmt(pairs.join(":"), Sha256DigestFmt::DottedHex)?;
        let own = SocketAddr::new([0, 0, 0, 0].into(), 0);
        let config = ClientConfig::builder().with_bind_address(own).with_server_certificate_hashes([hash]).build();
        let endpoint = Endpoint::client(config)?;
        let ip = listens.address.ip();
        let connection = endpoint.connect(format!("https://{ip}:{port}/rooms/{room}")).await?;
        let (send, receive) = connection.open_bi().await?.await?;
        let mut session = Session { connection, _endpoint: endpoint, send, receive, came: Vec::new() };
        session.say(&[FromUser::Hello { group, name: "load", ticket: &[] }]).await?;
        Ok(session)
    }

    /// Sends frames as a datagram.
    pub fn send(&self, frames: &[FromUser<'_>]) -> Result<(), Failure> {
        Ok(self.connection.send_datagram(written(frames))?)
    }

    /// Sends frames on the stream.
    pub async fn say(&mut self, frames: &[FromUser<'_>]) -> Result<(), Failure> {
        Ok(self.send.write_all(&written(frames)).await?)
    }

    /// Returns the frames of the next datagram, or the next complete frames of the stream.
    pub async fn receive(&mut self) -> Result<Vec<u8>, Failure> {
        let mut piece = [0; 4096];
        loop {
            tokio::select! {
                datagram = self.connection.receive_datagram() => return Ok(datagram?.payload().to_vec()),
                read = self.receive.read(&mut piece) => {
                    let length = read?.ok_or("the server ended")?;
                    self.came.extend_from_slice(&piece[..length]);
                    let whole = whole(&self.came);
                    if whole > 0 {
                        return Ok(self.came.drain(..whole).collect());
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
fn whole(came: &[u8]) -> usize {
    let mut rest = came;
    while let Ok((_, behind)) = FromServer::read(rest) {
        rest = behind;
    }
    came.len() - rest.len()
}

fn written(frames: &[FromUser<'_>]) -> Vec<u8> {
    let mut out = Vec::new();
    frames.iter().for_each(|frame| frame.write(&mut out));
    out
}
