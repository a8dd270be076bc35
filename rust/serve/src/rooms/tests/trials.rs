//! Users who do anything in any order receive only what they may.

use super::support::Numbers;
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
