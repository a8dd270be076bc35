//! Which poses of a user all others of its group have acknowledged: the round trip of the paper's Eq. 3,
//! D_i = T_is + max over j != i of (T_sj + T_js) + T_si, ends when the last of them has.

/// Acknowledgements of one user's poses.
#[derive(Default)]
pub struct Settling {
    /// Greatest number of a pose that the user sent.
    sent: Option<u32>,
    /// Greatest number that the user was told.
    told: Option<u32>,
    /// Others of the group, and the greatest number that each has acknowledged.
    peers: Vec<(u16, Option<u32>)>,
}

impl Settling {
    /// The user's group has these others.
    pub fn new(peers: impl Iterator<Item = u16>) -> Self {
        Settling { sent: None, told: None, peers: peers.map(|peer| (peer, None)).collect() }
    }

    /// The user has sent a pose. False if it is not newer than those before.
    pub fn send(&mut self, sequence: u32) -> bool {
        let is_newer = self.sent.is_none_or(|sent| sequence > sent);
        if is_newer {
            self.sent = Some(sequence);
        }
        is_newer
    }

    /// Another user has joined the group; it has acknowledged nothing.
    pub fn join(&mut self, peer: u16) {
        self.peers.push((peer, None));
    }

    /// Another user has left the group and does not count any more; the number that settles by it.
    pub fn leave(&mut self, peer: u16) -> Option<u32> {
        self.peers.retain(|(number, _)| *number != peer);
        self.settle()
    }

    /// Another user has acknowledged a pose; the number that settles by it. Numbers that were not sent do not count.
    pub fn acknowledge(&mut self, peer: u16, sequence: u32) -> Option<u32> {
        let sent = self.sent.filter(|sent| sequence <= *sent);
        let entry = self.peers.iter_mut().find(|(number, _)| *number == peer)?;
        sent?;
        entry.1 = entry.1.max(Some(sequence));
        self.settle()
    }

    /// The least number that the others have acknowledged, if it has risen.
    fn settle(&mut self) -> Option<u32> {
        // None is less than every number.
        let least = self.peers.iter().map(|(_, sequence)| *sequence).min().flatten();
        if least <= self.told {
            return None;
        }
        self.told = least;
        least
    }
}
