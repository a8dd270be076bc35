// Structural similarity in windows of TAPS pixels: sum and difference of both lumas, then moments tile by tile.

struct Similarity {
    // Width, height, pixels, tiles across.
    size: vec4<u32>,
    // First word of each frame's colour.
    first: vec4<u32>,
    // Pixels whose windows lie inside the picture: first column and row, end column and row.
    inside: vec4<u32>,
    // Wang's constants c1 and c2.
    constants: vec4<f32>,
    // Window weights along one axis.
    weights: array<vec4<f32>, 5>,
}

@group(0) @binding(0) var<uniform> settings: Similarity;
@group(0) @binding(1) var<storage, read> reference: array<f32>;
@group(0) @binding(2) var<storage, read> compared: array<f32>;
@group(0) @binding(3) var<storage, read_write> planes: array<vec2<f32>>;
@group(0) @binding(4) var<storage, read_write> sums: array<f32>;
@group(0) @binding(5) var<storage, read_write> map: array<f32>;

// Converts linear light to sRGB (IEC 61966-2-1). `pow` of drivers has relative errors of 2^-21; one Newton step for
// y^12 = x^5 reduces them to one or two roundings.
fn to_srgb(linear: f32) -> f32 {
    let x = clamp(linear, 0.0, 1.0);
    if x <= 0.0031308 {
        return 12.92 * x;
    }
    let rough = pow(x, 1.0 / 2.4);
    let x_squared = x * x;
    let squared = rough * rough;
    let fourth = squared * squared;
    let correction = (x_squared * x_squared * x / (fourth * fourth * fourth) - 1.0) / 12.0;
    return 1.055 * (rough + rough * correction) - 0.055;
}

@compute @workgroup_size(GROUP)
fn similarity_luma(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let pixel = item_number(group, local);
    if pixel >= settings.size.z {
        return;
    }
    let a = settings.first.x + 3u * pixel;
    let b = settings.first.y + 3u * pixel;
    let x = vec3<f32>(to_srgb(reference[a]), to_srgb(reference[a + 1u]), to_srgb(reference[a + 2u]));
    let y = vec3<f32>(to_srgb(compared[b]), to_srgb(compared[b + 1u]), to_srgb(compared[b + 2u]));
    // Rec. 709.
    let luma = vec3<f32>(0.2126, 0.7152, 0.0722);
    planes[pixel] = vec2<f32>(dot(luma, x + y), dot(luma, x - y));
}

const TILE: u32 = 16u;
const SIDE: u32 = TILE + TAPS - 1u;
const MIDDLE: u32 = TAPS / 2u;

// Sum and difference of all pixels seen by a tile's windows.
var<workgroup> loaded: array<vec2<f32>, SIDE * SIDE>;
// Means and variances of sum and difference along each row.
var<workgroup> row_moments: array<vec4<f32>, SIDE * TILE>;

// Mirrors an index at the ends of a line: d c b a | a b c d | d c b a. Indices lie less than TAPS lines outside. They
// are shifted by whole periods first, because in OpenGL the operator % is undefined for negative numbers.
fn mirror(i: i32, length: i32) -> u32 {
    let shifted = (i + 2 * i32(TAPS) * length) % (2 * length);
    return u32(select(2 * length - 1 - shifted, shifted, shifted < length));
}

fn weight(k: u32) -> f32 {
    return settings.weights[k / 4u][k % 4u];
}

// Loads the pixels seen by the windows of this workgroup.
fn load(tile: vec2<u32>, local: u32) {
    for (var i = local; i < SIDE * SIDE; i += TILE * TILE) {
        let at = vec2<i32>(tile * TILE + vec2<u32>(i % SIDE, i / SIDE)) - i32(MIDDLE);
        let column = mirror(at.x, i32(settings.size.x));
        let row = mirror(at.y, i32(settings.size.y));
        loaded[i] = planes[row * settings.size.x + column];
    }
}

// Computes moments along rows, about the window's middle pixel, so that the difference of mean square and squared mean
// loses little precision.
fn compute_row_moments(local: u32) {
    for (var i = local; i < SIDE * TILE; i += TILE * TILE) {
        let first = i / TILE * SIDE + i % TILE;
        let center = loaded[first + MIDDLE];
        var mean = vec2<f32>(0.0);
        var square = vec2<f32>(0.0);
        for (var k = 0u; k < TAPS; k++) {
            let difference = loaded[first + k] - center;
            mean += weight(k) * difference;
            square += weight(k) * difference * difference;
        }
        row_moments[i] = vec4<f32>(center + mean, square - mean * mean);
    }
}

// Returns 1 minus the similarity of the window around a pixel. Both factors are 1 minus a non-negative term that is 0
// for equal images: D^2 / ((S^2 + D^2)/2 + c1) and var d / ((var s + var d)/2 + c2).
fn dissimilarity(column: u32, row: u32) -> f32 {
    let center = row_moments[(row + MIDDLE) * TILE + column].xy;
    var mean = vec2<f32>(0.0);
    var square = vec2<f32>(0.0);
    for (var k = 0u; k < TAPS; k++) {
        let line = row_moments[(row + k) * TILE + column];
        let difference = line.xy - center;
        mean += weight(k) * difference;
        square += weight(k) * (line.zw + difference * difference);
    }
    let variance = max(square - mean * mean, vec2<f32>(0.0));
    let level = center + mean;
    let difference_squared = level.y * level.y;
    let by_mean = difference_squared / (0.5 * (level.x * level.x + difference_squared) + settings.constants.x);
    let by_contrast = variance.y / (0.5 * (variance.x + variance.y) + settings.constants.y);
    return by_mean + by_contrast - by_mean * by_contrast;
}

fn measure(tile: vec2<u32>, local: u32) -> f32 {
    load(tile, local);
    workgroupBarrier();
    compute_row_moments(local);
    workgroupBarrier();
    return dissimilarity(local % TILE, local / TILE);
}

// Sums the values of this workgroup's windows inside the picture, in a fixed order.
fn store_sum(tile: vec2<u32>, local: u32, value: f32) {
    let pixel = tile * TILE + vec2<u32>(local % TILE, local / TILE);
    let is_inside = all(pixel >= settings.inside.xy) && all(pixel < settings.inside.zw);
    loaded[local] = vec2<f32>(select(0.0, value, is_inside), 0.0);
    workgroupBarrier();
    for (var stride = TILE * TILE / 2u; stride > 0u; stride /= 2u) {
        if local < stride {
            loaded[local] += loaded[local + stride];
        }
        workgroupBarrier();
    }
    if local == 0u {
        sums[tile.y * settings.size.w + tile.x] = loaded[0].x;
    }
}

@compute @workgroup_size(TILE, TILE)
fn similarity_sums(@builtin(workgroup_id) tile: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    store_sum(tile.xy, local, measure(tile.xy, local));
}

@compute @workgroup_size(TILE, TILE)
fn similarity_map(@builtin(workgroup_id) tile: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let value = measure(tile.xy, local);
    let pixel = tile.xy * TILE + vec2<u32>(local % TILE, local / TILE);
    if all(pixel < settings.size.xy) {
        map[pixel.y * settings.size.x + pixel.x] = 1.0 - value;
    }
    store_sum(tile.xy, local, value);
}
