//! Any bytes as a message of a room's user or of its server: an error, or frames that are written as the same bytes.

#![no_main]

use libfuzzer_sys::fuzz_target;
use nearfar_serve::rooms::frame::{FromServer, FromUser};

fuzz_target!(|message: &[u8]| {
    let (mut rest, mut written) = (message, Vec::new());
    while let Ok((frame, behind)) = FromUser::read(rest) {
        frame.write(&mut written);
        rest = behind;
    }
    assert_eq!([&written, rest].concat(), message);
    let (mut rest, mut written) = (message, Vec::new());
    while let Ok((frame, behind)) = FromServer::read(rest) {
        frame.write(&mut written);
        assert_eq!(frame.bytes(), rest.len() - behind.len());
        rest = behind;
    }
    assert_eq!([&written, rest].concat(), message);
});
