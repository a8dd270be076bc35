//! Any bytes as OBJ text: an error, or plain text that stays as it is.

#![no_main]

use libfuzzer_sys::fuzz_target;
use nearfar_core::scene::wavefront::plain;

fuzz_target!(|text: &[u8]| {
    if let Ok(Some(text)) = plain(text) {
        assert_eq!(plain(&text).expect("plain text is read"), None);
    }
});
