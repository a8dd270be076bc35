//! Timeouts, tested with a virtual clock.

use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;

use bytes::Bytes;
use futures_util::{SinkExt, StreamExt};
use tokio::io::{AsyncWriteExt, DuplexStream, duplex};
use tokio::task::JoinHandle;
use tokio::time::{Instant, timeout};
use tokio_tungstenite::WebSocketStream;
use tokio_tungstenite::tungstenite::Message;
use tokio_tungstenite::tungstenite::protocol::Role;

use super::support::{Transport, User, limits, pose};
use crate::rooms::frame::{FromServer, FromUser};
use crate::rooms::outbox::Outbox;
use crate::rooms::{Entrance, Limits, Reason, Rooms, Session, serve};

/// A user within this process.
type LocalUser = User<WebSocketStream<DuplexStream>>;

const SECOND: Duration = Duration::from_secs(1);

/// Connects a user within this process; returns the user, the task that returns the reason for its end, and its outbox.
async fn connect(limits: Limits) -> (LocalUser, JoinHandle<Reason>, Arc<Outbox>) {
    let (user, serving, outbox) = connect_unserved(limits).await;
    (user, tokio::spawn(serving), outbox)
}

/// Like `connect`, for a user that has joined.
async fn join(limits: Limits) -> (LocalUser, JoinHandle<Reason>, Arc<Outbox>) {
    let (mut user, served, outbox) = connect(limits).await;
    user.hello(0, "", &[]).await;
    (user, served, outbox)
}

/// Like `connect`, but the test drives the connection's future.
async fn connect_unserved(limits: Limits) -> (LocalUser, impl Future<Output = Reason>, Arc<Outbox>) {
    let rooms = Arc::new(Rooms::new(limits, None).expect("there are random bytes"));
    let (near, far) = duplex(1 << 12);
    let client = rooms.count_client([127, 0, 0, 1].into(), 1).expect("a free connection");
    let entrance = Entrance { room: "hall".to_owned(), token: None, client };
    let session = Session::new(rooms, entrance, Instant::now().into_std());
    let outbox = Arc::clone(&session.outbox);
    let user = User::new(WebSocketStream::from_raw_socket(near, Role::Client, None).await);
    (user, serve(session, far, Bytes::new()), outbox)
}

/// Whether the server ends the connection within a second.
async fn is_ended(user: &mut LocalUser) -> bool {
    let next = timeout(SECOND, user.transport.next()).await;
    matches!(next, Ok(None | Some(Err(_) | Ok(Message::Close(_)))))
}

#[tokio::test(start_paused = true)]
async fn users_without_hello_are_disconnected() {
    let (mut user, served, _) = connect(limits()).await;
    let begun = Instant::now();
    assert_eq!(user.expect_refusal(Reason::Silent).await, "expected hello");
    assert_eq!(begun.elapsed().as_secs(), 10);
    assert_eq!(served.await.expect("it ended"), Reason::Silent);
}

#[tokio::test(start_paused = true)]
async fn pings_before_hello_do_not_extend_the_timeout() {
    let (mut user, served, _) = connect(limits()).await;
    let begun = Instant::now();
    while user.transport.send(Message::Ping(Bytes::new())).await.is_ok() {
        let _ = timeout(SECOND, user.transport.next()).await;
        tokio::time::sleep(SECOND).await;
    }
    drop(user);
    assert_eq!(served.await.expect("it ended"), Reason::Silent);
    assert!(begun.elapsed() <= 15 * SECOND);
}

#[tokio::test(start_paused = true)]
async fn users_who_do_not_answer_pings_are_disconnected() {
    let (_user, served, _) = join(limits()).await;
    let begun = Instant::now();
    // The user does not poll its socket, so no ping is answered.
    while !served.is_finished() {
        tokio::time::sleep(SECOND / 10).await;
    }
    assert_eq!(served.await.expect("it ended"), Reason::Silent);
    let limits = limits();
    let most = limits.silence + limits.linger + SECOND;
    assert!((limits.silence..most).contains(&begun.elapsed()), "{:?}", begun.elapsed());
}

#[tokio::test(start_paused = true)]
async fn users_who_answer_pings_stay() {
    let (mut user, served, _) = join(limits()).await;
    let (begun, mut pings) = (Instant::now(), 0);
    while begun.elapsed() < 3600 * SECOND {
        // Polling the socket answers pings.
        match timeout(60 * SECOND, user.transport.next()).await.expect("a ping").expect("the connection lives") {
            Ok(Message::Ping(_)) => pings += 1,
            other => panic!("{other:?}"),
        }
    }
    assert!((350..=361).contains(&pings), "{pings}");
    assert!(!served.is_finished());
}

#[tokio::test(start_paused = true)]
async fn clients_that_do_not_close_are_abandoned() {
    let limits = limits();
    let (mut user, served, _) = join(limits).await;
    let begun = Instant::now();
    user.send(&[FromUser::Bye]).await;
    assert_eq!(served.await.expect("it ended"), Reason::Bye);
    assert!((limits.linger..limits.linger + SECOND).contains(&begun.elapsed()));
}

#[tokio::test(start_paused = true)]
async fn flooding_clients_are_not_read_further() {
    let limits = Limits { messages_per_second: 1e-6, burst: Duration::from_secs(5_000_000), ..limits() };
    let (mut user, served, _) = join(limits).await;
    while user.transport.send(Message::binary(Vec::new())).await.is_ok() && !is_ended(&mut user).await {}
    let begun = Instant::now();
    // More bytes than the stream can buffer.
    let more = user.transport.get_mut().write_all(&[0; 1 << 14]).await;
    assert!(more.is_err(), "the bytes are read");
    assert!(begun.elapsed() >= limits.linger - SECOND, "{:?}", begun.elapsed());
    assert_eq!(served.await.expect("it ended"), Reason::Flood);
}

/// A user whose stream is full, so that nothing more can be written, with another frame queued.
async fn join_with_full_stream(limits: Limits) -> (LocalUser, JoinHandle<Reason>, Arc<Outbox>) {
    let (user, served, outbox) = join(limits).await;
    outbox.add(&FromServer::Signal { user: 9, payload: &[0; 4096] });
    tokio::time::sleep(SECOND).await;
    outbox.add(&FromServer::Signal { user: 9, payload: b"behind" });
    (user, served, outbox)
}

#[tokio::test(start_paused = true)]
async fn a_ping_precedes_queued_messages() {
    let (mut user, _served, _outbox) = join_with_full_stream(limits()).await;
    tokio::time::sleep(12 * SECOND).await;
    let mut next = async || user.transport.next().await.expect("a message").expect("the connection lives");
    assert!(matches!(next().await, Message::Binary(bytes) if bytes.len() > 4096));
    assert!(matches!(next().await, Message::Ping(_)));
    assert!(matches!(next().await, Message::Binary(_)));
}

#[tokio::test(start_paused = true)]
async fn unread_pongs_are_bounded() {
    let limits = Limits { queue_bytes: 2000, users: 2, silence: 100 * SECOND, ..limits() };
    let (mut user, served, _) = join(limits).await;
    // The user sends pings and reads nothing: the stream buffers 4 KiB of pongs, and so does the connection.
    for _ in 0..10_000 {
        user.transport.get_mut().write_all(&[0x89, 0x80, 0, 0, 0, 0]).await.expect("it is read");
    }
    tokio::time::sleep(11 * SECOND).await;
    // Then the user reads all that was written, which is only the buffered pongs.
    let mut answers = 0;
    let reason = loop {
        match timeout(SECOND, user.transport.next()).await {
            Ok(Some(Ok(Message::Pong(_)))) => answers += 1,
            Ok(Some(Ok(_))) => {}
            Ok(_) => break Some(served.await.expect("it ended")),
            Err(_) => break None,
        }
    };
    assert!(answers < 5000, "{answers}");
    assert_eq!(reason, Some(Reason::Slow));
}

#[tokio::test(start_paused = true)]
async fn after_a_refusal_at_most_one_message_is_read() {
    let limits = Limits { linger: 100 * SECOND, ..limits() };
    let (mut user, served, _) = join(limits).await;
    user.transport.send_bytes(vec![0xff; 100]).await;
    // The frames are well-formed, so the server could read on for ever.
    let frame = [&[0x82, 0xfe, 4, 0, 0, 0, 0, 0][..], &[0; 1024]].concat();
    let mut sent = 0;
    while timeout(SECOND, user.transport.get_mut().write_all(&frame)).await.is_ok_and(|result| result.is_ok()) {
        sent += frame.len();
        assert!(sent < 1 << 20, "the server reads on");
    }
    assert!(sent >= limits.message_bytes, "{sent}");
    assert!(!served.is_finished(), "the reason may be read meanwhile");
    user.expect_refusal(Reason::Frame).await;
    drop(user);
    assert_eq!(served.await.expect("it ended"), Reason::Frame);
}

#[tokio::test(start_paused = true)]
async fn a_close_frame_is_answered() {
    let (mut user, served, _) = join(limits()).await;
    user.transport.send(Message::Close(None)).await.expect("sent");
    let answer = loop {
        match user.transport.next().await {
            Some(Ok(Message::Binary(_))) => {}
            other => break other,
        }
    };
    assert!(matches!(answer, Some(Ok(Message::Close(_)))), "{answer:?}");
    drop(user);
    assert_eq!(served.await.expect("it ended"), Reason::Bye);
}

#[tokio::test(start_paused = true)]
async fn a_pause_of_the_process_disconnects_no_active_user() {
    let (mut user, serving, _) = connect_unserved(limits()).await;
    let mut serving = pin!(serving);
    tokio::select! {
        reason = &mut serving => panic!("{reason:?}"),
        () = user.hello(0, "", &[]) => {}
    }
    tokio::time::sleep(3600 * SECOND).await;
    user.send(&[FromUser::Pose(pose(1))]).await;
    let quiet = async {
        loop {
            match timeout(SECOND, user.transport.next()).await {
                Ok(Some(Ok(Message::Ping(_)))) => {}
                Ok(other) => break Some(other),
                Err(_) => break None,
            }
        }
    };
    tokio::select! {
        reason = &mut serving => panic!("{reason:?}"),
        message = quiet => assert!(message.is_none(), "{message:?}"),
    }
}

#[tokio::test(start_paused = true)]
async fn a_message_that_arrives_byte_by_byte_is_read() {
    let (mut user, served, _) = join(limits()).await;
    let mut message = vec![0x82, 0x80 | 3, 0, 0, 0, 0];
    FromUser::Bye.write(&mut message);
    for byte in message {
        user.transport.get_mut().write_all(&[byte]).await.expect("sent");
        tokio::time::sleep(20 * SECOND).await;
    }
    assert_eq!(served.await.expect("it ended"), Reason::Bye);
}
