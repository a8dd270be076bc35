//! Where pages connect for datagrams, and the certificate by which they know the server there.

use std::sync::Arc;

use time::OffsetDateTime;

use crate::pinned::Pinned;
use crate::rooms::Datagrams;

/// Where sessions are taken, as pages are told.
pub struct Offer {
    /// Port of UDP.
    pub port: u16,
    /// The certificate that no authority has signed; none if one has signed the server's.
    pub pinned: Option<Arc<Pinned>>,
}

impl Offer {
    /// Description of the offer for pages.
    pub fn description(&self) -> Datagrams {
        Datagrams { port: self.port, hashes: self.pinned.iter().map(|pinned| pinned.hash()).collect() }
    }

    /// Make the next certificate if it is time.
    pub fn refresh(&self) -> Result<(), String> {
        self.pinned.as_ref().map_or(Ok(()), |pinned| pinned.refresh(OffsetDateTime::now_utc()))
    }
}
