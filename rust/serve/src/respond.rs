//! HTTP responses: documents in full, in part or "not modified", and plain texts.

use std::io;
use std::net::IpAddr;
use std::ops::Range;

use axum::body::Body;
use axum::http::header::{self, HeaderMap, HeaderName};
use axum::http::response::Builder;
use axum::http::{Method, Response, StatusCode};

use crate::gzip::GzipCache;
use crate::site::Document;

/// Cache-Control of documents that are named by their content.
const FOREVER: &str = "public, max-age=31536000, immutable";

/// A client's request for a document.
pub struct DocumentRequest<'a> {
    /// Address of the client.
    pub client: IpAddr,
    /// GET or HEAD.
    pub method: &'a Method,
    /// Headers of the request.
    pub headers: &'a HeaderMap,
    /// Cache of compressed documents.
    pub gzip: &'a GzipCache,
}

/// Responds with a document.
pub async fn document(request: &DocumentRequest<'_>, document: &Document) -> Response<Body> {
    match try_document(request, document).await {
        Ok(answer) => answer,
        Err(error) => {
            tracing::warn!(%error, "a document cannot be read");
            text_response(StatusCode::NOT_FOUND, "the file cannot be read")
        }
    }
}

async fn try_document(request: &DocumentRequest<'_>, document: &Document) -> io::Result<Response<Body>> {
    let copy_tag = format!("{}-gzip\"", document.tag.trim_end_matches('"'));
    if let Some(tag) = [&document.tag, &copy_tag].into_iter().find(|tag| matches_tag(request.headers, tag)) {
        return Ok(finish(head(document, tag).status(StatusCode::NOT_MODIFIED).body(Body::empty())));
    }
    // Ranges refer to the uncompressed content.
    let may_compress = accepts_gzip(request.headers) && !request.headers.contains_key(header::RANGE);
    if may_compress && document.is_worth_compressing() {
        let read = async {
            let (bytes, opened) = document.content.open().await?;
            opened.bytes(0..bytes).await
        };
        // The tag alone is not enough: a damaged file may be replaced under the same name.
        let key = format!("{} {}", document.tag, document.content.version().await?);
        if let Some(copy) = request.gzip.get(&key, read).await? {
            let head = head(document, &copy_tag)
                .header(header::CONTENT_TYPE, &document.media)
                .header(header::CONTENT_ENCODING, "gzip")
                .header(header::CONTENT_LENGTH, copy.len());
            return Ok(finish(head.body(Body::from(copy))));
        }
    }
    try_uncompressed(request, document).await
}

/// Headers that all responses with a document have; `tag` distinguishes its compressed copy.
fn head(document: &Document, tag: &str) -> Builder {
    let head = Response::builder()
        .header(header::ETAG, tag)
        .header(header::CACHE_CONTROL, if document.is_immutable { FOREVER } else { "no-cache" })
        .header(header::ACCEPT_RANGES, "bytes");
    if document.is_compressible { head.header(header::VARY, "accept-encoding") } else { head }
}

/// Responds with the uncompressed document or the requested part of it.
async fn try_uncompressed(request: &DocumentRequest<'_>, document: &Document) -> io::Result<Response<Body>> {
    let (bytes, opened) = document.content.open().await?;
    // If-Range has one strong tag, unlike If-None-Match.
    let is_same = request.headers.get(header::IF_RANGE).is_none_or(|value| value.as_bytes() == document.tag.as_bytes());
    let range = request.headers.get(header::RANGE).and_then(|value| value.to_str().ok()).filter(|_| is_same);
    let head = head(document, &document.tag).header(header::CONTENT_TYPE, &document.media);
    let (head, part) = match requested_range(range, bytes) {
        RequestedRange::All => (head.status(StatusCode::OK), 0..bytes),
        RequestedRange::Part(part) => {
            let range = format!("bytes {}-{}/{bytes}", part.start, part.end - 1);
            (head.status(StatusCode::PARTIAL_CONTENT).header(header::CONTENT_RANGE, range), part)
        }
        RequestedRange::Unsatisfiable => {
            let (status, range) = (StatusCode::RANGE_NOT_SATISFIABLE, format!("bytes */{bytes}"));
            return Ok(text_response_with(status, "the file is shorter", header::CONTENT_RANGE, &range));
        }
    };
    let head = head.header(header::CONTENT_LENGTH, part.end - part.start);
    let is_head = *request.method == Method::HEAD;
    Ok(finish(head.body(if is_head { Body::empty() } else { opened.body(part).await? })))
}

/// Meaning of a `Range` header for a file (RFC 9110, section 14).
#[derive(Debug, PartialEq)]
enum RequestedRange {
    /// The whole file: no such header, or one that may be ignored, such as one with several ranges.
    All,
    /// A byte range.
    Part(Range<u64>),
    /// The range lies beyond the file's end.
    Unsatisfiable,
}

/// Parses a `Range` header for a file of `bytes` bytes.
fn requested_range(header: Option<&str>, bytes: u64) -> RequestedRange {
    let Some(text) = header.and_then(|text| text.trim().strip_prefix("bytes=")) else { return RequestedRange::All };
    let Some((first, last)) = text.trim().split_once('-') else { return RequestedRange::All };
    let is_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    if !is_digits(first) || !is_digits(last) {
        return RequestedRange::All;
    }
    // None if the number is missing. Numbers beyond 64 bits lie beyond the end of every file.
    let number = |text: &str| (!text.is_empty()).then(|| text.parse().unwrap_or(u64::MAX));
    match (number(first), number(last)) {
        // Suffix range: the last `count` bytes.
        (None, Some(count)) if count > 0 && bytes > 0 => RequestedRange::Part(bytes.saturating_sub(count)..bytes),
        (None, Some(_)) => RequestedRange::Unsatisfiable,
        (Some(first), Some(last)) if last < first => RequestedRange::All,
        (Some(first), _) if first >= bytes => RequestedRange::Unsatisfiable,
        (Some(first), None) => RequestedRange::Part(first..bytes),
        (Some(first), Some(last)) => RequestedRange::Part(first..last.saturating_add(1).min(bytes)),
        (None, None) => RequestedRange::All,
    }
}

/// Plain-text response with a status and a sentence.
pub fn text_response(status: StatusCode, reason: &str) -> Response<Body> {
    let text = format!("{status}: {reason}\n");
    let head = Response::builder().status(status).header(header::CACHE_CONTROL, "no-store");
    finish(head.header(header::CONTENT_TYPE, "text/plain; charset=utf-8").body(Body::from(text)))
}

/// Plain-text response with one more header, which is left out if its value is invalid.
pub fn text_response_with(status: StatusCode, reason: &str, name: HeaderName, value: &str) -> Response<Body> {
    let mut answer = text_response(status, reason);
    if let Ok(value) = value.parse() {
        answer.headers_mut().insert(name, value);
    }
    answer
}

/// Permanent redirection to an address.
pub fn redirection(target: &str, reason: &str) -> Response<Body> {
    text_response_with(StatusCode::PERMANENT_REDIRECT, reason, header::LOCATION, target)
}

/// Unwraps a response whose headers are known to be valid.
pub fn finish(answer: Result<Response<Body>, axum::http::Error>) -> Response<Body> {
    answer.unwrap_or_else(|_| {
        let mut failed = Response::new(Body::empty());
        *failed.status_mut() = StatusCode::INTERNAL_SERVER_ERROR;
        failed
    })
}

/// Whether `If-None-Match` contains a tag or `*`.
fn matches_tag(headers: &HeaderMap, tag: &str) -> bool {
    header_items(headers, header::IF_NONE_MATCH)
        .any(|tag_item| tag_item == "*" || tag_item.trim_start_matches("W/") == tag)
}

/// Whether `Accept-Encoding` contains gzip.
fn accepts_gzip(headers: &HeaderMap) -> bool {
    header_items(headers, header::ACCEPT_ENCODING).any(|coding| {
        let (name, weight) = coding.split_once(';').unwrap_or((coding, ""));
        let weight = weight.trim().strip_prefix("q=").map_or(Ok(1.0), str::parse::<f32>);
        matches!(name.trim().to_ascii_lowercase().as_str(), "gzip" | "*") && weight.is_ok_and(|weight| weight > 0.0)
    })
}

/// Comma-separated items of all headers with a name.
fn header_items(headers: &HeaderMap, name: HeaderName) -> impl Iterator<Item = &str> {
    let values = headers.get_all(name).into_iter().filter_map(|value| value.to_str().ok());
    values.flat_map(|text| text.split(',')).map(str::trim)
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::io::Read;
    use std::time::SystemTime;

    use axum::body::to_bytes;

    use super::*;
    use crate::site::Content;

    #[test]
    fn accepted_encodings_are_parsed() {
        for (header, expected) in [
            ("gzip", true),
            ("br, GZIP", true),
            ("gzip;q=0.5, br", true),
            ("*", true),
            ("gzip;q=0", false),
            ("gzip;q=0.000, br", false),
            ("br, zstd", false),
            ("x-gzipped", false),
            ("gzip;q=wrong", false),
            ("", false),
        ] {
            let mut headers = HeaderMap::new();
            headers.insert(header::ACCEPT_ENCODING, header.parse().expect("a header"));
            assert_eq!(accepts_gzip(&headers), expected, "{header}");
        }
        assert!(!accepts_gzip(&HeaderMap::new()));
    }

    /// Only on Unix: other systems distinguish versions of a file only by the modification time.
    #[cfg(unix)]
    #[tokio::test]
    async fn compressed_copies_follow_the_file() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().canonicalize().expect("a path").join("a.glb");
        let served = Document::immutable("files/a.glb", Content::File(path.clone(), 5000), "model/gltf-binary");
        let (headers, gzip) = ([(header::ACCEPT_ENCODING, "gzip".parse().expect("a header"))], GzipCache::new(1 << 20));
        let headers = HeaderMap::from_iter(headers);
        let client = IpAddr::from([127, 0, 0, 1]);
        let request = DocumentRequest { client, method: &Method::GET, headers: &headers, gzip: &gzip };
        for letter in [b'x', b'a'] {
            // A new file with the size and the modification time of the one before, as a restored backup has them.
            fs::write(path.with_extension("new"), [letter; 5000]).expect("written");
            let file = fs::File::options().append(true).open(path.with_extension("new")).expect("a file");
            file.set_modified(SystemTime::UNIX_EPOCH).expect("a time");
            fs::rename(path.with_extension("new"), &path).expect("replaced");
            for _ in 0..2 {
                let answer = document(&request, &served).await;
                assert_eq!(answer.headers()[header::CONTENT_ENCODING], "gzip");
                let copy = to_bytes(answer.into_body(), usize::MAX).await.expect("a body");
                let mut content = Vec::new();
                flate2::read::GzDecoder::new(&copy[..]).read_to_end(&mut content).expect("a copy");
                assert!(content == [letter; 5000]);
            }
        }
    }

    #[test]
    fn ranges_follow_the_standard() {
        let part = |range| RequestedRange::Part(range);
        for (header, expected) in [
            ("bytes=0-0", part(0..1)),
            ("bytes=2-5", part(2..6)),
            ("bytes=2-", part(2..10)),
            ("bytes=2-99", part(2..10)),
            ("bytes=-3", part(7..10)),
            ("bytes=-99", part(0..10)),
            ("bytes=9-18446744073709551615", part(9..10)),
            ("bytes=10-", RequestedRange::Unsatisfiable),
            ("bytes=-0", RequestedRange::Unsatisfiable),
            ("bytes=99999999999999999999999-", RequestedRange::Unsatisfiable),
            ("bytes=5-2", RequestedRange::All),
            ("bytes=0-1,3-4", RequestedRange::All),
            ("bytes=a-b", RequestedRange::All),
            ("bytes=20-a", RequestedRange::All),
            ("bytes=-", RequestedRange::All),
            ("bytes=+1-2", RequestedRange::All),
            ("items=0-1", RequestedRange::All),
            ("", RequestedRange::All),
        ] {
            assert_eq!(requested_range(Some(header), 10), expected, "{header}");
        }
        assert_eq!(requested_range(None, 10), RequestedRange::All);
        assert_eq!(requested_range(Some("bytes=0-"), 0), RequestedRange::Unsatisfiable);
        assert_eq!(requested_range(Some("bytes=-5"), 0), RequestedRange::Unsatisfiable);
    }
}
