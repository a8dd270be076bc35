//! QUIC connections with valid and invalid session requests, and a certificate signed by an authority.

use std::net::{Ipv4Addr, SocketAddr};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use quinn::crypto::rustls::QuicClientConfig;
use quinn::{ClientConfig, Connection, ConnectionError, Endpoint, RecvStream, SendStream};
use rcgen::{BasicConstraints, CertificateParams, IsCa, Issuer, KeyPair};
use rustls::RootCertStore;
use rustls::pki_types::CertificateDer;
use tokio::time::timeout;

use crate::clients::MAX_PENDING;
use crate::rooms::Limits;
use crate::rooms::tests::support::{HOURS, Random, TEST_TIMEOUT, limits, server_content, start_within};
use crate::webtransport::{session, trial, wire};
use crate::{Server, tls};

/// A server with a signed certificate, and a client that trusts its authority.
struct Bench {
    server: Server,
    endpoint: Endpoint,
}

impl Bench {
    fn new(limits: Limits, server_limits: crate::Limits) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let (paths, authority) = write_signed_certificate(folder.path());
        let server = start_within(server_content(limits, None), Some(paths), server_limits);
        let mut trusted = RootCertStore::empty();
        trusted.add(authority).expect("an authority");
        let provider = Arc::new(rustls::crypto::ring::default_provider());
        let tls = rustls::ClientConfig::builder_with_provider(provider).with_safe_default_protocol_versions();
        let mut tls = tls.expect("versions").with_root_certificates(trusted).with_no_client_auth();
        tls.alpn_protocols = vec![b"h3".to_vec()];
        let config = ClientConfig::new(Arc::new(QuicClientConfig::try_from(tls).expect("TLS 1.3")));
        let mut endpoint = Endpoint::client(SocketAddr::from((Ipv4Addr::LOCALHOST, 0))).expect("a socket");
        endpoint.set_default_client_config(config);
        Bench { server, endpoint }
    }

    async fn connect(&self) -> Result<Connection, ConnectionError> {
        let port = self.server.datagrams().expect("datagrams").port;
        let connecting = self.endpoint.connect((Ipv4Addr::LOCALHOST, port).into(), "localhost");
        timeout(TEST_TIMEOUT, connecting.expect("an address")).await.expect("an answer")
    }

    /// Sends bytes on the first stream of a new connection.
    async fn send(&self, bytes: &[u8]) -> (Connection, SendStream, RecvStream) {
        let connection = self.connect().await.expect("a connection");
        let (mut send, receive) = connection.open_bi().await.expect("a stream");
        let _ = send.write_all(bytes).await;
        (connection, send, receive)
    }

    /// Status of the response to a request.
    async fn status(&self, path: &str, origin: &str) -> (String, Connection, SendStream) {
        let (connection, send, mut receive) = self.send(&request(path, origin)).await;
        let mut answer = [0; 10];
        timeout(TEST_TIMEOUT, receive.read_exact(&mut answer)).await.expect("in time").expect("an answer");
        assert_eq!(answer[..7], [1, 8, 0, 0, 0x5f, 9, 3]);
        (String::from_utf8_lossy(&answer[7..]).into(), connection, send)
    }
}

/// Writes a signed certificate and its key; returns their paths, and the authority.
fn write_signed_certificate(folder: &Path) -> ((PathBuf, PathBuf), CertificateDer<'static>) {
    let pair = || KeyPair::generate().expect("a key");
    let mut authority_parameters = CertificateParams::new(Vec::new()).expect("no names");
    authority_parameters.is_ca = IsCa::Ca(BasicConstraints::Unconstrained);
    let key = pair();
    let authority = authority_parameters.self_signed(&key).expect("signed");
    let own_key = pair();
    let mut parameters = CertificateParams::new(vec!["localhost".to_owned()]).expect("a name");
    parameters.distinguished_name.push(rcgen::DnType::CommonName, "localhost");
    let signed = parameters.signed_by(&own_key, &Issuer::new(authority_parameters, key)).expect("signed");
    (tls::tests::write_pem(folder, "signed", &signed.pem(), &own_key.serialize_pem()), authority.der().clone())
}

/// A request for a session.
fn request(path: &str, origin: &str) -> Vec<u8> {
    let mut body = wire::tests::session_fields(path);
    if !origin.is_empty() {
        body.extend_from_slice(&[0x5f, 90 - 15, origin.len() as u8]);
        body.extend_from_slice(origin.as_bytes());
    }
    let mut bytes = Vec::new();
    wire::put_frame(&mut bytes, wire::frame::HEADERS, &body);
    bytes
}

#[tokio::test]
async fn requests_are_answered_with_their_codes() {
    let bench = Bench::new(limits(), crate::Limits { connections: 8, ..crate::Limits::default() });
    assert_eq!(bench.server.datagrams().map(|datagrams| datagrams.hashes.len()), Some(0), "pages trust the authority");
    let mut open_connections = Vec::new();
    for (path, origin, expected) in [
        ("/rooms/hall", "", "200"),
        ("/rooms/hall", "https://evil.example", "403"),
        ("/rooms/a/b", "", "404"),
        ("/elsewhere", "", "404"),
        // Fills the remaining connection slots of rooms.
        ("/rooms/1", "", "200"),
        ("/rooms/2", "", "200"),
        ("/rooms/3", "", "200"),
        ("/rooms/4", "", "200"),
        ("/rooms/5", "", "200"),
        ("/rooms/6", "", "503"),
    ] {
        let (status, connection, send) = bench.status(path, origin).await;
        assert_eq!(status, expected, "{path} {origin}");
        if status == "200" {
            open_connections.push((connection, send));
        } else {
            timeout(TEST_TIMEOUT, connection.closed()).await.expect("it is closed");
        }
    }
}

#[tokio::test]
async fn connections_without_a_session_request_are_closed() {
    let bench = Bench::new(limits(), crate::Limits::default());
    let mut random = Random(11);
    let mut cases = vec![
        vec![0, 1, 0],
        vec![4, 0],
        vec![1, 0x50, 0x00],
        vec![0x40, 0x41, 0],
        [&[0x21, 2, 9, 9][..], &request("no path", "")].concat(),
        request("/rooms/hall", "\n"),
    ];
    for _ in 0..40 {
        let mut changed = request("/rooms/hall", "https://localhost");
        // The first four bytes, with type and length, stay.
        random.change(3, &mut changed[4..]);
        cases.push(changed);
    }
    for (number, case) in cases.into_iter().enumerate() {
        let (connection, mut send, mut receive) = bench.send(&case).await;
        let _ = send.finish();
        let mut answer = [0; 3];
        let answered = timeout(TEST_TIMEOUT, receive.read_exact(&mut answer)).await.expect("an end");
        assert!(answered.is_err() || number >= 6, "{case:?}");
        connection.close(0u32.into(), b"");
    }
    assert_eq!(bench.status("/rooms/hall", "").await.0, "200");
}

#[tokio::test]
async fn few_frames_come_before_a_head() {
    for (count, is_read) in [(0, true), (16, true), (17, false)] {
        let bytes = [[0x21, 0].repeat(count), request("/rooms/hall", "")].concat();
        assert_eq!(session::read_request(&mut &bytes[..]).await.is_ok(), is_read, "{count}");
    }
}

#[test]
fn any_bytes_on_the_first_stream_are_a_request_or_refused() {
    let mut random = Random(5);
    for _ in 0..20_000 {
        let mut bytes = request("/rooms/hall", "https://localhost");
        random.change(4, &mut bytes);
        trial::run(&bytes);
    }
}

#[tokio::test]
async fn idle_connections_are_limited_and_closed() {
    let bench = Bench::new(Limits { hello: HOURS, ..limits() }, crate::Limits::default());
    let mut idle = Vec::new();
    for _ in 0..MAX_PENDING {
        idle.push(bench.connect().await.expect("a free slot"));
    }
    assert!(bench.connect().await.is_err(), "all slots are taken");
    idle.pop().expect("one").close(0u32.into(), b"");
    while bench.connect().await.is_err() {}
    let short = Bench::new(Limits { hello: Duration::from_secs(2), ..limits() }, crate::Limits::default());
    // On a busy machine the timeout may expire before the handshake ends or the stream opens.
    let connection = loop {
        if let Ok(connection) = short.connect().await {
            break connection;
        }
    };
    // A stream whose type never arrives.
    if let Ok(mut open) = connection.open_uni().await {
        let _ = open.write_all(&[0x40]).await;
    }
    timeout(TEST_TIMEOUT, connection.closed()).await.expect("it is closed");
}
