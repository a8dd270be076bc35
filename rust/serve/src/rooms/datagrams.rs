//! WebTransport transport of a user's frames: reliable frames on a stream, replaceable ones in datagrams.

use std::future::{Future, poll_fn};
use std::pin::{Pin, pin};
use std::sync::Arc;
use std::task::{Context, Poll};
use std::time::Duration;

use bytes::{Buf, Bytes, BytesMut};
use futures_util::{Stream, stream};
use quinn::{Connection, ConnectionError, ReadError, RecvStream, SendDatagramError, SendStream, WriteError};
use tokio::time::{Instant, Sleep, interval, sleep_until, timeout, timeout_at};

use super::frame::{FromServer, HEAD};
use super::outbox::{Part, Taken};
use super::reason::{End, Reason, broken_connection};
use super::session::Session;
use crate::limits::{READ, ROW};
use crate::webtransport::session::{Link, datagram, payload};

/// Greatest size of a datagram's frames in bytes; few networks carry larger packets.
pub const DATAGRAM: usize = 1200;
/// Interval at which the received bytes of a user without a stream are counted.
const COUNTED: Duration = Duration::from_millis(100);

type Incoming = Pin<Box<dyn Stream<Item = Result<Bytes, ConnectionError>> + Send>>;
type Sending = Pin<Box<dyn Future<Output = Result<(), SendDatagramError>> + Send>>;

/// WebTransport connection of a user.
struct Way {
    link: Link,
    send: SendStream,
    receive: RecvStream,
    incoming: Incoming,
    session: Session,
    /// Received bytes of an incomplete frame of the stream.
    came: BytesMut,
    /// Bytes that the stream has not accepted yet, and the arrival times of the poses among them.
    written: BytesMut,
    read: Vec<std::time::Instant>,
    /// Datagram that waits for buffer space; it wakes this task, and is composed anew then.
    waiting: Option<Sending>,
    /// Number of bytes received so far.
    heard: u64,
    /// Time of the stream's last progress.
    moved: Instant,
    begun: Instant,
    /// Timeout for a user who does not read.
    silence: Duration,
    clock: Pin<Box<Sleep>>,
}

/// Serves a user whose WebTransport session has begun; returns the reason for its end.
pub async fn serve(mut session: Session, link: Link, silence: Duration) -> Reason {
    let rooms = Arc::clone(&session.rooms);
    rooms.figures.datagrams.inc();
    let begun = Instant::now();
    let mut heard = 0;
    let opened = accept_stream(&mut session, &link, begun + rooms.limits.hello, &mut heard).await;
    let (end, mut told) = match opened {
        Ok(streams) => follow(session, link, streams, begun, silence, heard).await,
        Err(end) => {
            session.end(end.reason);
            (end, Told { link, stream: None })
        }
    };
    let _ = timeout(rooms.limits.linger, told.farewell(&end)).await;
    told.link.close(end.reason.close_code(), end.reason.name());
    rooms.figures.datagrams.dec();
    end.reason
}

/// Waits until the user opens its stream, or until the end.
async fn accept_stream(
    session: &mut Session,
    link: &Link,
    until: Instant,
    heard: &mut u64,
) -> Result<(SendStream, RecvStream), End> {
    let mut streams = pin!(timeout_at(until, link.stream()));
    // Arriving datagrams do not wake this task, because nothing reads them yet.
    let mut clock = interval(COUNTED);
    poll_fn(|context| {
        while clock.poll_tick(context).is_ready() {
            count(session, &link.connection, heard)?;
        }
        session.outbox.register(context.waker());
        if let Some(end) = session.outbox.ended() {
            return Poll::Ready(Err(end));
        }
        streams.as_mut().poll(context).map(|opened| match opened {
            Ok(Ok(streams)) => Ok(streams),
            Ok(Err(_)) => Err(broken(&link.connection)),
            Err(_) => Err(End::new(Reason::Silent, "expected hello")),
        })
    })
    .await
}

/// Serves a user until the end; also returns the channel for the final message.
async fn follow(
    session: Session,
    link: Link,
    (send, receive): (SendStream, RecvStream),
    begun: Instant,
    silence: Duration,
    heard: u64,
) -> (End, Told) {
    let connection = link.connection.clone();
    let incoming: Incoming = Box::pin(stream::unfold(connection, |connection| async move {
        Some((connection.read_datagram().await, connection))
    }));
    let (came, written, read, waiting) = (BytesMut::new(), BytesMut::new(), Vec::new(), None);
    let clock = Box::pin(sleep_until(begun));
    let moved = begun;
    let mut way = Way {
        link,
        send,
        receive,
        incoming,
        session,
        came,
        written,
        read,
        waiting,
        heard,
        moved,
        begun,
        silence,
        clock,
    };
    let end = poll_fn(|context| way.poll(context)).await;
    way.session.end(end.reason);
    (end, Told { link: way.link, stream: Some((way.send, way.written)) })
}

impl Way {
    fn poll(&mut self, context: &mut Context<'_>) -> Poll<End> {
        // Registered before polling, so that no frame added meanwhile is missed.
        self.session.outbox.register(context.waker());
        let end = match self.poll_end(context) {
            Err(end) => Some(end),
            Ok(Poll::Ready(())) => Some(End::new(Reason::Bye, "the user left")),
            Ok(Poll::Pending) => None,
        };
        end.map_or(Poll::Pending, Poll::Ready)
    }

    /// Does all work that is possible now; ready when the user has ended the session.
    fn poll_end(&mut self, context: &mut Context<'_>) -> Result<Poll<()>, End> {
        count(&mut self.session, &self.link.connection, &mut self.heard)?;
        // Datagrams that arrive before hello are dropped.
        self.read_datagrams(context)?;
        self.read_stream(context)?;
        if self.link.poll_ended(context).is_ready() {
            return self.link.connection.close_reason().map_or(Ok(Poll::Ready(())), |error| Err(lost(error)));
        }
        self.look_at_clock(context)?;
        self.write_stream(context)?;
        self.write_datagrams(context)?;
        Ok(Poll::Pending)
    }

    fn read_stream(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        let mut piece = [0; READ];
        for _ in 0..ROW {
            let Poll::Ready(polled) = self.receive.poll_read(context, &mut piece) else { return Ok(()) };
            match polled {
                Ok(0) if self.came.is_empty() => return Err(End::new(Reason::Bye, "the user left")),
                Ok(0) => return Err(End::new(Reason::Frame, "expected a whole frame before the stream's end")),
                Ok(length) => self.came.extend_from_slice(&piece[..length]),
                Err(ReadError::ConnectionLost(error)) => return Err(lost(error)),
                Err(_) => return Err(broken_connection()),
            }
            self.take_frames()?;
        }
        context.waker().wake_by_ref();
        Ok(())
    }

    /// Processes the complete frames of the received bytes. Each counts as a message.
    fn take_frames(&mut self) -> Result<(), End> {
        let most = self.session.rooms.limits.message_bytes;
        while let Some(head) = self.came.first_chunk::<HEAD>() {
            let length = HEAD + usize::from(u16::from_le_bytes([head[1], head[2]]));
            if length > most {
                return Err(End::new(Reason::Frame, format!("expected frames of at most {most} bytes")));
            }
            if self.came.len() < length {
                break;
            }
            let frame = self.came.split_to(length);
            self.session.message(&frame, std::time::Instant::now())?;
        }
        Ok(())
    }

    fn read_datagrams(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        for _ in 0..ROW {
            let Poll::Ready(Some(came)) = self.incoming.as_mut().poll_next(context) else { return Ok(()) };
            let bytes = came.map_err(lost)?;
            let frames = payload(&bytes).ok_or_else(|| End::new(Reason::Frame, "expected datagrams of the session"))?;
            self.session.datagram(frames, std::time::Instant::now())?;
        }
        context.waker().wake_by_ref();
        Ok(())
    }

    /// Checks the timeouts for silence and for not reading. Frames are not delayed by this timer.
    fn look_at_clock(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        let limits = self.session.rooms.limits;
        while self.clock.as_mut().poll(context).is_ready() {
            let now = Instant::now();
            if !self.session.is_in() && now >= self.begun + limits.hello {
                return Err(End::new(Reason::Silent, "expected hello"));
            }
            if !self.written.is_empty() && now >= self.moved + self.silence {
                return Err(End::new(Reason::Slow, "expected a client that reads"));
            }
            let deadline = if self.session.is_in() { self.moved + self.silence } else { self.begun + limits.hello };
            // Periodic wake-ups also count received bytes that were not for any reader.
            let next = now + limits.ping;
            self.clock.as_mut().reset(if deadline > now { next.min(deadline) } else { next });
        }
        Ok(())
    }

    /// Writes reliable frames as soon as the stream has accepted the previous ones.
    fn write_stream(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        loop {
            while !self.written.is_empty() {
                match Pin::new(&mut self.send).poll_write(context, &self.written) {
                    // A user who does not read must not delay the end.
                    Poll::Pending => return self.session.outbox.ended().map_or(Ok(()), Err),
                    Poll::Ready(Ok(length)) => self.written.advance(length),
                    Poll::Ready(Err(WriteError::ConnectionLost(error))) => return Err(lost(error)),
                    Poll::Ready(Err(_)) => return Err(broken_connection()),
                }
                self.moved = Instant::now();
            }
            let read = std::mem::take(&mut self.read);
            self.wrote(read.into_iter());
            match self.session.outbox.take(Part::Lasting, &mut self.written, &mut self.read) {
                Taken::End(end) => return Err(end),
                Taken::Message => self.moved = Instant::now(),
                Taken::Nothing => return Ok(()),
            }
        }
    }

    /// Sends the newest poses as datagrams while the connection accepts them; otherwise newer poses replace waiting
    /// ones.
    fn write_datagrams(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        self.waiting = None;
        loop {
            let passing = self.session.outbox.passing(self.link.most().min(DATAGRAM));
            if passing.bytes.is_empty() {
                return Ok(());
            }
            let (connection, bytes) = (self.link.connection.clone(), datagram(&passing.bytes));
            let mut sending: Sending = Box::pin(async move { connection.send_datagram_wait(bytes).await });
            match sending.as_mut().poll(context) {
                Poll::Pending => {
                    self.waiting = Some(sending);
                    return Ok(());
                }
                Poll::Ready(Ok(())) => {
                    let outbox = Arc::clone(&self.session.outbox);
                    self.wrote(outbox.confirm_sent(&passing));
                }
                // The path MTU has shrunk meanwhile; the loop composes a smaller datagram.
                Poll::Ready(Err(SendDatagramError::TooLarge)) => {}
                Poll::Ready(Err(SendDatagramError::ConnectionLost(error))) => return Err(lost(error)),
                Poll::Ready(Err(_)) => return Err(broken_connection()),
            }
        }
    }

    /// Records that poses were written; `read` has their arrival times.
    fn wrote(&self, read: impl ExactSizeIterator<Item = std::time::Instant>) {
        let now = std::time::Instant::now();
        self.session.rooms.figures.written(read.map(|read| now.saturating_duration_since(read)));
    }
}

/// Counts newly received network bytes, including packet headers.
fn count(session: &mut Session, connection: &Connection, heard: &mut u64) -> Result<(), End> {
    let all = connection.stats().udp_rx.bytes;
    let came = all - std::mem::replace(heard, all);
    session.took(usize::try_from(came).unwrap_or(usize::MAX), std::time::Instant::now())
}

/// Parts of a connection needed for the final message.
struct Told {
    link: Link,
    /// The stream, and the rest of a partly written frame.
    stream: Option<(SendStream, BytesMut)>,
}

impl Told {
    /// Sends the reason and waits until the user has ended the session, so that all written data arrive. Data from the
    /// user are no longer read.
    async fn farewell(&mut self, end: &End) {
        if end.reason == Reason::Gone || self.link.connection.close_reason().is_some() {
            return;
        }
        if let Some((send, rest)) = &mut self.stream {
            if end.reason != Reason::Bye {
                FromServer::Refused { code: end.reason.code(), sentence: &end.sentence }.write(rest);
            }
            // The stream is acknowledged before the session is ended.
            if send.write_all(rest).await.is_ok() && send.finish().is_ok() {
                let _ = send.stopped().await;
            }
        }
        if self.link.end(end.reason.close_code(), end.reason.name()).await.is_ok() {
            poll_fn(|context| self.link.poll_ended(context)).await;
            // A browser loses the close code if the connection is closed before it has closed it itself.
            self.link.connection.closed().await;
        }
    }
}

/// End for a connection whose stream was not opened properly.
fn broken(connection: &Connection) -> End {
    match connection.close_reason() {
        Some(error) => lost(error),
        None => End::new(Reason::Frame, "expected a stream of the session"),
    }
}

/// End for a connection error.
fn lost(error: ConnectionError) -> End {
    match error {
        ConnectionError::TimedOut => End::new(Reason::Silent, "expected an answer to a ping"),
        ConnectionError::ApplicationClosed(_) => End::new(Reason::Bye, "the user left"),
        ConnectionError::TransportError(error) => End::new(Reason::Frame, error.to_string()),
        _ => broken_connection(),
    }
}
