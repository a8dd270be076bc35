//! Parses the load from the arguments.

use std::net::SocketAddr;
use std::str::FromStr;
use std::time::Duration;

use crate::attack::{Attack, NAMES};
use crate::failure::Failure;

/// Users per room, unless groups are larger.
const ROOM: usize = 64;
/// Longer than any measurement.
const NEVER: Duration = Duration::from_secs(1 << 32);

/// Number and behaviour of the users.
#[derive(Clone)]
pub struct Load {
    pub users: usize,
    pub group: usize,
    pub hertz: f64,
    pub seconds: f64,
    pub attack: Option<Attack>,
    pub way: Way,
    /// Time after which a user leaves and rejoins.
    pub stay: Duration,
    /// Address at which the server listens, and its network namespace.
    pub serve: SocketAddr,
    pub namespace: Option<String>,
}

impl Load {
    pub fn read(arguments: &[String]) -> Result<Self, Failure> {
        let usage = || Failure::from("expected USERS GROUP HERTZ SECONDS, and pairs of an option and its value");
        let [users, group, hertz, seconds, options @ ..] = arguments else { return Err(usage()) };
        let mut load = Load {
            users: users.parse()?,
            group: group.parse()?,
            hertz: hertz.parse()?,
            seconds: seconds.parse()?,
            attack: None,
            way: Way::WebSocket,
            stay: NEVER,
            serve: ([127, 0, 0, 1], 0).into(),
            namespace: None,
        };
        for option in options.chunks(2) {
            let [name, value] = option else { return Err(usage()) };
            match name.as_str() {
                "--attack" => load.attack = Some(value.parse().map_err(|_| format!("--attack: one of {NAMES}"))?),
                "--by" => load.way = value.parse()?,
                "--stay" => load.stay = Duration::try_from_secs_f64(value.parse()?)?,
                "--serve" => load.serve = value.parse()?,
                "--in" => load.namespace = Some(value.clone()),
                _ => return Err(format!("expected an option of those above, got {name}").into()),
            }
        }
        Ok(load)
    }

    /// Room and group of a user.
    pub fn place(&self, number: usize) -> (usize, u16) {
        let group = number / self.group;
        (group / (ROOM / self.group).max(1), group as u16)
    }
}

/// Transport of the users' connections.
#[derive(Clone, Copy)]
pub enum Way {
    WebSocket,
    Datagrams,
}

impl FromStr for Way {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "websocket" => Ok(Way::WebSocket),
            "datagrams" => Ok(Way::Datagrams),
            _ => Err(format!("--by: expected websocket or datagrams, got {text:?}")),
        }
    }
}
