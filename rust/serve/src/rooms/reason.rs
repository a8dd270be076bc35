//! Reasons for the end of a user's connection.

/// WebSocket close code for a connection that its user ended.
const NORMAL: u16 = 1000;
/// First application-defined close code; a reason's code is added to it.
const FIRST_OWN_CODE: u16 = 4000;

/// Reason for the end of a connection.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Reason {
    /// The user has left.
    Bye,
    /// The connection broke.
    Gone,
    /// The user's frames have another version.
    Version,
    /// The user sent an invalid or too large message.
    Frame,
    /// The user's token is missing or invalid here.
    Token,
    /// The room or the server is full.
    Full,
    /// The user sent too much.
    Flood,
    /// The user reads too slowly.
    Slow,
    /// The user timed out.
    Silent,
    /// The user has reconnected.
    Replaced,
    /// The server is shutting down.
    Ending,
}

impl Reason {
    /// Code in a frame.
    pub fn code(self) -> u8 {
        self as u8
    }

    /// Name in metrics.
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

    /// WebSocket close code.
    pub fn close_code(self) -> u16 {
        if self == Reason::Bye { NORMAL } else { FIRST_OWN_CODE + u16::from(self.code()) }
    }
}

/// End of a connection: the reason, and a sentence for the user.
#[derive(Clone, Debug, PartialEq)]
pub struct End {
    pub reason: Reason,
    /// Expectation that was not met, as a sentence.
    pub sentence: String,
}

impl End {
    pub fn new(reason: Reason, sentence: impl Into<String>) -> Self {
        End { reason, sentence: sentence.into() }
    }

    /// End of a connection that the user has left.
    pub fn by_user() -> Self {
        End::new(Reason::Bye, "the user left")
    }

    /// End of a broken connection.
    pub fn broken() -> Self {
        End::new(Reason::Gone, "the connection broke off")
    }
}
