//! Authority of a connection over its user's number.

use std::sync::Arc;
use std::time::{Duration, Instant};

use bytes::BytesMut;

use super::support::{pose, split};
use crate::clients::Clients;
use crate::rooms::figures::Figures;
use crate::rooms::frame::{FromServer, To};
use crate::rooms::outbox::{Outbox, Part, Taken};
use crate::rooms::reason::Reason;
use crate::rooms::room::{By, Joining, Room};

fn room() -> Room {
    let begun = Clients::enter(&Arc::default(), [127, 0, 0, 1].into(), 1).expect("the first one");
    Room::new(0, Arc::new(Figures::new()), begun)
}

fn join(room: &Room, back: Option<(u16, u64)>) -> (u16, Arc<Outbox>) {
    let outbox = Arc::new(Outbox::new(10_000, Duration::from_secs(2)));
    let joining = Joining { group: 1, name: "", token: None, back, identity: 7, outbox: Arc::clone(&outbox) };
    (room.join(&joining, 9, |_, _| [0; 26]).expect("there is place"), outbox)
}

/// Queued frames, except those about joining and leaving.
fn queued_frames(outbox: &Outbox) -> Vec<Vec<u8>> {
    let mut message = BytesMut::new();
    assert!(!matches!(outbox.take(Part::All, &mut message, &mut Vec::new()), Taken::End(_)));
    let is_sent = |frame: &Vec<u8>| {
        let (frame, _) = FromServer::read(frame).expect("a frame");
        !matches!(frame, FromServer::Welcome { .. } | FromServer::Joined { .. } | FromServer::Left { .. })
    };
    split(&message).into_iter().filter(is_sent).collect()
}

#[test]
fn a_connection_that_was_replaced_does_nothing() {
    let (room, now) = (room(), Instant::now());
    let (peer, hears) = join(&room, None);
    let (user, old) = join(&room, None);
    let (again, own) = join(&room, Some((user, 7)));
    assert_eq!((again, old.ended().map(|end| end.reason)), (user, Some(Reason::Replaced)));
    let act = |outbox: &Arc<Outbox>, sequence| {
        let by = By { user, outbox };
        room.pose(by, pose(sequence), now);
        room.acknowledge(by, peer, 1);
        room.say(by, To::Group, b"said", now).expect("it is little");
        room.say(by, To::Room, b"said", now).expect("it is little");
        room.signal(by, peer, b"signal", now).expect("it is little");
    };
    room.pose(By { user: peer, outbox: &hears }, pose(1), now);
    act(&old, 1_000_000);
    assert_eq!(queued_frames(&hears), Vec::<Vec<u8>>::new());
    // The replaced connection's pose does not supersede the user's own lower numbers.
    act(&own, 1);
    assert_eq!(queued_frames(&hears).len(), 5, "say, say, signal, pose, settled");
    room.leave(By { user, outbox: &old });
    act(&own, 2);
    assert_eq!(queued_frames(&hears).len(), 4, "the user has not left");
}
