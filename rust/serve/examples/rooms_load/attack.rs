//! Users who misbehave beside those who are measured: in the group of the first of them.

use std::net::SocketAddr;
use std::str::FromStr;
use std::time::{Duration, Instant};

use futures_util::{SinkExt, StreamExt};
use nearfar_serve::rooms::frame::{FromServer, FromUser, To};
use tokio::io::AsyncWriteExt;
use tokio_tungstenite::tungstenite::Message;

use crate::{Failure, Socket, connect, pose};

/// Users who misbehave at the same time.
pub const INTRUDERS: usize = 8;
/// The group of those who are measured first.
const GROUP: u16 = 0;
/// Pause before they come again.
const PAUSE: Duration = Duration::from_millis(10);
/// Pause between two things that are said to those who do not read.
const SPEAKS: Duration = Duration::from_millis(300);

/// Names of the ways to misbehave.
pub const NAMES: &str = "garbage, flood-pose, flood-say, flood-signal, churn, mute, vanish, slow";

/// Ways to misbehave.
#[derive(Clone, Copy)]
pub enum Attack {
    /// Send bytes that are no frame.
    Garbage,
    /// Send poses without a pause.
    FloodPose,
    /// Say something to the room without a pause.
    FloodSay,
    /// Signal to one of those who are measured without a pause.
    FloodSignal,
    /// Join and leave without a pause.
    Churn,
    /// Read all, and acknowledge no pose.
    Mute,
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
            "flood-pose" => Ok(Attack::FloodPose),
            "flood-say" => Ok(Attack::FloodSay),
            "flood-signal" => Ok(Attack::FloodSignal),
            "churn" => Ok(Attack::Churn),
            "mute" => Ok(Attack::Mute),
            "vanish" => Ok(Attack::Vanish),
            "slow" => Ok(Attack::Slow),
            _ => Err(format!("expected one of {NAMES}, got {text:?}")),
        }
    }
}

/// Misbehave again and again; the first of all speaks where others do not read.
pub async fn attack(kind: Attack, address: SocketAddr, number: usize, epoch: Instant) {
    loop {
        // Each attempt ends with an error: the server closes it.
        let _ = attempt(kind, address, number, epoch).await;
        tokio::time::sleep(PAUSE).await;
    }
}

async fn attempt(kind: Attack, address: SocketAddr, number: usize, epoch: Instant) -> Result<(), Failure> {
    let mut socket = connect(address, 0, GROUP).await?;
    let said = written(FromUser::Say { to: To::Group, payload: &[0; 4000] });
    match kind {
        Attack::Garbage => {
            socket.send(Message::binary(vec![0xff; 100])).await?;
            read_on(&mut socket).await;
        }
        Attack::FloodPose => {
            for sequence in 0.. {
                socket.send(Message::binary(written(FromUser::Pose(pose(sequence, epoch))))).await?;
            }
        }
        Attack::FloodSay => {
            let said = written(FromUser::Say { to: To::Room, payload: &[0; 4000] });
            loop {
                socket.send(Message::binary(said.clone())).await?;
            }
        }
        Attack::FloodSignal => {
            let signal = written(FromUser::Signal { user: other(&mut socket).await?, payload: &[0; 4000] });
            loop {
                socket.send(Message::binary(signal.clone())).await?;
            }
        }
        Attack::Churn => {
            socket.send(Message::binary(written(FromUser::Bye))).await?;
            read_on(&mut socket).await;
        }
        Attack::Mute => read_on(&mut socket).await,
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

/// The number of another user who is there.
async fn other(socket: &mut Socket) -> Result<u16, Failure> {
    loop {
        let message = socket.next().await.ok_or("the server ended")??.into_data();
        let mut rest = &message[..];
        while !rest.is_empty() {
            let (frame, behind) = FromServer::read(rest).map_err(|fault| format!("{fault:?}"))?;
            if let FromServer::Joined { user, .. } = frame {
                return Ok(user);
            }
            rest = behind;
        }
    }
}

async fn read_on(socket: &mut Socket) {
    while socket.next().await.is_some_and(|message| message.is_ok()) {}
}

fn written(frame: FromUser<'_>) -> Vec<u8> {
    let mut out = Vec::new();
    frame.write(&mut out);
    out
}
