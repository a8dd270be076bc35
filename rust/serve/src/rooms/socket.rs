//! WebSocket transport of a user's messages.

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

use super::frame::{FromServer, HEAD_BYTES};
use super::outbox::{Selection, Taken};
use super::pose;
use super::reason::{End, Reason};
use super::session::Session;
use crate::clients::{MAX_CONSECUTIVE, READ_BYTES};

/// A connection's bidirectional stream.
pub trait Duplex: AsyncRead + AsyncWrite + Unpin + Send + 'static {}

impl<S: AsyncRead + AsyncWrite + Unpin + Send + 'static> Duplex for S {}

/// WebSocket connection of a user.
struct Socket<S> {
    stream: WebSocketStream<Counted<S>>,
    session: Session,
    /// Buffer for joining queued frames to a message.
    message: BytesMut,
    /// Arrival times of the poses in the message being written.
    received: Vec<std::time::Instant>,
    /// Whether the stream has not accepted all of the last message yet.
    is_writing: bool,
    is_ping_due: bool,
    begun: Instant,
    /// Time of the last received byte.
    last_received: Instant,
    last_ping: Instant,
    timer: Pin<Box<Sleep>>,
}

/// Serves a user over a new WebSocket; `first_bytes` arrived with its request. Returns the reason for the end.
pub async fn serve<S: Duplex>(session: Session, stream: S, first_bytes: Bytes) -> Reason {
    let (limits, now) = (session.rooms.limits, Instant::now());
    // One message of a full queue, and pongs.
    let max_write_bytes = 2 * limits.queue_bytes + limits.users * (HEAD_BYTES + 2 + pose::MAX_BYTES);
    let config = WebSocketConfig::default()
        .read_buffer_size(READ_BYTES)
        .write_buffer_size(0)
        .max_write_buffer_size(max_write_bytes)
        .max_message_size(Some(limits.message_bytes))
        .max_frame_size(Some(limits.message_bytes));
    let stream = Counted { stream, received_bytes: 0 };
    let stream = WebSocketStream::from_partially_read(stream, first_bytes.into(), Role::Server, Some(config)).await;
    let mut socket = Socket {
        stream,
        session,
        message: BytesMut::new(),
        received: Vec::new(),
        is_writing: false,
        is_ping_due: false,
        begun: now,
        last_received: now,
        last_ping: now,
        timer: Box::pin(sleep_until(now)),
    };
    let end = poll_fn(|context| socket.work(context).map_or_else(Poll::Ready, |()| Poll::Pending)).await;
    let Socket { session, stream, .. } = socket;
    session.end(end.reason);
    let _ = timeout(limits.linger, farewell(stream, &end, limits.message_bytes)).await;
    end.reason
}

impl<S: Duplex> Socket<S> {
    /// Does all work that is possible now.
    fn work(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        // Registered before polling, so that no frame added meanwhile is missed.
        self.session.outbox.register(context.waker());
        // Read before the timer is checked: bytes may have arrived while the process was suspended.
        self.read(context)?;
        self.check_timer(context)?;
        self.write(context)
    }

    /// Checks the timeouts for silence. Messages are not delayed by this timer.
    fn check_timer(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        let limits = self.session.rooms.limits;
        while self.timer.as_mut().poll(context).is_ready() {
            let (now, is_in) = (Instant::now(), self.session.is_in());
            let deadline = if is_in { self.last_received + limits.silence } else { self.begun + limits.hello };
            if now >= deadline {
                let sentence = if is_in { "expected an answer to a ping" } else { "expected hello" };
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
                Message::Binary(bytes) => self.session.message(&bytes, now)?,
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
                    // A user who does not read must not delay the end.
                    Poll::Pending => return self.session.outbox.ended().map_or(Ok(()), Err),
                    Poll::Ready(flushed) => flushed?,
                }
                self.is_writing = false;
                self.session.rooms.figures.written(self.received.drain(..));
            }
            // The ping goes first, because the queue may never be empty.
            let message = if std::mem::take(&mut self.is_ping_due) {
                Message::Ping(Bytes::new())
            } else {
                match self.session.outbox.take(Selection::All, &mut self.message, &mut self.received) {
                    Taken::End(end) => return Err(end),
                    Taken::Message => Message::Binary(self.message.split().freeze()),
                    Taken::Nothing => return Ok(()),
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

/// Sends the reason and waits until the user has closed the connection, so that all written data arrive. Reads at
/// most `max_bytes` meanwhile.
async fn farewell<S: Duplex>(
    mut stream: WebSocketStream<Counted<S>>,
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
    // Not reading limits the work for a flooding user; the caller's timeout ends this.
    std::future::pending().await
}

/// Reads messages until the user has closed the WebSocket, or until `remaining_bytes` are read.
fn poll_closed<S: Duplex>(
    stream: &mut WebSocketStream<Counted<S>>,
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

async fn send_reason<S: Duplex>(stream: &mut WebSocketStream<Counted<S>>, end: &End) -> Result<(), Error> {
    if end.reason != Reason::Bye {
        let mut message = BytesMut::new();
        FromServer::Refused { code: end.reason.code(), sentence: &end.sentence }.write(&mut message);
        stream.feed(Message::Binary(message.freeze())).await?;
    }
    let close = CloseFrame { code: end.reason.close_code().into(), reason: end.reason.name().into() };
    stream.send(Message::Close(Some(close))).await
}

/// A stream that counts received bytes.
struct Counted<S> {
    stream: S,
    received_bytes: usize,
}

impl<S> Counted<S> {
    /// Bytes received since the last call.
    fn take_count(&mut self) -> usize {
        std::mem::take(&mut self.received_bytes)
    }
}

impl<S: AsyncRead + Unpin> AsyncRead for Counted<S> {
    fn poll_read(mut self: Pin<&mut Self>, context: &mut Context<'_>, into: &mut ReadBuf<'_>) -> Poll<io::Result<()>> {
        let before = into.filled().len();
        let polled = Pin::new(&mut self.stream).poll_read(context, into);
        self.received_bytes += into.filled().len() - before;
        polled
    }
}

impl<S: AsyncWrite + Unpin> AsyncWrite for Counted<S> {
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
