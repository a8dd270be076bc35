//! Places, queries and headers of a request: an answer, and parts of documents that are those of their content.

#![no_main]

use std::io::Read;
use std::sync::LazyLock;

use arbitrary::Arbitrary;
use axum::http::header::{
    ACCEPT_ENCODING, CONTENT_ENCODING, CONTENT_RANGE, ETAG, HOST, IF_NONE_MATCH, IF_RANGE, RANGE,
};
use axum::http::{HeaderMap, HeaderName, HeaderValue, Method, StatusCode, Uri};
use flate2::read::GzDecoder;
use libfuzzer_sys::fuzz_target;
use nearfar_fuzz::served::{NAME, Served};

static SERVED: LazyLock<Served> = LazyLock::new(|| Served::new("query", true));

#[derive(Arbitrary, Debug)]
enum Named {
    Document(u8),
    Place([Coordinate; 3], Below),
    Places(Vec<Coordinate>, Below),
    Text(String, Below),
}

#[derive(Arbitrary, Debug)]
enum Coordinate {
    Small(i8, u8),
    Number(f64),
    Text(String),
}

#[derive(Arbitrary, Debug)]
enum Below {
    Parts,
    Manifest,
    Tileset,
    File,
}

#[derive(Arbitrary, Debug)]
enum Tag {
    Own,
    Weak,
    Listed,
    Any,
    Other(Vec<u8>),
}

#[derive(Arbitrary, Debug)]
enum Part {
    Numbers(Option<u64>, Option<u64>),
    Near(u8, u8),
    Other(Vec<u8>),
}

#[derive(Arbitrary, Debug)]
enum Host {
    Own(Option<u16>),
    Other(Vec<u8>),
}

#[derive(Arbitrary, Debug)]
struct Input {
    named: Named,
    query: Option<String>,
    method: Option<String>,
    part: Option<Part>,
    if_range: Option<Tag>,
    if_none_match: Option<Tag>,
    host: Option<Host>,
    encodings: Option<Encodings>,
}

#[derive(Arbitrary, Debug)]
enum Encodings {
    Gzip,
    Listed(u8),
    Other(Vec<u8>),
}

/// A target; characters that targets don't have are encoded.
fn target(path: &str, query: Option<&str>) -> Option<Uri> {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"/,.+-_".contains(&byte);
    let encoded = |text: &str| -> String {
        text.bytes()
            .map(|byte| if plain(byte) { char::from(byte).to_string() } else { format!("%{byte:02x}") })
            .collect()
    };
    let query = query.map(|text| format!("?{}", encoded(text))).unwrap_or_default();
    format!("/{}{query}", encoded(path)).parse().ok()
}

fn path(named: &Named) -> String {
    let texts = |given: &[Coordinate]| -> String {
        let texts: Vec<String> = given
            .iter()
            .map(|each| match each {
                Coordinate::Small(whole, part) => format!("{whole}.{part}"),
                Coordinate::Number(value) => format!("{value:e}"),
                Coordinate::Text(text) => text.clone(),
            })
            .collect();
        texts.join(",")
    };
    let below = |below: &Below| match below {
        Below::Parts => "parts",
        Below::Manifest => "manifest.json",
        Below::Tileset => "tileset.json",
        Below::File => "files/part",
    };
    match named {
        Named::Document(number) => {
            let count = SERVED.listed.len();
            SERVED.listed.keys().nth(usize::from(*number) % count).cloned().unwrap_or_default()
        }
        Named::Place(given, name) => format!("at/{}/{}", texts(given), below(name)),
        Named::Places(given, name) => format!("at/{}/{}", texts(given), below(name)),
        Named::Text(text, name) => format!("at/{text}/{}", below(name)),
    }
}

fn insert(headers: &mut HeaderMap, name: HeaderName, value: &[u8]) -> Option<HeaderValue> {
    let value = HeaderValue::from_bytes(value).ok()?;
    headers.insert(name, value.clone());
    Some(value)
}

fn tag_header(tag: &Tag, own: &str) -> Vec<u8> {
    match tag {
        Tag::Own => own.as_bytes().to_vec(),
        Tag::Weak => format!("W/{own}").into_bytes(),
        Tag::Listed => format!("\"other\", {own}").into_bytes(),
        Tag::Any => b"*".to_vec(),
        Tag::Other(bytes) => bytes.clone(),
    }
}

fn part_header(part: &Part) -> Vec<u8> {
    let told = |number: &Option<u64>| number.map(|number| number.to_string()).unwrap_or_default();
    match part {
        Part::Numbers(first, last) => format!("bytes={}-{}", told(first), told(last)).into_bytes(),
        Part::Near(first, last) => format!("bytes={first}-{last}").into_bytes(),
        Part::Other(bytes) => bytes.clone(),
    }
}

/// Bytes that a part asks for, found by looking at each; none for the whole content.
fn expected(part: &Part, content: &[u8]) -> Option<Vec<u8>> {
    let (first, last) = match part {
        Part::Numbers(first, last) => (*first, *last),
        Part::Near(first, last) => (Some(u64::from(*first)), Some(u64::from(*last))),
        Part::Other(_) => return None,
    };
    let count = content.len() as u64;
    let is_in = |place: u64| match (first, last) {
        (Some(first), Some(last)) => first <= place && place <= last,
        (Some(first), None) => first <= place,
        (None, Some(last)) => count - place <= last,
        (None, None) => true,
    };
    let is_whole = matches!((first, last), (None, None)) || first.zip(last).is_some_and(|(first, last)| last < first);
    let bytes = content.iter().enumerate().filter(|(place, _)| is_in(*place as u64)).map(|(_, byte)| *byte);
    if is_whole { None } else { Some(bytes.collect()) }
}

/// The answer with a part is that part of the content, wherever it says that it begins.
fn check_part(told: Option<&HeaderValue>, body: &[u8], content: &[u8]) {
    let text = told.and_then(|value| value.to_str().ok()).expect("a part tells where it lies");
    let (place, count) = text.strip_prefix("bytes ").and_then(|text| text.split_once('/')).expect("place/count");
    let (first, last) = place.split_once('-').expect("first-last");
    let [first, last, count] = [first, last, count].map(|text| text.parse::<usize>().expect("a number"));
    assert_eq!((&content[first..=last], content.len()), (body, count));
}

/// A compressed answer has the same content.
fn check_encodings(encodings: &Encodings, uri: &Uri, content: &[u8]) {
    let listed = match encodings {
        Encodings::Gzip => b"gzip".to_vec(),
        Encodings::Listed(weight) => format!("br, gzip;q={}", f32::from(*weight) / 100.0).into_bytes(),
        Encodings::Other(bytes) => bytes.clone(),
    };
    let mut headers = HeaderMap::new();
    insert(&mut headers, ACCEPT_ENCODING, &listed);
    let answer = SERVED.ask_twice(uri, &headers);
    assert_eq!(answer.status, StatusCode::OK);
    if answer.headers.contains_key(CONTENT_ENCODING) {
        let mut unpacked = Vec::new();
        GzDecoder::new(&answer.body[..]).read_to_end(&mut unpacked).expect("gzip");
        assert_eq!(unpacked, content);
    } else {
        assert_eq!(&answer.body[..], content);
    }
}

fuzz_target!(|input: Input| {
    let path = path(&input.named);
    let Some(uri) = target(&path, input.query.as_deref()) else { return };
    let none = HeaderMap::new();
    if let Some(method) = input.method.as_ref().and_then(|text| Method::from_bytes(text.as_bytes()).ok())
        && !matches!(method, Method::GET | Method::HEAD)
    {
        assert!(!SERVED.ask(method, &uri, &none).status.is_server_error());
    }
    let plain = SERVED.ask_twice(&uri, &none);
    let content = SERVED.listed.get(&path).map_or(&plain.body[..], |content| &content[..]);
    if SERVED.listed.contains_key(&path) {
        assert_eq!((plain.status, &plain.body[..]), (StatusCode::OK, content));
    } else {
        assert!(plain.status == StatusCode::OK || plain.status.is_client_error());
        assert!(plain.status != StatusCode::OK || SERVED.is_of_region(&path), "{path}");
    }
    let mut headers = HeaderMap::new();
    if let Some(host) = &input.host {
        let name = match host {
            Host::Own(None) => NAME.as_bytes().to_vec(),
            Host::Own(Some(port)) => format!("{NAME}:{port}").into_bytes(),
            Host::Other(bytes) => bytes.clone(),
        };
        let is_set = insert(&mut headers, HOST, &name).is_some();
        let answer = SERVED.ask_twice(&uri, &headers);
        let lower = name.to_ascii_lowercase();
        let port = lower.strip_prefix(NAME.as_bytes()).and_then(|rest| rest.strip_prefix(b":").or(Some(rest)));
        let is_own = port.is_some_and(|port| port.iter().all(u8::is_ascii_digit));
        assert!(answer.status == StatusCode::FORBIDDEN || is_own || !is_set, "{name:?}");
        headers.remove(HOST);
    }
    // Lines on a region's parts differ from request to request.
    let Some(own) = plain.headers.get(ETAG).and_then(|value| value.to_str().ok()) else { return };
    if let Some(encodings) = &input.encodings {
        check_encodings(encodings, &uri, content);
    }
    let part = input.part.as_ref().filter(|part| insert(&mut headers, RANGE, &part_header(part)).is_some());
    let is_same = match &input.if_range {
        Some(tag) => insert(&mut headers, IF_RANGE, &tag_header(tag, own)).is_none_or(|value| value == own),
        None => true,
    };
    let known = input.if_none_match.as_ref();
    let known = known.filter(|tag| insert(&mut headers, IF_NONE_MATCH, &tag_header(tag, own)).is_some());
    let answer = SERVED.ask_twice(&uri, &headers);
    match known {
        Some(Tag::Other(_)) if answer.status == StatusCode::NOT_MODIFIED => return,
        Some(Tag::Own | Tag::Weak | Tag::Listed | Tag::Any) => {
            assert_eq!((answer.status, answer.body.len()), (StatusCode::NOT_MODIFIED, 0));
            return;
        }
        _ => {}
    }
    match answer.status {
        StatusCode::OK => assert_eq!(&answer.body[..], content),
        StatusCode::PARTIAL_CONTENT => check_part(answer.headers.get(CONTENT_RANGE), &answer.body, content),
        other => assert_eq!(other, StatusCode::RANGE_NOT_SATISFIABLE),
    }
    match part.filter(|_| is_same) {
        None => assert_eq!(answer.status, StatusCode::OK),
        Some(Part::Other(_)) => {}
        Some(part) => match expected(part, content) {
            None => assert_eq!(answer.status, StatusCode::OK),
            Some(bytes) if bytes.is_empty() => assert_eq!(answer.status, StatusCode::RANGE_NOT_SATISFIABLE),
            Some(bytes) => assert_eq!((answer.status, &answer.body[..]), (StatusCode::PARTIAL_CONTENT, &bytes[..])),
        },
    }
});
