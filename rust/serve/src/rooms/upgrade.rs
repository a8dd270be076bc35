//! The request by which a connection becomes the WebSocket of a room, or a session of WebTransport.

use axum::body::Body;
use axum::http::header::{self, HeaderValue};
use axum::http::{Request, Response, StatusCode};
use tokio_tungstenite::tungstenite::handshake::server::create_response_with_body;

use super::about;
use super::door::{CLOSED, Door};
use super::places::Place;
use super::session::Entering;
use crate::respond;

/// Most bytes of a room's name.
const NAME: usize = 64;

/// The name of a room, if a decoded path without its leading slash leads to one.
pub fn room(path: &str) -> Option<&str> {
    let name = path.strip_prefix(about::PATH)?.strip_prefix('/')?;
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
        return respond::refusal(StatusCode::FORBIDDEN, CLOSED);
    }
    match create_response_with_body(request, Body::empty) {
        Ok(mut answer) => {
            let Some(place) = place() else {
                return respond::refusal(StatusCode::SERVICE_UNAVAILABLE, "there are as many users as there may be");
            };
            answer.extensions_mut().insert(entering(room, place, request));
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

/// Answer a request for a session of WebTransport: where it leads, or the status by which it is refused.
pub fn session<B>(
    room: &str,
    door: Door<'_>,
    place: impl FnOnce() -> Option<Place>,
    request: &Request<B>,
) -> Result<Entering, StatusCode> {
    if !door.is_open(request.headers()) {
        return Err(StatusCode::FORBIDDEN);
    }
    let place = place().ok_or(StatusCode::SERVICE_UNAVAILABLE)?;
    Ok(entering(room, place, request))
}

fn entering<B>(room: &str, place: Place, request: &Request<B>) -> Entering {
    let query = request.uri().query().unwrap_or_default();
    let token = query.split('&').find_map(|pair| pair.strip_prefix("token="));
    Entering::new(room, token, place)
}
