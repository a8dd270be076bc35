//! Any bytes as the target of a request: listed documents come, nothing else does, and no secret.

#![no_main]

use std::sync::LazyLock;

use axum::http::header::LOCATION;
use axum::http::{HeaderMap, HeaderValue, StatusCode, Uri};
use libfuzzer_sys::fuzz_target;
use nearfar_fuzz::served::Served;

static SEVERAL: LazyLock<Served> = LazyLock::new(|| Served::new("paths", false));
static SINGLE: LazyLock<Served> = LazyLock::new(|| Served::new("path", true));

/// Percent signs with two digits become bytes; none if these are no text.
fn decoded(path: &[u8]) -> Option<String> {
    let mut bytes = Vec::new();
    let mut rest = path;
    while let Some((first, after)) = rest.split_first() {
        let digits = std::str::from_utf8(after.get(..2).unwrap_or_default()).unwrap_or_default();
        let is_hex = digits.len() == 2 && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
        let (byte, after) = match u8::from_str_radix(digits, 16) {
            Ok(byte) if *first == b'%' && is_hex => (byte, &after[2..]),
            _ => (*first, after),
        };
        bytes.push(byte);
        rest = after;
    }
    String::from_utf8(bytes).ok()
}

fn encoded(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("%{byte:02x}")).collect()
}

/// Ask for a target: a path, an address or a name.
fn check(served: &Served, target: &[u8]) {
    let Ok(uri) = Uri::try_from(target) else { return };
    let answer = served.ask_twice(&uri, &HeaderMap::new());
    let path = if target[0] == b'/' { target } else { uri.path().as_bytes() };
    let path = path.split(|byte| b"?#".contains(byte)).next().and_then(|path| path.strip_prefix(b"/"));
    let path = path.and_then(decoded);
    match path.as_ref().and_then(|path| served.listed.get(path)) {
        Some(content) => assert_eq!((answer.status, &answer.body[..]), (StatusCode::OK, &content[..]), "{path:?}"),
        None if path.as_ref().is_some_and(|path| path == "metrics" || served.is_of_region(path)) => {}
        None if path.is_some_and(|path| served.sites.contains(&path.as_str())) => {
            let location = answer.headers.get(LOCATION).map(HeaderValue::as_bytes);
            assert_eq!(location, Some(format!("{}/", uri.path()).as_bytes()));
            assert!(!uri.path().starts_with("//"), "another server");
        }
        None => assert!(answer.status.is_client_error(), "{uri}: {}", answer.status),
    }
}

fuzz_target!(|target: &[u8]| {
    for served in [&*SEVERAL, &*SINGLE] {
        check(served, target);
        check(served, format!("/{}", encoded(target)).as_bytes());
        for site in ["memory", "disk", "scene"] {
            check(served, &[b"/", site.as_bytes(), b"/", target].concat());
            check(served, format!("/{site}/{}", encoded(target)).as_bytes());
        }
    }
});
