// Looks a cube map up along directions: the value of the texel hit, or the minimum or maximum of the taps that
// `taps_of` returns.

struct Lookup {
    // Texels across a face, values per texel.
    map: vec4<u32>,
    // Number of directions of this call, and of directions from its first one to the end of the array.
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

// Tests the bits, because compilers may assume that there are no non-finite numbers.
fn is_invalid(d: vec3<f32>) -> bool {
    let bits = bitcast<vec3<u32>>(d) & vec3<u32>(~SIGN);
    return all(bits == vec3<u32>(0u)) || any(bits >= vec3<u32>(EXPONENT));
}

// Inverse of `order_from_bits`.
fn bits_from_order(order: u32) -> u32 {
    return select(~order, order & ~SIGN, (order & SIGN) != 0u);
}

const NEAREST: u32 = 0u;
const MIN: u32 = 1u;

// Returns the bits of the minimum or maximum of the taps whose value is known; NaN if no value is.
fn extreme_bits(taps: Taps, channel: u32) -> u32 {
    var extreme = 0u;
    var is_known = false;
    for (var i = 0u; i < 4u; i++) {
        let bits = faces[taps.texel[i] * lookup.map.y + channel];
        // NaN marks an unknown value and is skipped.
        if taps.weight[i] > NEGLIGIBLE && (bits & ~SIGN) <= EXPONENT {
            let order = order_from_bits(bits);
            extreme = select(order, select(max(extreme, order), min(extreme, order), FILTER == MIN), is_known);
            is_known = true;
        }
    }
    return select(NAN, bits_from_order(extreme), is_known);
}

@compute @workgroup_size(GROUP)
fn lookup_values(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let number = item_number(group, local);
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
