//! WebSocket transport of a user's messages.

use std::future::poll_fn;
use std::io;
use std::pin::Pin;
use std::task::{Context, Poll, ready};

use bytes::{Bytes, BytesMut};
use futures_util::{Sink, Stream};
use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
use tokio::time::{Instant, Sleep, sleep_until, timeout};
use tokio_tungstenite::WebSocketStream;
use tokio_tungstenite::tungstenite::Error;
use tokio_tungstenite::tungstenite::protocol::{CloseFrame, Message, Role, WebSocketConfig};

use super::frame::{FromServer, HEAD};
use super::outbox::{Part, Taken};
use super::pose;
use super::reason::{End, Reason, broken_connection};
use super::session::Session;
use super::tap::Tap;
use crate::limits::{READ, ROW};

/// WebSocket connection of a user.
struct Socket<S> {
    stream: WebSocketStream<Tap<S>>,
    session: Session,
    /// Buffer for joining queued frames to a message.
    message: BytesMut,
    /// Arrival times of the poses in the message being written.
    read: Vec<std::time::Instant>,
    /// Whether the stream has not accepted all of the last message yet.
    is_writing: bool,
    is_ping_due: bool,
    begun: Instant,
    /// Time of the last received byte.
    heard: Instant,
    /// Time of the last ping.
    pinged: Instant,
    clock: Pin<Box<Sleep>>,
}

/// Serves a user over a new WebSocket; `came` arrived with its request. Returns the reason for the end.
pub async fn serve<S>(session: Session, stream: S, came: Bytes) -> Reason
where
    S: AsyncRead + AsyncWrite + Unpin,
{
    let (limits, now) = (session.rooms.limits, Instant::now());
    // One message of a full queue, and pongs.
    let most = 2 * limits.queue_bytes + limits.users * (HEAD + 2 + pose::MAX);
    let config = WebSocketConfig::default()
        .read_buffer_size(READ)
        .write_buffer_size(0)
        .max_write_buffer_size(most)
        .max_message_size(Some(limits.message_bytes))
        .max_frame_size(Some(limits.message_bytes));
    let stream = WebSocketStream::from_partially_read(Tap::new(stream), came.into(), Role::Server, Some(config)).await;
    let clock = Box::pin(sleep_until(now));
    let (message, read) = (BytesMut::new(), Vec::new());
    let (is_writing, is_ping_due) = (false, false);
    let mut socket =
        Socket { stream, session, message, read, is_writing, is_ping_due, begun: now, heard: now, pinged: now, clock };
    let end = poll_fn(|context| socket.poll(context)).await;
    let Socket { session, stream, .. } = socket;
    session.end(end.reason);
    let _ = timeout(limits.linger, farewell(stream, &end, limits.message_bytes)).await;
    end.reason
}

impl<S: AsyncRead + AsyncWrite + Unpin> Socket<S> {
    fn poll(&mut self, context: &mut Context<'_>) -> Poll<End> {
        // Registered before polling, so that no frame added meanwhile is missed.
        self.session.outbox.register(context.waker());
        // Read before the timer is checked: bytes may have arrived while the process was suspended.
        if let Poll::Ready(end) = self.poll_read(context) {
            return Poll::Ready(end);
        }
        if let Poll::Ready(end) = self.poll_clock(context) {
            return Poll::Ready(end);
        }
        self.poll_write(context)
    }

    /// Checks the timeouts for silence. Messages are not delayed by this timer.
    fn poll_clock(&mut self, context: &mut Context<'_>) -> Poll<End> {
        let limits = self.session.rooms.limits;
        loop {
            ready!(self.clock.as_mut().poll(context));
            let (now, is_in) = (Instant::now(), self.session.is_in());
            let deadline = if is_in { self.heard + limits.silence } else { self.begun + limits.hello };
            if now >= deadline {
                let sentence = if is_in { "expected an answer to a ping" } else { "expected hello" };
                return Poll::Ready(End::new(Reason::Silent, sentence));
            }
            if now >= self.heard.max(self.pinged) + limits.ping {
                (self.is_ping_due, self.pinged) = (true, now);
            }
            self.clock.as_mut().reset(deadline.min(self.heard.max(self.pinged) + limits.ping));
        }
    }

    fn poll_read(&mut self, context: &mut Context<'_>) -> Poll<End> {
        for _ in 0..ROW {
            let polled = Pin::new(&mut self.stream).poll_next(context);
            let came = self.stream.get_mut().came();
            if came == 0 && polled.is_pending() {
                return Poll::Pending;
            }
            let now = Instant::now();
            if came > 0 {
                self.heard = now;
            }
            let now = now.into_std();
            let taken = self.session.took(came, now).and_then(|()| match ready_or(polled)? {
                None => Ok(false),
                Some(Message::Binary(bytes)) => self.session.message(&bytes, now).map(|()| true),
                Some(Message::Text(_)) => Err(End::new(Reason::Frame, "expected binary messages")),
                Some(Message::Close(_)) => Err(End::new(Reason::Bye, "the user left")),
                Some(_) => self.session.count_message(now).map(|()| true),
            });
            match taken {
                Ok(true) => {}
                Ok(false) => return Poll::Pending,
                Err(end) => return Poll::Ready(end),
            }
        }
        context.waker().wake_by_ref();
        Poll::Pending
    }

    /// Writes all queued frames as one message as soon as the stream has accepted the previous one.
    fn poll_write(&mut self, context: &mut Context<'_>) -> Poll<End> {
        loop {
            if self.is_writing {
                match Pin::new(&mut self.stream).poll_flush(context) {
                    // A user who does not read must not delay the end.
                    Poll::Pending => return self.session.outbox.ended().map_or(Poll::Pending, Poll::Ready),
                    Poll::Ready(Err(error)) => return Poll::Ready(lost(error)),
                    Poll::Ready(Ok(())) => {}
                }
                self.is_writing = false;
                let now = std::time::Instant::now();
                let ages = self.read.drain(..).map(|read| now.saturating_duration_since(read));
                self.session.rooms.figures.written(ages);
            }
            // The ping goes first, because the queue may never be empty.
            let message = if std::mem::take(&mut self.is_ping_due) {
                Message::Ping(Bytes::new())
            } else {
                match self.session.outbox.take(Part::All, &mut self.message, &mut self.read) {
                    Taken::End(end) => return Poll::Ready(end),
                    Taken::Message => Message::Binary(self.message.split().freeze()),
                    Taken::Nothing => return Poll::Pending,
                }
            };
            if let Err(error) = Pin::new(&mut self.stream).start_send(message) {
                return Poll::Ready(lost(error));
            }
            self.is_writing = true;
        }
    }
}

/// Received message, none if there is none yet, or the end.
fn ready_or(polled: Poll<Option<Result<Message, Error>>>) -> Result<Option<Message>, End> {
    match polled {
        Poll::Pending => Ok(None),
        Poll::Ready(Some(Ok(message))) => Ok(Some(message)),
        Poll::Ready(Some(Err(error))) => Err(lost(error)),
        Poll::Ready(None) => Err(broken_connection()),
    }
}

/// End for a WebSocket error.
fn lost(error: Error) -> End {
    use tokio_tungstenite::tungstenite::error::ProtocolError;
    match error {
        Error::Io(error) if error.kind() == io::ErrorKind::TimedOut => {
            End::new(Reason::Slow, "expected a client that reads")
        }
        Error::WriteBufferFull(_) => End::new(Reason::Slow, "expected a client that reads the answers to its pings"),
        Error::Protocol(ProtocolError::ResetWithoutClosingHandshake) | Error::Io(_) => broken_connection(),
        Error::ConnectionClosed | Error::AlreadyClosed => broken_connection(),
        other => End::new(Reason::Frame, other.to_string()),
    }
}

/// Sends the reason and waits until the user has closed the connection, so that all written data arrive. Reads at
/// most `most` bytes meanwhile.
async fn farewell<S>(mut stream: WebSocketStream<Tap<S>>, end: &End, most: usize) -> Result<(), Error>
where
    S: AsyncRead + AsyncWrite + Unpin,
{
    let mut left = if end.reason == Reason::Flood { 0 } else { most };
    let is_told = end.reason != Reason::Gone && say_why(&mut stream, end).await.is_ok();
    if !is_told {
        // After the user's close frame nothing more can be sent, but the reply must be flushed.
        let _ = poll_fn(|context| Pin::new(&mut stream).poll_flush(context)).await;
    }
    if is_told {
        poll_fn(|context| poll_closed(&mut stream, context, &mut left)).await;
    }
    let tap = stream.get_mut();
    poll_fn(|context| Pin::new(&mut *tap).poll_shutdown(context)).await?;
    let is_closed = poll_fn(|context| poll_drained(tap, context, &mut left)).await?;
    // Not reading limits the work for a flooding user; the caller's timeout ends this.
    if is_closed { Ok(()) } else { std::future::pending().await }
}

/// Reads messages until the user has closed the WebSocket, or until `left` bytes are read.
fn poll_closed<S>(stream: &mut WebSocketStream<Tap<S>>, context: &mut Context<'_>, left: &mut usize) -> Poll<()>
where
    S: AsyncRead + AsyncWrite + Unpin,
{
    while *left > 0 {
        let polled = Pin::new(&mut *stream).poll_next(context);
        *left = left.saturating_sub(stream.get_mut().came());
        if !ready!(polled).is_some_and(|message| message.is_ok()) {
            break;
        }
    }
    Poll::Ready(())
}

/// Reads until the user has closed its side, or until `left` bytes are read; returns whether it has closed.
fn poll_drained<S>(tap: &mut Tap<S>, context: &mut Context<'_>, left: &mut usize) -> Poll<io::Result<bool>>
where
    S: AsyncRead + AsyncWrite + Unpin,
{
    let mut rest = [0; READ];
    while *left > 0 {
        let mut into = ReadBuf::new(&mut rest);
        ready!(Pin::new(&mut *tap).poll_read(context, &mut into))?;
        if into.filled().is_empty() {
            return Poll::Ready(Ok(true));
        }
        *left = left.saturating_sub(into.filled().len());
    }
    Poll::Ready(Ok(false))
}

async fn say_why<S>(stream: &mut WebSocketStream<Tap<S>>, end: &End) -> Result<(), Error>
where
    S: AsyncRead + AsyncWrite + Unpin,
{
    let mut message = BytesMut::new();
    FromServer::Refused { code: end.reason.code(), sentence: &end.sentence }.write(&mut message);
    let close = CloseFrame { code: end.reason.close_code().into(), reason: end.reason.name().into() };
    let told = (end.reason != Reason::Bye).then(|| Message::Binary(message.freeze()));
    for message in told.into_iter().chain([Message::Close(Some(close))]) {
        poll_fn(|context| Pin::new(&mut *stream).poll_ready(context)).await?;
        Pin::new(&mut *stream).start_send(message)?;
    }
    poll_fn(|context| Pin::new(&mut *stream).poll_flush(context)).await
}
