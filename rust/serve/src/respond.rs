//! Answers with documents: whole, in part, or that the client has them already.

use std::io;
use std::ops::Range;
use std::path::Path;

use axum::body::Body;
use axum::http::header::{self, HeaderMap, HeaderValue};
use axum::http::{Method, Response, StatusCode};
use bytes::Bytes;
use tokio::io::{AsyncReadExt, AsyncSeekExt};
use tokio_util::io::ReaderStream;

use crate::ranges::{Wanted, wanted};
use crate::site::{Content, Document};

/// For documents that are named by their content.
const FOREVER: &str = "public, max-age=31536000, immutable";
/// Bytes that are read from a file at once.
const PIECE: usize = 1 << 18;

/// Answer a request with a document.
pub async fn document(method: &Method, asked: &HeaderMap, document: &Document) -> Response<Body> {
    let head = Response::builder()
        .header(header::ETAG, &document.tag)
        .header(header::CACHE_CONTROL, if document.is_immutable { FOREVER } else { "no-cache" })
        .header(header::ACCEPT_RANGES, "bytes");
    if knows(asked, &document.tag) {
        return finished(head.status(StatusCode::NOT_MODIFIED).body(Body::empty()));
    }
    let (bytes, opened) = match open(&document.content).await {
        Ok(opened) => opened,
        Err(error) => {
            tracing::warn!(%error, "a document cannot be read");
            return refusal(StatusCode::NOT_FOUND, "the file cannot be read");
        }
    };
    // One strong tag, unlike If-None-Match.
    let is_same = asked.get(header::IF_RANGE).is_none_or(|value| value.as_bytes() == document.tag.as_bytes());
    let range = asked.get(header::RANGE).and_then(|value| value.to_str().ok()).filter(|_| is_same);
    let head = head.header(header::CONTENT_TYPE, &document.media);
    let (head, part) = match wanted(range, bytes) {
        Wanted::Whole => (head.status(StatusCode::OK), 0..bytes),
        Wanted::Part(part) => {
            let told = format!("bytes {}-{}/{bytes}", part.start, part.end - 1);
            (head.status(StatusCode::PARTIAL_CONTENT).header(header::CONTENT_RANGE, told), part)
        }
        Wanted::Nothing => {
            let mut answer = refusal(StatusCode::RANGE_NOT_SATISFIABLE, "the file is shorter");
            let told = format!("bytes */{bytes}");
            answer
                .headers_mut()
                .insert(header::CONTENT_RANGE, told.parse().unwrap_or(HeaderValue::from_static("bytes */*")));
            return answer;
        }
    };
    let head = head.header(header::CONTENT_LENGTH, part.end - part.start);
    if *method == Method::HEAD {
        return finished(head.body(Body::empty()));
    }
    match opened.read(part).await {
        Ok(body) => finished(head.body(body)),
        Err(error) => {
            tracing::warn!(%error, "a document cannot be read");
            refusal(StatusCode::NOT_FOUND, "the file cannot be read")
        }
    }
}

/// An answer that tells why there is no document.
pub fn refusal(status: StatusCode, reason: &str) -> Response<Body> {
    let text = format!("{status}: {reason}\n");
    let head = Response::builder().status(status).header(header::CACHE_CONTROL, "no-store");
    finished(head.header(header::CONTENT_TYPE, "text/plain; charset=utf-8").body(Body::from(text)))
}

/// An answer whose headers are known to be valid.
pub fn finished(answer: Result<Response<Body>, axum::http::Error>) -> Response<Body> {
    answer.unwrap_or_else(|_| {
        let mut failed = Response::new(Body::empty());
        *failed.status_mut() = StatusCode::INTERNAL_SERVER_ERROR;
        failed
    })
}

/// Whether `If-None-Match` names a tag, or any.
fn knows(asked: &HeaderMap, tag: &str) -> bool {
    let values = asked.get_all(header::IF_NONE_MATCH);
    let mut listed = values.iter().filter_map(|value| value.to_str().ok()).flat_map(|text| text.split(','));
    listed.any(|each| matches!(each.trim(), "*") || each.trim().trim_start_matches("W/") == tag)
}

/// Content that can be read.
enum Opened {
    Bytes(Bytes),
    File(tokio::fs::File),
}

async fn open(content: &Content) -> io::Result<(u64, Opened)> {
    match content {
        Content::Bytes(data) => Ok((data.len() as u64, Opened::Bytes(data.clone()))),
        Content::File(path, bytes) => {
            let file = open_file(path).await?;
            let found = file.metadata().await?;
            if !found.is_file() || found.len() != *bytes {
                let message = format!("{}: expected {bytes} bytes, got {}", path.display(), found.len());
                return Err(io::Error::new(io::ErrorKind::InvalidData, message));
            }
            Ok((*bytes, Opened::File(file)))
        }
        Content::Elsewhere(read) => {
            let read = read.clone();
            let data = tokio::task::spawn_blocking(move || read()).await.map_err(io::Error::other)??;
            Ok((data.len() as u64, Opened::Bytes(data)))
        }
    }
}

/// Open a file; a link in its place may lead out of the bundle.
async fn open_file(path: &Path) -> io::Result<tokio::fs::File> {
    let mut options = tokio::fs::OpenOptions::new();
    options.read(true);
    #[cfg(unix)]
    options.custom_flags(libc::O_NOFOLLOW);
    options.open(path).await
}

impl Opened {
    async fn read(self, part: Range<u64>) -> io::Result<Body> {
        match self {
            Opened::Bytes(data) => {
                let place = |value: u64| usize::try_from(value).unwrap_or(usize::MAX).min(data.len());
                Ok(Body::from(data.slice(place(part.start)..place(part.end))))
            }
            Opened::File(mut file) => {
                file.seek(io::SeekFrom::Start(part.start)).await?;
                let reader = file.take(part.end - part.start);
                Ok(Body::from_stream(ReaderStream::with_capacity(reader, PIECE)))
            }
        }
    }
}
