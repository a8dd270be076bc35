// Ranges of a cube map along directions: the texel, or the minimum or maximum of those that `taps_of` finds.

struct Lookup {
    // Texels across a face, values per texel.
    map: vec4<u32>,
    // Number of directions, and the number of directions from the first one to the end.
    rows: vec4<u32>,
}

@group(2) @binding(0) var<uniform> lookup: Lookup;
@group(2) @binding(1) var<storage, read> faces: array<u32>;
@group(2) @binding(2) var<storage, read> directions: array<f32>;
@group(2) @binding(3) var<storage, read_write> values: array<u32>;
@group(2) @binding(4) var<storage, read_write> count_to_end: atomic<u32>;

// Weights below this may be due to rounding.
const NEGLIGIBLE: f32 = 1e-10;

fn direction_of(number: u32) -> vec3<f32> {
    return vec3<f32>(directions[3u * number], directions[3u * number + 1u], directions[3u * number + 2u]);
}

// Zero and non-finite numbers are found by bits: compilers may assume that there are none.
fn is_invalid(d: vec3<f32>) -> bool {
    let bits = bitcast<vec3<u32>>(d) & vec3<u32>(~SIGN);
    return all(bits == vec3<u32>(0u)) || any(bits >= vec3<u32>(EXPONENT));
}

// Inverse of `ordered`.
fn bits_of(order: u32) -> u32 {
    return select(~order, order & ~SIGN, (order & SIGN) != 0u);
}

const NEAREST: u32 = 0u;
const MIN: u32 = 1u;

// Returns the bits of the minimum or maximum of the taps that are known, NaN if none is.
fn extreme_bits(taps: Taps, channel: u32) -> u32 {
    var extreme = 0u;
    var is_known = false;
    for (var i = 0u; i < 4u; i++) {
        let bits = faces[taps.texel[i] * lookup.map.y + channel];
        // NaN marks an unknown value and is skipped.
        if taps.weight[i] > NEGLIGIBLE && (bits & ~SIGN) <= EXPONENT {
            let order = ordered(bits);
            extreme = select(order, select(max(extreme, order), min(extreme, order), FILTER == MIN), is_known);
            is_known = true;
        }
    }
    return select(NAN, bits_of(extreme), is_known);
}

@compute @workgroup_size(GROUP)
fn lookup_values(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let number = number_of(group, local);
    if number >= lookup.rows.x {
        return;
    }
    let d = direction_of(number);
    if is_invalid(d) {
        atomicMax(&count_to_end, lookup.rows.y - number);
        return;
    }
    let channels = lookup.map.y;
    if FILTER == NEAREST {
        let texel = texel_number(d, lookup.map.x);
        for (var channel = 0u; channel < channels; channel++) {
            values[number * channels + channel] = faces[texel * channels + channel];
        }
        return;
    }
    let taps = taps_of(d, lookup.map.x);
    for (var channel = 0u; channel < channels; channel++) {
        values[number * channels + channel] = extreme_bits(taps, channel);
    }
}
