//! Connection of a user, over WebSocket or WebTransport.

use nearfar_serve::rooms::frame::FromUser;

use crate::datagrams::Session;
use crate::failure::Failure;
use crate::options::{Load, Way};
use crate::server::Listens;
use crate::websocket::Socket;

/// One connection.
pub enum Line {
    WebSocket(Socket),
    Datagrams(Session),
}

impl Line {
    /// Joins the room and the group of the user with a number.
    pub async fn join(load: &Load, number: usize, listens: &Listens) -> Result<Self, Failure> {
        let (room, group) = load.place(number);
        match load.way {
            Way::WebSocket => Ok(Line::WebSocket(Socket::join(listens.address, room, group).await?)),
            Way::Datagrams => Ok(Line::Datagrams(Session::join(listens, room, group).await?)),
        }
    }

    /// Sends frames whose loss later frames compensate.
    pub async fn send(&mut self, frames: &[FromUser<'_>]) -> Result<(), Failure> {
        match self {
            Line::WebSocket(socket) => socket.send(frames).await,
            Line::Datagrams(session) => session.send(frames),
        }
    }

    /// Sends the departure of the user.
    pub async fn leave(mut self) -> Result<(), Failure> {
        match &mut self {
            Line::WebSocket(socket) => socket.send(&[FromUser::Bye]).await,
            Line::Datagrams(session) => session.say(&[FromUser::Bye]).await,
        }
    }

    /// Receives the next frames.
    pub async fn receive(&mut self) -> Result<Vec<u8>, Failure> {
        match self {
            Line::WebSocket(socket) => socket.receive().await,
            Line::Datagrams(session) => session.receive().await,
        }
    }

    /// Bytes sent and received: WebSocket messages with their headers, or UDP payloads.
    pub fn bytes(&self) -> (usize, usize) {
        match self {
            Line::WebSocket(socket) => (socket.sent, socket.received),
            Line::Datagrams(session) => session.bytes(),
        }
    }
}
