//! Who may enter by the page that asks.

use std::net::{IpAddr, SocketAddr};

use axum::http::header::{self, HeaderMap, HeaderValue};

/// The sentence for pages that may not.
pub const CLOSED: &str = "pages of this origin may not enter";

/// The rules by which pages of other sites are kept out.
#[derive(Clone, Copy)]
pub struct Door<'a> {
    /// The name by which the request calls the server, with its port.
    pub host: Option<&'a str>,
    /// It is one of the names that the server was told, or that its certificate lists.
    pub is_named: bool,
    /// Whose pages may read files: an origin, or `*`.
    pub allowed: Option<&'a HeaderValue>,
    /// Users need a token.
    pub needs_token: bool,
}

impl Door<'_> {
    /// Programs send no origin; browsers send one for sockets, and where pages of other sites want to read the answer.
    pub fn is_open(self, headers: &HeaderMap) -> bool {
        let mut origins = headers.get_all(header::ORIGIN).iter();
        let Some(origin) = origins.next() else { return true };
        if origins.next().is_some() {
            return false;
        }
        if self.allowed.is_some_and(|allowed| if allowed == "*" { self.needs_token } else { allowed == origin }) {
            return true;
        }
        // A proxy may encrypt for the server, so the scheme tells nothing.
        let origin = origin.to_str().unwrap_or_default();
        let own = origin.strip_prefix("https://").or_else(|| origin.strip_prefix("http://"));
        own.zip(self.host).is_some_and(|(own, host)| own.eq_ignore_ascii_case(host) && self.is_own(host))
    }

    /// Whether a page that was called by this name is the server's own. The owner of a name may let it lead first to
    /// the owner's page, then to this server; an address leads nowhere else, nor does localhost.
    fn is_own(self, host: &str) -> bool {
        let is_address = host.parse::<SocketAddr>().is_ok() || host.trim_matches(['[', ']']).parse::<IpAddr>().is_ok();
        let name = host.split(':').next().unwrap_or_default();
        self.needs_token || self.is_named || is_address || name.eq_ignore_ascii_case("localhost")
    }
}
