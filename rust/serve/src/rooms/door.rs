//! Access control by the origin of the requesting page.

use std::net::{IpAddr, SocketAddr};

use axum::http::header::{self, HeaderMap, HeaderValue};

/// Reason sent to pages that are refused.
pub const CLOSED: &str = "pages of this origin may not enter";

/// Rules that keep pages of other sites out.
#[derive(Clone, Copy)]
pub struct Door<'a> {
    /// Host header of the request, with its port.
    pub host: Option<&'a str>,
    /// Whether the host is one of the configured names, or is listed in the server's certificate.
    pub is_named: bool,
    /// Origin whose pages may read files, or `*`.
    pub allowed: Option<&'a HeaderValue>,
    /// Whether users need a token.
    pub needs_token: bool,
}

impl Door<'_> {
    /// Programs send no Origin header; browsers send it for WebSockets, and for cross-origin reads.
    pub fn is_open(self, headers: &HeaderMap) -> bool {
        let mut origins = headers.get_all(header::ORIGIN).iter();
        let Some(origin) = origins.next() else { return true };
        if origins.next().is_some() {
            return false;
        }
        if self.allowed.is_some_and(|allowed| if allowed == "*" { self.needs_token } else { allowed == origin }) {
            return true;
        }
        // The scheme is ignored, because a proxy may terminate TLS.
        let origin = origin.to_str().unwrap_or_default();
        let own = origin.strip_prefix("https://").or_else(|| origin.strip_prefix("http://"));
        own.zip(self.host).is_some_and(|(own, host)| own.eq_ignore_ascii_case(host) && self.is_own(host))
    }

    /// Whether a page loaded from this host belongs to the server. With DNS rebinding, a name's owner can serve a page
    /// from it and then redirect the name to this server; IP addresses and localhost cannot be rebound.
    fn is_own(self, host: &str) -> bool {
        let is_address = host.parse::<SocketAddr>().is_ok() || host.trim_matches(['[', ']']).parse::<IpAddr>().is_ok();
        let name = host.split(':').next().unwrap_or_default();
        self.needs_token || self.is_named || is_address || name.eq_ignore_ascii_case("localhost")
    }
}
