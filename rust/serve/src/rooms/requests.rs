//! HTTP requests for rooms: their capabilities, and connections by WebSocket or WebTransport.

use std::borrow::Cow;
use std::net::{IpAddr, SocketAddr};

use axum::body::Body;
use axum::http::header::{self, HeaderMap, HeaderValue};
use axum::http::{Request, Response, StatusCode};
use icu_normalizer::ComposingNormalizerBorrowed;
use serde::Serialize;
use tokio_tungstenite::tungstenite::handshake::server::create_response_with_body;

use super::hub::{CountedClient, Rooms};
use super::session::Entrance;
use crate::respond;

/// Path of the capabilities, and path prefix of rooms.
pub const PATH: &str = "rooms";
/// Maximum size of a room's name, bytes.
const MAX_NAME_BYTES: usize = 64;
/// Reason sent to pages of other origins.
const WRONG_ORIGIN: &str = "pages of this origin may not enter";

/// Capabilities of a server's rooms.
#[derive(Serialize)]
struct Capabilities {
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

/// Access rules, which keep pages of other sites out.
#[derive(Clone, Copy)]
pub struct AccessRules<'a> {
    /// Host header of the request, with its port.
    pub host: Option<&'a str>,
    /// Whether the host is one of the configured names, or is listed in the server's certificate.
    pub is_known_host: bool,
    /// Origin whose pages may read files, or `*`.
    pub allowed: Option<&'a HeaderValue>,
    /// Whether users need a token.
    pub needs_token: bool,
}

impl AccessRules<'_> {
    /// Whether a request's page may enter. Requests without an Origin header are admitted: programs send none, whereas
    /// browsers send it for WebSockets and for cross-origin reads.
    fn admits(self, headers: &HeaderMap) -> bool {
        let mut origins = headers.get_all(header::ORIGIN).iter();
        let Some(origin) = origins.next() else { return true };
        if origins.next().is_some() {
            return false;
        }
        if self.allowed.is_some_and(|allowed| if allowed == "*" { self.needs_token } else { allowed == origin }) {
            return true;
        }
        // The scheme is ignored, because a proxy may terminate TLS.
        let origin = origin.to_str().unwrap_or_default();
        let page_host = origin.strip_prefix("https://").or_else(|| origin.strip_prefix("http://"));
        page_host.zip(self.host).is_some_and(|(page, host)| page.eq_ignore_ascii_case(host) && self.is_own_host(host))
    }

    /// Whether a page loaded from this host belongs to the server. By DNS rebinding, the owner of a name can serve a
    /// page and then point the name to this server; IP addresses and localhost cannot be rebound.
    fn is_own_host(self, host: &str) -> bool {
        let is_address = host.parse::<SocketAddr>().is_ok() || host.trim_matches(['[', ']']).parse::<IpAddr>().is_ok();
        let name = host.split(':').next().unwrap_or_default();
        self.needs_token || self.is_known_host || is_address || name.eq_ignore_ascii_case("localhost")
    }
}

/// Answers a request for the capabilities of rooms.
pub fn capabilities(
    rooms: &Rooms,
    datagrams: Option<Datagrams>,
    rules: AccessRules<'_>,
    headers: &HeaderMap,
) -> Response<Body> {
    if !rules.admits(headers) {
        return respond::text_response(StatusCode::FORBIDDEN, WRONG_ORIGIN);
    }
    // Numbers, flags and hexadecimal digits always serialise.
    let text = serde_json::to_string(&Capabilities { peers: rooms.peers, datagrams }).unwrap_or_default();
    let head = Response::builder().header(header::CACHE_CONTROL, "no-store");
    respond::finish(head.header(header::CONTENT_TYPE, "application/json").body(Body::from(text)))
}

/// Name of the room in a decoded path without its leading slash; none for other paths. The name is converted to
/// Unicode's normalisation form C, because keyboards and systems encode accented letters differently.
pub fn room_name(path: &str) -> Option<Cow<'_, str>> {
    let name = ComposingNormalizerBorrowed::new_nfc().normalize(path.strip_prefix(PATH)?.strip_prefix('/')?);
    let has_length = (1..=MAX_NAME_BYTES).contains(&name.len());
    (has_length && !name.contains(|character: char| character.is_control() || character == '/')).then_some(name)
}

/// Answers a WebSocket request for a room: switches protocols, with an `Entrance` extension in the response, or refuses
/// with a reason. `count_client` counts the connection; it returns none if the server is full.
pub fn upgrade<B>(
    room: &str,
    rules: AccessRules<'_>,
    count_client: impl FnOnce() -> Option<CountedClient>,
    request: &Request<B>,
) -> Response<Body> {
    if !rules.admits(request.headers()) {
        return respond::text_response(StatusCode::FORBIDDEN, WRONG_ORIGIN);
    }
    match create_response_with_body(request, Body::empty) {
        Ok(mut answer) => {
            let Some(client) = count_client() else {
                let reason = "the server has its maximum number of users";
                return respond::text_response(StatusCode::SERVICE_UNAVAILABLE, reason);
            };
            answer.extensions_mut().insert(entrance(room, client, request));
            answer
        }
        Err(error) => {
            let mut answer = respond::text_response(StatusCode::UPGRADE_REQUIRED, &error.to_string());
            let headers = answer.headers_mut();
            headers.insert(header::CONNECTION, HeaderValue::from_static("upgrade"));
            headers.insert(header::UPGRADE, HeaderValue::from_static("websocket"));
            headers.insert(header::SEC_WEBSOCKET_VERSION, HeaderValue::from_static("13"));
            answer
        }
    }
}

/// Admits a request for a WebTransport session; returns the room to enter, or the status of the refusal.
pub fn enter<B>(
    room: &str,
    rules: AccessRules<'_>,
    count_client: impl FnOnce() -> Option<CountedClient>,
    request: &Request<B>,
) -> Result<Entrance, StatusCode> {
    if !rules.admits(request.headers()) {
        return Err(StatusCode::FORBIDDEN);
    }
    let client = count_client().ok_or(StatusCode::SERVICE_UNAVAILABLE)?;
    Ok(entrance(room, client, request))
}

fn entrance<B>(room: &str, client: CountedClient, request: &Request<B>) -> Entrance {
    let query = request.uri().query().unwrap_or_default();
    let token = query.split('&').find_map(|pair| pair.strip_prefix("token="));
    Entrance { room: room.to_owned(), token: token.map(str::to_owned), client }
}
