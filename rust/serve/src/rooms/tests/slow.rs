//! Users who read slowly, or not at all.

use std::time::Duration;

use tokio::net::TcpSocket;

use super::support::{User, join, limits, over, pose, server};
use crate::Server;
use crate::rooms::frame::{FromServer, FromUser, To};
use crate::rooms::{Limits, Reason};

/// Bytes that the system keeps for a user who does not read.
const KEPT: u32 = 4096;

/// A user of a group, whose system keeps few bytes for it.
async fn slow(server: &Server, group: u16) -> User {
    let socket = TcpSocket::new_v4().expect("a socket");
    socket.set_recv_buffer_size(KEPT).expect("a size");
    let stream = socket.connect(server.address()).await.expect("a connection");
    let mut user = over(stream, server.address(), "/rooms/hall").await.expect("a socket");
    user.hello(group, "slow", &[]).await;
    user
}

#[tokio::test]
async fn who_does_not_read_delays_nobody_and_gets_the_newest_pose_later() {
    let server = server(limits(), None);
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
    // It is a user as before.
    slow.send(&[FromUser::Pose(pose(1))]).await;
    assert_eq!(friend.pose_of(slow.number).await, pose(1));
}

#[tokio::test]
async fn who_lets_too_much_wait_is_ended_and_others_get_all() {
    let server = server(Limits { queue_bytes: 1 << 17, linger: Duration::from_secs(3600), ..limits() }, None);
    let mut slow = slow(&server, 1).await;
    let (mut sender, mut friend) = (join(&server, "hall", 1, "").await, join(&server, "hall", 1, "").await);
    let number = slow.number;
    let (mut round, mut has_left) = (0u32, false);
    while !has_left {
        let payload = [&round.to_le_bytes()[..], &[0; 4000]].concat();
        sender.send(&[FromUser::Say { to: To::Group, payload: &payload }]).await;
        has_left = friend
            .until(|frame| match frame {
                FromServer::Say { payload, .. } => {
                    assert_eq!(payload[..4], round.to_le_bytes());
                    Some(false)
                }
                FromServer::Left { user } => (user == number).then_some(true),
                _ => None,
            })
            .await;
        round += u32::from(!has_left);
    }
    // What waited for it is gone; it reads on to the reason.
    let sentence = slow.is_refused(Reason::Slow).await;
    assert!(sentence.ends_with("before 131072 bytes wait for it"), "{sentence}");
}
