//! Authority of a connection over its user's number.

use std::sync::Arc;
use std::time::{Duration, Instant};

use bytes::BytesMut;

use super::support::{pose, split};
use crate::clients::Clients;
use crate::rooms::figures::Figures;
use crate::rooms::frame::{FromServer, To};
use crate::rooms::outbox::{Outbox, Selection, Taken};
use crate::rooms::reason::Reason;
use crate::rooms::room::{JoinRequest, Room, Sender};

fn room() -> Room {
    let begun = Clients::admit(&Arc::default(), [127, 0, 0, 1].into(), 1, 1).expect("the first one");
    Room::new(0, Arc::new(Figures::new()), begun)
}

fn join(room: &Room, previous: Option<(u16, u64)>) -> Sender {
    let outbox = Arc::new(Outbox::new(10_000, Duration::from_secs(2)));
    let join_request =
        JoinRequest { group: 1, name: "", token: None, previous, identity: 7, outbox: Arc::clone(&outbox) };
    Sender { user: room.join(&join_request, 9, |_, _| [0; 26]).expect("there is place"), outbox }
}

/// Queued frames, except those about joining and leaving.
fn queued_frames(outbox: &Outbox) -> Vec<Vec<u8>> {
    let mut message = BytesMut::new();
    assert!(!matches!(outbox.take(Selection::All, &mut message, &mut Vec::new()), Taken::End(_)));
    let is_sent = |frame: &Vec<u8>| {
        let (frame, _) = FromServer::read(frame).expect("a frame");
        !matches!(frame, FromServer::Welcome { .. } | FromServer::Joined { .. } | FromServer::Left { .. })
    };
    split(&message).into_iter().filter(is_sent).collect()
}

#[test]
fn a_connection_that_was_replaced_does_nothing() {
    let (room, now) = (room(), Instant::now());
    let peer = join(&room, None);
    let old = join(&room, None);
    let new = join(&room, Some((old.user, 7)));
    assert_eq!((new.user, old.outbox.ended().map(|end| end.reason)), (old.user, Some(Reason::Replaced)));
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
