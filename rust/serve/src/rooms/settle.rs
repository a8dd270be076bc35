//! Tracks which of a user's poses are settled: acknowledged by all others of its group. The time until then is the
//! round trip of user i in the paper's Eq. 3, D_i = T_is + max over j != i of (T_sj + T_js) + T_si, where T_ab is the
//! time from a to b, and s the server.

/// Acknowledgements of one user's poses.
#[derive(Default)]
pub struct Settlement {
    /// Greatest sequence number that the user has sent.
    sent: Option<u32>,
    /// Greatest sequence number that was reported to the user as settled.
    settled: Option<u32>,
    /// Other users of the group, with the greatest number that each has acknowledged.
    peers: Vec<(u16, Option<u32>)>,
}

impl Settlement {
    pub fn new(peers: impl Iterator<Item = u16>) -> Self {
        Settlement { sent: None, settled: None, peers: peers.map(|peer| (peer, None)).collect() }
    }

    /// Records a sent pose. False if it is not newer than all earlier ones.
    pub fn send(&mut self, sequence: u32) -> bool {
        let is_newer = Some(sequence) > self.sent;
        self.sent = self.sent.max(Some(sequence));
        is_newer
    }

    /// Adds a user to the group, without acknowledgements.
    pub fn join(&mut self, peer: u16) {
        self.peers.push((peer, None));
    }

    /// Removes a user from the group; returns the sequence number that this settles, if any.
    pub fn leave(&mut self, peer: u16) -> Option<u32> {
        self.peers.retain(|(number, _)| *number != peer);
        self.settle()
    }

    /// Records an acknowledgement; returns the sequence number that it settles, if any. Numbers that were never sent
    /// are ignored.
    pub fn acknowledge(&mut self, peer: u16, sequence: u32) -> Option<u32> {
        if Some(sequence) > self.sent {
            return None;
        }
        let (_, acknowledged) = self.peers.iter_mut().find(|(number, _)| *number == peer)?;
        *acknowledged = (*acknowledged).max(Some(sequence));
        self.settle()
    }

    /// Greatest number up to which all others have acknowledged, if it has grown.
    fn settle(&mut self) -> Option<u32> {
        // None is less than every number.
        let settled = self.peers.iter().map(|(_, sequence)| *sequence).min().flatten();
        if settled <= self.settled {
            return None;
        }
        self.settled = settled;
        settled
    }
}
