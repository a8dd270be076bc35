//! Misbehaving WebTransport users, and connections that are not sessions.

use std::time::Duration;

use tokio::time::timeout;
use wtransport::VarInt;

use super::session_support::{connect, join, request_session};
use super::support::{
    self, HOURS, Random, TEST_TIMEOUT, Transport, encode, limits, pick, pose, say_until_left, server,
};
use crate::rooms::frame::{FromServer, FromUser, To};
use crate::rooms::{Limits, Reason};

/// Burst that is over before a sender fills its share, so that the reader is at fault.
const MOMENT: Duration = Duration::from_micros(1);

#[tokio::test]
async fn malformed_streams_disconnect_their_sender_alone() {
    let server = server(limits(), None);
    let mut witness = support::join(&server, "hall", 1, "").await;
    for (sent, sentence) in [
        (vec![99, 0, 0], "a frame has a kind that users do not send"),
        (vec![2, 3, 0, 1, 1, 1], "a pose is too short"),
        (vec![4, 0xff, 0xff], "expected frames of at most 32768 bytes"),
        (encode(&[FromUser::Hello { group: 1, name: "again", ticket: &[] }]), "expected one hello"),
    ] {
        let mut guest = join(&server, "hall", 1, "").await;
        guest.transport.send.write_all(&sent).await.expect("sent");
        assert_eq!(guest.expect_refusal(Reason::Frame).await, sentence);
        witness.wait_until_left(guest.number).await;
    }
    let mut guest = join(&server, "hall", 1, "").await;
    guest.transport.send.write_all(&[2, 40, 0, 1]).await.expect("sent");
    guest.transport.send.finish().await.expect("it has come");
    assert_eq!(guest.expect_refusal(Reason::Frame).await, "expected a whole frame before the stream's end");
    let mut guest = connect(&server, "/rooms/hall").await;
    guest.send(&[FromUser::Pose(pose(1))]).await;
    assert_eq!(guest.expect_refusal(Reason::Frame).await, "expected hello first");
}

#[tokio::test]
async fn malformed_datagrams_disconnect_their_sender_alone() {
    let server = server(limits(), None);
    let mut witness = support::join(&server, "hall", 1, "").await;
    let others = "expected only poses and acknowledgements in datagrams";
    for (sent, sentence) in [
        (vec![99, 0, 0], "a frame has a kind that users do not send"),
        (vec![2], "a frame is too short"),
        (encode(&[FromUser::Pose(pose(1)), FromUser::Bye]), others),
        (encode(&[FromUser::Say { to: To::Room, payload: b"" }]), others),
    ] {
        let mut guest = join(&server, "hall", 1, "").await;
        guest.transport.connection.send_datagram(sent).expect("sent");
        assert_eq!(guest.expect_refusal(Reason::Frame).await, sentence);
        witness.wait_until_left(guest.number).await;
    }
}

#[tokio::test]
async fn datagrams_before_hello_are_dropped() {
    let server = server(limits(), None);
    let mut guest = connect(&server, "/rooms/hall").await;
    for _ in 0..3 {
        guest.transport.connection.send_datagram([99, 0, 0]).expect("sent");
    }
    guest.send(&[FromUser::Hello { group: 1, name: "", ticket: &[] }]).await;
    guest.wait_for(pick!(FromServer::Welcome { .. } => ())).await;
}

#[tokio::test]
async fn sessions_that_send_too_much_are_closed() {
    let few = Limits { messages_per_second: 20.0, ..limits() };
    let narrow = Limits { bytes_per_second: 4000.0, ..limits() };
    let quiet = Limits { said_bytes_per_second: 100.0, ..limits() };
    for (limits, sent) in
        [(few, vec![]), (few, encode(&[FromUser::Pose(pose(1))])), (narrow, encode(&[FromUser::Pose(pose(1)); 5]))]
    {
        let server = server(limits, None);
        let mut guest = join(&server, "hall", 1, "").await;
        // The loop continues after the session is closed and sends fail.
        for _ in 0..500 {
            let _ = guest.transport.connection.send_datagram(&sent);
            tokio::task::yield_now().await;
        }
        guest.expect_refusal(Reason::Flood).await;
    }
    let server = server(quiet, None);
    let mut guest = join(&server, "hall", 1, "").await;
    let payload = [1; 4096];
    for _ in 0..9 {
        let _ = guest.transport.send.write_all(&encode(&[FromUser::Say { to: To::Room, payload: &payload }])).await;
    }
    guest.expect_refusal(Reason::Flood).await;
}

#[tokio::test]
async fn users_who_stop_answering_leave_and_silent_users_stay() {
    let limits = Limits { ping: Duration::from_millis(300), silence: Duration::from_secs(10), ..limits() };
    let server = server(limits, None);
    let mut witness = join(&server, "hall", 1, "").await;
    // The client's runtime stops, so that nothing answers any more.
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().expect("a runtime");
    let vanished = std::thread::scope(|scope| {
        let thread = scope.spawn(|| {
            let guest = runtime.block_on(join(&server, "hall", 1, ""));
            let number = guest.number;
            std::mem::forget(guest);
            runtime.shutdown_background();
            number
        });
        thread.join().expect("it joined")
    });
    witness.wait_for(pick!(FromServer::Left { user } if user == vanished => ())).await;
}

#[tokio::test]
async fn others_see_users_leave_who_close_a_session_or_a_stream() {
    let server = server(limits(), None);
    let mut witness = support::join(&server, "hall", 1, "").await;
    let guest = join(&server, "hall", 1, "").await;
    guest.transport.connection.close(VarInt::from_u32(0), b"");
    witness.wait_until_left(guest.number).await;
    let mut guest = join(&server, "hall", 1, "").await;
    guest.transport.send.finish().await.expect("it has come");
    guest.transport.expect_close(Reason::Bye).await;
    witness.wait_until_left(guest.number).await;
    let guest = join(&server, "hall", 1, "").await;
    let number = guest.number;
    drop(guest);
    witness.wait_until_left(number).await;
}

#[tokio::test]
async fn sessions_without_hello_are_closed() {
    let limits = Limits { hello: Duration::from_secs(5), ping: HOURS, silence: 2 * HOURS, ..limits() };
    let server = server(limits, None);
    let mut guest = connect(&server, "/rooms/hall").await;
    guest.send(&[]).await;
    guest.transport.connection.send_datagram([]).expect("sent");
    let (connection, _endpoint) = request_session(&server, "/rooms/hall", None).await.expect("a session");
    assert_eq!(guest.expect_refusal(Reason::Silent).await, "expected hello");
    timeout(TEST_TIMEOUT, connection.closed()).await.expect("its stream does not come");
}

#[tokio::test]
async fn sessions_that_do_not_read_are_closed_and_others_receive_all() {
    let server = server(Limits { ping: HOURS, silence: 2 * HOURS, burst: MOMENT, ..limits() }, None);
    let mut slow = join(&server, "hall", 1, "").await;
    let mut sender = support::join(&server, "hall", 1, "").await;
    let mut friend = support::join(&server, "hall", 1, "").await;
    say_until_left(&mut sender, &mut friend, slow.number).await;
    // It next reads the reason.
    let sentence = slow.expect_refusal(Reason::Slow).await;
    assert!(sentence.ends_with("before 131072 bytes are queued"), "{sentence}");
}

#[tokio::test]
async fn random_bytes_end_with_a_reason() {
    let server = server(limits(), None);
    let mut random = Random(3);
    let mut witness = support::join(&server, "hall", 1, "").await;
    for round in 0..20 {
        let mut guest = join(&server, "hall", 1, "").await;
        let garbage: Vec<u8> = (0..1 + random.below(600)).map(|_| random.below(256) as u8).collect();
        if round % 2 == 0 {
            let _ = guest.transport.send.write_all(&garbage).await;
            let _ = guest.transport.send.finish().await;
        } else {
            guest.transport.connection.send_datagram(&garbage).expect("sent");
        }
        guest.expect_refusal(Reason::Frame).await;
        witness.wait_until_left(guest.number).await;
    }
}
