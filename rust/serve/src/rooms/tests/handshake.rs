//! Handshake of a connection to a room.

use std::sync::Arc;
use std::time::{Duration, Instant};

use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;
use tokio_rustls::TlsConnector;
use tokio_rustls::rustls::pki_types::pem::PemObject;
use tokio_rustls::rustls::pki_types::{CertificateDer, ServerName};
use tokio_rustls::rustls::{ClientConfig, RootCertStore};
use tokio_tungstenite::client_async;
use tokio_tungstenite::tungstenite::client::IntoClientRequest;

use super::support::{self, User, encode, join, limits, pick, pose, server, start, start_within};
use crate::rooms::frame::{FromServer, FromUser, To};
use crate::rooms::hub::CountedClient;
use crate::rooms::pose::Pose;
use crate::rooms::reason::{End, Reason};
use crate::rooms::{Entrance, Key, Limits, Rooms, Session, requests};
use crate::{HeaderValue, Server, ServerContent, tls};

fn server_content(origin: Option<&'static str>) -> ServerContent {
    let (hosts, origin) = (Some(["localhost".to_owned()].into()), origin.map(HeaderValue::from_static));
    ServerContent { hosts, origin, ..support::server_content(limits(), None) }
}

/// Status status of the response to a request for a room.
async fn status(server: &Server, target: &str, headers: &[&str]) -> u16 {
    let mut stream = TcpStream::connect(server.address()).await.expect("a connection");
    let request = format!("GET {target} HTTP/1.1\r\n{}\r\n\r\n", headers.join("\r\n"));
    stream.write_all(request.as_bytes()).await.expect("sent");
    let mut head = [0; 12];
    stream.read_exact(&mut head).await.expect("an answer");
    std::str::from_utf8(&head[9..]).expect("ASCII").parse().expect("a code")
}

const UPGRADE_HEADERS: [&str; 5] = [
    "Host: localhost:80",
    "Connection: keep-alive, Upgrade",
    "Upgrade: websocket",
    "Sec-WebSocket-Version: 13",
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==",
];

#[tokio::test]
async fn pages_of_other_origins_do_not_enter() {
    for (allowed, origin, expected) in [
        (None, None, 101),
        (None, Some("http://localhost:80"), 101),
        (None, Some("https://LOCALHOST:80"), 101),
        (None, Some("http://localhost:81"), 403),
        (None, Some("http://evil.example"), 403),
        (None, Some("http://localhost:80.evil.example"), 403),
        (None, Some("localhost:80"), 403),
        (None, Some("null"), 403),
        (None, Some(""), 403),
        (Some("https://other.example"), Some("https://other.example"), 101),
        (Some("https://other.example"), Some("http://localhost:80"), 101),
        (Some("https://other.example"), Some("https://evil.example"), 403),
        (Some("*"), Some("https://any.example"), 403),
        (Some("*"), Some("null"), 403),
        (Some("*"), Some("http://localhost:80"), 101),
    ] {
        let server = start(server_content(allowed), None);
        let origin = origin.map(|origin| format!("Origin: {origin}"));
        let headers: Vec<&str> = UPGRADE_HEADERS.iter().copied().chain(origin.as_deref()).collect();
        assert_eq!(status(&server, "/rooms/hall", &headers).await, expected, "{allowed:?} {origin:?}");
    }
    let server = start(server_content(None), None);
    let both = [&UPGRADE_HEADERS[..], &["Origin: http://localhost:80", "Origin: http://evil.example"]].concat();
    assert_eq!(status(&server, "/rooms/hall", &both).await, 403);
}

#[tokio::test]
async fn unknown_host_names_are_refused_without_a_key() {
    for (host, has_key, allowed, expected) in [
        ("rebound.example:80", false, None, 403),
        ("rebound.example:80", true, None, 101),
        ("rebound.example", false, Some("http://rebound.example"), 101),
        ("rebound.example", false, Some("*"), 403),
        ("192.168.1.7:8000", false, None, 101),
        ("192.168.1.7", false, None, 101),
        ("[2001:db8::7]:8000", false, None, 101),
        ("[2001:db8::7]", false, None, 101),
        ("localhost:80", false, None, 101),
        ("192.168.1.7.rebound.example", false, None, 403),
        ("localhost.rebound.example:80", false, None, 403),
    ] {
        let key = has_key.then(|| Key::new(&[1; 16]).expect("a key"));
        let rooms = Some(Arc::new(Rooms::new(limits(), key).expect("limits that fit")));
        let server = start(ServerContent { hosts: None, rooms, ..server_content(allowed) }, None);
        let (named, origin) = (format!("Host: {host}"), format!("Origin: http://{host}"));
        let program = [&[&*named], &UPGRADE_HEADERS[1..]].concat();
        assert_eq!(status(&server, "/rooms/hall", &program).await, 101, "{host}: a program");
        let page = [&program[..], &[&*origin]].concat();
        assert_eq!(status(&server, "/rooms/hall", &page).await, expected, "{host} {has_key} {allowed:?}");
    }
    // A user with a token may come from any page, if files are public.
    let rooms = Some(Arc::new(Rooms::new(limits(), Key::new(&[1; 16]).ok()).expect("limits that fit")));
    let server = start(ServerContent { rooms, ..server_content(Some("*")) }, None);
    let page = [&UPGRADE_HEADERS[..], &["Origin: https://any.example"]].concat();
    assert_eq!(status(&server, "/rooms/hall", &page).await, 101);
}

#[tokio::test]
async fn rooms_leave_connections_to_files() {
    let limits = crate::Limits { connections: 4, ..crate::Limits::default() };
    let server = start_within(ServerContent { hosts: None, ..server_content(None) }, None, limits);
    let mut users = Vec::new();
    for number in 0..3 {
        users.push(join(&server, &number.to_string(), 0, "").await);
    }
    assert_eq!(status(&server, "/rooms/hall", &UPGRADE_HEADERS).await, 503);
    assert_eq!(status(&server, "/healthz", &UPGRADE_HEADERS[..1]).await, 200);
    drop(users.pop());
    // The slot becomes free when the connection has ended.
    while status(&server, "/rooms/hall", &UPGRADE_HEADERS).await != 101 {}
}

#[test]
fn sockets_and_new_rooms_of_a_client_are_limited() {
    let limits = Limits { sockets_per_client: 2, rooms_per_client: 1, ..limits() };
    let rooms = Arc::new(Rooms::new(limits, None).expect("limits that fit"));
    let count = |client: [u8; 4]| rooms.count_client(client.into(), 100);
    let [first_connection, second_connection, other_client] =
        [1, 1, 2].map(|last| count([10, 0, 0, last]).expect("a free connection"));
    assert!(count([10, 0, 0, 1]).is_none());
    let enter = |room: &str, client: &CountedClient| {
        let entrance = Entrance { room: room.to_owned(), token: None, client: client.clone() };
        let mut session = Session::new(Arc::clone(&rooms), entrance, Instant::now());
        let hello = encode(&[FromUser::Hello { group: 0, name: "", ticket: &[] }]);
        session.handle_message(&hello, Instant::now()).map(|()| session)
    };
    let first = enter("first", &first_connection).expect("its first room");
    let end = enter("second", &second_connection).err().expect("it has created one");
    assert_eq!(end, End::new(Reason::Full, "expected a client that has created fewer than 1 rooms"));
    assert!(enter("first", &second_connection).is_ok(), "it may enter");
    assert!(enter("second", &other_client).is_ok(), "others may create one");
    drop(first);
    assert!(enter("second", &second_connection).is_ok());
}

/// A single user of a room, and a function that sends its frames some seconds after the start.
fn join_alone(limits: Limits) -> (Arc<Rooms>, impl FnMut(u64, FromUser<'_>) -> Result<(), End>) {
    let (rooms, begin) = (Arc::new(Rooms::new(limits, None).expect("they fit")), Instant::now());
    let client = rooms.count_client([10, 0, 0, 1].into(), 100).expect("a free connection");
    let entrance = Entrance { room: "hall".to_owned(), token: None, client };
    let mut session = Session::new(Arc::clone(&rooms), entrance, begin);
    let mut send = move |seconds, frame: FromUser<'_>| {
        session.handle_message(&encode(&[frame]), begin + Duration::from_secs(seconds))
    };
    assert_eq!(send(0, FromUser::Hello { group: 0, name: "", ticket: &[] }), Ok(()));
    (rooms, send)
}

#[test]
fn poses_beyond_the_rate_are_dropped_except_final_ones() {
    let (rooms, mut send) = join_alone(Limits { poses_per_second: 10.0, ..limits() });
    let mut sequence = 0;
    let mut poses = |after, count, stops| {
        let dropped = rooms.statistics.dropped.get();
        for _ in 0..count {
            sequence += 1;
            send(after, FromUser::Pose(Pose { stops, ..pose(sequence) }))?;
        }
        Ok::<_, End>(rooms.statistics.dropped.get() - dropped)
    };
    assert_eq!(poses(0, 120, false), Ok(100), "the poses of two seconds are forwarded");
    assert_eq!(poses(0, 20, true), Ok(0));
    assert_eq!(poses(1, 120, false), Ok(110), "dropped poses do not count against the rate");
    assert_eq!(poses(1, 10, true), Ok(0));
    assert_eq!(poses(1, 1, true).map_err(|end| end.reason), Err(Reason::Flood));
}

#[test]
fn users_who_say_too_much_are_disconnected() {
    for (payload, most) in [(4096, 7), (0, 512)] {
        let (_rooms, mut say) = join_alone(Limits { said_bytes_per_second: 1000.0, ..limits() });
        let payload = vec![1; payload];
        for count in 0..most {
            let to_one = FromUser::Signal { user: 1, payload: &payload };
            let frame = if count % 2 == 0 { to_one } else { FromUser::Say { to: To::Room, payload: &payload } };
            assert_eq!(say(0, frame), Ok(()), "a quarter of 128 KiB");
        }
        assert_eq!(say(10, FromUser::Say { to: To::Group, payload: &payload }), Ok(()), "it has refilled");
        let too_much = (0..=most).find_map(|_| say(10, FromUser::Say { to: To::Group, payload: &payload }).err());
        assert_eq!(too_much.map(|end| end.reason), Some(Reason::Flood));
    }
}

#[test]
fn limits_are_consistent() {
    let refused = |limits| Rooms::new(limits, None).err().expect("they do not fit");
    let base = Limits::default();
    let least = 34 + 72 * base.users;
    assert!(Rooms::new(Limits { queue_bytes: least, ..base }, None).is_ok());
    let wrong = refused(Limits { queue_bytes: least - 1, ..base });
    assert_eq!(wrong, "queue_bytes: expected 18466 or more for 256 users, got 18465");
    let zero = Duration::ZERO;
    for (limits, start) in [
        (Limits { users: 0, ..base }, "users: "),
        (Limits { users: 65_535, queue_bytes: 1 << 30, ..base }, "users: "),
        (Limits { burst: zero, ..base }, "burst: "),
        (Limits { hello: zero, ..base }, "hello: "),
        (Limits { ping: zero, ..base }, "ping: "),
        (Limits { ping: base.silence, ..base }, "ping: "),
        (Limits { silence: zero, ..base }, "silence: "),
        (Limits { linger: zero, ..base }, "linger: "),
        (Limits { bytes_per_second: 0.0, ..base }, "bytes_per_second: "),
        (Limits { messages_per_second: f64::NAN, ..base }, "messages_per_second: "),
        (Limits { said_bytes_per_second: f64::INFINITY, ..base }, "said_bytes_per_second: "),
        (Limits { poses_per_second: -1.0, ..base }, "poses_per_second: "),
    ] {
        let sentence = refused(limits);
        assert!(sentence.starts_with(start), "{sentence}");
    }
}

#[tokio::test]
async fn requests_without_an_upgrade_get_no_socket() {
    let server = start(server_content(None), None);
    for missing in &UPGRADE_HEADERS[1..] {
        let headers: Vec<&str> = UPGRADE_HEADERS.into_iter().filter(|each| each != missing).collect();
        assert_eq!(status(&server, "/rooms/hall", &headers).await, 426, "without {missing}");
    }
    let other_host = [&["Host: evil.example"], &UPGRADE_HEADERS[1..]].concat();
    assert_eq!(status(&server, "/rooms/hall", &other_host).await, 403);
    for (target, expected) in [("/rooms/h%C3%A4ll", 101), ("/rooms/", 404), ("/rooms/a/b", 404)] {
        assert_eq!(status(&server, target, &UPGRADE_HEADERS).await, expected, "{target}");
    }
    let without = start(ServerContent { rooms: None, ..server_content(None) }, None);
    assert_eq!(status(&without, "/rooms/hall", &UPGRADE_HEADERS).await, 404);
}

#[test]
fn names_of_rooms_are_short_and_plain() {
    let long = format!("rooms/{}", "a".repeat(65));
    for (path, name) in [
        ("rooms/hall", Some("hall")),
        ("rooms/a b.\u{e9}", Some("a b.\u{e9}")),
        ("rooms/a b.e\u{301}", Some("a b.\u{e9}")),
        (&long[..long.len() - 1], Some(&long[6..70])),
        (&long, None),
        ("rooms/", None),
        ("rooms/a/b", None),
        ("rooms/a\n", None),
        ("room/a", None),
        ("/rooms/a", None),
    ] {
        assert_eq!(requests::room_name(path).as_deref(), name, "{path}");
    }
}

#[tokio::test]
async fn frames_that_arrive_with_the_request_are_read() {
    let server = server(limits(), None);
    let mut friend = join(&server, "hall", 1, "").await;
    let mut stream = TcpStream::connect(server.address()).await.expect("a connection");
    let frames = encode(&[FromUser::Hello { group: 1, name: "early", ticket: &[] }, FromUser::Pose(pose(1))]);
    // Masking key of zeros.
    let head = [0x82, 0x80 | frames.len() as u8, 0, 0, 0, 0];
    let request = format!("GET /rooms/hall HTTP/1.1\r\n{}\r\n\r\n", UPGRADE_HEADERS.join("\r\n"));
    stream.write_all(&[request.as_bytes(), &head, &frames].concat()).await.expect("sent");
    let number = friend.wait_for(pick!(FromServer::Joined { user, name: "early", .. } => user)).await;
    assert_eq!(friend.next_pose_of(number).await, pose(1));
}

#[tokio::test]
async fn an_encrypted_server_encrypts_sockets() {
    let folder = tempfile::tempdir().expect("a folder");
    let (certificate, key) = tls::self_signed(vec!["laptop.local".into()]).expect("made");
    let paths = tls::tests::write_pem(folder.path(), "laptop", &certificate, &key);
    let server = start(ServerContent { hosts: None, ..server_content(None) }, Some(paths));
    let mut trusted = RootCertStore::empty();
    trusted.add(CertificateDer::from_pem_slice(certificate.as_bytes()).expect("a certificate")).expect("trusted");
    let mut config = ClientConfig::builder().with_root_certificates(trusted).with_no_client_auth();
    // ALPN of browsers for a WebSocket.
    config.alpn_protocols = vec![b"http/1.1".to_vec()];
    let connector = TlsConnector::from(Arc::new(config));
    let mut users = Vec::new();
    for _ in 0..2 {
        let stream = TcpStream::connect(server.address()).await.expect("a connection");
        let name = ServerName::try_from("laptop.local").expect("a name");
        let stream = connector.connect(name, stream).await.expect("a handshake");
        // Page whose host is listed in the server's certificate.
        let mut request = "wss://laptop.local/rooms/hall".into_client_request().expect("a request");
        request.headers_mut().insert("origin", HeaderValue::from_static("https://laptop.local"));
        let mut user = User::new(client_async(request, stream).await.expect("a socket").0);
        user.hello(1, "", &[]).await;
        users.push(user);
    }
    users[0].send(&[FromUser::Pose(pose(3))]).await;
    let number = users[0].number;
    assert_eq!(users[1].next_pose_of(number).await, pose(3));
}
