//! Wavefront OBJ text made plain before a general reader takes it: readers count indices from the end of the file, skip
//! lines that are indented, and take what an index of 0 happens to meet.

use std::borrow::Cow;

use crate::base::{Error, Result};

/// Kinds of indices, in the order in which a face's corner names them.
const KINDS: [&str; 3] = ["vertex", "texture coordinate", "normal"];
/// Keywords of lines that readers must not miss.
const KEYWORDS: [&[u8]; 8] = [b"v", b"vt", b"vn", b"f", b"o", b"g", b"usemtl", b"mtllib"];

/// Returns the text with all indices of faces counted from 1, one blank after keywords, no indentation, and no line that
/// goes on in the next one; nothing if the text is so already.
///
/// Indices that name nothing are errors with the number of their line. Indices may name what follows later.
pub fn plain(text: &[u8]) -> Result<Option<Vec<u8>>> {
    let mut scan = Scan { text, counts: [0; 3], greatest: [(0, 0); 3], copied: 0, out: None };
    let (mut start, mut line) = (0, 1);
    while start < text.len() {
        let (end, lines) = logical_end(text, start);
        scan.line(start, end, line)?;
        (start, line) = (end + 1, line + lines);
    }
    for ((kind, count), (index, line)) in KINDS.iter().zip(scan.counts).zip(scan.greatest) {
        if index > count {
            return Err(absent(line, kind, &index.to_string(), count));
        }
    }
    Ok(scan.out.map(|mut out| {
        out.extend_from_slice(&text[scan.copied..]);
        out
    }))
}

struct Scan<'a> {
    text: &'a [u8],
    /// Vertices, texture coordinates and normals so far.
    counts: [u64; 3],
    /// The greatest index of each kind, and its line.
    greatest: [(u64, u64); 3],
    /// Bytes of the text that `out` has, or leaves out.
    copied: usize,
    /// The plain text, from the first line on that has to change.
    out: Option<Vec<u8>>,
}

impl Scan<'_> {
    fn line(&mut self, start: usize, end: usize, line: u64) -> Result<()> {
        let whole = &self.text[start..end];
        let trimmed = whole.trim_ascii_start();
        let length =
            trimmed.iter().position(|byte| byte.is_ascii_whitespace() || *byte == b'\\').unwrap_or(trimmed.len());
        let (keyword, rest) = trimmed.split_at(length);
        if !KEYWORDS.contains(&keyword) {
            return Ok(());
        }
        let is_plain =
            whole.len() == trimmed.len() && !whole.contains(&b'\n') && matches!(rest, [] | [b' ' | b'\r', ..]);
        match keyword {
            b"f" => return self.face(rest, [start, end], line, is_plain),
            b"v" => self.counts[0] += 1,
            b"vt" => self.counts[1] += 1,
            b"vn" => self.counts[2] += 1,
            _ => {}
        }
        if !is_plain {
            let out = self.rewritten(start, end);
            out.extend_from_slice(keyword);
            out.push(b' ');
            let joined = joined(rest);
            out.extend_from_slice(joined.trim_ascii_start());
        }
        Ok(())
    }

    /// A face: corners of one to three indices.
    fn face(&mut self, rest: &[u8], [start, end]: [usize; 2], line: u64, mut is_plain: bool) -> Result<()> {
        let rest = if rest.contains(&b'\n') { Cow::Owned(joined(rest)) } else { Cow::Borrowed(rest) };
        let stated = rest.split(|&byte| byte == b'#').next().unwrap_or_default();
        is_plain &= stated.len() == rest.len();
        for corner in corners(stated) {
            for (kind, index) in corner.split(|&byte| byte == b'/').enumerate() {
                if kind >= KINDS.len() {
                    let corner = String::from_utf8_lossy(corner);
                    return Err(Error::Scene(format!("line {line}: '{corner}' has more than three indices")));
                }
                if index.is_empty() && kind > 0 {
                    continue;
                }
                is_plain &= index.first().is_some_and(u8::is_ascii_digit);
                let index = self.absolute(index, kind, line)?;
                if index > self.greatest[kind].0 {
                    self.greatest[kind] = (index, line);
                }
            }
        }
        if !is_plain {
            self.write_face(stated, [start, end], line)?;
        }
        Ok(())
    }

    fn write_face(&mut self, stated: &[u8], [start, end]: [usize; 2], line: u64) -> Result<()> {
        let mut face = b"f".to_vec();
        for corner in corners(stated) {
            for (kind, index) in corner.split(|&byte| byte == b'/').enumerate() {
                face.push(if kind == 0 { b' ' } else { b'/' });
                if !index.is_empty() {
                    face.extend_from_slice(self.absolute(index, kind, line)?.to_string().as_bytes());
                }
            }
        }
        self.rewritten(start, end).extend_from_slice(&face);
        Ok(())
    }

    /// The output, in place of a line that it leaves out; what was before is copied.
    fn rewritten(&mut self, start: usize, end: usize) -> &mut Vec<u8> {
        let out = self.out.get_or_insert_default();
        out.extend_from_slice(&self.text[self.copied..start]);
        self.copied = end;
        out
    }

    /// An index counted from 1: negative ones count back from the last so far.
    fn absolute(&self, index: &[u8], kind: usize, line: u64) -> Result<u64> {
        let (digits, is_back) = match index {
            [b'-', digits @ ..] => (digits, true),
            [b'+', digits @ ..] => (digits, false),
            digits => (digits, false),
        };
        let word = || String::from_utf8_lossy(index).into_owned();
        if digits.is_empty() || !digits.iter().all(u8::is_ascii_digit) {
            return Err(Error::Scene(format!("line {line}: a face has '{}' where an index belongs", word())));
        }
        let value =
            digits.iter().fold(0u64, |value, digit| value.saturating_mul(10).saturating_add(u64::from(digit - b'0')));
        let count = self.counts[kind];
        match (value, is_back) {
            (0, _) => Err(Error::Scene(format!("line {line}: a face names {} 0, but the first is 1", KINDS[kind]))),
            (value, true) if value > count => Err(absent(line, KINDS[kind], &word(), count)),
            (value, true) => Ok(count + 1 - value),
            (value, false) => Ok(value),
        }
    }
}

fn absent(line: u64, kind: &str, index: &str, count: u64) -> Error {
    Error::Scene(format!("line {line}: a face names {kind} {index} of {count}"))
}

fn corners(stated: &[u8]) -> impl Iterator<Item = &[u8]> {
    stated.split(u8::is_ascii_whitespace).filter(|corner| !corner.is_empty())
}

/// A line in one piece: blanks in place of its line breaks and of the backslashes before them.
fn joined(line: &[u8]) -> Vec<u8> {
    let ends = |at: usize| matches!(line[at..], [b'\\', b'\n', ..] | [b'\\', b'\r', b'\n', ..] | [b'\n', ..]);
    line.iter().enumerate().map(|(at, &byte)| if ends(at) { b' ' } else { byte }).collect()
}

/// The end of the line that begins here, without its last line feed, and how many lines of the text it takes.
fn logical_end(text: &[u8], start: usize) -> (usize, u64) {
    let (mut at, mut lines) = (start, 1);
    loop {
        let end = text[at..].iter().position(|&byte| byte == b'\n').map_or(text.len(), |n| at + n);
        if end == text.len() || !matches!(text[start..end], [.., b'\\'] | [.., b'\\', b'\r']) {
            return (end, lines);
        }
        (at, lines) = (end + 1, lines + 1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n";

    fn of(faces: &str) -> String {
        let text = format!("{CORNERS}{faces}");
        let plain = plain(text.as_bytes()).unwrap().map_or(text, |plain| String::from_utf8(plain).unwrap());
        plain.strip_prefix(CORNERS).unwrap().to_owned()
    }

    #[test]
    fn what_is_plain_stays_as_it_is() {
        for faces in
            ["", "f 1 2 3", "f 1 2 3\r\nf 3//1 2//1 1//1\r\n", "o a\nusemtl \n\ng\nf 1// 2/ 3\n", "# f 0\nfoo 0\n\\\n"]
        {
            assert_eq!(plain(format!("{CORNERS}{faces}").as_bytes()), Ok(None), "{faces:?}");
        }
    }

    #[test]
    fn indices_count_from_one() {
        assert_eq!(of("f -3 -2 -1\nv 5 5 5\nf -1 1//-1 +2\n"), "f 1 2 3\nv 5 5 5\nf 4 1//1 2\n");
        assert_eq!(of("f 4 2 3 # ends\nv 5 5 5"), "f 4 2 3\nv 5 5 5");
    }

    #[test]
    fn no_line_is_missed() {
        assert_eq!(of(" f 1 2 3\n\tf\t1  2 3 \n"), "f 1 2 3\nf 1 2 3\n");
        assert_eq!(of("f 1 2\\\n3\\\r\n 1\r\nf 1 \\\n2 3"), "f 1 2 3 1\nf 1 2 3");
        assert_eq!(of("v\t1 2 \\\n 3\n  o  a \nf 4 1 2"), "v 1 2    3\no a \nf 4 1 2");
    }

    #[test]
    fn what_names_nothing_is_an_error() {
        for (faces, words) in [
            ("f 0 1 2", "line 5: a face names vertex 0, but the first is 1"),
            ("\nf 1 2 3\nf 1 2 4\n", "line 7: a face names vertex 4 of 3"),
            ("f -4 1 2", "line 5: a face names vertex -4 of 3"),
            ("f 1//9 2 3", "line 5: a face names normal 9 of 1"),
            ("f 1/1 2/1 3/1", "line 5: a face names texture coordinate 1 of 0"),
            ("f 1 \\\n2\\\n3\nf 1 2 x", "line 8: a face has 'x' where an index belongs"),
            ("f 1.0 2 3", "line 5: a face has '1.0' where an index belongs"),
            ("f /1 2 3", "line 5: a face has '' where an index belongs"),
            ("f 1/1/1/1 2 3", "line 5: '1/1/1/1' has more than three indices"),
            ("f 99999999999999999999999 2 3", "line 5: a face names vertex 18446744073709551615 of 3"),
            ("f - 2 3", "line 5: a face has '-' where an index belongs"),
        ] {
            assert_eq!(plain(format!("{CORNERS}{faces}").as_bytes()), Err(Error::Scene(words.to_owned())), "{faces:?}");
        }
    }
}
