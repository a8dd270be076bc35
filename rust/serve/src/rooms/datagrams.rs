//! WebTransport transport of a user's frames: reliable frames on a stream, replaceable ones in datagrams.

use std::future::poll_fn;
use std::pin::{Pin, pin};
use std::sync::Arc;
use std::task::{Context, Poll};
use std::time::Duration;

use bytes::{Buf, Bytes, BytesMut};
use futures_util::{Stream, stream};
use quinn::{Connection, ConnectionError, ReadError, RecvStream, SendDatagramError, SendStream, WriteError};
use tokio::time::{Instant, Sleep, interval, sleep_until, timeout, timeout_at};

use super::frame::{FromServer, HEAD_BYTES};
use super::outbox::{Selection, Taken};
use super::reason::{End, Reason};
use super::session::Session;
use crate::clients::{MAX_CONSECUTIVE, READ_BYTES};
use crate::webtransport::session::{Link, datagram, payload};

/// Greatest size of a datagram's frames in bytes; few networks carry larger packets.
pub const MAX_DATAGRAM_BYTES: usize = 1200;
/// Interval at which the received bytes of a user without a stream are counted.
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
    written: BytesMut,
    /// Arrival times of the poses among these bytes.
    received: Vec<std::time::Instant>,
    /// Datagram that waits for buffer space; it wakes this task, and is composed anew then.
    blocked: Option<Sending>,
    /// Network bytes received so far.
    received_bytes: u64,
    /// Time of the stream's last progress.
    last_progress: Instant,
    begun: Instant,
    /// Timeout for a user who does not read.
    silence: Duration,
    timer: Pin<Box<Sleep>>,
}

/// Serves a user whose WebTransport session has begun; returns the reason for its end.
pub async fn serve(mut session: Session, link: Link, silence: Duration) -> Reason {
    let rooms = Arc::clone(&session.rooms);
    rooms.figures.datagrams.inc();
    let begun = Instant::now();
    let mut received_bytes = 0;
    let accepted = accept_stream(&mut session, &link, begun + rooms.limits.hello, &mut received_bytes).await;
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
                written: BytesMut::new(),
                received: Vec::new(),
                blocked: None,
                received_bytes,
                last_progress: begun,
                begun,
                silence,
                timer: Box::pin(sleep_until(begun)),
            };
            let end = poll_fn(|context| transport.work(context).map_or_else(Poll::Ready, |()| Poll::Pending)).await;
            let Transport { session, link, send, written, .. } = transport;
            session.end(end.reason);
            (end, Farewell { link, stream: Some((send, written)) })
        }
    };
    let _ = timeout(rooms.limits.linger, farewell.send(&end)).await;
    farewell.link.close(end.reason.close_code(), end.reason.name());
    rooms.figures.datagrams.dec();
    end.reason
}

/// Waits until the user opens its stream, or until the end.
async fn accept_stream(
    session: &mut Session,
    link: &Link,
    until: Instant,
    received_bytes: &mut u64,
) -> Result<(SendStream, RecvStream), End> {
    let mut streams = pin!(timeout_at(until, link.stream()));
    // Arriving datagrams do not wake this task, because nothing reads them yet.
    let mut timer = interval(COUNT_INTERVAL);
    poll_fn(|context| {
        while timer.poll_tick(context).is_ready() {
            count(session, &link.connection, received_bytes)?;
        }
        session.outbox.register(context.waker());
        if let Some(end) = session.outbox.ended() {
            return Poll::Ready(Err(end));
        }
        streams.as_mut().poll(context).map(|opened| match opened {
            Ok(Ok(streams)) => Ok(streams),
            // The stream was not opened properly.
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
    /// Does all work that is possible now.
    fn work(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        // Registered before polling, so that no frame added meanwhile is missed.
        self.session.outbox.register(context.waker());
        count(&mut self.session, &self.link.connection, &mut self.received_bytes)?;
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
        while let Some(head) = self.incomplete.first_chunk::<HEAD_BYTES>() {
            let length = HEAD_BYTES + usize::from(u16::from_le_bytes([head[1], head[2]]));
            if length > max_bytes {
                return Err(End::new(Reason::Frame, format!("expected frames of at most {max_bytes} bytes")));
            }
            if self.incomplete.len() < length {
                break;
            }
            let frame = self.incomplete.split_to(length);
            self.session.message(&frame, std::time::Instant::now())?;
        }
        Ok(())
    }

    fn read_datagrams(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        for _ in 0..MAX_CONSECUTIVE {
            let Poll::Ready(Some(received)) = self.incoming.as_mut().poll_next(context) else { return Ok(()) };
            let bytes = received?;
            let frames = payload(&bytes).ok_or_else(|| End::new(Reason::Frame, "expected datagrams of the session"))?;
            self.session.datagram(frames, std::time::Instant::now())?;
        }
        context.waker().wake_by_ref();
        Ok(())
    }

    /// Checks the timeouts for silence and for not reading. Frames are not delayed by this timer.
    fn check_timer(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        let limits = self.session.rooms.limits;
        while self.timer.as_mut().poll(context).is_ready() {
            let now = Instant::now();
            if !self.session.is_in() && now >= self.begun + limits.hello {
                return Err(End::new(Reason::Silent, "expected hello"));
            }
            if !self.written.is_empty() && now >= self.last_progress + self.silence {
                return Err(End::new(Reason::Slow, "expected a client that reads"));
            }
            let deadline =
                if self.session.is_in() { self.last_progress + self.silence } else { self.begun + limits.hello };
            // Periodic wake-ups also count received bytes that were not for any reader.
            let next = now + limits.ping;
            self.timer.as_mut().reset(if deadline > now { next.min(deadline) } else { next });
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
                    Poll::Ready(Err(WriteError::ConnectionLost(error))) => return Err(error.into()),
                    Poll::Ready(Err(_)) => return Err(End::broken()),
                }
                self.last_progress = Instant::now();
            }
            self.session.rooms.figures.written(self.received.drain(..));
            match self.session.outbox.take(Selection::Reliable, &mut self.written, &mut self.received) {
                Taken::End(end) => return Err(end),
                Taken::Message => self.last_progress = Instant::now(),
                Taken::Nothing => return Ok(()),
            }
        }
    }

    /// Sends the newest poses as datagrams while the connection accepts them; otherwise newer poses replace waiting
    /// ones.
    fn write_datagrams(&mut self, context: &mut Context<'_>) -> Result<(), End> {
        self.blocked = None;
        loop {
            let queued = self.session.outbox.datagram(self.link.max_payload_bytes().min(MAX_DATAGRAM_BYTES));
            if queued.bytes.is_empty() {
                return Ok(());
            }
            let (connection, bytes) = (self.link.connection.clone(), datagram(&queued.bytes));
            let mut sending: Sending = Box::pin(async move { connection.send_datagram_wait(bytes).await });
            match sending.as_mut().poll(context) {
                Poll::Pending => {
                    self.blocked = Some(sending);
                    return Ok(());
                }
                Poll::Ready(Ok(())) => self.session.rooms.figures.written(self.session.outbox.confirm_sent(&queued)),
                // The path MTU has shrunk meanwhile; the loop composes a smaller datagram.
                Poll::Ready(Err(SendDatagramError::TooLarge)) => {}
                Poll::Ready(Err(SendDatagramError::ConnectionLost(error))) => return Err(error.into()),
                Poll::Ready(Err(_)) => return Err(End::broken()),
            }
        }
    }
}

/// Counts newly received network bytes, with packet headers.
fn count(session: &mut Session, connection: &Connection, received_bytes: &mut u64) -> Result<(), End> {
    let total = connection.stats().udp_rx.bytes;
    let new = total - std::mem::replace(received_bytes, total);
    session.count_bytes(usize::try_from(new).unwrap_or(usize::MAX), std::time::Instant::now())
}

/// Parts of a connection needed for the final message.
struct Farewell {
    link: Link,
    /// The stream, and the rest of a partly written frame.
    stream: Option<(SendStream, BytesMut)>,
}

impl Farewell {
    /// Sends the reason and waits until the user has ended the session, so that all written data arrive. Data from the
    /// user are no longer read.
    async fn send(&mut self, end: &End) {
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
