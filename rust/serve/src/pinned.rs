//! Self-signed certificate that pages pin by its hash. Browsers accept such certificates for at most 14 days, so it is
//! replaced before it expires.

use std::sync::{Arc, PoisonError, RwLock};

use rcgen::{CertificateParams, DnType, KeyPair};
use rustls::crypto::ring;
use rustls::pki_types::PrivateKeyDer;
use rustls::server::{ClientHello, ResolvesServerCert};
use rustls::sign::CertifiedKey;
use sha2::{Digest, Sha256};
use time::{Duration, OffsetDateTime};

/// Validity in days, starting one day in the past: other machines' clocks may be slow.
const DAYS: i64 = 13;
/// Days until the next certificate; a page's hash stays usable for at most this long.
const USED: i64 = 6;

/// Current certificate.
#[derive(Debug)]
pub struct Pinned(RwLock<Made>);

#[derive(Debug)]
struct Made {
    key: Arc<CertifiedKey>,
    hash: String,
    until: OffsetDateTime,
}

impl Pinned {
    /// Creates the first certificate.
    pub fn new(now: OffsetDateTime) -> Result<Self, String> {
        Ok(Pinned(RwLock::new(make(now)?)))
    }

    /// SHA-256 of the certificate in hexadecimal digits.
    pub fn hash(&self) -> String {
        self.0.read().unwrap_or_else(PoisonError::into_inner).hash.clone()
    }

    /// Replaces the certificate if it is due.
    pub fn refresh(&self, now: OffsetDateTime) -> Result<(), String> {
        let until = self.0.read().unwrap_or_else(PoisonError::into_inner).until;
        // If the clock is set back by more than a day, the certificate would not be valid yet.
        if (until - Duration::days(USED + 1)..until).contains(&now) {
            return Ok(());
        }
        let next = make(now)?;
        *self.0.write().unwrap_or_else(PoisonError::into_inner) = next;
        Ok(())
    }
}

impl ResolvesServerCert for Pinned {
    fn resolve(&self, _: ClientHello<'_>) -> Option<Arc<CertifiedKey>> {
        Some(Arc::clone(&self.0.read().unwrap_or_else(PoisonError::into_inner).key))
    }
}

fn make(now: OffsetDateTime) -> Result<Made, String> {
    let wrong = |error: rcgen::Error| format!("a certificate for datagrams cannot be made: {error}");
    // Browsers compare only the hash, not the name.
    let mut asked = CertificateParams::new(vec!["localhost".to_owned()]).map_err(wrong)?;
    (asked.not_before, asked.not_after) = (now - Duration::DAY, now + Duration::days(DAYS - 1));
    asked.distinguished_name.push(DnType::CommonName, "nearfar");
    // P-256, which browsers require.
    let pair = KeyPair::generate().map_err(wrong)?;
    let signed = asked.self_signed(&pair).map_err(wrong)?;
    let hash = Sha256::digest(signed.der()).iter().map(|byte| format!("{byte:02x}")).collect();
    let secret = PrivateKeyDer::try_from(pair.serialize_der()).map_err(str::to_owned)?;
    let key = CertifiedKey::from_der(vec![signed.der().clone()], secret, &ring::default_provider())
        .map_err(|error| error.to_string())?;
    Ok(Made { key: Arc::new(key), hash, until: now + Duration::days(USED) })
}

#[cfg(test)]
mod tests {
    use x509_parser::prelude::{FromDer, X509Certificate};

    use super::*;

    #[test]
    fn the_next_one_is_made_long_before_the_end() {
        let now = OffsetDateTime::now_utc();
        let pinned = Pinned::new(now).expect("made");
        let read = |at: &Made| {
            let der = at.key.cert[0].clone();
            let (_, parsed) = X509Certificate::from_der(&der).expect("a certificate");
            (parsed.validity().not_before.timestamp(), parsed.validity().not_after.timestamp())
        };
        let first = pinned.hash();
        assert_eq!(first.len(), 64);
        for after in [Duration::ZERO, Duration::days(USED) - Duration::SECOND] {
            pinned.refresh(now + after).expect("made");
            assert_eq!(pinned.hash(), first);
            let (begins, ends) = read(&pinned.0.read().expect("no panic"));
            assert!((begins..ends).contains(&(now + after).unix_timestamp()) && ends - begins <= 14 * 86_400);
        }
        for at in [now + Duration::days(USED), now + Duration::days(40), now - Duration::DAY] {
            let before = pinned.hash();
            pinned.refresh(at).expect("made");
            assert_ne!(pinned.hash(), before);
            let (begins, ends) = read(&pinned.0.read().expect("no panic"));
            assert!((begins..ends).contains(&at.unix_timestamp()));
        }
    }
}
