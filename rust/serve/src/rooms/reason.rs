//! Why a user's connection ends.

/// Close code of WebSocket for a connection that its user ended.
const NORMAL: u16 = 1000;
/// Close codes of applications begin here; that of a reason is so many higher than the reason's own.
const OWN: u16 = 4000;

/// Why a connection ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Reason {
    /// The user said so.
    Bye,
    /// The connection broke off.
    Gone,
    /// The user speaks another version.
    Version,
    /// The user sent what is no message, or one that is too large.
    Frame,
    /// The user has no token, or one that is not valid here.
    Token,
    /// The room, or the server, has as many as it may.
    Full,
    /// The user sends too much.
    Flood,
    /// The user reads too slowly.
    Slow,
    /// Nothing was heard of the user.
    Silent,
    /// The user has come back by another connection.
    Replaced,
    /// The server ends.
    Ending,
}

impl Reason {
    /// All reasons, in the order of their codes.
    pub const ALL: [Reason; 11] = [
        Reason::Bye,
        Reason::Gone,
        Reason::Version,
        Reason::Frame,
        Reason::Token,
        Reason::Full,
        Reason::Flood,
        Reason::Slow,
        Reason::Silent,
        Reason::Replaced,
        Reason::Ending,
    ];

    /// Its number in a frame.
    pub fn code(self) -> u8 {
        self as u8
    }

    /// Its name in counts.
    pub fn name(self) -> &'static str {
        match self {
            Reason::Bye => "bye",
            Reason::Gone => "gone",
            Reason::Version => "version",
            Reason::Frame => "frame",
            Reason::Token => "token",
            Reason::Full => "full",
            Reason::Flood => "flood",
            Reason::Slow => "slow",
            Reason::Silent => "silent",
            Reason::Replaced => "replaced",
            Reason::Ending => "ending",
        }
    }

    /// Its close code of WebSocket.
    pub fn close_code(self) -> u16 {
        if self == Reason::Bye { NORMAL } else { OWN + u16::from(self.code()) }
    }
}

/// The end of a connection: why, and in a sentence for who was ended.
#[derive(Clone, Debug, PartialEq)]
pub struct End {
    /// Why.
    pub reason: Reason,
    /// The sentence, which names what was expected.
    pub sentence: String,
}

impl End {
    /// An end for a reason, with its sentence.
    pub fn new(reason: Reason, sentence: impl Into<String>) -> Self {
        End { reason, sentence: sentence.into() }
    }
}

/// The end of a connection that broke off.
pub fn gone() -> End {
    End::new(Reason::Gone, "the connection broke off")
}
