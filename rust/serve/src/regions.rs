//! HTTP handlers for regions on demand: parts as they become ready, complete manifests, and files.

use std::convert::Infallible;
use std::net::IpAddr;
use std::sync::Arc;

use axum::body::{Body, Bytes};
use axum::http::header;
use axum::http::{Response, StatusCode};
use futures_util::stream;
use serde_json::json;

use crate::clients::client_key;
use crate::demand::{Answer, CompleteRegion, Demand, Event, Outcome, Place, Refusal, Ticket};
use crate::file::Content;
use crate::respond::{self, DocumentRequest};
use crate::site::Document;

/// Media types by file name suffix.
const MEDIA: [(&str, &str); 3] = [("json", "application/json"), ("glb", "model/gltf-binary"), ("webp", "image/webp")];

/// Answers requests below a site with regions on demand: `at/PLACE/parts`, `at/PLACE/manifest.json`,
/// `at/PLACE/tileset.json`, `files/NAME`, and `at/PLACE/files/NAME`, so that `at/PLACE/` can be opened like an exported
/// bundle. None for other names.
pub async fn answer(demand: &Arc<Demand>, name: &str, request: &DocumentRequest<'_>) -> Option<Response<Body>> {
    if name.starts_with("files/") {
        return Some(file(demand, name, request).await);
    }
    let (place, name) = name.strip_prefix("at/")?.split_once('/')?;
    let place: Place = match place.parse() {
        Ok(place) => place,
        Err(reason) => return Some(respond::text_response(StatusCode::BAD_REQUEST, &reason)),
    };
    match name {
        "parts" => Some(parts(demand, request.client, place).await),
        "manifest.json" | "tileset.json" => Some(document(demand, place, name, request).await),
        _ if name.starts_with("files/") => Some(file(demand, name, request).await),
        _ => None,
    }
}

/// Streams JSON lines that announce parts as they become ready; the last line announces the outcome.
async fn parts(demand: &Arc<Demand>, client: IpAddr, place: Place) -> Response<Body> {
    let lines = match request_region(demand, client, place).await {
        Err(refusal) => return refuse(refusal),
        Ok(Answer::Complete(region)) => manifest_line(region).into(),
        Ok(Answer::InProgress(ticket)) => Body::from_stream(stream::unfold(Some(ticket), next_lines)),
    };
    let head = Response::builder().header(header::CONTENT_TYPE, "application/x-ndjson");
    respond::finish(head.header(header::CACHE_CONTROL, "no-store").body(lines))
}

/// Requests a region in a blocking thread, because it may wait for the disk.
async fn request_region(demand: &Arc<Demand>, client: IpAddr, place: Place) -> Result<Answer, Refusal> {
    let demand = Arc::clone(demand);
    let task = tokio::task::spawn_blocking(move || demand.request(client_key(client), place));
    task.await.unwrap_or(Err(Refusal::Closing))
}

/// Looks up a region's file in a blocking thread, because it may wait for the disk.
async fn look_up(
    demand: &Arc<Demand>,
    find: impl FnOnce(&Demand) -> Option<Content> + Send + 'static,
) -> Option<Content> {
    let demand = Arc::clone(demand);
    tokio::task::spawn_blocking(move || find(&demand)).await.ok()?
}

/// Manifest of a complete region, as one JSON line; pages know the event by the name "whole".
fn manifest_line(region: CompleteRegion) -> Vec<u8> {
    let manifest = match region {
        CompleteRegion::InMemory(region) => region.file("manifest.json").unwrap_or_default(),
        CompleteRegion::Manifest(data) => data,
    };
    [b"{\"event\":\"whole\",\"manifest\":", manifest.trim_ascii_end(), b"}\n"].concat()
}

async fn next_lines(ticket: Option<Ticket>) -> Option<(Result<Bytes, Infallible>, Option<Ticket>)> {
    let mut ticket = ticket?;
    let line = |value: serde_json::Value| Ok(Bytes::from(format!("{value}\n")));
    match ticket.event().await {
        Event::Lines(lines) => Some((Ok(lines.concat().into()), Some(ticket))),
        Event::Waiting(count) => Some((line(json!({"event": "waiting", "before": count})), Some(ticket))),
        Event::End(Outcome::Complete) => None,
        Event::End(Outcome::Failed(reason)) => Some((line(json!({"event": "failed", "reason": reason})), None)),
    }
}

/// Answers with a document of a region, after the region is complete.
async fn document(demand: &Arc<Demand>, place: Place, name: &str, request: &DocumentRequest<'_>) -> Response<Body> {
    let region = match request_region(demand, request.client, place).await {
        Err(refusal) => return refuse(refusal),
        Ok(Answer::Complete(region)) => region,
        Ok(Answer::InProgress(ticket)) => match ticket.wait().await {
            Ok(region) => region,
            Err(reason) => return respond::text_response(StatusCode::UNPROCESSABLE_ENTITY, &reason),
        },
    };
    let content = match region {
        CompleteRegion::InMemory(region) => region.file(name).map(Content::Bytes),
        CompleteRegion::Manifest(data) if name == "manifest.json" => Some(Content::Bytes(data)),
        CompleteRegion::Manifest(data) => look_up(demand, move |demand| demand.tileset(&data)).await,
    };
    let document = match content {
        Some(Content::Bytes(data)) => Document::mutable(data, media_of(name)),
        Some(Content::File(path, bytes)) => {
            let tag = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            Document::revalidated(&tag, Content::File(path, bytes), media_of(name))
        }
        _ => return respond::text_response(StatusCode::NOT_FOUND, "no such file"),
    };
    respond::document(request, &document).await
}

async fn file(demand: &Arc<Demand>, name: &str, request: &DocumentRequest<'_>) -> Response<Body> {
    let owned_name = name.to_owned();
    let Some(content) = look_up(demand, move |demand| demand.file(&owned_name)).await else {
        return respond::text_response(StatusCode::NOT_FOUND, "no such file");
    };
    respond::document(request, &Document::immutable(name, content, media_of(name))).await
}

fn refuse(refusal: Refusal) -> Response<Body> {
    let (status, reason) = match refusal {
        Refusal::TooManyOfClient(limit) => {
            (StatusCode::TOO_MANY_REQUESTS, format!("this address already waits for {limit} regions"))
        }
        Refusal::TooMany(limit) => {
            (StatusCode::SERVICE_UNAVAILABLE, format!("clients already wait for {limit} regions"))
        }
        Refusal::Closing => (StatusCode::SERVICE_UNAVAILABLE, "the server is shutting down".to_owned()),
    };
    respond::text_response_with(status, &reason, header::RETRY_AFTER, "2")
}

fn media_of(name: &str) -> &'static str {
    let suffix = name.rsplit('.').next().unwrap_or_default();
    MEDIA.iter().find(|(listed, _)| *listed == suffix).map_or("application/octet-stream", |(_, media)| media)
}
