//! From a request to its answer.

use std::collections::HashSet;
use std::net::IpAddr;
use std::sync::Arc;

use axum::body::Body;
use axum::http::header::{self, HeaderName, HeaderValue};
use axum::http::{Method, Request, Response, StatusCode};
use percent_encoding::percent_decode_str;

use crate::site::{Sites, find};
use crate::{regions, respond};

/// State that all requests share.
pub struct Router {
    /// Sites by the first part of their paths.
    pub sites: Sites,
    /// Names by which the server may be called; none for any. Another name is another site's that points here.
    pub hosts: Option<HashSet<String>>,
    /// Headers of all answers.
    pub headers: Vec<(HeaderName, HeaderValue)>,
}

impl Router {
    /// Answer a client's request.
    pub async fn answer<B>(self: Arc<Self>, client: IpAddr, request: Request<B>) -> Response<Body> {
        let mut answer = self.found(client, &request).await;
        let is_head = request.method() == Method::HEAD;
        for (name, value) in &self.headers {
            answer.headers_mut().entry(name).or_insert_with(|| value.clone());
        }
        if is_head { answer.map(|_| Body::empty()) } else { answer }
    }

    async fn found<B>(&self, client: IpAddr, request: &Request<B>) -> Response<Body> {
        if !self.is_called_by_its_name(request) {
            return respond::refusal(StatusCode::FORBIDDEN, "the server is not called by this name");
        }
        if !matches!(*request.method(), Method::GET | Method::HEAD) {
            let mut answer = respond::refusal(StatusCode::METHOD_NOT_ALLOWED, "expected GET or HEAD");
            answer.headers_mut().insert(header::ALLOW, HeaderValue::from_static("GET, HEAD"));
            return answer;
        }
        let nothing = || respond::refusal(StatusCode::NOT_FOUND, "no such file");
        // A target such as `*` is no path.
        let Some(path) = request.uri().path().strip_prefix('/') else { return nothing() };
        // Decoded once: a name that still has percent signs is that of a file with percent signs.
        let Ok(path) = percent_decode_str(path).decode_utf8() else { return nothing() };
        if path == "healthz" {
            return respond::refusal(StatusCode::OK, "the server runs");
        }
        let Some((site, name)) = find(&self.sites, &path) else { return nothing() };
        if let Some(document) = site.documents.get(name) {
            return respond::document(request.method(), request.headers(), document).await;
        }
        match &site.demand {
            Some(demand) => match regions::answer(demand, client, name, request).await {
                Some(answer) => answer,
                None => nothing(),
            },
            None => nothing(),
        }
    }

    fn is_called_by_its_name<B>(&self, request: &Request<B>) -> bool {
        let Some(hosts) = &self.hosts else { return true };
        let named = request.headers().get(header::HOST).and_then(|value| value.to_str().ok());
        let named = named.or_else(|| request.uri().authority().map(|found| found.as_str())).unwrap_or_default();
        let is_port = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
        let name = named.rsplit_once(':').filter(|(_, port)| is_port(port)).map_or(named, |(name, _)| name);
        hosts.contains(&name.to_ascii_lowercase())
    }
}
