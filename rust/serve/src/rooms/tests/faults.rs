//! Misbehaving users, and users who read slowly: they are disconnected with a reason, and others only see that they left.

use std::time::Duration;

use futures_util::SinkExt;
use tokio::io::AsyncWriteExt;
use tokio::net::TcpSocket;
use tokio_tungstenite::tungstenite::Message;

use super::support::{
    HOURS, Transport, User, connect, encode, join, limits, pick, pose, say_until_left, server, upgrade,
};
use crate::Server;
use crate::rooms::frame::{FromServer, FromUser, To};
use crate::rooms::pose::{Placed, Pose};
use crate::rooms::{Limits, Reason};

/// Two users of the intruder's group, who exchange poses while it misbehaves.
struct Witnesses(User, User, u32);

impl Witnesses {
    async fn new(server: &Server) -> Self {
        Witnesses(join(server, "hall", 1, "").await, join(server, "hall", 1, "").await, 0)
    }

    /// Both see that this user has left, and still see each other.
    async fn see_that_left(&mut self, user: u16) {
        for witness in [&mut self.0, &mut self.1] {
            witness.sees_leave(user).await;
        }
        self.see().await;
    }

    async fn see(&mut self) {
        self.2 += 1;
        let Witnesses(one, two, sequence) = self;
        one.send(&[FromUser::Pose(pose(*sequence))]).await;
        assert_eq!(two.pose_of(one.number).await.sequence, *sequence);
        two.send(&[FromUser::Pose(pose(*sequence))]).await;
        assert_eq!(one.pose_of(two.number).await.sequence, *sequence);
    }
}

#[tokio::test]
async fn malformed_messages_disconnect_their_sender_alone() {
    let server = server(limits(), None);
    let mut witnesses = Witnesses::new(&server).await;
    let nowhere = Pose { head: Placed { position: [f32::NAN; 3], ..pose(1).head }, ..pose(1) };
    let lost = Pose { head: Placed { rotation: [0; 4], ..pose(1).head }, ..pose(1) };
    let mut half = encode(&[FromUser::Pose(pose(2))]);
    half.truncate(20);
    let good = encode(&[FromUser::Say { to: To::Group, payload: b"before" }]);
    for (message, sentence) in [
        (vec![0xff; 500], "a frame is too short"),
        (vec![99, 0, 0], "a frame has a kind that users do not send"),
        (vec![0x82, 0, 0], "a frame has a kind that users do not send"),
        (encode(&[FromUser::Pose(nowhere)]), "a position is none"),
        (encode(&[FromUser::Pose(lost)]), "a rotation is not a unit quaternion"),
        (half, "a frame is too short"),
        ([good, vec![3, 1, 0, 9]].concat(), "a frame is too short"),
        (encode(&[FromUser::Hello { group: 1, name: "again", ticket: &[] }]), "expected one hello"),
        (vec![0; (1 << 15) + 1], "Space limit exceeded: Message too long: 32769 > 32768"),
    ] {
        let mut user = join(&server, "hall", 1, "intruder").await;
        user.transport.send_bytes(message).await;
        assert_eq!(user.is_refused(Reason::Frame).await, sentence);
        witnesses.see_that_left(user.number).await;
    }
    let mut user = join(&server, "hall", 1, "intruder").await;
    user.transport.send(Message::text("hello")).await.expect("sent");
    assert_eq!(user.is_refused(Reason::Frame).await, "expected binary messages");
    witnesses.see_that_left(user.number).await;
}

#[tokio::test]
async fn nobody_is_in_a_room_before_hello() {
    let server = server(limits(), None);
    let mut witnesses = Witnesses::new(&server).await;
    for frame in [FromUser::Pose(pose(1)), FromUser::Bye, FromUser::Say { to: To::Room, payload: b"" }] {
        let mut user = connect(server.address(), "/rooms/hall").await.expect("a connection");
        user.send(&[frame]).await;
        assert_eq!(user.is_refused(Reason::Frame).await, "expected hello first");
    }
    let mut old = connect(server.address(), "/rooms/hall").await.expect("a connection");
    old.transport.send_bytes(vec![1, 5, 0, 7, 0, 0, 0, 0]).await;
    assert_eq!(old.is_refused(Reason::Version).await, "expected version 1, got 7");
    witnesses.see().await;
}

#[tokio::test]
async fn users_who_vanish_within_a_message_have_left() {
    let server = server(limits(), None);
    let mut witnesses = Witnesses::new(&server).await;
    // Three bytes of a message of 100 bytes; and the first fragment of another message.
    for beginning in [[0x82, 0x80 | 100, 1, 2, 3, 4, 5, 6, 7], [0x02, 0x80 | 3, 1, 2, 3, 4, 5, 6, 7]] {
        let mut user = join(&server, "hall", 1, "intruder").await;
        user.transport.get_mut().write_all(&beginning).await.expect("sent");
        let number = user.number;
        drop(user);
        witnesses.see_that_left(number).await;
    }
}

#[tokio::test]
async fn broken_framing_disconnects_its_sender_alone() {
    let server = server(limits(), None);
    let mut witnesses = Witnesses::new(&server).await;
    for wrong in [
        // Unmasked frame; reserved bits; unknown opcode; continuation without a start; long ping; 2^63 bytes.
        &[0x82, 3, 6, 0, 0][..],
        &[0xf2, 0x83, 0, 0, 0, 0, 6, 0, 0],
        &[0x8b, 0x80, 0, 0, 0, 0],
        &[0x80, 0x80, 0, 0, 0, 0],
        &[0x89, 0xfe, 0, 200, 0, 0, 0, 0],
        &[0x82, 0xff, 0x80, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
    ] {
        let mut user = join(&server, "hall", 1, "intruder").await;
        user.transport.get_mut().write_all(&[wrong, &[0; 200]].concat()).await.expect("sent");
        user.is_refused(Reason::Frame).await;
        witnesses.see_that_left(user.number).await;
    }
}

#[tokio::test]
async fn acknowledgements_and_signals_for_nobody_are_ignored() {
    let server = server(limits(), None);
    let mut witnesses = Witnesses::new(&server).await;
    let mut user = join(&server, "hall", 1, "").await;
    let nobody = 40_000;
    user.send(&[FromUser::Ack { user: nobody, sequence: 1 }, FromUser::Signal { user: nobody, payload: b"" }]).await;
    user.send(&[FromUser::Ack { user: user.number, sequence: 1 }, FromUser::Pose(pose(5))]).await;
    assert_eq!(witnesses.0.pose_of(user.number).await.sequence, 5);
}

#[tokio::test]
async fn users_who_send_too_much_are_disconnected() {
    let few = Limits { messages_per_second: 1e-6, burst: Duration::from_secs(50_000_000), ..limits() };
    let little = Limits { bytes_per_second: 1e-6, burst: Duration::from_secs(10_000_000_000), ..limits() };
    for (limits, message) in [
        (few, Message::binary(encode(&[FromUser::Pose(pose(1))]))),
        (few, Message::Ping(b"empty".as_slice().into())),
        (few, Message::binary(Vec::new())),
        (little, Message::binary(encode(&[FromUser::Say { to: To::Group, payload: &[1; 4000] }]))),
    ] {
        let server = server(limits, None);
        let mut witness = join(&server, "hall", 1, "").await;
        let mut user = join(&server, "hall", 1, "").await;
        // The connection may end during the writes.
        for _ in 0..60 {
            let _ = user.transport.send(message.clone()).await;
        }
        assert!(user.is_refused(Reason::Flood).await.starts_with("expected at most"));
        witness.sees_leave(user.number).await;
    }
}

#[tokio::test]
async fn empty_fragments_count_as_bytes() {
    let limits = Limits { bytes_per_second: 1e-6, burst: Duration::from_secs(10_000_000_000), ..limits() };
    let server = server(limits, None);
    let mut user = join(&server, "hall", 1, "").await;
    user.transport.get_mut().write_all(&[0x02, 0x80, 0, 0, 0, 0]).await.expect("sent");
    for _ in 0..2000 {
        let _ = user.transport.get_mut().write_all(&[0x00, 0x80, 0, 0, 0, 0]).await;
    }
    user.is_refused(Reason::Flood).await;
}

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
            let _ = sender.transport.send(Message::binary(encode(&[frame]))).await;
        }
        sender.is_refused(Reason::Flood).await;
        friend.sees_leave(sender.number).await;
    }
    friend.send(&[FromUser::Say { to: To::Room, payload: b"still there" }]).await;
    victim.until(pick!(FromServer::Say { payload: b"still there", .. } => ())).await;
}
