//! Requests that upgrade a connection to a room's WebSocket, or start a WebTransport session.

use axum::body::Body;
use axum::http::header::{self, HeaderValue};
use axum::http::{Request, Response, StatusCode};
use tokio_tungstenite::tungstenite::handshake::server::create_response_with_body;

use super::about;
use super::door::{CLOSED, Door};
use super::places::Place;
use super::session::Entering;
use crate::respond;

/// Greatest size of a room's name, bytes.
const NAME: usize = 64;

/// Name of the room in a decoded path without its leading slash; none if the path is not that of a room.
pub fn room(path: &str) -> Option<&str> {
    let name = path.strip_prefix(about::PATH)?.strip_prefix('/')?;
    let is_name = (1..=NAME).contains(&name.len()) && !name.contains(|each: char| each.is_control() || each == '/');
    is_name.then_some(name)
}

/// Handles a request for a room: switches to WebSocket, with an `Entering` extension in the response, or refuses with
/// a reason.
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
                return respond::refusal(StatusCode::SERVICE_UNAVAILABLE, "the server has its maximum number of users");
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

/// Handles a request for a WebTransport session; returns the room to enter, or the status of the refusal.
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
