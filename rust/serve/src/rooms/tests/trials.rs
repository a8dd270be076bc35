//! Users who do anything in any order see nothing that users may not see.

use super::support::Numbers;
use crate::rooms::trial;

#[test]
fn whatever_users_do_each_sees_what_it_may() {
    let mut numbers = Numbers(7);
    for _ in 0..2_000 {
        let length = numbers.below(400);
        trial::run(&(0..length).map(|_| numbers.below(256) as u8).collect::<Vec<_>>());
    }
}
