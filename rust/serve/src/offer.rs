//! Offer of WebTransport sessions to pages: a port, and the self-signed certificate that pages pin there by its hash.
//! Browsers accept such certificates for at most 14 days, so it is replaced before it expires.

use std::sync::Arc;

use data_encoding::HEXLOWER;
use parking_lot::RwLock;
use rustls::crypto::ring;
use rustls::server::{ClientHello, ResolvesServerCert};
use rustls::sign::CertifiedKey;
use sha2::{Digest, Sha256};
use time::{Duration, OffsetDateTime};

use crate::rooms::Datagrams;
use crate::tls;

/// Validity in days, starting one day in the past.
const VALID_DAYS: i64 = 13;
/// Days for which a certificate is used; pages must connect within this time after they have received its hash.
const USED_DAYS: i64 = 6;

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

/// Current self-signed certificate, which pages pin.
#[derive(Debug)]
pub struct Pinned(RwLock<Generated>);

#[derive(Debug)]
struct Generated {
    key: Arc<CertifiedKey>,
    hash: String,
    used_until: OffsetDateTime,
}

impl Pinned {
    /// Creates the first certificate.
    pub fn new(now: OffsetDateTime) -> Result<Self, String> {
        Ok(Pinned(RwLock::new(Generated::new(now)?)))
    }

    /// SHA-256 of the certificate in hexadecimal digits.
    fn hash(&self) -> String {
        self.0.read().hash.clone()
    }

    fn refresh(&self, now: OffsetDateTime) -> Result<(), String> {
        let used_until = self.0.read().used_until;
        // If the clock is set back by more than a day, the certificate would not be valid yet.
        if !(used_until - Duration::days(USED_DAYS + 1)..used_until).contains(&now) {
            let next = Generated::new(now)?;
            *self.0.write() = next;
        }
        Ok(())
    }
}

impl ResolvesServerCert for Pinned {
    fn resolve(&self, _: ClientHello<'_>) -> Option<Arc<CertifiedKey>> {
        Some(Arc::clone(&self.0.read().key))
    }
}

impl Generated {
    fn new(now: OffsetDateTime) -> Result<Self, String> {
        // Browsers compare only the hash, so any name will do.
        let (certificate, pair) = tls::generate(vec!["localhost".to_owned()], now, VALID_DAYS)
            .map_err(|error| format!("a certificate for datagrams cannot be made: {error}"))?;
        let hash = HEXLOWER.encode(&Sha256::digest(certificate.der()));
        let key = CertifiedKey::from_der(vec![certificate.der().clone()], pair.into(), &ring::default_provider())
            .map_err(|error| error.to_string())?;
        Ok(Generated { key: Arc::new(key), hash, used_until: now + Duration::days(USED_DAYS) })
    }
}

#[cfg(test)]
mod tests {
    use x509_parser::prelude::{FromDer, X509Certificate};

    use super::*;

    #[test]
    fn certificates_are_replaced_before_they_expire() {
        let now = OffsetDateTime::now_utc();
        let pinned = Pinned::new(now).expect("made");
        let validity = || {
            let der = pinned.0.read().key.cert[0].clone();
            let (_, parsed) = X509Certificate::from_der(&der).expect("a certificate");
            parsed.validity().not_before.timestamp()..parsed.validity().not_after.timestamp()
        };
        let first = pinned.hash();
        assert_eq!(first.len(), 64);
        for age in [Duration::ZERO, Duration::days(USED_DAYS) - Duration::SECOND] {
            pinned.refresh(now + age).expect("made");
            assert_eq!(pinned.hash(), first);
            let range = validity();
            assert!(range.contains(&(now + age).unix_timestamp()) && range.end - range.start <= 14 * 86_400);
        }
        for time in [now + Duration::days(USED_DAYS), now + Duration::days(40), now - Duration::DAY] {
            let previous = pinned.hash();
            pinned.refresh(time).expect("made");
            assert_ne!(pinned.hash(), previous);
            assert!(validity().contains(&time.unix_timestamp()));
        }
    }
}
