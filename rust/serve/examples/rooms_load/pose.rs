//! Test pose of the users.

use std::time::Instant;

use nearfar_serve::rooms::pose::{Begin, Placed, Pose};

/// Pose with a head, two hands and a pointer.
pub fn pose(sequence: u32, epoch: Instant) -> Pose {
    let head = Placed { position: [0.0, 1.7, 0.0], rotation: [0, 0, 0, 32767] };
    Pose {
        sequence,
        clock: epoch.elapsed().as_micros() as u64,
        is_acknowledged: true,
        stops: false,
        head,
        hands: [Some(head); 2],
        pointer: Some((Begin::Right, 20.0)),
    }
}
