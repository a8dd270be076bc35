//! Any bytes as an OpenEXR file: an error, or parts that are encoded and decoded to the same parts.

#![no_main]

use libfuzzer_sys::fuzz_target;
use nearfar_core::base::Progress;
use nearfar_core::exr::{self, Part, Values};

/// Name, width and height of a part, and its channels.
type Bits = (String, usize, usize, Vec<(String, Vec<u32>)>);

/// Parts whose values are compared by their bits, because NaN differs from itself.
fn bits(parts: &[Part]) -> Vec<Bits> {
    let channel = |values: &Values| match values {
        Values::Half(values) => values.iter().map(|value| u32::from(value.to_bits())).collect(),
        Values::Float(values) => values.iter().map(|value| value.to_bits()).collect(),
        Values::Unsigned(values) => values.to_vec(),
    };
    parts
        .iter()
        .map(|part| {
            let channels = part.channels.iter().map(|(name, values)| (name.clone(), channel(values))).collect();
            (part.name.clone(), part.width, part.height, channels)
        })
        .collect()
}

fuzz_target!(|bytes: &[u8]| {
    let Ok(parts) = exr::decode(bytes, &Progress::new()) else { return };
    // Other programs write what we do not, such as parts without names or with equal ones.
    let Ok(written) = exr::encode(&parts, &Progress::new()) else { return };
    let again = exr::decode(&written, &Progress::new()).expect("what was encoded is decoded");
    assert_eq!(bits(&parts), bits(&again));
});
