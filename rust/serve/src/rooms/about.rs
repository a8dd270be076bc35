//! The answer by which a page learns how to use the rooms of its server.

use axum::body::Body;
use axum::http::header::{self, HeaderMap};
use axum::http::{Response, StatusCode};
use serde::Serialize;

use super::door::{CLOSED, Door};
use super::hub::Rooms;
use crate::respond;

/// The path of the answer, and the part of a room's path before its name.
pub const PATH: &str = "rooms";

/// How the rooms of a server may be used.
#[derive(Serialize)]
struct About {
    /// Pages may exchange files among themselves.
    peers: bool,
    /// Where datagrams are taken, if anywhere.
    datagrams: Option<Datagrams>,
}

/// Where a page connects by WebTransport.
#[derive(Clone, Debug, Serialize)]
pub struct Datagrams {
    /// Port of UDP.
    pub port: u16,
    /// SHA-256 of certificates that no authority has signed, in hexadecimal digits.
    pub hashes: Vec<String>,
}

/// Answer a request for what the rooms can do.
pub fn answer(rooms: &Rooms, datagrams: Option<Datagrams>, door: Door<'_>, headers: &HeaderMap) -> Response<Body> {
    if !door.is_open(headers) {
        return respond::refusal(StatusCode::FORBIDDEN, CLOSED);
    }
    // Numbers, flags and digits always become text.
    let text = serde_json::to_string(&About { peers: rooms.peers, datagrams }).unwrap_or_default();
    let head = Response::builder().header(header::CACHE_CONTROL, "no-store");
    respond::finished(head.header(header::CONTENT_TYPE, "application/json").body(Body::from(text)))
}
