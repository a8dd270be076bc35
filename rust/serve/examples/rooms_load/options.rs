//! Parses the load from the arguments.

use std::net::SocketAddr;
use std::time::Duration;

pub type Failure = Box<dyn std::error::Error + Send + Sync>;

/// Users per room, unless groups are larger.
const ROOM_USERS: usize = 64;
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
    pub transport: Transport,
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
            transport: Transport::WebSocket,
            stay: NEVER,
            serve: ([127, 0, 0, 1], 0).into(),
            namespace: None,
        };
        for option in options.chunks(2) {
            let [name, value] = option else { return Err(usage()) };
            match name.as_str() {
                "--attack" => load.attack = Some(choice(name, value, &ATTACKS)?),
                "--by" => load.transport = choice(name, value, &TRANSPORTS)?,
                "--stay" => load.stay = Duration::try_from_secs_f64(value.parse()?)?,
                "--serve" => load.serve = value.parse()?,
                "--in" => load.namespace = Some(value.clone()),
                _ => return Err(format!("expected --attack, --by, --stay, --serve or --in, got {name}").into()),
            }
        }
        Ok(load)
    }

    /// Room and group of a user.
    pub fn room_and_group(&self, number: usize) -> (usize, u16) {
        let group = number / self.group;
        (group / (ROOM_USERS / self.group).max(1), group as u16)
    }
}

/// Finds the value with a name; the error lists all names.
fn choice<T: Copy>(option: &str, name: &str, choices: &[(&str, T)]) -> Result<T, Failure> {
    let value = choices.iter().find(|(key, _)| *key == name).map(|(_, value)| *value);
    let names: Vec<&str> = choices.iter().map(|(key, _)| *key).collect();
    value.ok_or_else(|| format!("{option}: expected one of {}, got {name:?}", names.join(", ")).into())
}

/// Transport of the users' connections.
#[derive(Clone, Copy)]
pub enum Transport {
    WebSocket,
    Datagrams,
}

const TRANSPORTS: [(&str, Transport); 2] = [("websocket", Transport::WebSocket), ("datagrams", Transport::Datagrams)];

/// Kinds of attacks.
#[derive(Clone, Copy)]
pub enum Attack {
    /// Sends invalid frames.
    Garbage,
    /// Sends poses without a pause.
    FloodPose,
    /// Sends messages to the room without a pause.
    FloodSay,
    /// Sends signals to a measured user without a pause.
    FloodSignal,
    /// Joins and leaves without a pause.
    Churn,
    /// Reads everything, but acknowledges no pose.
    Mute,
    /// Disconnects in the middle of a message.
    Vanish,
    /// Does not read the messages of the first misbehaving user.
    Slow,
}

const ATTACKS: [(&str, Attack); 8] = [
    ("garbage", Attack::Garbage),
    ("flood-pose", Attack::FloodPose),
    ("flood-say", Attack::FloodSay),
    ("flood-signal", Attack::FloodSignal),
    ("churn", Attack::Churn),
    ("mute", Attack::Mute),
    ("vanish", Attack::Vanish),
    ("slow", Attack::Slow),
];
