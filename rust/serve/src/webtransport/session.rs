//! A session of WebTransport over a connection of QUIC: one for each connection, at its first stream.

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

/// Most bytes of a request's head.
const HEAD: u64 = 1 << 12;
/// Code by which a side closes a connection that has done what it should.
const NO_ERROR: VarInt = VarInt::from_u32(0x100);
/// Code by which the server closes one that breaks the rules of HTTP/3.
const PROTOCOL_ERROR: VarInt = VarInt::from_u32(0x101);
/// Fewest bytes of a datagram that a client must take, so that a pose always fits.
const DATAGRAM: usize = 256;
/// The session's number, that of its stream, as it stands before streams and datagrams of the session.
const NUMBER: u64 = 0;
/// Frames that may come before a request's head.
const BEFORE: usize = 16;

/// A request for a session that waits for its answer.
pub struct Asking {
    connection: Connection,
    send: SendStream,
    receive: RecvStream,
    control: SendStream,
    /// The request, with `Host` and `Origin` as HTTP/1.1 has them.
    pub request: Request<()>,
}

/// A session.
pub struct Link {
    /// The connection that it has for itself.
    pub connection: Connection,
    send: SendStream,
    receive: RecvStream,
    /// Its end would be that of the connection.
    _control: SendStream,
}

/// Why there is no session: a side broke off, or broke the rules.
#[derive(Debug)]
pub struct Broken;

impl Asking {
    /// Read a connection's request; errors close it.
    pub async fn read(connection: &Connection) -> Result<Self, Broken> {
        let asking = read(connection).await;
        if asking.is_err() {
            break_off(connection);
        }
        asking
    }

    /// Begin the session.
    pub async fn accept(mut self) -> Result<Link, Broken> {
        self.answer(StatusCode::OK).await?;
        let Asking { connection, send, receive, control, .. } = self;
        Ok(Link { connection, send, receive, _control: control })
    }

    /// Tell that there is none, and close the connection when the answer has come, or after some time.
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
    /// The stream by which the user's frames come and go. It is the first one that the client opens in the session.
    pub async fn stream(&self) -> Result<(SendStream, RecvStream), Broken> {
        let (send, mut receive) = self.connection.accept_bi().await.map_err(|_| Broken)?;
        let is_own = number(&mut receive).await? == frame::STREAM && number(&mut receive).await? == NUMBER;
        if is_own { Ok((send, receive)) } else { Err(Broken) }
    }

    /// Wait until the client has ended the session; what else it tells of the session is of no meaning here.
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

    /// Most bytes of a datagram's payload that the connection takes, none if it takes no datagrams.
    pub fn most(&self) -> usize {
        self.connection.max_datagram_size().map_or(0, |most| most.saturating_sub(1))
    }

    /// Tell the client the end of the session.
    pub async fn end(&mut self, code: u16, reason: &str) -> Result<(), Broken> {
        self.send.write_all(&wire::close(code.into(), reason)).await.map_err(|_| Broken)?;
        self.send.finish().map_err(|_| Broken)
    }

    /// Close the connection.
    pub fn close(&self, code: u16, reason: &str) {
        self.connection.close(VarInt::from_u32(code.into()), reason.as_bytes());
    }
}

/// Close a connection that asks for no session.
pub fn break_off(connection: &Connection) {
    connection.close(PROTOCOL_ERROR, b"expected a request for a session of WebTransport");
}

/// A datagram as it goes over the connection.
pub fn datagram(payload: &[u8]) -> Bytes {
    let mut bytes = BytesMut::with_capacity(1 + payload.len());
    wire::put_number(&mut bytes, NUMBER);
    bytes.extend_from_slice(payload);
    bytes.freeze()
}

/// The payload of one that has come; none if it is of another session, which there is not.
pub fn payload(mut datagram: &[u8]) -> Option<&[u8]> {
    (wire::number(&mut datagram)? == NUMBER).then_some(datagram)
}

async fn read(connection: &Connection) -> Result<Asking, Broken> {
    let mut control = connection.open_uni().await.map_err(|_| Broken)?;
    control.write_all(&wire::settings()).await.map_err(|_| Broken)?;
    // The client's own settings are not read: with no table for headers, they would change nothing.
    let (send, mut receive) = connection.accept_bi().await.map_err(|_| Broken)?;
    let request = asked(&mut receive).await?;
    if connection.max_datagram_size().is_none_or(|most| most < DATAGRAM) {
        return Err(Broken);
    }
    Ok(Asking { connection: connection.clone(), send, receive, control, request })
}

/// The request for a session with which a connection's first stream begins.
pub async fn asked(receive: &mut (impl AsyncRead + Unpin)) -> Result<Request<()>, Broken> {
    let fields = fields::read(&head(receive).await?).ok_or(Broken)?;
    request(fields).ok_or(Broken)
}

/// The body of the first frame that is a head; others before it are of no meaning.
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

/// The request of these fields, if it is one for a session.
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
