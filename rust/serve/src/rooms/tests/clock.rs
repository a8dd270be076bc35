//! Time that passes without messages, by a clock that the tests turn.

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

use super::support::{User, limits};
use crate::rooms::frame::FromUser;
use crate::rooms::{Entering, Limits, Reason, Rooms, Session, serve};

const SECOND: Duration = Duration::from_secs(1);

/// A user's connection within this process, and why it ends.
async fn user(limits: Limits) -> (User<DuplexStream>, JoinHandle<Reason>) {
    let rooms = Arc::new(Rooms::new(limits, None).expect("there are random bytes"));
    let (near, far) = duplex(1 << 12);
    let entering = Entering { room: "hall".into(), token: None };
    let session = Session::new(rooms, entering, Instant::now().into_std());
    let served = tokio::spawn(serve(session, far, Bytes::new()));
    (User::new(WebSocketStream::from_raw_socket(near, Role::Client, None).await), served)
}

#[tokio::test(start_paused = true)]
async fn who_says_no_hello_is_ended() {
    let (mut user, served) = user(limits()).await;
    let begun = Instant::now();
    assert_eq!(user.is_refused(Reason::Silent).await, "expected hello");
    assert_eq!(begun.elapsed().as_secs(), 10);
    assert_eq!(served.await.expect("it ended"), Reason::Silent);
}

#[tokio::test(start_paused = true)]
async fn who_only_pings_before_hello_is_ended_at_the_same_time() {
    let (mut user, served) = user(limits()).await;
    let begun = Instant::now();
    while user.socket.send(Message::Ping(Bytes::new())).await.is_ok() {
        let _ = timeout(SECOND, user.socket.next()).await;
        tokio::time::sleep(SECOND).await;
    }
    drop(user);
    assert_eq!(served.await.expect("it ended"), Reason::Silent);
    assert!(begun.elapsed() <= 15 * SECOND);
}

#[tokio::test(start_paused = true)]
async fn who_answers_no_ping_is_ended() {
    let (mut user, served) = user(limits()).await;
    user.hello(0, "", &[]).await;
    let begun = Instant::now();
    // It does not look at its socket, so no ping is answered.
    while !served.is_finished() {
        tokio::time::sleep(SECOND / 10).await;
    }
    assert_eq!(served.await.expect("it ended"), Reason::Silent);
    let limits = limits();
    let most = limits.silence + limits.linger + SECOND;
    assert!((limits.silence..most).contains(&begun.elapsed()), "{:?}", begun.elapsed());
}

#[tokio::test(start_paused = true)]
async fn who_answers_pings_stays() {
    let (mut user, served) = user(limits()).await;
    user.hello(0, "", &[]).await;
    let (begun, mut pings) = (Instant::now(), 0);
    while begun.elapsed() < 3600 * SECOND {
        // Reading answers.
        match timeout(60 * SECOND, user.socket.next()).await.expect("a ping").expect("the connection lives") {
            Ok(Message::Ping(_)) => pings += 1,
            other => panic!("{other:?}"),
        }
    }
    assert!((350..=361).contains(&pings), "{pings}");
    assert!(!served.is_finished());
}

#[tokio::test(start_paused = true)]
async fn who_does_not_close_is_left_behind() {
    let limits = limits();
    let (mut user, served) = user(limits).await;
    user.hello(0, "", &[]).await;
    let begun = Instant::now();
    user.send(&[FromUser::Bye]).await;
    assert_eq!(served.await.expect("it ended"), Reason::Bye);
    assert!((limits.linger..limits.linger + SECOND).contains(&begun.elapsed()));
}

#[tokio::test(start_paused = true)]
async fn who_floods_is_not_read_on() {
    let limits = Limits { messages_per_second: 1e-6, burst: Duration::from_secs(5_000_000), ..limits() };
    let (mut user, served) = user(limits).await;
    user.hello(0, "", &[]).await;
    while user.socket.send(Message::binary(Vec::new())).await.is_ok() && !user.is_ended().await {}
    let begun = Instant::now();
    // More than the stream holds.
    let more = user.socket.get_mut().write_all(&[0; 1 << 14]).await;
    assert!(more.is_err(), "it is taken");
    assert!(begun.elapsed() >= limits.linger - SECOND, "{:?}", begun.elapsed());
    assert_eq!(served.await.expect("it ended"), Reason::Flood);
}

#[tokio::test(start_paused = true)]
async fn a_message_that_comes_byte_by_byte_is_read() {
    let (mut user, served) = user(limits()).await;
    user.hello(0, "", &[]).await;
    let mut message = vec![0x82, 0x80 | 3, 0, 0, 0, 0];
    FromUser::Bye.write(&mut message);
    for byte in message {
        user.socket.get_mut().write_all(&[byte]).await.expect("sent");
        tokio::time::sleep(20 * SECOND).await;
    }
    assert_eq!(served.await.expect("it ended"), Reason::Bye);
}
