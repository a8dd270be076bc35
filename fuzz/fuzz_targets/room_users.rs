//! Any steps of the users of rooms, in any order: none sees what it may not see, and nothing that waits grows.

#![no_main]

use libfuzzer_sys::fuzz_target;
use nearfar_serve::rooms::trial;

fuzz_target!(|script: &[u8]| trial::run(script));
