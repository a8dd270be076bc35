//! Log on standard error: text lines, or one JSON object per line.

use std::io;

pub use tracing_subscriber::filter::LevelFilter;

/// Starts logging events of at least a level; responses are logged at level info. False if logging has already
/// been started.
pub fn start(level: LevelFilter, as_json: bool) -> bool {
    let log = tracing_subscriber::fmt().with_max_level(level).with_writer(io::stderr);
    let started = if as_json { log.json().flatten_event(true).try_init() } else { log.with_ansi(false).try_init() };
    started.is_ok()
}
