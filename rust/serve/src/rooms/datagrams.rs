//! Transport of a user's frames by WebTransport: frames that must arrive on a stream, replaceable ones in datagrams.

use std::future::poll_fn;
use std::pin::{Pin, pin};
use std::sync::Arc;
use std::task::{Context, Poll};
use std::time::Duration;

use bytes::{Buf, Bytes, BytesMut};
use futures_util::{Stream, stream};
use quinn::{Connection, ConnectionError, ReadError, RecvStream, SendDatagramError, SendStream, WriteError};
use tokio::time::{Instant, Sleep, interval, sleep_until, timeout, timeout_at};

use super::frame::{FromServer, HEADER_BYTES};
use super::outbox::{Outgoing, Selection};
use super::reason::{End, Reason};
use super::session::Session;
use crate::clients::{MAX_CONSECUTIVE, READ_BYTES};
use crate::webtransport::session::{Link, encode_datagram, payload};

/// Maximum size of a datagram's frames in bytes; few networks carry larger packets.
pub const MAX_DATAGRAM_BYTES: usize = 1200;
/// Interval at which received bytes are counted before the user has opened its stream.
const COUNT_INTERVAL: Duration = Duration::from_millis(100);

type Incoming = Pin<Box<dyn Stream<Item = Result<Bytes, ConnectionError>> + Send>>;
type Sending = Pin<Box<dyn Future<Output = Result<(), SendDatagramError>> + Send>>;

/// WebTransport connection of a user.
struct Transport {
    link: Link,
    send: SendStream,
    receive: RecvStream,
    incoming: Incoming,
    session: Session,
    /// Received bytes of an incomplete frame of the stream.
    incomplete: BytesMut,
    /// Bytes that the stream has not accepted yet.
    unwritten: BytesMut,
    /// Arrival times of the poses among these bytes.
    arrivals: Vec<std::time::Instant>,
    /// Datagram that waits for space in the send buffer. When there is space it wakes this task, which composes a new
    /// datagram of the newest poses.
    blocked: Option<Sending>,
    /// Network bytes received so far.
    received_bytes: u64,
    /// Time of the stream's last progress.
    last_progress: Instant,
    started: Instant,
    /// Timeout for a user who does not read.
    silence: Duration,
    timer: Pin<Box<Sleep>>,
}

/// Serves a user whose WebTransport session is established; returns the reason for its end.
pub async fn serve(mut session: Session, link: Link, silence: Duration) -> Reason {
    let rooms = Arc::clone(&session.rooms);
    rooms.statistics.datagrams.inc();
    let started = Instant::now();
    let mut received_bytes = 0;
    let accepted = accept_stream(&mut session, &link, started + rooms.limits.hello, &mut received_bytes).await;
    let (end, mut farewell) = match accepted {
        Err(end) => {
            session.end(end.reason);
            (end, Farewell { link, stream: None })
        }
        Ok((send, receive)) => {
            let next = |connection: Connection| async { Some((connection.read_datagram().await, connection)) };
            let mut transport = Transport {
                incoming: Box::pin(stream::unfold(link.connection.clone(), next)),
                link,
                send,
                receive,
                session,
                incomplete: BytesMut::new(),
                unwritten: BytesMut::new(),
                arrivals: Vec::new(),
                blocked: None,
                received_bytes,
                last_progress: started,
                started,
                silence,
                timer: Box::pin(sleep_until(started)),
            };
            let end = poll_fn(|context| transport.work(context).map_or_else(Poll::Ready, |()| Poll::Pending)).await;
            let Transport { session, link, send, unwritten, .. } = transport;
            session.end(end.reason);
            (end, Farewell { link, stream: Some((send, unwritten)) })
        }
    };
    let _ = timeout(rooms.limits.linger, farewell.send(&end)).await;
    farewell.link.close(end.reason.close_code(), end.reason.name());
    rooms.statistics.datagrams.dec();
    end.reason
}

/// Waits until the user opens its stream; an error if the connection ends or the deadline passes.
async fn accept_stream(
    session: &mut Session,
    link: &Link,
    deadline: Instant,
    received_bytes: &mut u64,
) -> Result<(SendStream, RecvStream), End> {
    let mut streams = pin!(timeout_at(deadline, link.stream()));
    // Received bytes are counted at intervals, because datagrams, which nothing reads yet, do not wake this task.
    let mut timer = interval(COUNT_INTERVAL);
    poll_fn(|context| {
        while timer.poll_tick(context).is_ready() {
            count_received(session, &link.connection, received_bytes)?;
        }
        session.outbox.register(context.waker());
        if let Some(end) = session.outbox.end_reason() {
            return Poll::Ready(Err(end));
        }
        streams.as_mut().poll(context).map(|opened| match opened {
            Ok(Ok(streams)) => Ok(streams),
            Ok(Err(_)) => Err(link
                .connection
                .close_reason()
                .map_or_else(|| End::new(Reason::Frame, "expected a stream of the session"), End::from)),
            Err(_) => Err(End::new(Reason::Silent, "expected hello")),
        })
    })
    .await
}

impl Transport {
    /// Reads, checks the timeouts and writes as far as possible without waiting.
    fn work(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        // The waker is registered before polling, so that a frame queued meanwhile wakes the task again.
        self.session.outbox.register(context.waker());
        count_received(&mut self.session, &self.link.connection, &mut self.received_bytes)?;
        // Datagrams that arrive before hello are dropped.
        self.read_datagrams(context)?;
        self.read_stream(context)?;
        if self.link.poll_ended(context).is_ready() {
            return Err(self.link.connection.close_reason().map_or_else(End::by_user, End::from));
        }
        self.check_timer(context)?;
        self.write_stream(context)?;
        self.write_datagrams(context)
    }

    fn read_stream(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        let mut piece = [0; READ_BYTES];
        for _ in 0..MAX_CONSECUTIVE {
            let Poll::Ready(polled) = self.receive.poll_read(context, &mut piece) else { return Ok(()) };
            match polled {
                Ok(0) if self.incomplete.is_empty() => return Err(End::by_user()),
                Ok(0) => return Err(End::new(Reason::Frame, "expected a whole frame before the stream's end")),
                Ok(length) => self.incomplete.extend_from_slice(&piece[..length]),
                Err(ReadError::ConnectionLost(error)) => return Err(error.into()),
                Err(_) => return Err(End::broken()),
            }
            self.take_frames()?;
        }
        context.waker().wake_by_ref();
        Ok(())
    }

    /// Processes the complete frames of the received bytes. Each counts as a message.
    fn take_frames(&mut self) -> Result<(), End> {
        let max_bytes = self.session.rooms.limits.message_bytes;
        while let Some(head) = self.incomplete.first_chunk::<HEADER_BYTES>() {
            let length = HEADER_BYTES + usize::from(u16::from_le_bytes([head[1], head[2]]));
            if length > max_bytes {
                return Err(End::new(Reason::Frame, format!("expected frames of at most {max_bytes} bytes")));
            }
            if self.incomplete.len() < length {
                break;
            }
            let frame = self.incomplete.split_to(length);
            self.session.handle_message(&frame, std::time::Instant::now())?;
        }
        Ok(())
    }

    fn read_datagrams(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        for _ in 0..MAX_CONSECUTIVE {
            let Poll::Ready(Some(received)) = self.incoming.as_mut().poll_next(context) else { return Ok(()) };
            let bytes = received?;
            let frames = payload(&bytes).ok_or_else(|| End::new(Reason::Frame, "expected datagrams of the session"))?;
            self.session.handle_datagram(frames, std::time::Instant::now())?;
        }
        context.waker().wake_by_ref();
        Ok(())
    }

    /// Checks the timeouts of users who send no hello or read nothing. The timer does not delay frames.
    fn check_timer(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        let limits = self.session.rooms.limits;
        while self.timer.as_mut().poll(context).is_ready() {
            let now = Instant::now();
            if !self.session.has_joined() && now >= self.started + limits.hello {
                return Err(End::new(Reason::Silent, "expected hello"));
            }
            if !self.unwritten.is_empty() && now >= self.last_progress + self.silence {
                return Err(End::new(Reason::Slow, "expected a client that reads"));
            }
            let deadline =
                if self.session.has_joined() { self.last_progress + self.silence } else { self.started + limits.hello };
            // The wake-ups are periodic, so that received bytes are counted even if none of them is for a reader.
            let next = now + limits.ping;
            self.timer.as_mut().reset(if deadline > now { next.min(deadline) } else { next });
        }
        Ok(())
    }

    /// Writes reliable frames as soon as the stream has accepted the previous ones.
    fn write_stream(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        loop {
            while !self.unwritten.is_empty() {
                match Pin::new(&mut self.send).poll_write(context, &self.unwritten) {
                    // A user who does not read cannot delay the end of the connection.
                    Poll::Pending => return self.session.outbox.end_reason().map_or(Ok(()), Err),
                    Poll::Ready(Ok(length)) => self.unwritten.advance(length),
                    Poll::Ready(Err(WriteError::ConnectionLost(error))) => return Err(error.into()),
                    Poll::Ready(Err(_)) => return Err(End::broken()),
                }
                self.last_progress = Instant::now();
            }
            self.session.rooms.statistics.count_forwarded(self.arrivals.drain(..));
            match self.session.outbox.take(Selection::Reliable, &mut self.unwritten, &mut self.arrivals) {
                Outgoing::End(end) => return Err(end),
                Outgoing::Message => self.last_progress = Instant::now(),
                Outgoing::Nothing => return Ok(()),
            }
        }
    }

    /// Sends the newest poses as datagrams while the connection accepts them; while it does not, newer poses replace
    /// those in the outbox.
    fn write_datagrams(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        self.blocked = None;
        loop {
            let queued = self.session.outbox.datagram(self.link.max_payload_bytes().min(MAX_DATAGRAM_BYTES));
            if queued.bytes.is_empty() {
                return Ok(());
            }
            let (connection, bytes) = (self.link.connection.clone(), encode_datagram(&queued.bytes));
            let mut sending: Sending = Box::pin(async move { connection.send_datagram_wait(bytes).await });
            match sending.as_mut().poll(context) {
                Poll::Pending => {
                    self.blocked = Some(sending);
                    return Ok(());
                }
                Poll::Ready(Ok(())) => {
                    self.session.rooms.statistics.count_forwarded(self.session.outbox.confirm_sent(&queued))
                }
                // The path MTU has shrunk meanwhile; the loop composes a smaller datagram.
                Poll::Ready(Err(SendDatagramError::TooLarge)) => {}
                Poll::Ready(Err(SendDatagramError::ConnectionLost(error))) => return Err(error.into()),
                Poll::Ready(Err(_)) => return Err(End::broken()),
            }
        }
    }
}

/// Counts newly received bytes of UDP, with QUIC's headers.
fn count_received(session: &mut Session, connection: &Connection, received_bytes: &mut u64) -> Result<(), End> {
    let total = connection.stats().udp_rx.bytes;
    let new = total - std::mem::replace(received_bytes, total);
    session.count_bytes(usize::try_from(new).unwrap_or(usize::MAX), std::time::Instant::now())
}

/// Parts of a connection that are needed to send the reason for its end.
struct Farewell {
    link: Link,
    /// The stream, and the rest of a partly written frame.
    stream: Option<(SendStream, BytesMut)>,
}

impl Farewell {
    /// Sends the reason and waits until the user has ended the session, so that all written data arrive. The user's
    /// data are no longer read.
    async fn send(&mut self, end: &End) {
        if end.reason == Reason::Gone || self.link.connection.close_reason().is_some() {
            return;
        }
        if let Some((send, rest)) = &mut self.stream {
            if end.reason != Reason::Bye {
                FromServer::Refused { code: end.reason.code(), sentence: &end.sentence }.write(rest);
            }
            // The session is ended after the client has acknowledged the stream.
            if send.write_all(rest).await.is_ok() && send.finish().is_ok() {
                let _ = send.stopped().await;
            }
        }
        if self.link.end(end.reason.close_code(), end.reason.name()).await.is_ok() {
            poll_fn(|context| self.link.poll_ended(context)).await;
            // The browser closes the connection first; otherwise it would not report the close code to the page.
            self.link.connection.closed().await;
        }
    }
}

impl From<ConnectionError> for End {
    fn from(error: ConnectionError) -> Self {
        match error {
            ConnectionError::TimedOut => End::new(Reason::Silent, "expected an answer to a ping"),
            ConnectionError::ApplicationClosed(_) => End::by_user(),
            ConnectionError::TransportError(error) => End::new(Reason::Frame, error.to_string()),
            _ => End::broken(),
        }
    }
}
