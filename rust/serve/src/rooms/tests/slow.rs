//! Users who read slowly, or not at all.

use std::time::Duration;

use futures_util::SinkExt;
use tokio::net::TcpSocket;
use tokio_tungstenite::tungstenite::Message;

use super::support::{HOURS, User, encode, join, limits, pick, pose, say_until_left, server, upgrade};
use crate::Server;
use crate::rooms::frame::{FromServer, FromUser, To};
use crate::rooms::{Limits, Reason};

/// Receive buffer in bytes of a user who does not read.
const KEPT: u32 = 4096;
/// Burst too short for a sender to fill a share in.
const MOMENT: Duration = Duration::from_micros(1);

/// A user of a group with a small receive buffer.
async fn slow(server: &Server, group: u16) -> User {
    let socket = TcpSocket::new_v4().expect("a socket");
    socket.set_recv_buffer_size(KEPT).expect("a size");
    let stream = socket.connect(server.address()).await.expect("a connection");
    let mut user = upgrade(stream, server.address(), "/rooms/hall").await.expect("a socket");
    user.hello(group, "slow", &[]).await;
    user
}

#[tokio::test]
async fn slow_readers_delay_nobody_and_get_the_newest_pose_later() {
    let server = server(Limits { ping: HOURS, silence: 2 * HOURS, ..limits() }, None);
    let mut slow = slow(&server, 1).await;
    let (mut sender, mut friend) = (join(&server, "hall", 1, "").await, join(&server, "hall", 1, "").await);
    let last = 50_000;
    for sequence in 1..=last {
        sender.send(&[FromUser::Pose(pose(sequence))]).await;
        if sequence % 100 == 0 {
            while friend.pose_of(sender.number).await.sequence < sequence {}
        }
    }
    let (mut seen, mut newest) = (0, 0);
    while newest < last {
        let sequence = slow.pose_of(sender.number).await.sequence;
        assert!(sequence > newest);
        (seen, newest) = (seen + 1, sequence);
    }
    assert!(seen < last / 2, "{seen} poses waited for it");
    // The user takes part again as before.
    slow.send(&[FromUser::Pose(pose(1))]).await;
    assert_eq!(friend.pose_of(slow.number).await, pose(1));
}

#[tokio::test]
async fn slow_readers_are_disconnected_and_others_receive_all() {
    let server = server(Limits { ping: HOURS, silence: 2 * HOURS, linger: HOURS, burst: MOMENT, ..limits() }, None);
    let mut slow = slow(&server, 1).await;
    let (mut sender, mut friend) = (join(&server, "hall", 1, "").await, join(&server, "hall", 1, "").await);
    say_until_left(&mut sender, &mut friend, slow.number).await;
    // Its queue was discarded; it reads on up to the reason.
    let sentence = slow.is_refused(Reason::Slow).await;
    assert!(sentence.ends_with("before 131072 bytes are queued"), "{sentence}");
}

#[tokio::test]
async fn a_burst_disconnects_its_sender_and_no_slow_reader() {
    let server = server(Limits { said_bytes_per_second: 1e-6, ping: HOURS, silence: 2 * HOURS, ..limits() }, None);
    let mut victim = slow(&server, 1).await;
    let mut friend = join(&server, "hall", 2, "").await;
    let said = FromUser::Say { to: To::Room, payload: &[1; 4000] };
    let signal = FromUser::Signal { user: victim.number, payload: &[1; 4000] };
    for frame in [said, signal] {
        let mut sender = join(&server, "hall", 2, "").await;
        // More than one user's queue may hold; the connection may end during the writes.
        for _ in 0..40 {
            let _ = sender.socket.send(Message::binary(encode(&[frame]))).await;
        }
        sender.is_refused(Reason::Flood).await;
        friend.sees_leave(sender.number).await;
    }
    friend.send(&[FromUser::Say { to: To::Room, payload: b"still there" }]).await;
    victim.until(pick!(FromServer::Say { payload: b"still there", .. } => ())).await;
}
