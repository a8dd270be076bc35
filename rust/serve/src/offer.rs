//! Port for WebTransport connections, and the certificate that pages pin there.

use std::sync::Arc;

use time::OffsetDateTime;

use crate::pinned::Pinned;
use crate::rooms::Datagrams;

/// Offer of WebTransport sessions to pages.
pub struct Offer {
    /// UDP port.
    pub port: u16,
    /// Self-signed certificate that pages pin; none if an authority has signed the server's certificate.
    pub pinned: Option<Arc<Pinned>>,
}

impl Offer {
    /// Description of the offer for pages.
    pub fn description(&self) -> Datagrams {
        Datagrams { port: self.port, hashes: self.pinned.iter().map(|pinned| pinned.hash()).collect() }
    }

    /// Replaces the certificate if it is due.
    pub fn refresh(&self) -> Result<(), String> {
        self.pinned.as_ref().map_or(Ok(()), |pinned| pinned.refresh(OffsetDateTime::now_utc()))
    }
}
