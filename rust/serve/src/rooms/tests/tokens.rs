//! Tokens and tickets, on their own and at admission.

use std::sync::Arc;
use std::time::{SystemTime, UNIX_EPOCH};

use super::support::{User, connect, join, limits, pick, server, server_content, start};
use crate::rooms::frame::{FromServer, FromUser};
use crate::rooms::{Key, Limits, Reason, Rooms, TokenNumber};
use crate::{Server, ServerContent};

fn key(byte: u8) -> Key {
    Key::new(&[byte; 16]).expect("a key")
}

/// A token that is valid for an hour.
fn token(key: &Key, room: &str, number: TokenNumber) -> String {
    let now = SystemTime::now().duration_since(UNIX_EPOCH).expect("a time").as_secs();
    key.token(room, now + 3600, number)
}

async fn connect_with_token(server: &Server, room: &str, token: &str) -> User {
    connect(server.address(), &format!("/rooms/{room}?a=b&token={token}")).await.expect("a connection")
}

/// Sends hello and asserts that the user is refused; returns the sentence.
async fn hello_is_refused(mut user: User) -> String {
    user.send(&[FromUser::Hello { group: 0, name: "", ticket: &[] }]).await;
    user.expect_refusal(Reason::Token).await
}

#[test]
fn a_token_is_valid_for_its_room_until_it_ends() {
    let (key, number) = (key(1), [7; 16]);
    let text = key.token("hall", 1000, number);
    assert!(text.starts_with("1000.0707"));
    assert_eq!(key.check("hall", 999, &text), Ok(number));
    assert_eq!(key.check("hall", 1000, &text), Err("expected a token that has not expired"));
    let wrong = Err("expected a token that was made for this room");
    assert_eq!(key.check("hal", 999, &text), wrong);
    assert_eq!(super::tokens::key(2).check("hall", 999, &text), wrong);
    for text in ["", ".", "1000", &text[1..], &text[..text.len() - 2], &format!("{text}.00"), &format!("+{text}")] {
        assert_eq!(key.check("hall", 999, text), wrong, "{text}");
    }
    assert!(Key::new(&[1; 15]).is_err());
}

#[test]
fn a_token_that_was_altered_is_refused() {
    let key = key(1);
    let text = key.token("hall", 1000, [7; 16]);
    for at in 0..text.len() {
        for bit in 0..7 {
            let mut bytes = text.clone().into_bytes();
            bytes[at] ^= 1 << bit;
            let altered = String::from_utf8(bytes).expect("ASCII");
            assert!(key.check("hall", 999, &altered).is_err(), "{altered}");
        }
    }
}

#[test]
fn a_ticket_restores_its_number_in_its_room() {
    let key = key(1);
    let token = Some(&[7; 16]);
    let ticket = key.ticket("hall", token, 513, 1 << 40);
    assert_eq!(key.check_ticket("hall", token, &ticket), Some((513, 1 << 40)));
    assert_eq!(key.check_ticket("room", token, &ticket), None);
    assert_eq!(key.check_ticket("hall", Some(&[8; 16]), &ticket), None, "a ticket is valid only with its token");
    assert_eq!(super::tokens::key(2).check_ticket("hall", token, &ticket), None);
    for at in 0..ticket.len() * 8 {
        let mut altered = ticket;
        altered[at / 8] ^= 1 << (at % 8);
        assert_eq!(key.check_ticket("hall", token, &altered), None);
        assert_eq!(key.check_ticket("hall", token, &ticket[..at / 8]), None);
    }
}

#[tokio::test]
async fn entering_requires_a_valid_token() {
    let (key, number) = (key(1), [3; 16]);
    let server = server(limits(), Some(key.clone()));
    for (token, sentence) in [
        (String::new(), "expected a token that was made for this room"),
        (token(&key, "yard", number), "expected a token that was made for this room"),
        (token(&super::tokens::key(2), "hall", number), "expected a token that was made for this room"),
        (key.token("hall", 1000, number), "expected a token that has not expired"),
    ] {
        assert_eq!(hello_is_refused(connect_with_token(&server, "hall", &token).await).await, sentence);
    }
    let mut user = connect_with_token(&server, "hall", &token(&key, "hall", number)).await;
    user.hello(0, "", &[]).await;
}

#[tokio::test]
async fn a_token_in_use_admits_no_other_connection() {
    let key = key(1);
    let server = server(limits(), Some(key.clone()));
    let (first, second) = (token(&key, "hall", [1; 16]), token(&key, "hall", [2; 16]));
    let mut user = connect_with_token(&server, "hall", &first).await;
    user.hello(0, "one", &[]).await;
    let mut other = connect_with_token(&server, "hall", &second).await;
    other.hello(0, "two", &[]).await;
    let replay = hello_is_refused(connect_with_token(&server, "hall", &first).await).await;
    assert_eq!(replay, "expected a token that no other connection uses");
    // Its user can reconnect with its ticket, which replaces the first connection.
    let mut again = connect_with_token(&server, "hall", &first).await;
    again.hello(0, "one", &user.ticket).await;
    assert_eq!(again.number, user.number);
    user.expect_refusal(Reason::Replaced).await;
    let gone = again.number;
    drop(again);
    other.wait_until_left(gone).await;
    other.wait_for(pick!(FromServer::Joined { .. } => ())).await;
    other.wait_until_left(gone).await;
    let mut later = connect_with_token(&server, "hall", &first).await;
    later.hello(0, "one", &[]).await;
    assert_ne!(later.number, gone, "it has no ticket");
}

#[tokio::test]
async fn a_ticket_restores_the_number_after_a_restart() {
    let (key, limits) = (key(1), Limits { users: 1, ..limits() });
    let first = server(limits, Some(key.clone()));
    let own = token(&key, "hall", [1; 16]);
    let mut user = connect_with_token(&first, "hall", &own).await;
    user.hello(0, "one", &[]).await;
    first.close();
    user.expect_refusal(Reason::Ending).await;
    let second = server(limits, Some(key.clone()));
    let mut again = connect_with_token(&second, "hall", &own).await;
    again.hello(0, "one", &user.ticket).await;
    assert_eq!(again.number, user.number);
    // A full room admits a user who replaces its own connection.
    let mut third = connect_with_token(&second, "hall", &own).await;
    third.hello(0, "one", &again.ticket).await;
    assert_eq!((third.number, &third.ticket), (user.number, &user.ticket));
    again.expect_refusal(Reason::Replaced).await;
}

#[tokio::test]
async fn rooms_without_tokens_have_lasting_tickets() {
    let open = || {
        let rooms = Some(Arc::new(Rooms::without_tokens(limits(), key(1)).expect("rooms")));
        start(ServerContent { rooms, ..server_content(limits(), None) }, None)
    };
    let first = open();
    let user = join(&first, "hall", 0, "one").await;
    first.close();
    let second = open();
    let mut again = connect(second.address(), "/rooms/hall").await.expect("a connection");
    again.hello(0, "one", &user.ticket).await;
    assert_eq!(again.number, user.number);
}

#[tokio::test]
async fn a_ticket_of_another_server_or_room_gives_a_new_number() {
    let (server, elsewhere) = (server(limits(), None), server(limits(), None));
    let first = join(&server, "hall", 0, "one").await;
    let mut others = vec![join(&server, "yard", 0, "two").await, join(&elsewhere, "hall", 0, "three").await];
    // Tickets of other rooms, changed to the number of a present user.
    others.iter_mut().for_each(|other| other.ticket[..2].copy_from_slice(&first.number.to_le_bytes()));
    for other in others {
        let mut user = connect(server.address(), "/rooms/hall").await.expect("a connection");
        user.hello(0, "", &other.ticket).await;
        assert_ne!(user.number, first.number);
    }
}

#[tokio::test]
async fn a_user_with_a_ticket_replaces_a_thief_of_its_token() {
    let key = key(1);
    let server = server(limits(), Some(key.clone()));
    let (own, other) = (token(&key, "hall", [1; 16]), token(&key, "hall", [2; 16]));
    let mut witness = connect_with_token(&server, "hall", &other).await;
    witness.hello(0, "witness", &[]).await;
    let mut user = connect_with_token(&server, "hall", &own).await;
    user.hello(0, "user", &[]).await;
    let (number, ticket) = (user.number, user.ticket.clone());
    drop(user);
    witness.wait_until_left(number).await;
    let mut thief = connect_with_token(&server, "hall", &own).await;
    thief.hello(0, "thief", &[]).await;
    // Another user's ticket is of no use.
    let mut stranger = connect_with_token(&server, "hall", &own).await;
    stranger.send(&[FromUser::Hello { group: 0, name: "", ticket: &witness.ticket }]).await;
    stranger.expect_refusal(Reason::Token).await;
    let mut again = connect_with_token(&server, "hall", &own).await;
    again.hello(0, "user", &ticket).await;
    assert_eq!(again.number, number);
    thief.expect_refusal(Reason::Replaced).await;
}
