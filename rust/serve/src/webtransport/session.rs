//! WebTransport session over a QUIC connection: one per connection, on its first stream.

use std::task::{Context, Poll, ready};
use std::time::Duration;

use axum::http::header::{self, HeaderValue};
use axum::http::{Request, StatusCode, Uri};
use bytes::{Bytes, BytesMut};
use quinn::{Connection, RecvStream, SendStream, VarInt};
use tokio::io::{AsyncRead, AsyncReadExt};
use tokio::time::timeout;

use super::fields::{self, Fields};
use super::wire::{self, frame};
use crate::limits::{READ, ROW};

/// Greatest size of a request's header block, bytes.
const HEAD: u64 = 1 << 12;
/// HTTP/3 code for closing a connection without an error.
const NO_ERROR: VarInt = VarInt::from_u32(0x100);
/// HTTP/3 code for closing a connection after a protocol violation.
const PROTOCOL_ERROR: VarInt = VarInt::from_u32(0x101);
/// Least datagram size in bytes that a client must accept, so that a pose always fits.
const DATAGRAM: usize = 256;
/// Session ID: the ID of its stream; it precedes the session's streams and datagrams.
const NUMBER: u64 = 0;
/// Greatest number of frames before a request's headers.
const BEFORE: usize = 16;

/// A session request that awaits its response.
pub struct Asking {
    connection: Connection,
    send: SendStream,
    receive: RecvStream,
    control: SendStream,
    /// The request, with `Host` and `Origin` as in HTTP/1.1.
    pub request: Request<()>,
}

/// A session.
pub struct Link {
    /// Connection, used only by this session.
    pub connection: Connection,
    send: SendStream,
    receive: RecvStream,
    /// Kept open, because closing the control stream closes the connection.
    _control: SendStream,
}

/// No session was established: the connection broke, or the client violated the protocol.
#[derive(Debug)]
pub struct Broken;

impl Asking {
    /// Reads a connection's request; closes the connection on errors.
    pub async fn read(connection: &Connection) -> Result<Self, Broken> {
        let asking = read(connection).await;
        if asking.is_err() {
            break_off(connection);
        }
        asking
    }

    /// Accepts the session.
    pub async fn accept(mut self) -> Result<Link, Broken> {
        self.answer(StatusCode::OK).await?;
        let Asking { connection, send, receive, control, .. } = self;
        Ok(Link { connection, send, receive, _control: control })
    }

    /// Refuses the session, and closes the connection once the response has arrived, or after the timeout `most`.
    pub async fn refuse(mut self, status: StatusCode, most: Duration) {
        let told = async {
            self.answer(status).await?;
            self.send.finish().map_err(|_| Broken)?;
            self.send.stopped().await.map_err(|_| Broken)
        };
        let _ = timeout(most, told).await;
        self.connection.close(NO_ERROR, b"");
    }

    async fn answer(&mut self, status: StatusCode) -> Result<(), Broken> {
        let mut bytes = Vec::new();
        wire::put_frame(&mut bytes, frame::HEADERS, &fields::answer(status.as_u16()));
        self.send.write_all(&bytes).await.map_err(|_| Broken)
    }
}

impl Link {
    /// Stream of the user's frames: the first one that the client opens in the session.
    pub async fn stream(&self) -> Result<(SendStream, RecvStream), Broken> {
        let (send, mut receive) = self.connection.accept_bi().await.map_err(|_| Broken)?;
        let is_own = number(&mut receive).await? == frame::STREAM && number(&mut receive).await? == NUMBER;
        if is_own { Ok((send, receive)) } else { Err(Broken) }
    }

    /// Waits until the client has ended the session; other capsules are ignored.
    pub fn poll_ended(&mut self, context: &mut Context<'_>) -> Poll<()> {
        let mut rest = [0; READ];
        for _ in 0..ROW {
            if !matches!(ready!(self.receive.poll_read(context, &mut rest)), Ok(1..)) {
                return Poll::Ready(());
            }
        }
        context.waker().wake_by_ref();
        Poll::Pending
    }

    /// Greatest payload of a datagram in bytes; 0 if the connection supports none.
    pub fn most(&self) -> usize {
        self.connection.max_datagram_size().map_or(0, |most| most.saturating_sub(1))
    }

    /// Sends the end of the session to the client.
    pub async fn end(&mut self, code: u16, reason: &str) -> Result<(), Broken> {
        self.send.write_all(&wire::close(code.into(), reason)).await.map_err(|_| Broken)?;
        self.send.finish().map_err(|_| Broken)
    }

    /// Closes the connection.
    pub fn close(&self, code: u16, reason: &str) {
        self.connection.close(VarInt::from_u32(code.into()), reason.as_bytes());
    }
}

/// Closes a connection without a valid session request.
pub fn break_off(connection: &Connection) {
    connection.close(PROTOCOL_ERROR, b"expected a request for a session of WebTransport");
}

/// Encodes a datagram with its session ID.
pub fn datagram(payload: &[u8]) -> Bytes {
    let mut bytes = BytesMut::with_capacity(1 + payload.len());
    wire::put_number(&mut bytes, NUMBER);
    bytes.extend_from_slice(payload);
    bytes.freeze()
}

/// Payload of a received datagram; none if it belongs to another session.
pub fn payload(mut datagram: &[u8]) -> Option<&[u8]> {
    (wire::number(&mut datagram)? == NUMBER).then_some(datagram)
}

async fn read(connection: &Connection) -> Result<Asking, Broken> {
    let mut control = connection.open_uni().await.map_err(|_| Broken)?;
    control.write_all(&wire::settings()).await.map_err(|_| Broken)?;
    // The client's settings are not read: without a dynamic table they have no effect.
    let (send, mut receive) = connection.accept_bi().await.map_err(|_| Broken)?;
    let request = read_request(&mut receive).await?;
    if connection.max_datagram_size().is_none_or(|most| most < DATAGRAM) {
        return Err(Broken);
    }
    Ok(Asking { connection: connection.clone(), send, receive, control, request })
}

/// Reads the session request at the start of a connection's first stream.
pub async fn read_request(receive: &mut (impl AsyncRead + Unpin)) -> Result<Request<()>, Broken> {
    let fields = fields::read(&head(receive).await?).ok_or(Broken)?;
    request(fields).ok_or(Broken)
}

/// Body of the first HEADERS frame; unknown frames before it are ignored.
async fn head(receive: &mut (impl AsyncRead + Unpin)) -> Result<Vec<u8>, Broken> {
    for _ in 0..=BEFORE {
        let (kind, length) = (number(receive).await?, number(receive).await?);
        if length > HEAD {
            return Err(Broken);
        }
        let mut body = vec![0; length as usize];
        receive.read_exact(&mut body).await.map_err(|_| Broken)?;
        match kind {
            frame::HEADERS => return Ok(body),
            frame::DATA | frame::SETTINGS | frame::STREAM => return Err(Broken),
            _ => {}
        }
    }
    Err(Broken)
}

async fn number(receive: &mut (impl AsyncRead + Unpin)) -> Result<u64, Broken> {
    let mut bytes = [0; 8];
    receive.read_exact(&mut bytes[..1]).await.map_err(|_| Broken)?;
    let length = wire::length_of(bytes[0]);
    receive.read_exact(&mut bytes[1..length]).await.map_err(|_| Broken)?;
    wire::number(&mut &bytes[..length]).ok_or(Broken)
}

/// Converts header fields to a request; none if it is not for a session.
fn request(fields: Fields) -> Option<Request<()>> {
    let is = |field: &Option<String>, expected| field.as_deref() == Some(expected);
    if !(is(&fields.method, "CONNECT") && is(&fields.scheme, "https") && is(&fields.protocol, "webtransport")) {
        return None;
    }
    let uri: Uri = fields.path.filter(|path| path.starts_with('/'))?.parse().ok()?;
    let mut request = Request::new(());
    *request.uri_mut() = uri;
    let headers = request.headers_mut();
    headers.insert(header::HOST, HeaderValue::try_from(fields.authority?).ok()?);
    if let Some(origin) = fields.origin {
        headers.insert(header::ORIGIN, HeaderValue::try_from(origin).ok()?);
    }
    Some(request)
}
