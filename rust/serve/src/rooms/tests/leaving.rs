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
use super::support::{TEST_TIMEOUT, Transport, User, connect, limits, server};
use crate::rooms::frame::FromUser;
use crate::rooms::{Datagrams, Key, Reason};

const ROUNDS: u8 = 40;
/// Additional delay of packets to the server on a slow path.
const DELAY: Duration = Duration::from_millis(5);

fn key() -> Key {
    Key::new(&[1; 16]).expect("a key")
}

/// Path to the room with a token of this number.
fn path(number: u8) -> String {
    format!("/rooms/hall?token={}", key().token("hall", u64::MAX, [number; 16]))
}

/// Reads until the server sends a close frame.
async fn wait_for_close(user: &mut User) {
    loop {
        let message =
            timeout(TEST_TIMEOUT, user.transport.next()).await.expect("a message").expect("no end before the close");
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
        // Every second user does not wait for the welcome.
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
        wait_for_close(&mut user).await;
        // The old connection still exists; the server has not read the reply to its close frame.
        let mut again = connect(server.address(), &path(0)).await.expect("a connection");
        again.hello(0, "", &[]).await;
        again.send(&[FromUser::Bye]).await;
        wait_for_close(&mut again).await;
    }
}

#[tokio::test]
async fn a_seat_is_free_when_the_server_ends_a_session_over_a_slow_path() {
    let server = server(limits(), Some(key()));
    let fast = server.datagrams().expect("datagrams");
    let slow = Datagrams { port: start_slow_relay(fast.port).await, ..fast.clone() };
    let rounds = (0..ROUNDS).map(async |round| {
        let path = path(round);
        let mut user = connect_at(slow.clone(), &path).await;
        user.hello(0, "", &[]).await;
        if round % 2 == 0 {
            user.send(&[FromUser::Bye]).await;
        }
        user.transport.send.finish().await.expect("the server reads");
        user.transport.expect_close(Reason::Bye).await;
        let mut again = session_support::connect(&server, &path).await;
        again.hello(0, "", &[]).await;
        again.send(&[FromUser::Bye]).await;
        again.transport.expect_close(Reason::Bye).await;
    });
    join_all(rounds).await;
}

/// Starts a UDP relay that delays packets to the server at a port; returns the relay's port.
async fn start_slow_relay(port: u16) -> u16 {
    let local = SocketAddr::from((Ipv4Addr::LOCALHOST, 0));
    let client_side = Arc::new(UdpSocket::bind(local).await.expect("a socket"));
    let relay_port = client_side.local_addr().expect("an address").port();
    tokio::spawn(async move {
        let mut clients = HashMap::new();
        let mut packet = [0; 1 << 16];
        while let Ok((length, client)) = client_side.recv_from(&mut packet).await {
            let server_side = match clients.get(&client) {
                Some(server_side) => Arc::clone(server_side),
                None => {
                    let server_side = Arc::new(UdpSocket::bind(local).await.expect("a socket"));
                    server_side.connect((Ipv4Addr::LOCALHOST, port)).await.expect("an address");
                    tokio::spawn(relay_answers(Arc::clone(&server_side), Arc::clone(&client_side), client));
                    clients.insert(client, Arc::clone(&server_side));
                    server_side
                }
            };
            let bytes = packet[..length].to_vec();
            tokio::spawn(async move {
                sleep(DELAY).await;
                let _ = server_side.send(&bytes).await;
            });
        }
    });
    relay_port
}

async fn relay_answers(server_side: Arc<UdpSocket>, client_side: Arc<UdpSocket>, client: SocketAddr) {
    let mut packet = [0; 1 << 16];
    // The server may have closed its port at the end.
    while let Ok(length) = server_side.recv(&mut packet).await {
        let _ = client_side.send_to(&packet[..length], client).await;
    }
}
