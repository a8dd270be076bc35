//! Routes requests to handlers.

use std::borrow::Cow;
use std::collections::HashSet;
use std::net::IpAddr;
use std::sync::Arc;

use axum::body::Body;
use axum::http::header::{self, HeaderName, HeaderValue};
use axum::http::{Method, Request, Response, StatusCode};
use percent_encoding::percent_decode_str;

use crate::metrics::{self, Metrics};
use crate::offer::Offer;
use crate::packed::Packed;
use crate::respond::Asked;
use crate::rooms::requests::{self, Door};
use crate::rooms::{Datagrams, Entrance, Rooms};
use crate::site::{Document, Sites, find};
use crate::{regions, respond};

/// Cache size of compressed documents, bytes.
const PACKED_BYTES: u64 = 128 << 20;
/// Divisor of the connections: share that is reserved for files.
const FILE_SHARE: usize = 4;
/// Time for which browsers cache a preflight response, seconds.
const PREFLIGHT_SECONDS: &str = "86400";

/// Content and rules of the server.
pub struct Answering {
    /// Sites by the first segment of their paths.
    pub sites: Sites,
    /// Accepted host names; none for any. Another name may be a foreign domain that resolves to this server.
    pub hosts: Option<HashSet<String>>,
    /// Headers of all responses.
    pub headers: Vec<(HeaderName, HeaderValue)>,
    /// Origin whose pages may read responses, or `*`; none for the server's own pages only.
    pub origin: Option<HeaderValue>,
    /// Rooms at `rooms/NAME`; `rooms` describes their capabilities.
    pub rooms: Option<Arc<Rooms>>,
}

/// State shared by all requests.
pub struct Router {
    pub(crate) answering: Answering,
    packed: Packed,
    /// Greatest number of room connections.
    sockets: usize,
    /// Names listed in the server's certificate.
    certified: Vec<String>,
    /// WebTransport offer for pages.
    pub(crate) offer: Option<Offer>,
    /// Metrics of the responses.
    pub metrics: Metrics,
}

impl Router {
    /// Creates a router.
    pub fn new(answering: Answering) -> Self {
        let metrics = Metrics::new(&answering.sites, answering.rooms.as_deref());
        let (packed, certified) = (Packed::new(PACKED_BYTES), Vec::new());
        Router { answering, packed, sockets: usize::MAX, certified, offer: None, metrics }
    }

    /// Reserves some of `connections` for files, and sets the names of the certificate and the WebTransport offer.
    pub(crate) fn configure(self, connections: usize, certified: Vec<String>, offer: Option<Offer>) -> Self {
        Router { sockets: connections - connections / FILE_SHARE, certified, offer, ..self }
    }

    /// Rooms of the server.
    pub fn rooms(&self) -> Option<&Arc<Rooms>> {
        self.answering.rooms.as_ref()
    }

    /// Responds to a client's request.
    pub async fn answer<B>(self: Arc<Self>, client: IpAddr, request: Request<B>) -> Response<Body> {
        let mut answer = self.dispatch(client, &request).await;
        for (name, value) in &self.answering.headers {
            answer.headers_mut().entry(name).or_insert_with(|| value.clone());
        }
        if let Some(origin) = &self.answering.origin {
            let headers = answer.headers_mut();
            headers.insert(header::ACCESS_CONTROL_ALLOW_ORIGIN, origin.clone());
            let exposed = HeaderValue::from_static("accept-ranges, content-length, content-range, etag");
            headers.insert(header::ACCESS_CONTROL_EXPOSE_HEADERS, exposed);
        }
        if request.method() == Method::HEAD { answer.map(|_| Body::empty()) } else { answer }
    }

    async fn dispatch<B>(&self, client: IpAddr, request: &Request<B>) -> Response<Body> {
        if !self.is_called_by_its_name(request) {
            return respond::refusal(StatusCode::FORBIDDEN, "the server does not have this host name");
        }
        if *request.method() == Method::OPTIONS && self.answering.origin.is_some() {
            return preflight();
        }
        if !matches!(*request.method(), Method::GET | Method::HEAD) {
            let status = StatusCode::METHOD_NOT_ALLOWED;
            return respond::refusal_with(status, "expected GET or HEAD", header::ALLOW, "GET, HEAD");
        }
        let nothing = || respond::refusal(StatusCode::NOT_FOUND, "no such file");
        let Some(path) = path_of(request) else { return nothing() };
        let asked = Asked { client, method: request.method(), headers: request.headers(), packed: &self.packed };
        match &*path {
            "healthz" => return respond::refusal(StatusCode::OK, "the server runs"),
            "metrics" => {
                let text = self.metrics.text();
                // The text changes every time, so a cached compressed copy would be useless.
                let document = Document { is_compressible: false, ..Document::mutable(text.into(), metrics::MEDIA) };
                return respond::document(&asked, &document).await;
            }
            _ => {}
        }
        if let Some(rooms) = self.rooms() {
            let door = || self.door(rooms, request);
            if path == requests::PATH {
                return requests::about(rooms, self.datagrams(), door(), request.headers());
            }
            if let Some(room) = requests::room(&path) {
                return requests::upgrade(room, door(), || rooms.count_client(client, self.sockets), request);
            }
        }
        if !path.is_empty() && self.answering.sites.contains_key(&*path) {
            // The page's relative addresses refer to the site's root.
            let root = format!("{}/", request.uri().path());
            return respond::redirection(&root, "the site's address ends with a slash");
        }
        let Some((site, name)) = find(&self.answering.sites, &path) else { return nothing() };
        if let Some(document) = site.documents.get(name) {
            return respond::document(&asked, document).await;
        }
        let Some(demand) = &site.demand else { return nothing() };
        regions::answer(demand, name, &asked).await.unwrap_or_else(nothing)
    }

    /// Room that a WebTransport request enters, or the status of the refusal.
    pub(crate) fn entrance<B>(&self, client: IpAddr, request: &Request<B>) -> Result<Entrance, StatusCode> {
        if !self.is_called_by_its_name(request) {
            return Err(StatusCode::FORBIDDEN);
        }
        let path = path_of(request).ok_or(StatusCode::NOT_FOUND)?;
        let (rooms, room) = self.rooms().zip(requests::room(&path)).ok_or(StatusCode::NOT_FOUND)?;
        requests::session(room, self.door(rooms, request), || rooms.count_client(client, self.sockets), request)
    }

    /// Current WebTransport settings for pages; none if it is off.
    pub(crate) fn datagrams(&self) -> Option<Datagrams> {
        self.offer.as_ref().map(Offer::description)
    }

    /// Access rules for a request for rooms.
    fn door<'a, B>(&'a self, rooms: &Rooms, request: &'a Request<B>) -> Door<'a> {
        Door {
            host: self.host(request),
            is_named: self.answering.hosts.is_some() || self.is_certified(request),
            allowed: self.answering.origin.as_ref(),
            needs_token: rooms.token_key.is_some(),
        }
    }

    /// Host of a request, with its port.
    pub fn host<'a, B>(&self, request: &'a Request<B>) -> Option<&'a str> {
        let header = request.headers().get(header::HOST).and_then(|value| value.to_str().ok());
        header.or_else(|| request.uri().authority().map(|authority| authority.as_str()))
    }

    /// Whether the request's host is one of the accepted names.
    pub fn is_called_by_its_name<B>(&self, request: &Request<B>) -> bool {
        self.answering.hosts.as_ref().is_none_or(|hosts| hosts.contains(&self.name(request)))
    }

    /// Whether the request's host is listed in the certificate.
    fn is_certified<B>(&self, request: &Request<B>) -> bool {
        let name = self.name(request);
        self.certified.iter().any(|listed| listed.eq_ignore_ascii_case(&name))
    }

    /// Host of a request without its port, in lower case.
    fn name<B>(&self, request: &Request<B>) -> String {
        without_port(self.host(request).unwrap_or_default()).to_ascii_lowercase()
    }
}

/// Host name without its port.
pub(crate) fn without_port(host: &str) -> &str {
    let is_port = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    host.rsplit_once(':').filter(|(_, port)| is_port(port)).map_or(host, |(name, _)| name)
}

/// Path of a request without its leading slash, percent-decoded once: remaining percent signs belong to the file's
/// name. None for targets that are not paths, such as `*`.
fn path_of<B>(request: &Request<B>) -> Option<Cow<'_, str>> {
    percent_decode_str(request.uri().path().strip_prefix('/')?).decode_utf8().ok()
}

/// Methods and headers allowed for pages of other sites.
fn preflight() -> Response<Body> {
    let head = Response::builder().status(StatusCode::NO_CONTENT);
    let head = head.header(header::ACCESS_CONTROL_ALLOW_METHODS, "GET, HEAD");
    let head = head.header(header::ACCESS_CONTROL_ALLOW_HEADERS, "range, if-range, if-none-match");
    respond::finished(head.header(header::ACCESS_CONTROL_MAX_AGE, PREFLIGHT_SECONDS).body(Body::empty()))
}
