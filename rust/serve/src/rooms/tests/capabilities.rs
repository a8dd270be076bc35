//! Responses to pages that ask for the capabilities of rooms.

use std::sync::Arc;

use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;

use super::support::{limits, server_content, start};
use crate::rooms::Rooms;
use crate::{HeaderValue, Server, ServerContent};

/// Requests a target; returns the head and the body of the response.
pub async fn get(server: &Server, target: &str, headers: &str) -> (String, String) {
    let mut stream = TcpStream::connect(server.address()).await.expect("a connection");
    let request = format!("GET {target} HTTP/1.1\r\nHost: localhost:80\r\nConnection: close\r\n{headers}\r\n");
    stream.write_all(request.as_bytes()).await.expect("sent");
    let mut answer = String::new();
    stream.read_to_string(&mut answer).await.expect("an answer");
    let (head, body) = answer.split_once("\r\n\r\n").expect("a head");
    (head.to_ascii_lowercase(), body.to_owned())
}

#[tokio::test]
async fn pages_can_read_the_capabilities_of_rooms() {
    let start_with = |peers| {
        let mut rooms = Rooms::new(limits(), None).expect("limits that fit");
        (rooms.peers, rooms.datagrams) = (peers, false);
        start(ServerContent { rooms: Some(Arc::new(rooms)), ..server_content(limits(), None) }, None)
    };
    let server = start_with(true);
    for target in ["/rooms", "/room%73", "/rooms?any"] {
        let (head, body) = get(&server, target, "").await;
        assert!(head.starts_with("http/1.1 200"), "{head}");
        assert!(head.contains("cache-control: no-store") && head.contains("content-type: application/json"), "{head}");
        assert_eq!(body, r#"{"peers":true,"datagrams":null}"#);
    }
    let server = start_with(false);
    assert_eq!(get(&server, "/rooms", "").await.1, r#"{"peers":false,"datagrams":null}"#);
}

#[tokio::test]
async fn pages_of_other_origins_cannot_read_them() {
    let origin = HeaderValue::from_static("*");
    let server = start(ServerContent { origin: Some(origin), ..server_content(limits(), None) }, None);
    assert!(get(&server, "/rooms", "Origin: https://evil.example\r\n").await.0.starts_with("http/1.1 403"));
    assert!(get(&server, "/rooms", "Origin: http://localhost:80\r\n").await.0.starts_with("http/1.1 200"));
    let hosts = Some(["other".to_owned()].into());
    let server = start(ServerContent { hosts, ..server_content(limits(), None) }, None);
    assert!(get(&server, "/rooms", "").await.0.starts_with("http/1.1 403"));
}

#[tokio::test]
async fn a_server_without_rooms_has_no_capabilities() {
    let server = start(ServerContent { rooms: None, ..server_content(limits(), None) }, None);
    assert!(get(&server, "/rooms", "").await.0.starts_with("http/1.1 404"));
}
