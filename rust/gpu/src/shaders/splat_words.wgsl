// Unpacks splats from the words of blocks; see `orthoview::splat::compressed`.

struct Head {
    corner: vec2<u32>,
    shown: vec2<u32>,
    // First word of its bits, widths of the fields, minimum kind.
    first: u32,
    widths: u32,
    depth: i32,
    slopes: vec2<i32>,
    normal: vec2<u32>,
    color: u32,
}

struct Splat {
    depth: u32,
    normal: vec2<u32>,
    color: vec3<u32>,
    kind: u32,
}

fn head_of(place: vec4<u32>, block: u32) -> Head {
    let at = place.z + HEAD * block;
    let corner = word(place.y, at);
    let slopes = bitcast<i32>(word(place.y, at + 6u));
    let normal = word(place.y, at + 7u);
    var head: Head;
    head.corner = vec2<u32>(corner & 0xffffu, corner >> 16u) * BLOCK;
    head.shown = vec2<u32>(word(place.y, at + 1u), word(place.y, at + 2u));
    head.first = place.w + word(place.y, at + 3u);
    head.widths = word(place.y, at + 4u);
    head.depth = bitcast<i32>(word(place.y, at + 5u));
    head.slopes = vec2<i32>((slopes << 16u) >> 16u, slopes >> 16u);
    head.normal = vec2<u32>(normal & 0xfffu, normal >> 12u);
    head.color = word(place.y, at + 8u);
    return head;
}

// Returns whether a pixel of a block shows a surface.
fn is_shown(head: Head, lane: u32) -> bool {
    return ((select(head.shown.x, head.shown.y, lane >= 32u) >> (lane & 31u)) & 1u) == 1u;
}

// Returns the number of a block's splats before a pixel.
fn rank_of(head: Head, lane: u32) -> u32 {
    let below = (1u << (lane & 31u)) - 1u;
    if lane < 32u {
        return countOneBits(head.shown.x & below);
    }
    return countOneBits(head.shown.x) + countOneBits(head.shown.y & below);
}

// Reads a bit field that may span two words.
fn read_field(page: u32, first: u32, at: u32, width: u32) -> u32 {
    if width == 0u {
        return 0u;
    }
    let number = first + (at >> 5u);
    let shift = at & 31u;
    var bits = word(page, number) >> shift;
    if shift + width > 32u {
        bits |= word(page, number + 1u) << (32u - shift);
    }
    return bits & ((1u << width) - 1u);
}

fn splat_of(page: u32, head: Head, lane: u32) -> Splat {
    let depth = head.widths & 31u;
    let normal_x = (head.widths >> 5u) & 15u;
    let normal_y = (head.widths >> 9u) & 15u;
    let red = (head.widths >> 13u) & 15u;
    let green = (head.widths >> 17u) & 15u;
    let blue = (head.widths >> 21u) & 15u;
    let kind = (head.widths >> 25u) & 3u;
    var at = rank_of(head, lane) * (depth + normal_x + normal_y + red + green + blue + kind);
    var splat: Splat;
    let rise = (i32(lane % BLOCK) * head.slopes.x + i32(lane / BLOCK) * head.slopes.y) >> FRACTION;
    splat.depth = u32(head.depth + rise + i32(read_field(page, head.first, at, depth)));
    at += depth;
    splat.normal.x = head.normal.x + read_field(page, head.first, at, normal_x);
    at += normal_x;
    splat.normal.y = head.normal.y + read_field(page, head.first, at, normal_y);
    at += normal_y;
    splat.color.x = (head.color & 255u) + read_field(page, head.first, at, red);
    at += red;
    splat.color.y = ((head.color >> 8u) & 255u) + read_field(page, head.first, at, green);
    at += green;
    splat.color.z = (head.color >> 16u) + read_field(page, head.first, at, blue);
    at += blue;
    splat.kind = (head.widths >> 27u) + read_field(page, head.first, at, kind);
    return splat;
}

// Decodes an octahedral normal; the result is not normalised.
fn normal_of(numbers: vec2<u32>, scale: f32) -> vec3<f32> {
    let flat = vec2<f32>(numbers) * scale - 1.0;
    let z = 1.0 - abs(flat.x) - abs(flat.y);
    let fold = max(-z, 0.0);
    return vec3<f32>(flat - select(vec2<f32>(fold), vec2<f32>(-fold), flat < vec2<f32>(0.0)), z);
}
