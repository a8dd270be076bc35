//! The request by which a connection becomes the WebSocket of a room.

use axum::body::Body;
use axum::http::header::{self, HeaderMap, HeaderValue};
use axum::http::{Request, Response, StatusCode};
use tokio_tungstenite::tungstenite::handshake::server::create_response_with_body;

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
/// why it does not. Pages may ask if they are the server's own, which has this name, or of the allowed origin.
pub fn answer<B>(
    room: &str,
    host: Option<&str>,
    allowed: Option<&HeaderValue>,
    request: &Request<B>,
) -> Response<Body> {
    if !may_enter(request.headers(), host, allowed) {
        return respond::refusal(StatusCode::FORBIDDEN, "pages of this origin may not enter");
    }
    match create_response_with_body(request, Body::empty) {
        Ok(mut answer) => {
            let query = request.uri().query().unwrap_or_default();
            let token = query.split('&').find_map(|pair| pair.strip_prefix("token=")).map(str::to_owned);
            answer.extensions_mut().insert(Entering { room: room.to_owned(), token });
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

/// Programs send no origin; browsers always do.
fn may_enter(headers: &HeaderMap, host: Option<&str>, allowed: Option<&HeaderValue>) -> bool {
    let mut origins = headers.get_all(header::ORIGIN).iter();
    let Some(origin) = origins.next() else { return true };
    if origins.next().is_some() {
        return false;
    }
    if allowed.is_some_and(|allowed| allowed == "*" || allowed == origin) {
        return true;
    }
    // A proxy may encrypt for the server, so the scheme tells nothing.
    let origin = origin.to_str().unwrap_or_default();
    let own = origin.strip_prefix("https://").or_else(|| origin.strip_prefix("http://"));
    own.zip(host).is_some_and(|(own, host)| own.eq_ignore_ascii_case(host))
}
