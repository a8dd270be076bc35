//! Certificates: read from files, generated for this machine, and reloaded when their files change.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::{Arc, PoisonError, RwLock};
use std::time::SystemTime;

use rcgen::{CertificateParams, DnType, KeyPair};
use rustls::crypto::ring;
use rustls::pki_types::pem::{self, PemObject};
use rustls::pki_types::{CertificateDer, PrivateKeyDer};
use rustls::server::{ClientHello, ResolvesServerCert};
use rustls::sign::CertifiedKey;
use rustls::{ServerConfig, version};
use sha2::{Digest, Sha256};
use time::{Duration, OffsetDateTime};
use x509_parser::prelude::{FromDer, GeneralName, X509Certificate};

/// Validity of a generated certificate in days: browsers distrust longer ones than thirteen months.
const DAYS: i64 = 397;

/// A valid certificate with its key.
#[derive(Debug)]
pub struct Identity {
    key: Arc<CertifiedKey>,
    /// SHA-256 of the certificate, formatted as in browsers.
    pub fingerprint: String,
    /// Expiry time in seconds since 1970.
    pub ends: i64,
    /// Host names and addresses in the certificate.
    pub names: Vec<String>,
    /// Whether it is self-signed.
    pub is_self_signed: bool,
}

impl Identity {
    /// Reads a certificate chain and its key, both in PEM.
    pub fn read(certificate: &Path, key: &Path) -> Result<Self, String> {
        let of = |path: &Path, what: &str, got: &str| format!("{}: expected {what} in PEM, got {got}", path.display());
        let unread = |path: &Path, what: &str, error: pem::Error| match error {
            pem::Error::Io(error) => format!("{}: expected {what} in PEM: {error}", path.display()),
            other => of(path, what, &other.to_string()),
        };
        let chain = CertificateDer::pem_file_iter(certificate).and_then(Iterator::collect::<Result<Vec<_>, _>>);
        let chain = chain.map_err(|error| unread(certificate, "a certificate", error))?;
        let secret = PrivateKeyDer::from_pem_file(key).map_err(|error| unread(key, "a key", error))?;
        let first = chain.first().ok_or_else(|| of(certificate, "a certificate", "none"))?.clone();
        let wrong = |error: &dyn std::fmt::Display| of(certificate, "a certificate", &error.to_string());
        let (_, parsed) = X509Certificate::from_der(&first).map_err(|error| wrong(&error))?;
        let (begins, ends) = (parsed.validity().not_before.timestamp(), parsed.validity().not_after.timestamp());
        let now = OffsetDateTime::now_utc().unix_timestamp();
        if !(begins..=ends).contains(&now) {
            let told = |at: i64| OffsetDateTime::from_unix_timestamp(at).map_or("?".into(), |at| at.date().to_string());
            return Err(format!(
                "{}: expected a certificate that is valid today, got one from {} to {}",
                certificate.display(),
                told(begins),
                told(ends)
            ));
        }
        let (names, is_self_signed) = (names_of(&parsed), parsed.issuer() == parsed.subject());
        let fingerprint = fingerprint(&first);
        let key_of = CertifiedKey::from_der(chain, secret, &ring::default_provider())
            .map_err(|error| format!("{}: expected the key of {}: {error}", key.display(), certificate.display()))?;
        Ok(Identity { key: Arc::new(key_of), fingerprint, ends, names, is_self_signed })
    }
}

/// Host names and addresses in a certificate.
fn names_of(certificate: &X509Certificate<'_>) -> Vec<String> {
    let Ok(Some(listed)) = certificate.subject_alternative_name() else { return Vec::new() };
    let named = listed.value.general_names.iter().filter_map(|name| match name {
        GeneralName::DNSName(name) => Some((*name).to_owned()),
        GeneralName::IPAddress(octets) => match octets.len() {
            4 => Some(std::net::IpAddr::from(<[u8; 4]>::try_from(*octets).ok()?).to_string()),
            _ => Some(std::net::IpAddr::from(<[u8; 16]>::try_from(*octets).ok()?).to_string()),
        },
        _ => None,
    });
    named.collect()
}

fn fingerprint(der: &[u8]) -> String {
    let mut text = String::new();
    for (index, byte) in Sha256::digest(der).iter().enumerate() {
        let _ = write!(text, "{}{byte:02X}", if index == 0 { "" } else { ":" });
    }
    text
}

/// Generates a self-signed certificate for host names and addresses, and its key, both in PEM.
pub fn self_signed(names: Vec<String>) -> Result<(String, String), String> {
    let wrong = |error: rcgen::Error| format!("names: expected names of hosts or addresses: {error}");
    let mut asked = CertificateParams::new(names).map_err(wrong)?;
    let now = OffsetDateTime::now_utc();
    // Clocks of other machines may be slow.
    asked.not_before = now - Duration::DAY;
    asked.not_after = now + Duration::days(DAYS - 1);
    asked.distinguished_name.push(DnType::CommonName, "nearfar");
    let key = KeyPair::generate().map_err(wrong)?;
    let signed = asked.self_signed(&key).map_err(wrong)?;
    Ok((signed.pem(), key.serialize_pem()))
}

/// The server's current certificate, reloaded when its files change.
#[derive(Debug)]
pub struct Current {
    certificate: PathBuf,
    key: PathBuf,
    read: RwLock<(Arc<Identity>, Option<SystemTime>)>,
}

impl Current {
    /// Reads a certificate and its key.
    pub fn read(certificate: PathBuf, key: PathBuf) -> Result<Arc<Self>, String> {
        let changed = changed(&certificate, &key);
        let identity = Arc::new(Identity::read(&certificate, &key)?);
        Ok(Arc::new(Current { certificate, key, read: RwLock::new((identity, changed)) }))
    }

    /// Current certificate.
    pub fn identity(&self) -> Arc<Identity> {
        Arc::clone(&self.read.read().unwrap_or_else(PoisonError::into_inner).0)
    }

    /// Reloads the files if they have changed; on errors the current certificate stays in use.
    pub fn refresh(&self) -> Result<(), String> {
        let found = changed(&self.certificate, &self.key);
        if self.read.read().unwrap_or_else(PoisonError::into_inner).1 == found {
            return Ok(());
        }
        let identity = Arc::new(Identity::read(&self.certificate, &self.key)?);
        *self.read.write().unwrap_or_else(PoisonError::into_inner) = (identity, found);
        Ok(())
    }

    /// TLS settings of connections.
    pub fn config(self: &Arc<Self>) -> Result<Arc<ServerConfig>, String> {
        let builder = ServerConfig::builder_with_provider(Arc::new(ring::default_provider()));
        let builder = builder.with_protocol_versions(&[&version::TLS13, &version::TLS12]);
        let builder = builder.map_err(|error| error.to_string())?.with_no_client_auth();
        let mut config = builder.with_cert_resolver(Arc::clone(self) as Arc<dyn ResolvesServerCert>);
        config.alpn_protocols = vec![b"h2".to_vec(), b"http/1.1".to_vec()];
        Ok(Arc::new(config))
    }
}

impl ResolvesServerCert for Current {
    fn resolve(&self, _: ClientHello<'_>) -> Option<Arc<CertifiedKey>> {
        Some(Arc::clone(&self.identity().key))
    }
}

/// Later modification time of the two files.
fn changed(certificate: &Path, key: &Path) -> Option<SystemTime> {
    let at = |path: &Path| std::fs::metadata(path).and_then(|found| found.modified()).ok();
    at(certificate).max(at(key))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn files(folder: &Path, name: &str) -> (PathBuf, PathBuf) {
        let (certificate, key) =
            self_signed(vec!["localhost".into(), "192.168.1.7".into(), "::1".into()]).expect("made");
        let paths = (folder.join(format!("{name}.pem")), folder.join(format!("{name}.key")));
        std::fs::write(&paths.0, certificate).expect("written");
        std::fs::write(&paths.1, key).expect("written");
        paths
    }

    #[test]
    fn a_generated_certificate_is_read() {
        let folder = tempfile::tempdir().expect("a folder");
        let (certificate, key) = files(folder.path(), "one");
        let identity = Identity::read(&certificate, &key).expect("it is valid");
        assert_eq!(identity.names, ["localhost", "192.168.1.7", "::1"]);
        assert_eq!(identity.fingerprint.len(), 32 * 3 - 1);
        let days = (identity.ends - OffsetDateTime::now_utc().unix_timestamp()) / 86_400;
        assert!((390..397).contains(&days), "{days}");
    }

    #[test]
    fn defects_of_certificates_are_named() {
        let folder = tempfile::tempdir().expect("a folder");
        let ((certificate, key), (_, other)) = (files(folder.path(), "one"), files(folder.path(), "two"));
        let reason = Identity::read(&certificate, &other).expect_err("the key of another");
        assert!(reason.contains("two.key: expected the key of"), "{reason}");
        let reason = Identity::read(&key, &key).expect_err("no certificate");
        assert!(reason.contains("one.key: expected a certificate in PEM"), "{reason}");
        let reason = Identity::read(&certificate, &folder.path().join("none")).expect_err("no file");
        assert!(reason.contains("none: expected a key in PEM: No such file"), "{reason}");
        let old = rcgen::date_time_ymd(2020, 1, 1);
        let mut asked = CertificateParams::new(vec!["localhost".into()]).expect("a name");
        (asked.not_before, asked.not_after) = (old, old + Duration::DAY);
        let pair = KeyPair::generate().expect("a key");
        let signed = asked.self_signed(&pair).expect("signed");
        std::fs::write(&certificate, signed.pem()).expect("written");
        std::fs::write(&key, pair.serialize_pem()).expect("written");
        let reason = Identity::read(&certificate, &key).expect_err("it has ended");
        assert!(reason.ends_with("valid today, got one from 2020-01-01 to 2020-01-02"), "{reason}");
    }

    #[test]
    fn a_new_certificate_is_taken_and_a_wrong_one_is_not() {
        let folder = tempfile::tempdir().expect("a folder");
        let ((certificate, key), new) = (files(folder.path(), "one"), files(folder.path(), "two"));
        let current = Current::read(certificate.clone(), key.clone()).expect("it is valid");
        let first = current.identity().fingerprint.clone();
        let at = |seconds| SystemTime::now() + std::time::Duration::from_secs(seconds);
        let touch = |path: &Path, time| {
            std::fs::File::options().append(true).open(path).and_then(|file| file.set_modified(time)).expect("touched");
        };
        std::fs::write(&certificate, "half a certif").expect("written");
        touch(&certificate, at(10));
        assert!(current.refresh().is_err());
        assert_eq!(current.identity().fingerprint, first);
        std::fs::copy(&new.0, &certificate).expect("copied");
        std::fs::copy(&new.1, &key).expect("copied");
        touch(&certificate, at(20));
        current.refresh().expect("it is valid");
        assert_ne!(current.identity().fingerprint, first);
    }
}
