//! Any bytes as a stream of meshoptimizer: an error, or as many rows as the layout says.

#![no_main]

use arbitrary::Arbitrary;
use libfuzzer_sys::fuzz_target;
use nearfar_core::scene::meshopt::{Filter, Layout, Mode, decode};

#[derive(Arbitrary, Debug)]
struct Input {
    count: u32,
    stride: u16,
    mode: u8,
    filter: u8,
    bytes: Vec<u8>,
}

const MODES: [Mode; 3] = [Mode::Attributes, Mode::Triangles, Mode::Indices];
const FILTERS: [Filter; 5] = [Filter::None, Filter::Octahedral, Filter::Quaternion, Filter::Exponential, Filter::Color];

fuzz_target!(|input: Input| {
    let layout = Layout {
        count: input.count as usize,
        stride: usize::from(input.stride),
        mode: MODES[usize::from(input.mode) % MODES.len()],
        filter: FILTERS[usize::from(input.filter) % FILTERS.len()],
    };
    if let Ok(words) = decode(&input.bytes, layout) {
        assert_eq!(words.len(), (layout.count * layout.stride).div_ceil(4));
        assert!(words.len() <= input.bytes.len() * 256);
    }
});
