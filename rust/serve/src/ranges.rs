//! Byte range that a request asks for (RFC 9110, section 14).

use std::ops::Range;

/// Meaning of a `Range` header for a file.
#[derive(Debug, PartialEq)]
pub enum Requested {
    /// The whole file: no such header, or one that may be ignored, such as one with several ranges.
    All,
    /// A byte range.
    Part(Range<u64>),
    /// The range lies beyond the file's end.
    Unsatisfiable,
}

/// Parses a `Range` header for a file of `bytes` bytes.
pub fn parse(header: Option<&str>, bytes: u64) -> Requested {
    let Some(text) = header.and_then(|text| text.trim().strip_prefix("bytes=")) else { return Requested::All };
    let Some((first, last)) = text.trim().split_once('-') else { return Requested::All };
    match (number(first), number(last)) {
        // Suffix range: the last `count` bytes.
        (Number::Missing, Number::Is(count)) if count > 0 && bytes > 0 => {
            Requested::Part(bytes.saturating_sub(count)..bytes)
        }
        (Number::Missing, Number::Is(_)) => Requested::Unsatisfiable,
        (Number::Is(first), Number::Is(last)) if last < first => Requested::All,
        (Number::Is(first), _) if first >= bytes => Requested::Unsatisfiable,
        (Number::Is(first), Number::Missing) => Requested::Part(first..bytes),
        (Number::Is(first), Number::Is(last)) => Requested::Part(first..last.saturating_add(1).min(bytes)),
        _ => Requested::All,
    }
}

enum Number {
    Missing,
    Is(u64),
    Wrong,
}

fn number(text: &str) -> Number {
    match text {
        "" => Number::Missing,
        // Numbers beyond 64 bits lie beyond the end of every file.
        _ if text.bytes().all(|byte| byte.is_ascii_digit()) => Number::Is(text.parse().unwrap_or(u64::MAX)),
        _ => Number::Wrong,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_follow_the_standard() {
        let part = |range| Requested::Part(range);
        for (header, expected) in [
            ("bytes=0-0", part(0..1)),
            ("bytes=2-5", part(2..6)),
            ("bytes=2-", part(2..10)),
            ("bytes=2-99", part(2..10)),
            ("bytes=-3", part(7..10)),
            ("bytes=-99", part(0..10)),
            ("bytes=9-18446744073709551615", part(9..10)),
            ("bytes=10-", Requested::Unsatisfiable),
            ("bytes=-0", Requested::Unsatisfiable),
            ("bytes=99999999999999999999999-", Requested::Unsatisfiable),
            ("bytes=5-2", Requested::All),
            ("bytes=0-1,3-4", Requested::All),
            ("bytes=a-b", Requested::All),
            ("bytes=-", Requested::All),
            ("bytes=+1-2", Requested::All),
            ("items=0-1", Requested::All),
            ("", Requested::All),
        ] {
            assert_eq!(parse(Some(header), 10), expected, "{header}");
        }
        assert_eq!(parse(None, 10), Requested::All);
        assert_eq!(parse(Some("bytes=0-"), 0), Requested::Unsatisfiable);
        assert_eq!(parse(Some("bytes=-5"), 0), Requested::Unsatisfiable);
    }
}
