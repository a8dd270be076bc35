//! Shared conversions of all bindings: arrays, errors, names, and the functions that run a kernel.

pub mod arrays;
pub mod errors;
pub mod one_of;
pub mod run;

use nearfar_core::base::{Error, Result};

/// The value with a name. The error lists all names.
pub fn choice<T: Copy>(argument: &'static str, name: &str, choices: &[(&str, T)]) -> Result<T> {
    let choice = choices.iter().find(|(key, _)| *key == name);
    choice.map(|(_, choice)| *choice).ok_or_else(|| {
        let names: Vec<String> = choices.iter().map(|(key, _)| format!("'{key}'")).collect();
        let (last, others) = names.split_last().map_or(("", &names[..]), |(last, others)| (last.as_str(), others));
        Error::value(argument, format!("{} or {last}", others.join(", ")), format!("'{name}'"))
    })
}
