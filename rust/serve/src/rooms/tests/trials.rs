//! Users who act at random, and settled poses compared with a model that evaluates the whole history.

use super::support::Random;
use crate::rooms::settle::Settlement;
use crate::rooms::trial;

#[test]
fn users_see_only_what_they_may_after_any_actions() {
    let mut random = Random(7);
    for _ in 0..2_000 {
        let length = random.below(400);
        trial::run(&(0..length).map(|_| random.below(256) as u8).collect::<Vec<_>>());
    }
}

#[test]
fn final_poses_arrive_and_settle_although_datagrams_are_lost() {
    /// Kinds of steps: pose, acknowledgement, receiving, and switching the loss of datagrams.
    const STEPS: [u8; 4] = [4, 11, 31, 23];
    let step = |kind: u8, user: u8| 8 * kind + user;
    let mut random = Random(9);
    for round in (0..4).cycle().take(500) {
        // Two or more users, up to a full room, connect and say hello in one group.
        let users = 2 + round;
        let mut script: Vec<u8> =
            (0..users).flat_map(|user| [step(0, user), step(2, user), 0, 0, step(31, user)]).collect();
        for count in 0..200 {
            // In the second half no poses are sent.
            let kinds = if count < 100 { &STEPS[..] } else { &STEPS[1..] };
            let kind = kinds[random.below(kinds.len() as u64) as usize];
            script.push(step(kind, random.below(users.into()) as u8));
            match kind {
                // Increment of the number, and flags.
                4 => script.extend([1 + random.below(3) as u8, random.below(4) as u8]),
                11 => script.extend([random.below(users.into()) as u8, 0]),
                _ => {}
            }
        }
        trial::run(&script);
    }
}

#[derive(Clone, Copy)]
enum Event {
    Sent(u32),
    Joined(u16),
    Left(u16),
    Acknowledged(u16, u32),
}

/// Greatest settled sequence number by definition: the least, over the present users, of the greatest number that each
/// has acknowledged since it joined.
fn settled_by_definition(log: &[Event]) -> Option<u32> {
    let is_present = |peer: u16| {
        let mut moves = log.iter().filter(|each| matches!(each, Event::Joined(p) | Event::Left(p) if *p == peer));
        matches!(moves.next_back(), Some(Event::Joined(_)))
    };
    let greatest = |peer: u16| {
        let joined = log.iter().rposition(|each| matches!(each, Event::Joined(p) if *p == peer)).unwrap_or(0);
        let mut best = None;
        for (at, each) in log.iter().enumerate().skip(joined) {
            let sent = log[..at].iter().filter_map(|each| if let Event::Sent(s) = each { Some(*s) } else { None });
            match *each {
                Event::Acknowledged(p, s) if p == peer && sent.max() >= Some(s) => best = best.max(Some(s)),
                _ => {}
            }
        }
        best
    };
    let present: Vec<u16> = (0..9).filter(|peer| is_present(*peer)).collect();
    present.into_iter().map(greatest).min().flatten()
}

#[test]
fn settled_poses_equal_the_model() {
    let mut random = Random(1);
    let (mut settled_count, mut settled_by_leaving) = (0, 0);
    for _ in 0..300 {
        let mut log = vec![Event::Joined(0), Event::Joined(1)];
        let (mut settlement, mut last_settled) = (Settlement::new([0, 1].into_iter()), None);
        let (mut present, mut sent) = (vec![0, 1], 0);
        for _ in 0..60 {
            let peer = random.below(6) as u16;
            let (event, answer) = match random.below(8) {
                0 if !present.contains(&peer) => {
                    present.push(peer);
                    settlement.join(peer);
                    (Event::Joined(peer), None)
                }
                1 if present.contains(&peer) => {
                    present.retain(|each| *each != peer);
                    (Event::Left(peer), settlement.leave(peer))
                }
                2 | 3 => {
                    sent += 1 + random.below(2) as u32;
                    assert!(settlement.send(sent) && !settlement.send(sent));
                    (Event::Sent(sent), None)
                }
                _ if present.contains(&peer) => {
                    // Some of them were never sent.
                    let sequence = random.below(u64::from(sent) + 2) as u32;
                    (Event::Acknowledged(peer, sequence), settlement.acknowledge(peer, sequence))
                }
                _ => continue,
            };
            log.push(event);
            let expected = settled_by_definition(&log)
                .filter(|least| last_settled.is_none_or(|last_settled| *least > last_settled));
            assert_eq!(answer, expected);
            if answer.is_some() {
                last_settled = answer;
                settled_count += 1;
                settled_by_leaving += usize::from(matches!(event, Event::Left(_)));
            }
        }
    }
    assert!(settled_count > 300 && settled_by_leaving > 20, "{settled_count} {settled_by_leaving}");
}

#[test]
fn absent_users_settle_nothing() {
    let mut settlement = Settlement::new([5].into_iter());
    assert!(settlement.send(3));
    assert_eq!(settlement.acknowledge(6, 3), None);
    assert_eq!(settlement.acknowledge(5, 4), None, "it was not sent");
    assert_eq!(settlement.acknowledge(5, 3), Some(3));
    settlement.join(6);
    assert_eq!(settlement.leave(5), None, "the remaining user has acknowledged nothing");
    assert_eq!(settlement.leave(6), None);
}
