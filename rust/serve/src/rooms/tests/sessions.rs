//! Rooms over WebTransport: choice of datagrams or the stream, and admission.

use std::net::UdpSocket;
use std::sync::Arc;

use wtransport::error::ConnectingError;

use super::capabilities;
use super::session_support::{connect, join, request_session};
use super::support::{
    self, Channel, Transport, limits, pick, pose, pose_to_acknowledge, server, server_content, start, start_at,
    start_within,
};
use crate::rooms::frame::{FromServer, FromUser, To};
use crate::rooms::pose::Pose;
use crate::rooms::{Key, Limits, Reason, Rooms};
use crate::{HeaderValue, ServerContent, tls};

#[tokio::test]
async fn users_of_both_transports_see_each_other() {
    let server = server(limits(), None);
    let mut socket = support::join(&server, "hall", 1, "socket").await;
    let mut guest = join(&server, "hall", 1, "guest").await;
    let joined = FromServer::Joined { user: guest.number, group: 1, name: "guest" };
    socket.wait_for(|frame| (frame == joined).then_some(())).await;
    guest.send_datagram(&[FromUser::Pose(pose(1))]);
    assert_eq!(socket.next_pose_of(guest.number).await, pose(1));
    socket.send(&[FromUser::Pose(pose(7))]).await;
    assert_eq!((guest.next_pose_of(socket.number).await, guest.channel), (pose(7), Channel::Datagram));
    // The final pose of a movement must arrive.
    let final_pose = Pose { stops: true, ..pose(2) };
    guest.send(&[FromUser::Pose(final_pose)]).await;
    assert_eq!(socket.next_pose_of(guest.number).await, final_pose);
    socket.send(&[FromUser::Pose(Pose { stops: true, ..pose(8) })]).await;
    assert_eq!(
        (guest.next_pose_of(socket.number).await, guest.channel),
        (Pose { stops: true, ..pose(8) }, Channel::Stream)
    );
    guest.send(&[FromUser::Say { to: To::Room, payload: b"to all" }]).await;
    let said = FromServer::Say { user: guest.number, to: To::Room, payload: b"to all" };
    socket.wait_for(|frame| (frame == said).then_some(())).await;
    guest.send(&[FromUser::Bye]).await;
    guest.transport.expect_close(Reason::Bye).await;
    socket.wait_until_left(guest.number).await;
}

#[tokio::test]
async fn poses_settle_by_datagrams_and_final_ones_by_the_stream() {
    let server = server(limits(), None);
    let mut one = join(&server, "hall", 1, "").await;
    let mut two = join(&server, "hall", 1, "").await;
    one.wait_for(pick!(FromServer::Joined { .. } => ())).await;
    let settled = pick!(FromServer::Settled { sequence } => sequence);
    for sequence in 1..4 {
        one.send_datagram(&[FromUser::Pose(pose_to_acknowledge(sequence))]);
        assert_eq!(
            (two.next_pose_of(one.number).await, two.channel),
            (pose_to_acknowledge(sequence), Channel::Datagram)
        );
        two.send_datagram(&[FromUser::Ack { user: one.number, sequence }]);
        assert_eq!((one.wait_for(settled).await, one.channel), (sequence, Channel::Datagram));
    }
    let final_pose = Pose { stops: true, ..pose_to_acknowledge(4) };
    one.send(&[FromUser::Pose(final_pose)]).await;
    assert_eq!((two.next_pose_of(one.number).await, two.channel), (final_pose, Channel::Stream));
    two.send(&[FromUser::Ack { user: one.number, sequence: 4 }]).await;
    assert_eq!((one.wait_for(settled).await, one.channel), (4, Channel::Stream));
}

#[tokio::test]
async fn an_older_late_pose_is_dropped() {
    let server = server(limits(), None);
    let mut one = join(&server, "hall", 1, "").await;
    let mut two = support::join(&server, "hall", 1, "").await;
    one.wait_for(pick!(FromServer::Joined { .. } => ())).await;
    // On the stream, so that the order is known.
    one.send(&[FromUser::Pose(pose(5))]).await;
    assert_eq!(two.next_pose_of(one.number).await, pose(5));
    one.send(&[FromUser::Pose(pose(4)), FromUser::Pose(pose(6))]).await;
    assert_eq!(two.next_pose_of(one.number).await, pose(6));
}

#[tokio::test]
async fn pages_of_other_origins_and_other_paths_get_no_session() {
    let server = server(limits(), None);
    let own = format!("http://{}", server.address());
    for (path, origin, expected) in [
        ("/rooms/hall", None, true),
        ("/rooms/hall", Some(own.as_str()), true),
        ("/rooms/h%C3%A4ll?any", Some(own.as_str()), true),
        ("/rooms/hall", Some("https://evil.example"), false),
        ("/rooms/hall", Some("http://127.0.0.1:1"), false),
        ("/rooms/hall", Some("null"), false),
        ("/rooms/a/b", None, false),
        ("/rooms", None, false),
        ("/", None, false),
    ] {
        match request_session(&server, path, origin).await {
            Ok(_) => assert!(expected, "{path} {origin:?}"),
            Err(ConnectingError::SessionRejected) => assert!(!expected, "{path} {origin:?}"),
            Err(error) => panic!("{error}"),
        }
    }
    // Files are public, but rooms without tokens are not.
    let origin = Some(HeaderValue::from_static("*"));
    let open = start(ServerContent { origin, ..server_content(limits(), None) }, None);
    assert!(request_session(&open, "/rooms/hall", Some("https://any.example")).await.is_err());
    let hosts = Some(["other".to_owned()].into());
    let named = start(ServerContent { hosts, ..server_content(limits(), None) }, None);
    assert!(request_session(&named, "/rooms/hall", None).await.is_err());
}

#[tokio::test]
async fn pages_can_read_the_port_of_webtransport() {
    let server = server(limits(), None);
    let offer = server.datagrams().expect("datagrams");
    assert_eq!(offer.port, server.address().port());
    let hash = &offer.hashes[0];
    let expected = format!(r#"{{"peers":true,"datagrams":{{"port":{},"hashes":["{hash}"]}}}}"#, offer.port);
    assert_eq!(capabilities::get(&server, "/rooms", "").await.1, expected);
}

#[tokio::test]
async fn users_need_a_token_as_over_sockets() {
    let key = Key::new(&[7; 32]).expect("a key");
    let server = server(limits(), Some(key.clone()));
    let mut guest = connect(&server, "/rooms/hall?token=none").await;
    guest.send(&[FromUser::Hello { group: 1, name: "", ticket: &[] }]).await;
    assert_eq!(guest.expect_refusal(Reason::Token).await, "expected a token that was made for this room");
    let token = key.token("hall", u64::MAX, [1; 16]);
    let mut guest = connect(&server, &format!("/rooms/hall?token={token}")).await;
    guest.send(&[FromUser::Hello { group: 1, name: "", ticket: &[] }]).await;
    guest.wait_for(pick!(FromServer::Welcome { .. } => ())).await;
}

#[tokio::test]
async fn sessions_leave_connections_to_files() {
    let limits = crate::Limits { connections: 4, ..crate::Limits::default() };
    let server = start_within(server_content(support::limits(), None), None, limits);
    let mut guests = Vec::new();
    for number in 0..3 {
        guests.push(join(&server, &number.to_string(), 0, "").await);
    }
    assert!(request_session(&server, "/rooms/hall", None).await.is_err());
    guests.truncate(2);
    // The slot becomes free when the connection has ended.
    while request_session(&server, "/rooms/hall", None).await.is_err() {}
}

#[tokio::test]
async fn webtransport_has_another_port_if_the_same_number_is_taken() {
    // A port that is free for TCP and bound for UDP.
    let bound = UdpSocket::bind("127.0.0.1:0").expect("a socket");
    let address = bound.local_addr().expect("an address");
    let server = start_at(address, server_content(limits(), None), None, crate::Limits::default());
    let port = server.datagrams().expect("datagrams").port;
    assert_ne!(port, server.address().port());
    let own = format!("http://{}", server.address());
    assert!(
        request_session(&server, "/rooms/hall", Some(&own)).await.is_ok(),
        "the origin of pages has the port of HTTP"
    );
    let other = format!("http://127.0.0.1:{port}");
    assert!(request_session(&server, "/rooms/hall", Some(&other)).await.is_err());
}

#[tokio::test]
async fn a_self_signed_certificate_is_not_used_for_datagrams() {
    let folder = tempfile::tempdir().expect("a folder");
    let (certificate, key) = tls::self_signed(vec!["127.0.0.1".into()]).expect("made");
    let paths = tls::tests::write_pem(folder.path(), "own", &certificate, &key);
    let server = start(server_content(limits(), None), Some(paths));
    let own = format!("https://{}", server.address());
    request_session(&server, "/rooms/hall", Some(&own)).await.expect("a session");
}

#[tokio::test]
async fn datagrams_can_be_switched_off() {
    let mut rooms = Rooms::new(Limits::default(), None).expect("limits that fit");
    rooms.datagrams = false;
    let server = start(ServerContent { rooms: Some(Arc::new(rooms)), ..server_content(limits(), None) }, None);
    assert!(server.datagrams().is_none());
}

#[tokio::test]
async fn a_server_at_shutdown_notifies_sessions() {
    let server = server(limits(), None);
    let mut guest = join(&server, "hall", 1, "").await;
    let (silent, _endpoint) = request_session(&server, "/rooms/hall", None).await.expect("a session");
    let closing = std::thread::spawn(move || server.close());
    assert_eq!(guest.expect_refusal(Reason::Ending).await, "the server is shutting down");
    silent.closed().await;
    closing.join().expect("it ends");
}

#[tokio::test]
async fn metrics_count_sessions() {
    let server = server(limits(), None);
    let guest = join(&server, "hall", 1, "").await;
    let (_, text) = capabilities::get(&server, "/metrics", "").await;
    assert!(text.contains("nearfar_room_datagram_connections 1") && text.contains("nearfar_room_users 1"), "{text}");
    drop(guest);
}
