//! Misbehaving users in the group of the first measured user.

use std::net::SocketAddr;
use std::time::{Duration, Instant};

use nearfar_serve::rooms::frame::{FromServer, FromUser, To};

use crate::connection::Socket;
use crate::options::{Attack, Failure};
use crate::user::pose;

/// Number of simultaneous misbehaving users.
pub const INTRUDERS: usize = 8;
/// Group of the first measured users, and of all misbehaving ones.
const GROUP: u16 = 0;
/// Pause between two attempts.
const PAUSE: Duration = Duration::from_millis(10);
/// Pause between two messages to users who do not read.
const SAY_INTERVAL: Duration = Duration::from_millis(300);

/// Repeats an attack for ever. `number` counts the misbehaving users; in a slow attack number 0 sends messages, and the
/// others do not read them.
pub async fn attack(kind: Attack, address: SocketAddr, number: usize, epoch: Instant) {
    loop {
        // Each attempt ends with an error when the server closes the connection.
        let _ = attempt(kind, address, number, epoch).await;
        tokio::time::sleep(PAUSE).await;
    }
}

async fn attempt(kind: Attack, address: SocketAddr, number: usize, epoch: Instant) -> Result<(), Failure> {
    let mut socket = Socket::join(address, 0, GROUP).await?;
    let payload = &[0; 4000];
    match kind {
        Attack::Garbage => {
            socket.send_bytes(vec![0xff; 100]).await?;
            read_until_closed(&mut socket).await
        }
        Attack::FloodPose => {
            for sequence in 0.. {
                socket.send(&[FromUser::Pose(pose(sequence, epoch))]).await?;
            }
            Ok(())
        }
        Attack::FloodSay => loop {
            socket.send(&[FromUser::Say { to: To::Room, payload }]).await?;
        },
        Attack::FloodSignal => {
            let user = other_user(&mut socket).await?;
            loop {
                socket.send(&[FromUser::Signal { user, payload }]).await?;
            }
        }
        Attack::Churn => {
            socket.send(&[FromUser::Bye]).await?;
            read_until_closed(&mut socket).await
        }
        Attack::Mute => read_until_closed(&mut socket).await,
        // Header of a message of 100 bytes, which stays incomplete.
        Attack::Vanish => socket.send_raw(&[0x82, 0x80 | 100, 1, 2, 3, 4, 5]).await,
        Attack::Slow if number == 0 => loop {
            socket.send(&[FromUser::Say { to: To::Group, payload }]).await?;
            tokio::time::sleep(SAY_INTERVAL).await;
        },
        Attack::Slow => loop {
            // Sending frames keeps the connection alive.
            socket.send(&[FromUser::Ack { user: 1, sequence: 1 }]).await?;
            tokio::time::sleep(Duration::from_secs(1)).await;
        },
    }
}

/// Returns the number of another user in the room.
async fn other_user(socket: &mut Socket) -> Result<u16, Failure> {
    loop {
        let message = socket.receive().await?;
        let mut rest = &message[..];
        while !rest.is_empty() {
            let (frame, remaining) = FromServer::read(rest).map_err(|fault| format!("{fault:?}"))?;
            if let FromServer::Joined { user, .. } = frame {
                return Ok(user);
            }
            rest = remaining;
        }
    }
}

async fn read_until_closed(socket: &mut Socket) -> Result<(), Failure> {
    loop {
        socket.receive().await?;
    }
}
