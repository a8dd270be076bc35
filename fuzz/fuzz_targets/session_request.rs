//! Any bytes as the first stream of a connection of WebTransport and as a datagram: a usable request, or none.

#![no_main]

use libfuzzer_sys::fuzz_target;
use nearfar_serve::session_trial;

fuzz_target!(|bytes: &[u8]| session_trial::run(bytes));
