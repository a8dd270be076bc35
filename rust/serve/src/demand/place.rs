//! Positions for which regions are made.

use std::fmt;
use std::str::FromStr;

/// Greatest coordinate, metres, as for scenes.
const MAX_METRES: f64 = 1e12;
/// Greatest length of a coordinate's text.
const MAX_CHARS: usize = 40;

/// A world position, metres. Its text, three comma-separated numbers, is its name in URLs and on disk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place(pub [f64; 3]);

impl fmt::Display for Place {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.0.map(|value| if value == 0.0 { 0.0 } else { value });
        write!(out, "{x},{y},{z}")
    }
}

impl FromStr for Place {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || format!("expected three numbers with commas between them, got {:?}", shortened(text));
        let mut values = text.split(',').map(|part| coordinate(part).ok_or_else(wrong));
        let mut next = || values.next().unwrap_or_else(|| Err(wrong()));
        let place = Place([next()?, next()?, next()?]);
        match values.next() {
            None => Ok(place),
            Some(_) => Err(wrong()),
        }
    }
}

/// Parses a finite number of plain characters; rejects "inf", "nan" and numbers out of range.
fn coordinate(text: &str) -> Option<f64> {
    let is_plain =
        text.len() <= MAX_CHARS && text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    let value: f64 = if is_plain { text.parse().ok()? } else { return None };
    (value.abs() <= MAX_METRES).then_some(value)
}

fn shortened(text: &str) -> String {
    text.chars().take(MAX_CHARS).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_and_numbers_are_each_others_inverse() {
        for (text, same) in [("4,1.7,-2", "4,1.7,-2"), ("-0,0,1e3", "0,0,1000"), ("0.1,2.50,-3E-2", "0.1,2.5,-0.03")] {
            let place: Place = text.parse().unwrap();
            assert_eq!(place.to_string(), same);
            assert_eq!(same.parse::<Place>().unwrap().to_string(), same);
        }
    }

    #[test]
    fn other_texts_are_refused() {
        for text in [
            "",
            "1,2",
            "1,2,3,4",
            "1,2,",
            "nan,0,0",
            "inf,0,0",
            "1e999,0,0",
            "1,2,3e13",
            "../1,2,3",
            "1, 2,3",
            "１,2,3",
        ] {
            let reason = text.parse::<Place>().unwrap_err();
            assert!(reason.starts_with("expected three numbers"), "{text}: {reason}");
        }
        assert!("9".repeat(1000).parse::<Place>().unwrap_err().len() < 120);
    }
}
