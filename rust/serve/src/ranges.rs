//! Byte range that a request asks for (RFC 9110, section 14).

use std::ops::Range;

/// Meaning of a `Range` header for a file.
#[derive(Debug, PartialEq)]
pub enum Wanted {
    /// The whole file: no such header, or one that may be ignored, such as one with several ranges.
    Whole,
    /// A byte range.
    Part(Range<u64>),
    /// The range lies beyond the file's end.
    Nothing,
}

/// Parses a `Range` header for a file of `bytes` bytes.
pub fn parse(header: Option<&str>, bytes: u64) -> Wanted {
    let Some(text) = header.and_then(|text| text.trim().strip_prefix("bytes=")) else { return Wanted::Whole };
    let Some((first, last)) = text.trim().split_once('-') else { return Wanted::Whole };
    match (number(first), number(last)) {
        // Suffix range: the last `count` bytes.
        (Number::Missing, Number::Is(count)) if count > 0 && bytes > 0 => {
            Wanted::Part(bytes.saturating_sub(count)..bytes)
        }
        (Number::Missing, Number::Is(_)) => Wanted::Nothing,
        (Number::Is(first), Number::Is(last)) if last < first => Wanted::Whole,
        (Number::Is(first), _) if first >= bytes => Wanted::Nothing,
        (Number::Is(first), Number::Missing) => Wanted::Part(first..bytes),
        (Number::Is(first), Number::Is(last)) => Wanted::Part(first..last.saturating_add(1).min(bytes)),
        _ => Wanted::Whole,
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
        let part = |range| Wanted::Part(range);
        for (header, expected) in [
            ("bytes=0-0", part(0..1)),
            ("bytes=2-5", part(2..6)),
            ("bytes=2-", part(2..10)),
            ("bytes=2-99", part(2..10)),
            ("bytes=-3", part(7..10)),
            ("bytes=-99", part(0..10)),
            ("bytes=9-18446744073709551615", part(9..10)),
            ("bytes=10-", Wanted::Nothing),
            ("bytes=-0", Wanted::Nothing),
            ("bytes=99999999999999999999999-", Wanted::Nothing),
            ("bytes=5-2", Wanted::Whole),
            ("bytes=0-1,3-4", Wanted::Whole),
            ("bytes=a-b", Wanted::Whole),
            ("bytes=-", Wanted::Whole),
            ("bytes=+1-2", Wanted::Whole),
            ("items=0-1", Wanted::Whole),
            ("", Wanted::Whole),
        ] {
            assert_eq!(parse(Some(header), 10), expected, "{header}");
        }
        assert_eq!(parse(None, 10), Wanted::Whole);
        assert_eq!(parse(Some("bytes=0-"), 0), Wanted::Nothing);
        assert_eq!(parse(Some("bytes=-5"), 0), Wanted::Nothing);
    }
}
