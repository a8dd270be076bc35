//! Routes requests to handlers.

use std::borrow::Cow;
use std::collections::HashSet;
use std::net::IpAddr;
use std::sync::Arc;

use axum::body::Body;
use axum::http::header::{self, HeaderName, HeaderValue};
use axum::http::uri::Authority;
use axum::http::{Method, Request, Response, StatusCode, Version};
use percent_encoding::percent_decode_str;

use crate::gzip::GzipCache;
use crate::metrics::{self, Metrics};
use crate::offer::Offer;
use crate::respond::DocumentRequest;
use crate::rooms::requests::{self, AccessRules};
use crate::rooms::{Datagrams, Entrance, Rooms};
use crate::site::{Document, Sites, find_site};
use crate::{regions, respond};

/// Cache size of compressed documents, bytes.
const GZIP_CACHE_BYTES: u64 = 128 << 20;
/// One of this many connections is reserved for files.
const FILE_SHARE_DIVISOR: usize = 4;
/// Bytes added for each header field to those of its name and value (RFC 9113, section 6.5.2).
const FIELD_BYTES: usize = 32;
/// Time for which browsers cache a preflight response, seconds.
const PREFLIGHT_SECONDS: &str = "86400";

/// Content and rules of the server.
pub struct ServerContent {
    /// Sites by the first segment of their paths.
    pub sites: Sites,
    /// Accepted host names; `None` accepts all. Others are refused, because a foreign domain may resolve to this server
    /// (DNS rebinding).
    pub hosts: Option<HashSet<String>>,
    /// Headers of all responses.
    pub headers: Vec<(HeaderName, HeaderValue)>,
    /// Origin whose pages may read responses, or `*`; none for the server's own pages only.
    pub origin: Option<HeaderValue>,
    /// Rooms, at the paths `rooms/NAME`; the path `rooms` answers with their capabilities.
    pub rooms: Option<Arc<Rooms>>,
}

/// State shared by all requests.
pub struct Router {
    pub(crate) content: ServerContent,
    gzip: GzipCache,
    /// Maximum number of connections to rooms.
    room_connections: usize,
    /// Maximum size of a request's target and headers, bytes.
    header_bytes: usize,
    /// Names listed in the server's certificate.
    certificate_names: Vec<String>,
    /// WebTransport offer for pages.
    pub(crate) offer: Option<Offer>,
    /// Metrics of the responses.
    pub metrics: Metrics,
}

impl Router {
    /// Creates a router.
    pub fn new(content: ServerContent) -> Self {
        let metrics = Metrics::new(&content.sites, content.rooms.as_deref());
        let (gzip, certificate_names) = (GzipCache::new(GZIP_CACHE_BYTES), Vec::new());
        let (room_connections, header_bytes) = (usize::MAX, usize::MAX);
        Router { content, gzip, room_connections, header_bytes, certificate_names, offer: None, metrics }
    }

    /// Reserves some of `connections` for files, and sets the limit of headers, the names of the certificate and the
    /// WebTransport offer.
    pub(crate) fn configure(
        self,
        connections: usize,
        header_bytes: usize,
        certificate_names: Vec<String>,
        offer: Option<Offer>,
    ) -> Self {
        let room_connections = connections - connections / FILE_SHARE_DIVISOR;
        Router { room_connections, header_bytes, certificate_names, offer, ..self }
    }

    /// Rooms of the server.
    pub fn rooms(&self) -> Option<&Arc<Rooms>> {
        self.content.rooms.as_ref()
    }

    /// Answers a client's request.
    pub async fn answer<B>(self: Arc<Self>, client: IpAddr, request: Request<B>) -> Response<Body> {
        let mut answer = self.dispatch(client, &request).await;
        for (name, value) in &self.content.headers {
            answer.headers_mut().entry(name).or_insert_with(|| value.clone());
        }
        if let Some(origin) = &self.content.origin {
            let headers = answer.headers_mut();
            headers.insert(header::ACCESS_CONTROL_ALLOW_ORIGIN, origin.clone());
            let exposed = HeaderValue::from_static("accept-ranges, content-length, content-range, etag");
            headers.insert(header::ACCESS_CONTROL_EXPOSE_HEADERS, exposed);
        }
        if request.method() == Method::HEAD { answer.map(|_| Body::empty()) } else { answer }
    }

    async fn dispatch<B>(&self, client: IpAddr, request: &Request<B>) -> Response<Body> {
        if let Err((status, reason)) = self.check(request) {
            return respond::text_response(status, reason);
        }
        if *request.method() == Method::OPTIONS && self.content.origin.is_some() {
            return preflight();
        }
        if !matches!(*request.method(), Method::GET | Method::HEAD) {
            let status = StatusCode::METHOD_NOT_ALLOWED;
            return respond::text_response_with(status, "expected GET or HEAD", header::ALLOW, "GET, HEAD");
        }
        let not_found = || respond::text_response(StatusCode::NOT_FOUND, "no such file");
        let Some(path) = decoded_path(request) else { return not_found() };
        let (method, headers) = (request.method(), request.headers());
        let document_request = DocumentRequest { client, method, headers, gzip: &self.gzip };
        match &*path {
            "healthz" => return respond::text_response(StatusCode::OK, "the server runs"),
            "metrics" => {
                let text = self.metrics.text();
                // The text changes every time, so a cached compressed copy would be useless.
                let document = Document { is_compressible: false, ..Document::mutable(text.into(), metrics::MEDIA) };
                return respond::document(&document_request, &document).await;
            }
            _ => {}
        }
        if let Some(rooms) = self.rooms() {
            let rules = || self.access_rules(rooms, request);
            if path == requests::PATH {
                return requests::capabilities(rooms, self.datagrams(), rules(), request.headers());
            }
            if let Some(room) = requests::room_name(&path) {
                let count = || rooms.count_client(client, self.room_connections);
                return requests::upgrade(&room, rules(), count, request);
            }
        }
        if !path.is_empty() && self.content.sites.contains_key(&*path) {
            // The page's relative addresses refer to the site's root.
            let root = format!("{}/", request.uri().path());
            return respond::redirection(&root, "the site's address ends with a slash");
        }
        let Some((site, name)) = find_site(&self.content.sites, &path) else { return not_found() };
        if let Some(document) = site.documents.get(name) {
            return respond::document(&document_request, document).await;
        }
        let Some(demand) = &site.demand else { return not_found() };
        regions::answer(demand, name, &document_request).await.unwrap_or_else(not_found)
    }

    /// Admits a WebTransport request to a room; the error is the status of the refusal.
    pub(crate) fn entrance<B>(&self, client: IpAddr, request: &Request<B>) -> Result<Entrance, StatusCode> {
        self.check(request).map_err(|(status, _)| status)?;
        let path = decoded_path(request).ok_or(StatusCode::NOT_FOUND)?;
        let (rooms, room) = self.rooms().zip(requests::room_name(&path)).ok_or(StatusCode::NOT_FOUND)?;
        let count = || rooms.count_client(client, self.room_connections);
        requests::enter(&room, self.access_rules(rooms, request), count, request)
    }

    /// Current WebTransport settings for pages; none if it is off.
    pub(crate) fn datagrams(&self) -> Option<Datagrams> {
        self.offer.as_ref().map(Offer::description)
    }

    /// Access rules for a request for rooms.
    fn access_rules<'a, B>(&'a self, rooms: &Rooms, request: &'a Request<B>) -> AccessRules<'a> {
        AccessRules {
            host: self.host(request),
            // If `hosts` is set, `check` has found the host in it.
            is_known_host: self.content.hosts.is_some() || self.is_certified(request),
            allowed: self.content.origin.as_ref(),
            needs_token: rooms.token_key.is_some(),
        }
    }

    /// Checks the size of a request's headers and its host; the error is the status and the reason of the refusal.
    pub(crate) fn check<B>(&self, request: &Request<B>) -> Result<(), (StatusCode, &'static str)> {
        if header_bytes(request) > self.header_bytes {
            return Err((StatusCode::REQUEST_HEADER_FIELDS_TOO_LARGE, "the headers are too large"));
        }
        if !has_valid_host(request) {
            return Err((StatusCode::BAD_REQUEST, "expected exactly one valid Host header"));
        }
        let has_name = self.content.hosts.as_ref().is_none_or(|hosts| hosts.contains(&self.host_name(request)));
        if has_name { Ok(()) } else { Err((StatusCode::FORBIDDEN, "the server does not have this host name")) }
    }

    /// Host of a request, with its port: that of its target if it has one, else that of the `Host` header (RFC 9112,
    /// section 3.2.2).
    pub fn host<'a, B>(&self, request: &'a Request<B>) -> Option<&'a str> {
        let target = request.uri().authority().map(|authority| authority.as_str());
        target.or_else(|| request.headers().get(header::HOST)?.to_str().ok())
    }

    /// Whether the request's host is listed in the certificate.
    fn is_certified<B>(&self, request: &Request<B>) -> bool {
        let name = self.host_name(request);
        self.certificate_names.iter().any(|listed| listed.eq_ignore_ascii_case(&name))
    }

    /// Host of a request without its port, in lower case.
    fn host_name<B>(&self, request: &Request<B>) -> String {
        without_port(self.host(request).unwrap_or_default()).to_ascii_lowercase()
    }
}

/// Size of a request's headers in bytes: its target, and the names and values of its header fields with 32 bytes for
/// each field, as in HTTP/2 and HTTP/3 (RFC 9113, section 6.5.2).
fn header_bytes<B>(request: &Request<B>) -> usize {
    let fields = request.headers().iter().map(|(name, value)| name.as_str().len() + value.len() + FIELD_BYTES);
    let uri = request.uri();
    let host_bytes = uri.authority().map_or(0, |authority| authority.as_str().len());
    host_bytes + uri.path_and_query().map_or(0, |path| path.as_str().len()) + fields.sum::<usize>()
}

/// Whether a request has one valid header `Host`, which only HTTP/1.1 requires (RFC 9112, section 3.2).
fn has_valid_host<B>(request: &Request<B>) -> bool {
    let mut hosts = request.headers().get_all(header::HOST).iter();
    match (hosts.next(), hosts.next()) {
        (Some(host), None) => host.is_empty() || Authority::try_from(host.as_bytes()).is_ok(),
        (None, _) => request.version() != Version::HTTP_11,
        _ => false,
    }
}

/// Removes the port from a host.
pub(crate) fn without_port(host: &str) -> &str {
    let is_port = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    host.rsplit_once(':').filter(|(_, port)| is_port(port)).map_or(host, |(name, _)| name)
}

/// Path of a request without its leading slash, percent-decoded once; percent signs that remain belong to the file's
/// name. None for targets that are not paths, such as `*`.
fn decoded_path<B>(request: &Request<B>) -> Option<Cow<'_, str>> {
    percent_decode_str(request.uri().path().strip_prefix('/')?).decode_utf8().ok()
}

/// Methods and headers allowed for pages of other sites.
fn preflight() -> Response<Body> {
    let head = Response::builder().status(StatusCode::NO_CONTENT);
    let head = head.header(header::ACCESS_CONTROL_ALLOW_METHODS, "GET, HEAD");
    let head = head.header(header::ACCESS_CONTROL_ALLOW_HEADERS, "range, if-range, if-none-match");
    respond::finish(head.header(header::ACCESS_CONTROL_MAX_AGE, PREFLIGHT_SECONDS).body(Body::empty()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rooms::tests::support::{limits, server_content};

    const HTTP_10: Version = Version::HTTP_10;
    const HTTP_11: Version = Version::HTTP_11;
    const HTTP_2: Version = Version::HTTP_2;

    /// Status of the answer to a request for `/healthz` from a server with the name `here`.
    async fn status(version: Version, target: &str, headers: &[(&str, &str)], header_bytes: usize) -> u16 {
        let named = ServerContent { hosts: Some(["here".to_owned()].into()), ..server_content(limits(), None) };
        let router = Arc::new(Router::new(named).configure(4, header_bytes, Vec::new(), None));
        let request = Request::builder().version(version).uri(target);
        let request = headers.iter().fold(request, |request, (name, value)| request.header(*name, *value));
        let client = IpAddr::from([127, 0, 0, 1]);
        router.answer(client, request.body(()).expect("a request")).await.status().as_u16()
    }

    #[tokio::test]
    async fn the_host_of_the_target_overrides_the_host_header() {
        for (version, target, hosts, expected) in [
            (HTTP_11, "/healthz", &["here"][..], 200),
            (HTTP_11, "/healthz", &["HERE:80"], 200),
            (HTTP_11, "/healthz", &["other"], 403),
            (HTTP_11, "/healthz", &[""], 403),
            (HTTP_11, "/healthz", &[], 400),
            (HTTP_11, "/healthz", &["here", "here"], 400),
            (HTTP_11, "/healthz", &["here", "other"], 400),
            (HTTP_11, "/healthz", &["other", "here"], 400),
            (HTTP_11, "/healthz", &["here, other"], 400),
            (HTTP_11, "/healthz", &["a here"], 400),
            (HTTP_11, "http://here/healthz", &["other"], 200),
            (HTTP_11, "http://here:80/healthz", &["here:80"], 200),
            (HTTP_11, "http://other/healthz", &["here"], 403),
            (HTTP_11, "http://here/healthz", &["here", "here"], 400),
            (HTTP_11, "http://here/healthz", &[], 400),
            (HTTP_10, "/healthz", &["here"], 200),
            (HTTP_10, "/healthz", &[], 403),
            (HTTP_2, "https://here/healthz", &[], 200),
            (HTTP_2, "https://other/healthz", &["here"], 403),
        ] {
            let headers: Vec<_> = hosts.iter().map(|host| ("host", *host)).collect();
            assert_eq!(status(version, target, &headers, 1 << 15).await, expected, "{version:?} {target} {hosts:?}");
        }
    }

    #[tokio::test]
    async fn larger_headers_are_refused() {
        // /healthz; host and here; x and a value; 32 bytes for each of two fields.
        let value = "y".repeat(1 << 13);
        let size = 8 + 8 + 1 + value.len() + 2 * 32;
        for (limit, expected) in [(size, 200), (size - 1, 431)] {
            let headers = [("host", "here"), ("x", value.as_str())];
            assert_eq!(status(HTTP_11, "/healthz", &headers, limit).await, expected);
        }
    }
}
