//! The request by which a connection becomes the WebSocket of a room.

use std::net::{IpAddr, SocketAddr};

use axum::body::Body;
use axum::http::header::{self, HeaderMap, HeaderValue};
use axum::http::{Request, Response, StatusCode};
use tokio_tungstenite::tungstenite::handshake::server::create_response_with_body;

use super::places::Place;
use super::session::Entering;
use crate::respond;

/// First part of the paths of rooms.
const ROOMS: &str = "rooms/";
/// Most bytes of a room's name.
const NAME: usize = 64;

/// The name of a room, if a decoded path without its leading slash leads to one.
pub fn room(path: &str) -> Option<&str> {
    let name = path.strip_prefix(ROOMS)?;
    let is_name = (1..=NAME).contains(&name.len()) && !name.contains(|each: char| each.is_control() || each == '/');
    is_name.then_some(name)
}

/// Answer a request for a room: that the connection becomes a WebSocket, with an extension that says where it leads; or
/// why it does not.
pub fn answer<B>(
    room: &str,
    door: Door<'_>,
    place: impl FnOnce() -> Option<Place>,
    request: &Request<B>,
) -> Response<Body> {
    if !door.is_open(request.headers()) {
        return respond::refusal(StatusCode::FORBIDDEN, "pages of this origin may not enter");
    }
    match create_response_with_body(request, Body::empty) {
        Ok(mut answer) => {
            let Some(place) = place() else {
                return respond::refusal(StatusCode::SERVICE_UNAVAILABLE, "there are as many users as there may be");
            };
            let query = request.uri().query().unwrap_or_default();
            let token = query.split('&').find_map(|pair| pair.strip_prefix("token="));
            answer.extensions_mut().insert(Entering::new(room, token, place));
            answer
        }
        Err(error) => {
            let mut answer = respond::refusal(StatusCode::UPGRADE_REQUIRED, &error.to_string());
            let headers = answer.headers_mut();
            headers.insert(header::CONNECTION, HeaderValue::from_static("upgrade"));
            headers.insert(header::UPGRADE, HeaderValue::from_static("websocket"));
            headers.insert(header::SEC_WEBSOCKET_VERSION, HeaderValue::from_static("13"));
            answer
        }
    }
}

/// The rules by which pages of other sites are kept out.
#[derive(Clone, Copy)]
pub struct Door<'a> {
    /// The name by which the request calls the server, with its port.
    pub host: Option<&'a str>,
    /// It is one of the names that the server was told, or that its certificate lists.
    pub is_named: bool,
    /// Whose pages may read files: an origin, or `*`.
    pub allowed: Option<&'a HeaderValue>,
    /// Users need a token.
    pub needs_token: bool,
}

impl Door<'_> {
    /// Programs send no origin; browsers always do.
    fn is_open(self, headers: &HeaderMap) -> bool {
        let mut origins = headers.get_all(header::ORIGIN).iter();
        let Some(origin) = origins.next() else { return true };
        if origins.next().is_some() {
            return false;
        }
        if self.allowed.is_some_and(|allowed| if allowed == "*" { self.needs_token } else { allowed == origin }) {
            return true;
        }
        // A proxy may encrypt for the server, so the scheme tells nothing.
        let origin = origin.to_str().unwrap_or_default();
        let own = origin.strip_prefix("https://").or_else(|| origin.strip_prefix("http://"));
        own.zip(self.host).is_some_and(|(own, host)| own.eq_ignore_ascii_case(host) && self.is_own(host))
    }

    /// Whether a page that was called by this name is the server's own. The owner of a name may let it lead first to
    /// the owner's page, then to this server; an address leads nowhere else, nor does localhost.
    fn is_own(self, host: &str) -> bool {
        let is_address = host.parse::<SocketAddr>().is_ok() || host.trim_matches(['[', ']']).parse::<IpAddr>().is_ok();
        let name = host.split(':').next().unwrap_or_default();
        self.needs_token || self.is_named || is_address || name.eq_ignore_ascii_case("localhost")
    }
}
