//! Public names of enum values.

use nearfar_core::base::{Error, Result};

/// The value with a name. The error lists all names.
pub fn choice<T: Copy>(argument: &'static str, name: &str, choices: &[(&str, T)]) -> Result<T> {
    let found = choices.iter().find(|(known, _)| *known == name);
    found.map(|(_, choice)| *choice).ok_or_else(|| {
        let names: Vec<String> = choices.iter().map(|(known, _)| format!("'{known}'")).collect();
        let (last, others) = names.split_last().map_or(("", &names[..]), |(last, others)| (last.as_str(), others));
        Error::value(argument, format!("{} or {last}", others.join(", ")), format!("'{name}'"))
    })
}
