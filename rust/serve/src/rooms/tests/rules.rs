//! Distribution of frames: who receives what, with a server on this machine.

use std::time::Duration;

use tokio::time::timeout;

use super::capabilities;
use super::support::{
    HOURS, TEST_TIMEOUT, connect, join, limits, pick, pose, pose_to_acknowledge, server, server_content, start_within,
};
use crate::Server;
use crate::rooms::frame::{FromServer, FromUser, To};
use crate::rooms::{Limits, Reason};

fn count(text: &str, name: &str) -> f64 {
    let line = text.lines().find_map(|line| line.strip_prefix(name));
    line.unwrap_or_else(|| panic!("{name} in {text}")).trim().parse().expect("a number")
}

#[tokio::test]
async fn users_see_who_is_present_joins_and_leaves() {
    let server = server(limits(), None);
    let mut ada = join(&server, "hall", 4, "Ada").await;
    let mut grace = connect(server.address(), "/rooms/hall").await.expect("a connection");
    grace.send(&[FromUser::Hello { group: 9, name: "Grace", ticket: &[] }]).await;
    let welcome = pick!(FromServer::Welcome { user, others, .. } if user != ada.number => others);
    assert_eq!(grace.wait_for(welcome).await, 1);
    grace.expect_frame(FromServer::Joined { user: ada.number, group: 4, name: "Ada" }).await;
    let (number, group) = ada.wait_for(pick!(FromServer::Joined { user, group, name: "Grace" } => (user, group))).await;
    assert_eq!(group, 9);
    let _elsewhere = join(&server, "yard", 4, "Eve").await;
    grace.send(&[FromUser::Bye]).await;
    ada.expect_frame(FromServer::Left { user: number }).await;
    assert!(grace.next().await.is_none(), "a user who leaves is not refused");
}

#[tokio::test]
async fn poses_go_to_the_group_with_the_number_that_the_server_assigned() {
    let server = server(limits(), None);
    let mut users = Vec::new();
    for (group, room) in [(1, "hall"), (1, "hall"), (2, "hall"), (1, "yard")] {
        users.push(join(&server, room, group, "").await);
    }
    let [sender, friend, stranger, elsewhere] = &mut users[..] else { panic!("four users") };
    sender.send(&[FromUser::Pose(pose(1)), FromUser::Say { to: To::Room, payload: b"end" }]).await;
    assert_eq!(friend.next_pose_of(sender.number).await, pose(1));
    let (user, to) = (sender.number, To::Room);
    // Only `joined` frames came before it.
    let frame = stranger.wait_for(|frame| (!matches!(frame, FromServer::Joined { .. })).then(|| format!("{frame:?}")));
    assert_eq!(frame.await, format!("{:?}", FromServer::Say { user, to, payload: b"end" }));
    let other = join(&server, "yard", 1, "late").await;
    elsewhere.expect_frame(FromServer::Joined { user: other.number, group: 1, name: "late" }).await;
}

#[tokio::test]
async fn messages_reach_the_group_or_the_room_in_order() {
    let server = server(limits(), None);
    let mut sender = join(&server, "hall", 1, "").await;
    let (mut friend, mut stranger) = (join(&server, "hall", 1, "").await, join(&server, "hall", 2, "").await);
    for round in 0..100u8 {
        let to = if round % 2 == 0 { To::Group } else { To::Room };
        sender.send(&[FromUser::Say { to, payload: &[round] }]).await;
    }
    let said = pick!(FromServer::Say { user, payload, .. } if user == sender.number => payload[0]);
    for round in 0..100 {
        assert_eq!(friend.wait_for(said).await, round);
        if round % 2 == 1 {
            assert_eq!(stranger.wait_for(said).await, round);
        }
    }
    // The sender does not receive its own message.
    friend.send(&[FromUser::Say { to: To::Group, payload: b"answer" }]).await;
    assert_eq!(sender.wait_for(pick!(FromServer::Say { user, .. } => user)).await, friend.number);
}

#[tokio::test]
async fn signals_reach_one_user_of_the_room() {
    let server = server(limits(), None);
    let mut sender = join(&server, "hall", 1, "").await;
    let (mut peer, mut stranger) = (join(&server, "hall", 1, "").await, join(&server, "hall", 2, "").await);
    let long = vec![5; 1 << 14];
    let nobody = FromUser::Signal { user: peer.number.wrapping_add(1000), payload: b"lost" };
    sender.send(&[nobody]).await;
    sender.send(&[FromUser::Signal { user: stranger.number, payload: &long }]).await;
    sender.send(&[FromUser::Say { to: To::Room, payload: b"end" }]).await;
    let received = |frame: FromServer<'_>| match frame {
        FromServer::Signal { user, payload } => Some((user, payload.len())),
        FromServer::Say { .. } => Some((0, 0)),
        _ => None,
    };
    assert_eq!(stranger.wait_for(received).await, (sender.number, long.len()));
    assert_eq!(peer.wait_for(received).await, (0, 0));
}

#[tokio::test]
async fn a_pose_settles_when_the_last_of_the_group_has_acknowledged_it_or_left() {
    let server = server(limits(), None);
    let mut sender = join(&server, "hall", 1, "").await;
    let (mut one, mut two) = (join(&server, "hall", 1, "").await, join(&server, "hall", 1, "").await);
    let mut stranger = join(&server, "hall", 2, "").await;
    let user = sender.number;
    let settled = |frame: FromServer<'_>| match frame {
        FromServer::Settled { sequence } => Some(sequence),
        FromServer::Say { .. } => Some(0),
        _ => None,
    };
    sender.send(&[FromUser::Pose(pose_to_acknowledge(1))]).await;
    for peer in [&mut one, &mut two] {
        assert!(peer.next_pose_of(user).await.is_acknowledged);
    }
    one.send(&[FromUser::Ack { user, sequence: 1 }, FromUser::Say { to: To::Group, payload: b"" }]).await;
    assert_eq!(sender.wait_for(settled).await, 0, "one of two has acknowledged it");
    // Acknowledgements by users outside the group, of unsent poses or of unknown users settle nothing.
    stranger.send(&[FromUser::Ack { user, sequence: 1 }, FromUser::Say { to: To::Room, payload: b"" }]).await;
    assert_eq!(sender.wait_for(settled).await, 0);
    let invalid = [FromUser::Ack { user, sequence: 2 }, FromUser::Ack { user: 31_000, sequence: 1 }];
    two.send(&invalid).await;
    two.send(&[FromUser::Ack { user, sequence: 1 }]).await;
    assert_eq!(sender.wait_for(settled).await, 1);
    // A later pose settles earlier ones without acknowledgements, and a user who leaves is not waited for.
    for sequence in 2..=4 {
        sender.send(&[FromUser::Pose(pose_to_acknowledge(sequence))]).await;
    }
    while one.next_pose_of(user).await.sequence < 4 {}
    one.send(&[FromUser::Ack { user, sequence: 4 }, FromUser::Say { to: To::Group, payload: b"" }]).await;
    assert_eq!(sender.wait_for(settled).await, 0);
    drop(two);
    assert_eq!(sender.wait_for(settled).await, 4);
    // An older pose is not forwarded.
    sender
        .send(&[
            FromUser::Pose(pose_to_acknowledge(4)),
            FromUser::Pose(pose_to_acknowledge(3)),
            FromUser::Pose(pose(9)),
        ])
        .await;
    assert_eq!(one.next_pose_of(user).await.sequence, 9);
}

#[tokio::test]
async fn rooms_of_a_server_and_users_of_a_room_are_limited() {
    let server = server(Limits { rooms: 2, users: 2, ..limits() }, None);
    let (mut one, two) = (join(&server, "hall", 1, "").await, join(&server, "hall", 2, "").await);
    let _yard = join(&server, "yard", 1, "").await;
    for (room, sentence) in
        [("hall", "expected a room with fewer than 2 users"), ("attic", "expected a server with fewer than 2 rooms")]
    {
        let mut user = connect(server.address(), &format!("/rooms/{room}")).await.expect("a connection");
        user.send(&[FromUser::Hello { group: 1, name: "", ticket: &[] }]).await;
        assert_eq!(user.expect_refusal(Reason::Full).await, sentence);
    }
    drop(two);
    one.wait_for(pick!(FromServer::Left { .. } => ())).await;
    join(&server, "hall", 1, "").await;
}

#[tokio::test]
async fn metrics_count_rooms() {
    let server = server(limits(), None);
    let mut sender = join(&server, "hall", 1, "").await;
    let mut friend = join(&server, "hall", 1, "").await;
    let mut leaves = join(&server, "yard", 1, "").await;
    leaves.send(&[FromUser::Bye]).await;
    assert!(leaves.next().await.is_none());
    for sequence in [5, 4, 6] {
        sender.send(&[FromUser::Pose(pose_to_acknowledge(sequence))]).await;
    }
    while friend.next_pose_of(sender.number).await.sequence < 6 {}
    // The pose was written before it arrived here, and is counted before the next message is written.
    sender.send(&[FromUser::Say { to: To::Group, payload: b"" }]).await;
    friend.wait_for(pick!(FromServer::Say { .. } => ())).await;
    drop(leaves);
    let (_, mut text) = capabilities::get(&server, "/metrics", "").await;
    // Upgraded connections still count: two of them, and that of the request for metrics.
    while count(&text, "nearfar_connections") > 3.0 {
        (_, text) = capabilities::get(&server, "/metrics", "").await;
    }
    assert_eq!(count(&text, "nearfar_connections"), 3.0);
    assert_eq!(count(&text, "nearfar_room_users"), 2.0);
    assert_eq!(count(&text, "nearfar_rooms"), 1.0);
    let forwarded = count(&text, "nearfar_room_poses_total{outcome=\"forwarded\"}");
    let dropped = count(&text, "nearfar_room_poses_total{outcome=\"dropped\"}");
    assert_eq!(forwarded + dropped, 3.0, "{text}");
    assert!(forwarded >= 1.0 && dropped >= 1.0);
    assert_eq!(count(&text, "nearfar_room_residence_seconds_count"), forwarded);
    assert_eq!(count(&text, "nearfar_room_closes_total{reason=\"bye\"}"), 1.0);
}

/// Starts a server with this grace period at shutdown, whose rooms have timeouts of hours.
fn start_with_grace(grace: Duration) -> Server {
    let rooms = Limits { hello: HOURS, ping: HOURS, silence: 2 * HOURS, linger: HOURS, ..limits() };
    start_within(server_content(rooms, None), None, crate::Limits { grace, ..crate::Limits::default() })
}

#[tokio::test]
async fn a_server_at_shutdown_notifies_all_users_and_waits_for_them() {
    let server = start_with_grace(HOURS);
    let mut user = join(&server, "hall", 1, "").await;
    let mut early = connect(server.address(), "/rooms/hall").await.expect("a connection");
    let closing = tokio::task::spawn_blocking(move || server.close());
    assert_eq!(user.expect_refusal(Reason::Ending).await, "the server is shutting down");
    assert_eq!(early.expect_refusal(Reason::Ending).await, "the server is shutting down");
    drop((user, early));
    timeout(TEST_TIMEOUT, closing).await.expect("it does not wait for its grace").expect("it ends");
}

#[tokio::test]
async fn a_server_at_shutdown_abandons_users_who_do_not_close() {
    let server = start_with_grace(Duration::from_millis(1));
    let mut rude = join(&server, "hall", 1, "").await;
    let closing = tokio::task::spawn_blocking(move || server.close());
    timeout(TEST_TIMEOUT, closing).await.expect("it does not wait for its users").expect("it ends");
    while rude.next().await.is_some() {}
}
