//! WebTransport session over a QUIC connection: one per connection, on its first stream.

use std::task::{Context, Poll, ready};
use std::time::Duration;

use axum::http::{Request, StatusCode, Uri, header};
use bytes::{Bytes, BytesMut};
use quinn::{Connection, RecvStream, SendStream, VarInt};
use tokio::io::{AsyncRead, AsyncReadExt};

use super::wire::{self, Fields, frame};
use crate::clients::{MAX_CONSECUTIVE, READ_BYTES};

/// Maximum size of a request's header block, bytes.
const MAX_HEADERS_BYTES: u64 = 1 << 12;
/// HTTP/3 code for closing a connection without an error.
const NO_ERROR: VarInt = VarInt::from_u32(0x100);
/// HTTP/3 code for closing a connection after a protocol violation.
const PROTOCOL_ERROR: VarInt = VarInt::from_u32(0x101);
/// Least datagram size in bytes that a client must accept, so that a pose always fits.
const MIN_DATAGRAM_BYTES: usize = 256;
/// Session ID, which is the ID of the session's first stream; each stream and datagram of the session begins with it.
const SESSION_ID: u64 = 0;
/// Greatest number of frames before a request's headers.
const MAX_FRAMES_BEFORE_HEADERS: usize = 16;

/// A session request that awaits its response.
pub struct SessionRequest {
    link: Link,
    /// The request, with `Host` and `Origin` as in HTTP/1.1.
    pub request: Request<()>,
}

/// An established session.
pub struct Link {
    /// Connection, used only by this session.
    pub connection: Connection,
    send: SendStream,
    receive: RecvStream,
    /// Kept open, because closing the control stream closes the connection.
    _control: SendStream,
}

/// Error: the connection broke, or the client violated the protocol, before the session was established.
#[derive(Debug)]
pub struct Broken;

impl<E: std::error::Error> From<E> for Broken {
    fn from(_: E) -> Self {
        Broken
    }
}

impl SessionRequest {
    /// Reads a connection's request; closes the connection on errors.
    pub async fn read(connection: &Connection) -> Result<Self, Broken> {
        let session_request = read_session_request(connection).await;
        if session_request.is_err() {
            reject(connection);
        }
        session_request
    }

    pub async fn accept(mut self) -> Result<Link, Broken> {
        self.respond(StatusCode::OK).await?;
        Ok(self.link)
    }

    /// Refuses the session, and closes the connection once the response has arrived, or after a timeout.
    pub async fn refuse(mut self, status: StatusCode, timeout: Duration) {
        let response = async {
            self.respond(status).await?;
            self.link.send.finish()?;
            self.link.send.stopped().await?;
            Ok::<_, Broken>(())
        };
        let _ = tokio::time::timeout(timeout, response).await;
        self.link.connection.close(NO_ERROR, b"");
    }

    async fn respond(&mut self, status: StatusCode) -> Result<(), Broken> {
        let mut bytes = Vec::new();
        wire::put_frame(&mut bytes, frame::HEADERS, &wire::status_fields(status.as_u16()));
        Ok(self.link.send.write_all(&bytes).await?)
    }
}

impl Link {
    /// Stream of the user's messages: the first one that the client opens in the session.
    pub async fn stream(&self) -> Result<(SendStream, RecvStream), Broken> {
        let (send, mut receive) = self.connection.accept_bi().await?;
        let is_of_session =
            read_varint(&mut receive).await? == frame::STREAM && read_varint(&mut receive).await? == SESSION_ID;
        if is_of_session { Ok((send, receive)) } else { Err(Broken) }
    }

    /// Waits for the end of the session's stream; its content is discarded.
    pub fn poll_ended(&mut self, context: &mut Context<'_>) -> Poll<()> {
        let mut buffer = [0; READ_BYTES];
        for _ in 0..MAX_CONSECUTIVE {
            if !matches!(ready!(self.receive.poll_read(context, &mut buffer)), Ok(1..)) {
                return Poll::Ready(());
            }
        }
        context.waker().wake_by_ref();
        Poll::Pending
    }

    /// Maximum payload of a datagram in bytes; 0 if the connection supports none.
    pub fn max_payload_bytes(&self) -> usize {
        self.connection.max_datagram_size().map_or(0, |max_bytes| max_bytes.saturating_sub(1))
    }

    /// Sends the end of the session to the client.
    pub async fn end(&mut self, code: u16, reason: &str) -> Result<(), Broken> {
        self.send.write_all(&wire::close_frame(code.into(), reason)).await?;
        Ok(self.send.finish()?)
    }

    pub fn close(&self, code: u16, reason: &str) {
        self.connection.close(VarInt::from_u32(code.into()), reason.as_bytes());
    }
}

/// Closes a connection that sent no valid session request.
pub fn reject(connection: &Connection) {
    connection.close(PROTOCOL_ERROR, b"expected a request for a session of WebTransport");
}

/// Encodes a datagram with its session ID.
pub fn encode_datagram(payload: &[u8]) -> Bytes {
    let mut bytes = BytesMut::with_capacity(1 + payload.len());
    wire::put_varint(&mut bytes, SESSION_ID);
    bytes.extend_from_slice(payload);
    bytes.freeze()
}

/// Payload of a received datagram; none if it belongs to another session.
pub fn payload(mut datagram: &[u8]) -> Option<&[u8]> {
    (wire::read_varint(&mut datagram)? == SESSION_ID).then_some(datagram)
}

async fn read_session_request(connection: &Connection) -> Result<SessionRequest, Broken> {
    let mut control = connection.open_uni().await?;
    control.write_all(&wire::settings()).await?;
    // The client's settings are not read: without a dynamic table they have no effect.
    let (send, mut receive) = connection.accept_bi().await?;
    let request = read_request(&mut receive).await?;
    if connection.max_datagram_size().is_none_or(|max_bytes| max_bytes < MIN_DATAGRAM_BYTES) {
        return Err(Broken);
    }
    Ok(SessionRequest { link: Link { connection: connection.clone(), send, receive, _control: control }, request })
}

/// Reads the session request at the start of a connection's first stream.
pub async fn read_request(receive: &mut (impl AsyncRead + Unpin)) -> Result<Request<()>, Broken> {
    let fields = wire::read_fields(&read_headers(receive).await?).ok_or(Broken)?;
    session_request(&fields).ok_or(Broken)
}

/// Reads the body of the first HEADERS frame; unknown frames before it are ignored.
async fn read_headers(receive: &mut (impl AsyncRead + Unpin)) -> Result<Vec<u8>, Broken> {
    for _ in 0..=MAX_FRAMES_BEFORE_HEADERS {
        let (kind, length) = (read_varint(receive).await?, read_varint(receive).await?);
        if length > MAX_HEADERS_BYTES {
            return Err(Broken);
        }
        let mut body = vec![0; length as usize];
        receive.read_exact(&mut body).await?;
        match kind {
            frame::HEADERS => return Ok(body),
            frame::DATA | frame::SETTINGS | frame::STREAM => return Err(Broken),
            _ => {}
        }
    }
    Err(Broken)
}

async fn read_varint(receive: &mut (impl AsyncRead + Unpin)) -> Result<u64, Broken> {
    let mut bytes = [0; 8];
    receive.read_exact(&mut bytes[..1]).await?;
    let length = wire::varint_length(bytes[0]);
    receive.read_exact(&mut bytes[1..length]).await?;
    wire::read_varint(&mut &bytes[..length]).ok_or(Broken)
}

/// Converts header fields to a request; none if it is not for a session.
fn session_request(fields: &Fields) -> Option<Request<()>> {
    for (name, expected) in [(":method", "CONNECT"), (":scheme", "https"), (":protocol", "webtransport")] {
        fields.get(name).filter(|value| *value == expected)?;
    }
    let uri: Uri = fields.get(":path").filter(|path| path.starts_with('/'))?.parse().ok()?;
    let request = Request::builder().uri(uri).header(header::HOST, fields.get(":authority")?);
    let origin = fields.get("origin").map(|origin| (header::ORIGIN, origin));
    origin.into_iter().fold(request, |request, (name, origin)| request.header(name, origin)).body(()).ok()
}
