//! Departures: a seat is free before its user is notified, so the same token can rejoin at once.

use std::collections::HashMap;
use std::net::{Ipv4Addr, SocketAddr};
use std::sync::Arc;
use std::time::Duration;

use futures_util::future::join_all;
use futures_util::{SinkExt, StreamExt};
use tokio::net::UdpSocket;
use tokio::time::{sleep, timeout};
use tokio_tungstenite::tungstenite::Message;

use super::session_support::{self, connect_at};
use super::support::{HANGS, Transport, User, connect, limits, server};
use crate::rooms::frame::FromUser;
use crate::rooms::{Datagrams, Key, Reason};

const ROUNDS: u8 = 40;
/// Additional delay of a slow path.
const LATE: Duration = Duration::from_millis(5);

fn key() -> Key {
    Key::new(&[1; 16]).expect("a key")
}

/// Path to the room with one of many tokens.
fn path(number: u8) -> String {
    format!("/rooms/hall?token={}", key().token("hall", u64::MAX, [number; 16]))
}

/// Reads until the server sends a close frame.
async fn until_closed(user: &mut User) {
    loop {
        let message = timeout(HANGS, user.transport.next()).await.expect("a message").expect("no end before the close");
        if message.expect("no error before the close").is_close() {
            return;
        }
    }
}

#[tokio::test]
async fn a_seat_is_free_when_the_server_closes_the_socket() {
    let server = server(limits(), Some(key()));
    for round in 0..ROUNDS {
        let mut user = connect(server.address(), &path(0)).await.expect("a connection");
        // Also without waiting for the welcome.
        if round % 2 == 0 {
            user.hello(0, "", &[]).await;
        } else {
            user.send(&[FromUser::Hello { group: 0, name: "", ticket: &[] }]).await;
        }
        if round % 3 > 0 {
            user.send(&[FromUser::Bye]).await;
        }
        if round % 3 < 2 {
            user.transport.send(Message::Close(None)).await.expect("the server reads");
        }
        until_closed(&mut user).await;
        // The old connection still exists; the server has not read the reply to its close frame.
        let mut again = connect(server.address(), &path(0)).await.expect("a connection");
        again.hello(0, "", &[]).await;
        again.send(&[FromUser::Bye]).await;
        until_closed(&mut again).await;
    }
}

#[tokio::test]
async fn a_seat_is_free_when_the_server_ends_the_session_of_a_slow_way() {
    let server = server(limits(), Some(key()));
    let fast = server.datagrams().expect("datagrams");
    let slow = Datagrams { port: slow_way(fast.port).await, ..fast.clone() };
    let rounds = (0..ROUNDS).map(async |round| {
        let path = path(round);
        let mut user = connect_at(slow.clone(), &path).await;
        user.hello(0, "", &[]).await;
        if round % 2 == 0 {
            user.send(&[FromUser::Bye]).await;
        }
        user.transport.send.finish().await.expect("the server reads");
        user.transport.is_closed(Reason::Bye).await;
        let mut again = session_support::connect(&server, &path).await;
        again.hello(0, "", &[]).await;
        again.send(&[FromUser::Bye]).await;
        again.transport.is_closed(Reason::Bye).await;
    });
    join_all(rounds).await;
}

/// Port of a UDP relay to another port that delays packets to the server.
async fn slow_way(port: u16) -> u16 {
    let local = SocketAddr::from((Ipv4Addr::LOCALHOST, 0));
    let near = Arc::new(UdpSocket::bind(local).await.expect("a socket"));
    let own = near.local_addr().expect("an address").port();
    tokio::spawn(async move {
        let mut clients = HashMap::new();
        let mut packet = [0; 1 << 16];
        while let Ok((length, client)) = near.recv_from(&mut packet).await {
            let far = match clients.get(&client) {
                Some(far) => Arc::clone(far),
                None => {
                    let far = Arc::new(UdpSocket::bind(local).await.expect("a socket"));
                    far.connect((Ipv4Addr::LOCALHOST, port)).await.expect("an address");
                    tokio::spawn(pass_back(Arc::clone(&far), Arc::clone(&near), client));
                    clients.insert(client, Arc::clone(&far));
                    far
                }
            };
            let bytes = packet[..length].to_vec();
            tokio::spawn(async move {
                sleep(LATE).await;
                let _ = far.send(&bytes).await;
            });
        }
    });
    own
}

async fn pass_back(far: Arc<UdpSocket>, near: Arc<UdpSocket>, client: SocketAddr) {
    let mut packet = [0; 1 << 16];
    // The server may have closed its port at the end.
    while let Ok(length) = far.recv(&mut packet).await {
        let _ = near.send_to(&packet[..length], client).await;
    }
}
