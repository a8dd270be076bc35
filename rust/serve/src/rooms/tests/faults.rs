//! Misbehaving users, and users who read slowly: they are disconnected with a reason, and others only see them leave.

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
use crate::rooms::pose::{Placement, Pose};
use crate::rooms::{Limits, Reason};

/// Two users of the intruder's group, who exchange poses while it misbehaves.
struct Witnesses(User, User, u32);

impl Witnesses {
    async fn new(server: &Server) -> Self {
        Witnesses(join(server, "hall", 1, "").await, join(server, "hall", 1, "").await, 0)
    }

    /// Asserts that both see a user leave, and still see each other.
    async fn expect_left(&mut self, user: u16) {
        for witness in [&mut self.0, &mut self.1] {
            witness.wait_until_left(user).await;
        }
        self.exchange_poses().await;
    }

    async fn exchange_poses(&mut self) {
        self.2 += 1;
        let Witnesses(first, second, sequence) = self;
        first.send(&[FromUser::Pose(pose(*sequence))]).await;
        assert_eq!(second.next_pose_of(first.number).await.sequence, *sequence);
        second.send(&[FromUser::Pose(pose(*sequence))]).await;
        assert_eq!(first.next_pose_of(second.number).await.sequence, *sequence);
    }
}

#[tokio::test]
async fn malformed_messages_disconnect_their_sender_alone() {
    let server = server(limits(), None);
    let mut witnesses = Witnesses::new(&server).await;
    let nan_position = Pose { head: Placement { position: [f32::NAN; 3], ..pose(1).head }, ..pose(1) };
    let zero_rotation = Pose { head: Placement { rotation: [0; 4], ..pose(1).head }, ..pose(1) };
    let mut half = encode(&[FromUser::Pose(pose(2))]);
    half.truncate(20);
    let good = encode(&[FromUser::Say { to: To::Group, payload: b"before" }]);
    for (message, sentence) in [
        (vec![0xff; 500], "a frame is too short"),
        (vec![99, 0, 0], "a frame has a kind that users do not send"),
        (vec![0x82, 0, 0], "a frame has a kind that users do not send"),
        (encode(&[FromUser::Pose(nan_position)]), "a position is out of range"),
        (encode(&[FromUser::Pose(zero_rotation)]), "a rotation is not a unit quaternion"),
        (half, "a frame is too short"),
        ([good, vec![3, 1, 0, 9]].concat(), "a frame is too short"),
        (encode(&[FromUser::Hello { group: 1, name: "again", ticket: &[] }]), "expected one hello"),
        (vec![0; (1 << 15) + 1], "Space limit exceeded: Message too long: 32769 > 32768"),
    ] {
        let mut user = join(&server, "hall", 1, "intruder").await;
        user.transport.send_bytes(message).await;
        assert_eq!(user.expect_refusal(Reason::Frame).await, sentence);
        witnesses.expect_left(user.number).await;
    }
    let mut user = join(&server, "hall", 1, "intruder").await;
    user.transport.send(Message::text("hello")).await.expect("sent");
    assert_eq!(user.expect_refusal(Reason::Frame).await, "expected binary messages");
    witnesses.expect_left(user.number).await;
}

#[tokio::test]
async fn frames_before_hello_are_refused() {
    let server = server(limits(), None);
    let mut witnesses = Witnesses::new(&server).await;
    for frame in [FromUser::Pose(pose(1)), FromUser::Bye, FromUser::Say { to: To::Room, payload: b"" }] {
        let mut user = connect(server.address(), "/rooms/hall").await.expect("a connection");
        user.send(&[frame]).await;
        assert_eq!(user.expect_refusal(Reason::Frame).await, "expected hello first");
    }
    let mut old = connect(server.address(), "/rooms/hall").await.expect("a connection");
    old.transport.send_bytes(vec![1, 5, 0, 7, 0, 0, 0, 0]).await;
    assert_eq!(old.expect_refusal(Reason::Version).await, "expected version 1, got 7");
    witnesses.exchange_poses().await;
}

#[tokio::test]
async fn users_who_disconnect_within_a_message_have_left() {
    let server = server(limits(), None);
    let mut witnesses = Witnesses::new(&server).await;
    // Three bytes of a message of 100 bytes; and the first fragment of another message.
    for start in [[0x82, 0x80 | 100, 1, 2, 3, 4, 5, 6, 7], [0x02, 0x80 | 3, 1, 2, 3, 4, 5, 6, 7]] {
        let mut user = join(&server, "hall", 1, "intruder").await;
        user.transport.get_mut().write_all(&start).await.expect("sent");
        let number = user.number;
        drop(user);
        witnesses.expect_left(number).await;
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
        user.expect_refusal(Reason::Frame).await;
        witnesses.expect_left(user.number).await;
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
    assert_eq!(witnesses.0.next_pose_of(user.number).await.sequence, 5);
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
        assert!(user.expect_refusal(Reason::Flood).await.starts_with("expected at most"));
        witness.wait_until_left(user.number).await;
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
    user.expect_refusal(Reason::Flood).await;
}

/// Receive buffer in bytes of a user who does not read.
const RECEIVE_BUFFER_BYTES: u32 = 4096;
/// Burst that is over before a sender fills its share, so that the reader is at fault.
const MOMENT: Duration = Duration::from_micros(1);

/// Joins a user with a small receive buffer.
async fn join_slow_reader(server: &Server, group: u16) -> User {
    let socket = TcpSocket::new_v4().expect("a socket");
    socket.set_recv_buffer_size(RECEIVE_BUFFER_BYTES).expect("a size");
    let stream = socket.connect(server.address()).await.expect("a connection");
    let mut user = upgrade(stream, server.address(), "/rooms/hall").await.expect("a socket");
    user.hello(group, "slow", &[]).await;
    user
}

#[tokio::test]
async fn slow_readers_delay_no_others_and_get_the_newest_pose_later() {
    let server = server(Limits { ping: HOURS, silence: 2 * HOURS, ..limits() }, None);
    let mut slow = join_slow_reader(&server, 1).await;
    let (mut sender, mut friend) = (join(&server, "hall", 1, "").await, join(&server, "hall", 1, "").await);
    let last = 50_000;
    for sequence in 1..=last {
        sender.send(&[FromUser::Pose(pose(sequence))]).await;
        if sequence % 100 == 0 {
            while friend.next_pose_of(sender.number).await.sequence < sequence {}
        }
    }
    let (mut seen, mut newest) = (0, 0);
    while newest < last {
        let sequence = slow.next_pose_of(sender.number).await.sequence;
        assert!(sequence > newest);
        (seen, newest) = (seen + 1, sequence);
    }
    assert!(seen < last / 2, "{seen} poses waited for it");
    // The user's own poses arrive as before.
    slow.send(&[FromUser::Pose(pose(1))]).await;
    assert_eq!(friend.next_pose_of(slow.number).await, pose(1));
}

#[tokio::test]
async fn slow_readers_are_disconnected_and_others_receive_all() {
    let server = server(Limits { ping: HOURS, silence: 2 * HOURS, linger: HOURS, burst: MOMENT, ..limits() }, None);
    let mut slow = join_slow_reader(&server, 1).await;
    let (mut sender, mut friend) = (join(&server, "hall", 1, "").await, join(&server, "hall", 1, "").await);
    say_until_left(&mut sender, &mut friend, slow.number).await;
    // Its queue was discarded, so it next reads the reason.
    let sentence = slow.expect_refusal(Reason::Slow).await;
    assert!(sentence.ends_with("before 131072 bytes are queued"), "{sentence}");
}

#[tokio::test]
async fn a_burst_disconnects_its_sender_instead_of_a_slow_reader() {
    let server = server(Limits { said_bytes_per_second: 1e-6, ping: HOURS, silence: 2 * HOURS, ..limits() }, None);
    let mut victim = join_slow_reader(&server, 1).await;
    let mut friend = join(&server, "hall", 2, "").await;
    let said = FromUser::Say { to: To::Room, payload: &[1; 4000] };
    let signal = FromUser::Signal { user: victim.number, payload: &[1; 4000] };
    for frame in [said, signal] {
        let mut sender = join(&server, "hall", 2, "").await;
        // The frames exceed what a user's queue may hold; the connection may end during the writes.
        for _ in 0..40 {
            let _ = sender.transport.send(Message::binary(encode(&[frame]))).await;
        }
        sender.expect_refusal(Reason::Flood).await;
        friend.wait_until_left(sender.number).await;
    }
    friend.send(&[FromUser::Say { to: To::Room, payload: b"still there" }]).await;
    victim.wait_for(pick!(FromServer::Say { payload: b"still there", .. } => ())).await;
}
