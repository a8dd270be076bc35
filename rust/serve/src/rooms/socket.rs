//! Transport of a user's frames by WebSocket.

use std::future::poll_fn;
use std::io;
use std::pin::Pin;
use std::task::{Context, Poll, ready};

use bytes::{Bytes, BytesMut};
use futures_util::{Sink, SinkExt, Stream};
use tokio::io::{AsyncRead, AsyncReadExt, AsyncWrite, AsyncWriteExt, ReadBuf};
use tokio::time::{Instant, Sleep, sleep_until, timeout};
use tokio_tungstenite::WebSocketStream;
use tokio_tungstenite::tungstenite::Error;
use tokio_tungstenite::tungstenite::protocol::{CloseFrame, Message, Role, WebSocketConfig};

use super::frame::{FromServer, HEADER_BYTES};
use super::outbox::{Outgoing, Selection};
use super::pose;
use super::reason::{End, Reason};
use super::session::Session;
use crate::clients::{MAX_CONSECUTIVE, READ_BYTES};

/// A connection's bidirectional stream.
pub trait Duplex: AsyncRead + AsyncWrite + Unpin + Send + 'static {}

impl<S: AsyncRead + AsyncWrite + Unpin + Send + 'static> Duplex for S {}

/// WebSocket connection of a user.
struct Socket<S> {
    stream: WebSocketStream<CountingStream<S>>,
    session: Session,
    /// Buffer in which queued frames are joined to a message.
    message: BytesMut,
    /// Arrival times of the poses in the message being written.
    arrivals: Vec<std::time::Instant>,
    /// Whether the stream has not accepted all of the last message yet.
    is_writing: bool,
    is_ping_due: bool,
    started: Instant,
    /// Time of the last received byte.
    last_received: Instant,
    last_ping: Instant,
    timer: Pin<Box<Sleep>>,
}

/// Serves a user over a new WebSocket; `first_bytes` arrived with its request. Returns the reason for the end.
pub async fn serve<S: Duplex>(session: Session, stream: S, first_bytes: Bytes) -> Reason {
    let (limits, now) = (session.rooms.limits, Instant::now());
    // Room for one message (a full queue plus one pose of each user) and for as many bytes of pongs as a queue holds.
    let max_write_bytes = 2 * limits.queue_bytes + limits.users * (HEADER_BYTES + 2 + pose::MAX_BYTES);
    let config = WebSocketConfig::default()
        .read_buffer_size(READ_BYTES)
        .write_buffer_size(0)
        .max_write_buffer_size(max_write_bytes)
        .max_message_size(Some(limits.message_bytes))
        .max_frame_size(Some(limits.message_bytes));
    let stream = CountingStream { stream, received_bytes: 0 };
    let stream = WebSocketStream::from_partially_read(stream, first_bytes.into(), Role::Server, Some(config)).await;
    let mut socket = Socket {
        stream,
        session,
        message: BytesMut::new(),
        arrivals: Vec::new(),
        is_writing: false,
        is_ping_due: false,
        started: now,
        last_received: now,
        last_ping: now,
        timer: Box::pin(sleep_until(now)),
    };
    let end = poll_fn(|context| socket.work(context).map_or_else(Poll::Ready, |()| Poll::Pending)).await;
    let Socket { session, stream, .. } = socket;
    session.end(end.reason);
    let _ = timeout(limits.linger, send_farewell(stream, &end, limits.message_bytes)).await;
    end.reason
}

impl<S: Duplex> Socket<S> {
    /// Reads, checks the timeouts and writes as far as possible without waiting.
    fn work(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        // The waker is registered before polling, so that a frame queued meanwhile wakes the task again.
        self.session.outbox.register(context.waker());
        // Reading precedes the timeouts, because bytes may have arrived while the process was suspended.
        self.read(context)?;
        self.check_timer(context)?;
        self.write(context)
    }

    /// Checks the timeouts of users who send nothing. The timer does not delay messages.
    fn check_timer(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        let limits = self.session.rooms.limits;
        while self.timer.as_mut().poll(context).is_ready() {
            let (now, has_joined) = (Instant::now(), self.session.has_joined());
            let deadline = if has_joined { self.last_received + limits.silence } else { self.started + limits.hello };
            if now >= deadline {
                let sentence = if has_joined { "expected an answer to a ping" } else { "expected hello" };
                return Err(End::new(Reason::Silent, sentence));
            }
            if now >= self.last_received.max(self.last_ping) + limits.ping {
                (self.is_ping_due, self.last_ping) = (true, now);
            }
            self.timer.as_mut().reset(deadline.min(self.last_received.max(self.last_ping) + limits.ping));
        }
        Ok(())
    }

    fn read(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        for _ in 0..MAX_CONSECUTIVE {
            let polled = Pin::new(&mut self.stream).poll_next(context);
            let received_bytes = self.stream.get_mut().take_count();
            if received_bytes > 0 {
                self.last_received = Instant::now();
                self.session.count_bytes(received_bytes, self.last_received.into_std())?;
            }
            let (Poll::Ready(message), now) = (polled, Instant::now().into_std()) else { return Ok(()) };
            match message.ok_or_else(End::broken)?? {
                Message::Binary(bytes) => self.session.handle_message(&bytes, now)?,
                Message::Text(_) => return Err(End::new(Reason::Frame, "expected binary messages")),
                Message::Close(_) => return Err(End::by_user()),
                _ => self.session.count_message(now)?,
            }
        }
        context.waker().wake_by_ref();
        Ok(())
    }

    /// Writes all queued frames as one message as soon as the stream has accepted the previous one.
    fn write(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        loop {
            if self.is_writing {
                match Pin::new(&mut self.stream).poll_flush(context) {
                    // A user who does not read cannot delay the end of the connection.
                    Poll::Pending => return self.session.outbox.end_reason().map_or(Ok(()), Err),
                    Poll::Ready(flushed) => flushed?,
                }
                self.is_writing = false;
                self.session.rooms.statistics.count_forwarded(self.arrivals.drain(..));
            }
            // The ping precedes the queue, which may never be empty.
            let message = if std::mem::take(&mut self.is_ping_due) {
                Message::Ping(Bytes::new())
            } else {
                match self.session.outbox.take(Selection::All, &mut self.message, &mut self.arrivals) {
                    Outgoing::End(end) => return Err(end),
                    Outgoing::Message => Message::Binary(self.message.split().freeze()),
                    Outgoing::Nothing => return Ok(()),
                }
            };
            Pin::new(&mut self.stream).start_send(message)?;
            self.is_writing = true;
        }
    }
}

impl From<Error> for End {
    fn from(error: Error) -> Self {
        use tokio_tungstenite::tungstenite::error::ProtocolError::ResetWithoutClosingHandshake as Reset;
        match error {
            Error::Io(error) if error.kind() == io::ErrorKind::TimedOut => {
                End::new(Reason::Slow, "expected a client that reads")
            }
            Error::WriteBufferFull(_) => {
                End::new(Reason::Slow, "expected a client that reads the answers to its pings")
            }
            Error::Protocol(Reset) | Error::Io(_) | Error::ConnectionClosed | Error::AlreadyClosed => End::broken(),
            other => End::new(Reason::Frame, other.to_string()),
        }
    }
}

/// Sends the reason and waits until the user has closed the connection, so that all written data arrive. Meanwhile
/// reads at most `max_bytes`.
async fn send_farewell<S: Duplex>(
    mut stream: WebSocketStream<CountingStream<S>>,
    end: &End,
    max_bytes: usize,
) -> Result<(), Error> {
    let mut remaining_bytes = if end.reason == Reason::Flood { 0 } else { max_bytes };
    if end.reason != Reason::Gone && send_reason(&mut stream, end).await.is_ok() {
        poll_fn(|context| poll_closed(&mut stream, context, &mut remaining_bytes)).await;
    } else {
        // After the user's close frame nothing more can be sent, but the reply must be flushed.
        let _ = stream.flush().await;
    }
    let stream = stream.get_mut();
    stream.shutdown().await?;
    let mut buffer = vec![0; READ_BYTES];
    while remaining_bytes > 0 {
        match stream.read(&mut buffer).await? {
            0 => return Ok(()),
            length => remaining_bytes = remaining_bytes.saturating_sub(length),
        }
    }
    // No more is read, which limits the work for a user who sends too much; the caller's timeout ends the wait.
    std::future::pending().await
}

/// Reads messages until the user has closed the WebSocket, or until `remaining_bytes` are read.
fn poll_closed<S: Duplex>(
    stream: &mut WebSocketStream<CountingStream<S>>,
    context: &mut Context<'_>,
    remaining_bytes: &mut usize,
) -> Poll<()> {
    while *remaining_bytes > 0 {
        let polled = Pin::new(&mut *stream).poll_next(context);
        *remaining_bytes = remaining_bytes.saturating_sub(stream.get_mut().take_count());
        if !ready!(polled).is_some_and(|message| message.is_ok()) {
            break;
        }
    }
    Poll::Ready(())
}

async fn send_reason<S: Duplex>(stream: &mut WebSocketStream<CountingStream<S>>, end: &End) -> Result<(), Error> {
    if end.reason != Reason::Bye {
        let mut message = BytesMut::new();
        FromServer::Refused { code: end.reason.code(), sentence: &end.sentence }.write(&mut message);
        stream.feed(Message::Binary(message.freeze())).await?;
    }
    let close = CloseFrame { code: end.reason.close_code().into(), reason: end.reason.name().into() };
    stream.send(Message::Close(Some(close))).await
}

/// A stream that counts the bytes received.
struct CountingStream<S> {
    stream: S,
    received_bytes: usize,
}

impl<S> CountingStream<S> {
    /// Bytes received since the last call.
    fn take_count(&mut self) -> usize {
        std::mem::take(&mut self.received_bytes)
    }
}

impl<S: AsyncRead + Unpin> AsyncRead for CountingStream<S> {
    fn poll_read(mut self: Pin<&mut Self>, context: &mut Context<'_>, buf: &mut ReadBuf<'_>) -> Poll<io::Result<()>> {
        let before = buf.filled().len();
        let polled = Pin::new(&mut self.stream).poll_read(context, buf);
        self.received_bytes += buf.filled().len() - before;
        polled
    }
}

impl<S: AsyncWrite + Unpin> AsyncWrite for CountingStream<S> {
    fn poll_write(mut self: Pin<&mut Self>, context: &mut Context<'_>, bytes: &[u8]) -> Poll<io::Result<usize>> {
        Pin::new(&mut self.stream).poll_write(context, bytes)
    }

    fn poll_flush(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_flush(context)
    }

    fn poll_shutdown(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_shutdown(context)
    }
}
