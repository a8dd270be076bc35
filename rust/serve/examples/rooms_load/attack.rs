//! Users who misbehave beside those who are measured: in the room of the first of them, in a group of their own.

use std::net::SocketAddr;
use std::str::FromStr;
use std::time::Duration;

use futures_util::{SinkExt, StreamExt};
use nearfar_serve::rooms::frame::{FromUser, To};
use tokio::io::AsyncWriteExt;
use tokio_tungstenite::tungstenite::Message;

use crate::{Failure, Socket, connect};

/// Users who misbehave at the same time.
pub const INTRUDERS: usize = 8;
/// Their group.
const GROUP: u16 = u16::MAX;
/// Pause before they come again.
const PAUSE: Duration = Duration::from_millis(10);
/// Pause between two things that are said to those who do not read.
const SPEAKS: Duration = Duration::from_millis(50);

/// What they do.
#[derive(Clone, Copy)]
pub enum Attack {
    /// Send bytes that are no frame.
    Garbage,
    /// Send without a pause.
    Flood,
    /// Go within a message.
    Vanish,
    /// Do not read what one of them says.
    Slow,
}

impl FromStr for Attack {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "garbage" => Ok(Attack::Garbage),
            "flood" => Ok(Attack::Flood),
            "vanish" => Ok(Attack::Vanish),
            "slow" => Ok(Attack::Slow),
            _ => Err(format!("expected garbage, flood, vanish or slow, got {text:?}")),
        }
    }
}

/// Misbehave again and again; the first of all speaks where others do not read.
pub async fn attack(kind: Attack, address: SocketAddr, number: usize) {
    loop {
        // Each attempt ends with an error: the server closes it.
        let _ = attempt(kind, address, number).await;
        tokio::time::sleep(PAUSE).await;
    }
}

async fn attempt(kind: Attack, address: SocketAddr, number: usize) -> Result<(), Failure> {
    let mut socket = connect(address, 0, GROUP).await?;
    let said = written(FromUser::Say { to: To::Group, payload: &[0; 4000] });
    match kind {
        Attack::Garbage => {
            socket.send(Message::binary(vec![0xff; 100])).await?;
            read_on(&mut socket).await;
        }
        Attack::Flood => {
            let frame = written(FromUser::Ack { user: 1, sequence: 1 });
            loop {
                socket.feed(Message::binary(frame.clone())).await?;
            }
        }
        // A message of 100 bytes begins.
        Attack::Vanish => socket.get_mut().write_all(&[0x82, 0x80 | 100, 1, 2, 3, 4, 5]).await?,
        Attack::Slow if number == 0 => loop {
            socket.send(Message::binary(said.clone())).await?;
            tokio::time::sleep(SPEAKS).await;
        },
        Attack::Slow => loop {
            // Frames that are sent keep the connection.
            socket.send(Message::binary(written(FromUser::Ack { user: 1, sequence: 1 }))).await?;
            tokio::time::sleep(Duration::from_secs(1)).await;
        },
    }
    Ok(())
}

async fn read_on(socket: &mut Socket) {
    while socket.next().await.is_some_and(|message| message.is_ok()) {}
}

fn written(frame: FromUser<'_>) -> Vec<u8> {
    let mut out = Vec::new();
    frame.write(&mut out);
    out
}
