//! WebSocket connection of a user.

use std::net::SocketAddr;

use futures_util::{SinkExt, StreamExt};
use nearfar_serve::rooms::frame::FromUser;
use tokio::io::AsyncWriteExt;
use tokio::net::TcpStream;
use tokio_tungstenite::tungstenite::Message;
use tokio_tungstenite::tungstenite::client::IntoClientRequest;
use tokio_tungstenite::{WebSocketStream, client_async};

use crate::failure::Failure;

/// A WebSocket, with the bytes of its messages including headers.
pub struct Socket {
    stream: WebSocketStream<TcpStream>,
    pub sent: usize,
    pub received: usize,
}

impl Socket {
    /// Join a group of a room.
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
        let mut message = Vec::new();
        frames.iter().for_each(|frame| frame.write(&mut message));
        self.send_bytes(message).await
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
