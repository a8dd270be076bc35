//! Outbox of a user, rate limits, and frames of replaced connections.

use std::sync::Arc;
use std::time::{Duration, Instant};

use bytes::BytesMut;

use super::support::{encode_each, pose, pose_to_acknowledge, split};
use crate::clients::Clients;
use crate::rooms::frame::{FromServer, To};
use crate::rooms::outbox::{Outbox, Outgoing, Selection};
use crate::rooms::pose::Pose;
use crate::rooms::reason::{End, Reason};
use crate::rooms::room::{JoinRequest, Room, Sender};
use crate::rooms::session::Bucket;
use crate::rooms::statistics::Statistics;

const BURST: Duration = Duration::from_secs(2);

/// Takes all queued frames, encoded.
fn drain(outbox: &Outbox) -> Vec<Vec<u8>> {
    let (mut message, mut read) = (BytesMut::new(), Vec::new());
    match outbox.take(Selection::All, &mut message, &mut read) {
        Outgoing::Nothing => Vec::new(),
        Outgoing::Message => split(&message),
        Outgoing::End(end) => panic!("{end:?}"),
    }
}

#[test]
fn newer_poses_overwrite_and_all_else_stays_in_order() {
    let (outbox, now) = (Outbox::new(1000, BURST), Instant::now());
    assert!(drain(&outbox).is_empty());
    assert!(!outbox.add_pose(1, pose_to_acknowledge(1), now));
    outbox.add(&FromServer::Left { user: 9 });
    assert!(!outbox.add_pose(2, pose(7), now));
    assert!(outbox.add_pose(1, pose(2), now));
    outbox.add_settled(4, false);
    outbox.add_settled(3, true);
    outbox.add(&FromServer::Left { user: 8 });
    let expected = [
        FromServer::Left { user: 9 },
        FromServer::Left { user: 8 },
        // The replaced pose needed acknowledgement, so this one does, too.
        FromServer::Pose { user: 1, pose: pose_to_acknowledge(2) },
        FromServer::Pose { user: 2, pose: pose(7) },
        FromServer::Settled { sequence: 4 },
    ];
    assert_eq!(drain(&outbox), encode_each(&expected));
    assert!(drain(&outbox).is_empty());
    outbox.add_pose(1, pose(3), now);
    outbox.forget(1);
    assert!(drain(&outbox).is_empty());
}

#[test]
fn poses_of_a_large_group_wait_for_several_full_datagrams() {
    let (outbox, now) = (Outbox::new(1000, BURST), Instant::now());
    for user in 0..100 {
        outbox.add_pose(user, pose(1), now);
    }
    let pose_bytes = encode_each(&[FromServer::Pose { user: 0, pose: pose(1) }])[0].len();
    let mut frames = Vec::new();
    for full in [true, true, true, false] {
        let datagram = outbox.datagram(30 * pose_bytes + pose_bytes / 2);
        assert_eq!(datagram.bytes.len(), if full { 30 } else { 10 } * pose_bytes);
        frames.extend(split(&datagram.bytes));
        assert_eq!(outbox.confirm_sent(&datagram).len(), datagram.bytes.len() / pose_bytes);
    }
    let expected: Vec<_> = (0..100).map(|user| FromServer::Pose { user, pose: pose(1) }).collect();
    assert_eq!(frames, encode_each(&expected));
    assert!(outbox.datagram(1000).bytes.is_empty());
}

#[test]
fn replaceable_poses_are_sent_apart_from_required_ones() {
    let (outbox, now) = (Outbox::new(1000, BURST), Instant::now());
    let take_reliable = || {
        let (mut message, mut read) = (BytesMut::new(), Vec::new());
        let _ = outbox.take(Selection::Reliable, &mut message, &mut read);
        (split(&message), read.len())
    };
    let final_pose = Pose { stops: true, ..pose(5) };
    outbox.add(&FromServer::Left { user: 9 });
    outbox.add_pose(1, pose(1), now);
    outbox.add_pose(2, final_pose, now);
    outbox.add_settled(4, false);
    let reliable = [FromServer::Left { user: 9 }, FromServer::Pose { user: 2, pose: final_pose }];
    assert_eq!(take_reliable(), (encode_each(&reliable), 1));
    let datagram = outbox.datagram(1000);
    let frames = [FromServer::Settled { sequence: 4 }, FromServer::Pose { user: 1, pose: pose(1) }];
    assert_eq!(split(&datagram.bytes), encode_each(&frames));
    // Frames stay queued until sent; newer ones replace them.
    outbox.add_pose(1, pose(2), now);
    outbox.add_settled(5, false);
    assert_eq!(outbox.confirm_sent(&datagram).len(), 1);
    let datagram = outbox.datagram(1000);
    let frames = [FromServer::Settled { sequence: 5 }, FromServer::Pose { user: 1, pose: pose(2) }];
    assert_eq!(split(&datagram.bytes), encode_each(&frames));
    outbox.add_settled(6, true);
    assert_eq!(outbox.confirm_sent(&datagram).len(), 1);
    assert_eq!(outbox.datagram(1000).bytes.len(), 0);
    assert_eq!(take_reliable(), (encode_each(&[FromServer::Settled { sequence: 6 }]), 0));
    assert!(drain(&outbox).is_empty());
}

#[test]
fn datagrams_hold_as_much_as_fits_and_omit_no_user() {
    let (outbox, now) = (Outbox::new(1000, BURST), Instant::now());
    let pose_bytes = FromServer::Pose { user: 0, pose: pose(0) }.bytes();
    assert!(outbox.datagram(pose_bytes).bytes.is_empty());
    (0..5).for_each(|user| assert!(!outbox.add_pose(user, pose(0), now)));
    assert!(outbox.datagram(pose_bytes - 1).bytes.is_empty(), "not even one fits");
    let mut seen = Vec::new();
    for sequence in 1..11 {
        let datagram = outbox.datagram(2 * pose_bytes + 1);
        for frame in split(&datagram.bytes) {
            let Ok((FromServer::Pose { user, .. }, _)) = FromServer::read(&frame) else { panic!("a pose") };
            seen.push(user);
        }
        assert_eq!(outbox.confirm_sent(&datagram).len(), 2);
        (0..5).for_each(|user| _ = outbox.add_pose(user, pose(sequence), now));
    }
    assert_eq!(seen[..5], [0, 1, 2, 3, 4]);
    let least = (0..5).map(|user| seen.iter().filter(|pose_bytes| **pose_bytes == user).count()).min();
    assert!(least >= Some(3), "{seen:?}");
}

#[test]
fn users_with_too_long_queues_are_disconnected_and_freed() {
    let (outbox, frame) = (Outbox::new(20, BURST), FromServer::Left { user: 1 });
    (0..3).for_each(|_| outbox.add(&frame));
    let _ = drain(&outbox);
    // Frames in flight count, too.
    outbox.add(&frame);
    outbox.add(&frame);
    let (mut message, mut read) = (BytesMut::new(), Vec::new());
    let end = outbox.take(Selection::All, &mut message, &mut read);
    assert!(matches!(&end, Outgoing::End(End { reason: Reason::Slow, .. })), "{end:?}");
    assert!(message.is_empty());
    // The first reason is kept.
    outbox.end(End::new(Reason::Ending, ""));
    outbox.add_pose(1, pose(1), Instant::now());
    assert_eq!(outbox.take(Selection::All, &mut message, &mut read), end);
}

#[test]
fn senders_that_fill_a_queue_are_disconnected_instead_of_its_user() {
    let (outbox, begin) = (Outbox::new(1000, BURST), Instant::now());
    let say = FromServer::Say { user: 1, to: To::Room, payload: &[0; 94] };
    assert_eq!(say.bytes(), 100);
    let add = |sender, after| outbox.add_from(sender, &say, begin + after);
    assert!((0..2).all(|_| add(1, Duration::ZERO).is_ok()));
    let end = add(1, Duration::ZERO).expect_err("a quarter is 250 bytes");
    assert_eq!((end.reason, outbox.end_reason()), (Reason::Flood, None));
    assert!(add(2, Duration::ZERO).is_ok(), "pose_bytes sender has its own share");
    assert_eq!(drain(&outbox).len(), 3);
    assert!(add(1, Duration::ZERO).is_ok(), "the queue is empty again");
    // A user who does not read for longer than a burst is disconnected itself, not the senders.
    assert!((0..10).all(|_| add(1, BURST).is_ok()));
    assert_eq!(outbox.end_reason().map(|end| end.reason), Some(Reason::Slow));
}

#[test]
fn poses_do_not_count_as_queued_bytes() {
    let (outbox, now) = (Outbox::new(20, BURST), Instant::now());
    for sequence in 0..1000 {
        (0..10).for_each(|user| _ = outbox.add_pose(user, pose(sequence), now));
    }
    assert_eq!(drain(&outbox).len(), 10);
}

#[test]
fn a_bucket_refills_with_time_up_to_its_burst() {
    let begin = Instant::now();
    let at = |seconds| begin + Duration::from_secs_f64(seconds);
    let mut bucket = Bucket::new(10.0, 20.0, begin);
    assert!(bucket.take(20.0, begin));
    assert!(!bucket.take(0.5, begin));
    assert!(bucket.take(9.0, at(1.0)));
    assert!(!bucket.take(21.0, at(100.0)), "its capacity is two seconds' worth");
    assert!(bucket.take(20.0, at(200.0)));
    // A clock that goes back refills nothing.
    assert!(!bucket.take(1.0, at(100.0)));
}

fn room() -> Room {
    let creator = Clients::admit(&Arc::default(), [127, 0, 0, 1].into(), 1, 1).expect("the first one");
    Room::new(0, Arc::new(Statistics::new()), creator)
}

fn join(room: &Room, previous: Option<(u16, u64)>) -> Sender {
    let outbox = Arc::new(Outbox::new(10_000, Duration::from_secs(2)));
    let join_request =
        JoinRequest { group: 1, name: "", token: None, previous, identity: 7, outbox: Arc::clone(&outbox) };
    Sender { user: room.join(&join_request, 9, |_, _| [0; 26]).expect("there is place"), outbox }
}

/// Takes all queued frames, except those about joining and leaving.
fn queued_frames(outbox: &Outbox) -> Vec<Vec<u8>> {
    let mut message = BytesMut::new();
    assert!(!matches!(outbox.take(Selection::All, &mut message, &mut Vec::new()), Outgoing::End(_)));
    let is_sent_by_users = |frame: &Vec<u8>| {
        let (frame, _) = FromServer::read(frame).expect("a frame");
        !matches!(frame, FromServer::Welcome { .. } | FromServer::Joined { .. } | FromServer::Left { .. })
    };
    split(&message).into_iter().filter(is_sent_by_users).collect()
}

#[test]
fn frames_of_a_replaced_connection_are_ignored() {
    let (room, now) = (room(), Instant::now());
    let peer = join(&room, None);
    let old = join(&room, None);
    let new = join(&room, Some((old.user, 7)));
    assert_eq!((new.user, old.outbox.end_reason().map(|end| end.reason)), (old.user, Some(Reason::Replaced)));
    let act = |sender: &Sender, sequence| {
        room.pose(sender, pose(sequence), now);
        room.acknowledge(sender, peer.user, 1);
        room.say(sender, To::Group, b"said", now).expect("it is little");
        room.say(sender, To::Room, b"said", now).expect("it is little");
        room.signal(sender, peer.user, b"signal", now).expect("it is little");
    };
    room.pose(&peer, pose(1), now);
    act(&old, 1_000_000);
    assert_eq!(queued_frames(&peer.outbox), Vec::<Vec<u8>>::new());
    // The replaced connection's pose does not supersede the user's own lower numbers.
    act(&new, 1);
    assert_eq!(queued_frames(&peer.outbox).len(), 5, "say, say, signal, pose, settled");
    room.leave(&old);
    act(&new, 2);
    assert_eq!(queued_frames(&peer.outbox).len(), 4, "the user has not left");
}
