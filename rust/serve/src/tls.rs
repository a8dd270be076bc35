//! Certificates: read from files, generated for this machine, and reloaded when their files change.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::SystemTime;

use parking_lot::RwLock;
use rcgen::{Certificate, CertificateParams, DnType, KeyPair};
use rustls::crypto::ring;
use rustls::pki_types::pem::{self, PemObject};
use rustls::pki_types::{CertificateDer, PrivateKeyDer};
use rustls::server::{ClientHello, ResolvesServerCert};
use rustls::sign::CertifiedKey;
use rustls::{ServerConfig, SupportedProtocolVersion, version};
use sha2::{Digest, Sha256};
use time::{Duration, OffsetDateTime};
use x509_parser::prelude::{FromDer, GeneralName, X509Certificate};

/// Validity of a generated certificate in days: browsers distrust certificates that are valid for more than 398 days.
const VALID_DAYS: i64 = 397;

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
        let mismatch =
            |path: &Path, what: &str, got: &str| format!("{}: expected {what} in PEM, got {got}", path.display());
        let read_error = |path: &Path, what: &str, error: pem::Error| match error {
            pem::Error::Io(error) => format!("{}: expected {what} in PEM: {error}", path.display()),
            error => mismatch(path, what, &error.to_string()),
        };
        let chain = CertificateDer::pem_file_iter(certificate).and_then(Iterator::collect::<Result<Vec<_>, _>>);
        let chain = chain.map_err(|error| read_error(certificate, "a certificate", error))?;
        let secret = PrivateKeyDer::from_pem_file(key).map_err(|error| read_error(key, "a key", error))?;
        let first = chain.first().ok_or_else(|| mismatch(certificate, "a certificate", "none"))?.clone();
        let (_, parsed) = X509Certificate::from_der(&first)
            .map_err(|error| mismatch(certificate, "a certificate", &error.to_string()))?;
        let (begins, ends) = (parsed.validity().not_before.timestamp(), parsed.validity().not_after.timestamp());
        if !(begins..=ends).contains(&OffsetDateTime::now_utc().unix_timestamp()) {
            let [begin_date, end_date] = [begins, ends].map(|seconds| {
                OffsetDateTime::from_unix_timestamp(seconds).map_or("?".into(), |time| time.date().to_string())
            });
            return Err(format!(
                "{}: expected a certificate that is valid today, got one from {begin_date} to {end_date}",
                certificate.display()
            ));
        }
        let (names, is_self_signed) = (certificate_names(&parsed), parsed.issuer() == parsed.subject());
        let digits: Vec<_> = Sha256::digest(&first).iter().map(|byte| format!("{byte:02X}")).collect();
        let certified = CertifiedKey::from_der(chain, secret, &ring::default_provider())
            .map_err(|error| format!("{}: expected the key of {}: {error}", key.display(), certificate.display()))?;
        Ok(Identity { key: Arc::new(certified), fingerprint: digits.join(":"), ends, names, is_self_signed })
    }
}

/// Host names and addresses in a certificate.
fn certificate_names(certificate: &X509Certificate<'_>) -> Vec<String> {
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

/// Generates a self-signed certificate for host names and addresses, and its key, both in PEM.
pub fn self_signed(names: Vec<String>) -> Result<(String, String), String> {
    let (certificate, key) = generate(names, OffsetDateTime::now_utc(), VALID_DAYS)
        .map_err(|error| format!("names: expected names of hosts or addresses: {error}"))?;
    Ok((certificate.pem(), key.serialize_pem()))
}

/// Generates a self-signed certificate with a validity in days, which starts one day in the past.
pub(crate) fn generate(
    names: Vec<String>,
    now: OffsetDateTime,
    days: i64,
) -> Result<(Certificate, KeyPair), rcgen::Error> {
    let mut parameters = CertificateParams::new(names)?;
    // Clocks of other machines may be slow.
    (parameters.not_before, parameters.not_after) = (now - Duration::DAY, now + Duration::days(days - 1));
    parameters.distinguished_name.push(DnType::CommonName, "nearfar");
    // The default, P-256, is what browsers require of pinned certificates.
    let key = KeyPair::generate()?;
    Ok((parameters.self_signed(&key)?, key))
}

/// TLS settings of a server for protocols with these ALPN names.
pub(crate) fn server_config(
    resolver: Arc<dyn ResolvesServerCert>,
    versions: &[&'static SupportedProtocolVersion],
    protocols: &[&[u8]],
) -> Result<ServerConfig, rustls::Error> {
    let builder = ServerConfig::builder_with_provider(Arc::new(ring::default_provider()));
    let builder = builder.with_protocol_versions(versions)?.with_no_client_auth();
    let mut config = builder.with_cert_resolver(resolver);
    config.alpn_protocols = protocols.iter().map(|name| name.to_vec()).collect();
    Ok(config)
}

/// The server's certificate, which is reloaded when its files change.
#[derive(Debug)]
pub struct CurrentCertificate {
    certificate: PathBuf,
    key: PathBuf,
    loaded: RwLock<(Arc<Identity>, Option<SystemTime>)>,
}

impl CurrentCertificate {
    /// Reads a certificate and its key.
    pub fn read(certificate: PathBuf, key: PathBuf) -> Result<Arc<Self>, String> {
        let modified = modification_time(&certificate, &key);
        let identity = Arc::new(Identity::read(&certificate, &key)?);
        Ok(Arc::new(CurrentCertificate { certificate, key, loaded: RwLock::new((identity, modified)) }))
    }

    /// The current certificate.
    pub fn identity(&self) -> Arc<Identity> {
        Arc::clone(&self.loaded.read().0)
    }

    /// Reloads the files if they have changed; on errors the current certificate stays in use.
    pub fn refresh(&self) -> Result<(), String> {
        let modified = modification_time(&self.certificate, &self.key);
        if self.loaded.read().1 != modified {
            let identity = Arc::new(Identity::read(&self.certificate, &self.key)?);
            *self.loaded.write() = (identity, modified);
        }
        Ok(())
    }

    /// TLS settings of connections.
    pub fn config(self: &Arc<Self>) -> Result<Arc<ServerConfig>, String> {
        let versions = [&version::TLS13, &version::TLS12];
        let config = server_config(Arc::clone(self) as _, &versions, &[b"h2", b"http/1.1"]);
        config.map(Arc::new).map_err(|error| error.to_string())
    }
}

impl ResolvesServerCert for CurrentCertificate {
    fn resolve(&self, _: ClientHello<'_>) -> Option<Arc<CertifiedKey>> {
        Some(Arc::clone(&self.identity().key))
    }
}

/// Later modification time of the two files.
fn modification_time(certificate: &Path, key: &Path) -> Option<SystemTime> {
    let [certificate, key] = [certificate, key].map(|path| path.metadata().and_then(|found| found.modified()).ok());
    certificate.max(key)
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// Writes a certificate and its key, both in PEM, to `NAME.pem` and `NAME.key`.
    pub fn write_pem(folder: &Path, name: &str, certificate: &str, key: &str) -> (PathBuf, PathBuf) {
        let paths = (folder.join(format!("{name}.pem")), folder.join(format!("{name}.key")));
        std::fs::write(&paths.0, certificate).expect("written");
        std::fs::write(&paths.1, key).expect("written");
        paths
    }

    fn files(folder: &Path, name: &str) -> (PathBuf, PathBuf) {
        let names = ["localhost", "192.168.1.7", "::1"].map(str::to_owned);
        let (certificate, key) = self_signed(names.into()).expect("made");
        write_pem(folder, name, &certificate, &key)
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
        let ((certificate, key), (_, other_key)) = (files(folder.path(), "one"), files(folder.path(), "two"));
        let reason = Identity::read(&certificate, &other_key).expect_err("the key of another");
        assert!(reason.contains("two.key: expected the key of"), "{reason}");
        let reason = Identity::read(&key, &key).expect_err("no certificate");
        assert!(reason.contains("one.key: expected a certificate in PEM"), "{reason}");
        let reason = Identity::read(&certificate, &folder.path().join("none")).expect_err("no file");
        assert!(reason.contains("none: expected a key in PEM: No such file"), "{reason}");
        let (expired, pair) = generate(Vec::new(), rcgen::date_time_ymd(2020, 1, 2), 1).expect("made");
        write_pem(folder.path(), "one", &expired.pem(), &pair.serialize_pem());
        let reason = Identity::read(&certificate, &key).expect_err("it has ended");
        assert!(reason.ends_with("valid today, got one from 2020-01-01 to 2020-01-02"), "{reason}");
    }

    #[test]
    fn a_changed_certificate_is_reloaded_only_if_it_is_valid() {
        let folder = tempfile::tempdir().expect("a folder");
        let ((certificate, key), new) = (files(folder.path(), "one"), files(folder.path(), "two"));
        let current = CurrentCertificate::read(certificate.clone(), key.clone()).expect("it is valid");
        let first = current.identity().fingerprint.clone();
        let touch = |seconds| {
            let time = SystemTime::now() + std::time::Duration::from_secs(seconds);
            let file = std::fs::File::options().append(true).open(&certificate);
            file.and_then(|file| file.set_modified(time)).expect("touched");
        };
        std::fs::write(&certificate, "half a certif").expect("written");
        touch(10);
        assert!(current.refresh().is_err());
        assert_eq!(current.identity().fingerprint, first);
        std::fs::copy(&new.0, &certificate).expect("copied");
        std::fs::copy(&new.1, &key).expect("copied");
        touch(20);
        current.refresh().expect("it is valid");
        assert_ne!(current.identity().fingerprint, first);
    }
}
