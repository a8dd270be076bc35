//! Shared conversions of all bindings: arrays, errors, names, and the functions that run a kernel.

mod arrays;
pub mod errors;
pub mod run;

use nearfar_core::base::{Error, Result};

pub use arrays::{
    Array1, Array2, Array3, Array4, BitsInOut, Floats, FloatsInOut, Points, Read1, Read2, Read3, Read4, ReadAny,
    Write1, Write2, Write3, Write4, array_of_rows, buffer, bytes_of, filled, flat_buffer, zeros,
};
pub(crate) use arrays::{argument_enum, with_array, with_rows};
pub use errors::to_python;
pub use run::Report;

/// Finds the value with a name; the error lists all names.
pub fn choice<T: Copy>(argument: &'static str, name: &str, choices: &[(&str, T)]) -> Result<T> {
    let choice = choices.iter().find(|(key, _)| *key == name);
    choice.map(|(_, choice)| *choice).ok_or_else(|| {
        let names: Vec<String> = choices.iter().map(|(key, _)| format!("'{key}'")).collect();
        let (last, others) = names.split_last().map_or(("", &names[..]), |(last, others)| (last.as_str(), others));
        Error::value(argument, format!("{} or {last}", others.join(", ")), format!("'{name}'"))
    })
}
