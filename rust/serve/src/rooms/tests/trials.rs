//! Users who do anything in any order, and settled poses compared with a model that evaluates the whole history.

use super::support::Numbers;
use crate::rooms::settle::Settling;
use crate::rooms::trial;

#[test]
fn users_see_only_what_they_may_after_any_actions() {
    let mut numbers = Numbers(7);
    for _ in 0..2_000 {
        let length = numbers.below(400);
        trial::run(&(0..length).map(|_| numbers.below(256) as u8).collect::<Vec<_>>());
    }
}

#[test]
fn the_last_pose_of_a_movement_arrives_and_settles_whatever_datagrams_are_lost() {
    /// Kinds of steps: pose, acknowledgement, receiving, and switching the loss of datagrams.
    const STEPS: [u8; 4] = [4, 11, 31, 23];
    let step = |kind: u8, user: u8| 8 * kind + user;
    let mut numbers = Numbers(9);
    for round in (0..4).cycle().take(500) {
        // Two or more users, up to a full room, connect and say hello in one group.
        let users = 2 + round;
        let mut script: Vec<u8> =
            (0..users).flat_map(|user| [step(0, user), step(2, user), 0, 0, step(31, user)]).collect();
        for count in 0..200 {
            // In the second half no poses are sent.
            let kinds = if count < 100 { &STEPS[..] } else { &STEPS[1..] };
            let kind = kinds[numbers.below(kinds.len() as u64) as usize];
            script.push(step(kind, numbers.below(users.into()) as u8));
            match kind {
                // Increment of the number, and flags.
                4 => script.extend([1 + numbers.below(3) as u8, numbers.below(4) as u8]),
                11 => script.extend([numbers.below(users.into()) as u8, 0]),
                _ => {}
            }
        }
        trial::run(&script);
    }
}

#[derive(Clone, Copy)]
enum Happened {
    Sent(u32),
    Joined(u16),
    Left(u16),
    Acknowledged(u16, u32),
}

/// Least, over the present users, of the greatest number that each has acknowledged since it joined.
fn least(log: &[Happened]) -> Option<u32> {
    let is_there = |peer: u16| {
        let mut moves = log.iter().filter(|each| matches!(each, Happened::Joined(p) | Happened::Left(p) if *p == peer));
        matches!(moves.next_back(), Some(Happened::Joined(_)))
    };
    let greatest = |peer: u16| {
        let came = log.iter().rposition(|each| matches!(each, Happened::Joined(p) if *p == peer)).unwrap_or(0);
        let mut best = None;
        for (at, each) in log.iter().enumerate().skip(came) {
            let sent = log[..at].iter().filter_map(|each| if let Happened::Sent(s) = each { Some(*s) } else { None });
            match *each {
                Happened::Acknowledged(p, s) if p == peer && sent.max() >= Some(s) => best = best.max(Some(s)),
                _ => {}
            }
        }
        best
    };
    let present: Vec<u16> = (0..9).filter(|peer| is_there(*peer)).collect();
    present.into_iter().map(greatest).min().flatten()
}

#[test]
fn settled_poses_equal_the_model() {
    let mut numbers = Numbers(1);
    let (mut settled_count, mut settled_by_leaving) = (0, 0);
    for _ in 0..300 {
        let mut log = vec![Happened::Joined(0), Happened::Joined(1)];
        let (mut settling, mut last_settled) = (Settling::new([0, 1].into_iter()), None);
        let (mut present, mut sent) = (vec![0, 1], 0);
        for _ in 0..60 {
            let peer = numbers.below(6) as u16;
            let (happened, answer) = match numbers.below(8) {
                0 if !present.contains(&peer) => {
                    present.push(peer);
                    settling.join(peer);
                    (Happened::Joined(peer), None)
                }
                1 if present.contains(&peer) => {
                    present.retain(|each| *each != peer);
                    (Happened::Left(peer), settling.leave(peer))
                }
                2 | 3 => {
                    sent += 1 + numbers.below(2) as u32;
                    assert!(settling.send(sent) && !settling.send(sent));
                    (Happened::Sent(sent), None)
                }
                _ if present.contains(&peer) => {
                    // Some of them were never sent.
                    let sequence = numbers.below(u64::from(sent) + 2) as u32;
                    (Happened::Acknowledged(peer, sequence), settling.acknowledge(peer, sequence))
                }
                _ => continue,
            };
            log.push(happened);
            let expected = least(&log).filter(|least| last_settled.is_none_or(|last_settled| *least > last_settled));
            assert_eq!(answer, expected);
            if answer.is_some() {
                last_settled = answer;
                settled_count += 1;
                settled_by_leaving += usize::from(matches!(happened, Happened::Left(_)));
            }
        }
    }
    assert!(settled_count > 300 && settled_by_leaving > 20, "{settled_count} {settled_by_leaving}");
}

#[test]
fn absent_users_settle_nothing() {
    let mut settling = Settling::new([5].into_iter());
    assert!(settling.send(3));
    assert_eq!(settling.acknowledge(6, 3), None);
    assert_eq!(settling.acknowledge(5, 4), None, "it was not sent");
    assert_eq!(settling.acknowledge(5, 3), Some(3));
    settling.join(6);
    assert_eq!(settling.leave(5), None, "who is left has acknowledged nothing");
    assert_eq!(settling.leave(6), None);
}
