//! The log, on standard error: lines for people, or one JSON object a line.

use std::io;

pub use tracing_subscriber::filter::LevelFilter;

/// Write events of at least a level from now on, and each answer at the level of information. False if a log is written
/// already.
pub fn begin(level: LevelFilter, as_json: bool) -> bool {
    let log = tracing_subscriber::fmt().with_max_level(level).with_writer(io::stderr);
    let begun = if as_json { log.json().flatten_event(true).try_init() } else { log.with_ansi(false).try_init() };
    begun.is_ok()
}
