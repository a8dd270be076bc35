//! Response that tells a page the capabilities of the server's rooms.

use axum::body::Body;
use axum::http::header::{self, HeaderMap};
use axum::http::{Response, StatusCode};
use serde::Serialize;

use super::door::{CLOSED, Door};
use super::hub::Rooms;
use crate::respond;

/// Path of the response, and path prefix of rooms.
pub const PATH: &str = "rooms";

/// Capabilities of a server's rooms.
#[derive(Serialize)]
struct About {
    /// Whether pages may exchange files among themselves.
    peers: bool,
    /// WebTransport address; none if it is off.
    datagrams: Option<Datagrams>,
}

/// WebTransport address for pages.
#[derive(Clone, Debug, Serialize)]
pub struct Datagrams {
    /// UDP port.
    pub port: u16,
    /// SHA-256 of self-signed certificates in hexadecimal digits.
    pub hashes: Vec<String>,
}

/// Handles a request for the capabilities of rooms.
pub fn answer(rooms: &Rooms, datagrams: Option<Datagrams>, door: Door<'_>, headers: &HeaderMap) -> Response<Body> {
    if !door.is_open(headers) {
        return respond::refusal(StatusCode::FORBIDDEN, CLOSED);
    }
    // Numbers, flags and hexadecimal digits always serialise.
    let text = serde_json::to_string(&About { peers: rooms.peers, datagrams }).unwrap_or_default();
    let head = Response::builder().header(header::CACHE_CONTROL, "no-store");
    respond::finished(head.header(header::CONTENT_TYPE, "application/json").body(Body::from(text)))
}
