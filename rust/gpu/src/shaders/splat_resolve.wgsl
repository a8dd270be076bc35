// Colours of pixels from the keys of their samples.

@group(0) @binding(6) var<storage, read_write> output: array<u32>;
@group(0) @binding(8) var<storage, read> keys: array<u32>;

// The last splat with its colours, cached because neighbouring samples often show the same splat.
struct LitSplat {
    place: u32,
    normal: vec3<f32>,
    // Colours on the side of the normal and on the other side.
    front: vec3<f32>,
    back: vec3<f32>,
}

// Returns the number of the view that contains a block.
fn view_of(block: u32) -> u32 {
    var low = 0u;
    var high = draw.work.w;
    while high - low > 1u {
        let middle = (low + high) / 2u;
        if views[middle].place.x <= block {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

fn light_splat(place: u32) -> LitSplat {
    let block = place >> LANE_BITS;
    let view = views[view_of(block)];
    let splat = splat_of(view.place.y, head_of(view.place, block - view.place.x), place & ((1u << LANE_BITS) - 1u));
    let normal = normalize(normal_of(splat.normal, view.rest.x));
    let albedo = linear_from_srgb(vec3<f32>(splat.color) / 255.0);
    return LitSplat(place, normal, albedo * irradiance(normal), albedo * irradiance(-normal));
}

fn store_color(at: u32, value: vec4<f32>) {
    let bits = bitcast<vec4<u32>>(value);
    output[at] = bits.x;
    output[at + 1u] = bits.y;
    output[at + 2u] = bits.z;
    output[at + 3u] = bits.w;
}

@compute @workgroup_size(GROUP)
fn splat_resolve(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let pixel = item_number(group, local);
    let grid = draw.size.w;
    let columns = draw.size.x / grid;
    if pixel >= columns * (draw.size.y / grid) {
        return;
    }
    let corner = vec2<u32>(pixel % columns, pixel / columns) * grid;
    if draw.outputs.z != NONE {
        let middle = corner + grid / 2u;
        let at = 2u * (middle.y * draw.size.x + middle.x);
        output[draw.outputs.z + 2u * pixel] = keys[at];
        output[draw.outputs.z + 2u * pixel + 1u] = keys[at + 1u];
    }
    if draw.outputs.x == NONE {
        return;
    }
    var sum = vec4<f32>(0.0);
    var before_mask = vec2<u32>(0u);
    var cached: LitSplat;
    cached.place = NONE;
    for (var n = 0u; n < grid * grid; n++) {
        let sample = corner + vec2<u32>(n % grid, n / grid);
        let at = 2u * (sample.y * draw.size.x + sample.x);
        let place = ~keys[at];
        let middle = vec2<f32>(sample + vec2<u32>(0u, draw.size.z)) + 0.5;
        let direction = draw.direction[0].xyz + draw.direction[1].xyz * middle.x + draw.direction[2].xyz * middle.y;
        if place != NONE {
            if place != cached.place {
                cached = light_splat(place);
            }
            sum += vec4<f32>(select(cached.front, cached.back, dot(cached.normal, direction) > 0.0), 1.0);
        } else if keys[at + 1u] != 0u {
            before_mask |= select(vec2<u32>(1u << n, 0u), vec2<u32>(0u, 1u << (n & 31u)), n >= 32u);
            sum.w += 1.0;
        } else if draw.limits.z == 0u {
            sum += vec4<f32>(background(normalize(direction)), 0.0);
        }
    }
    store_color(draw.outputs.x + 4u * pixel, sum / f32(grid * grid));
    if draw.outputs.y != NONE {
        output[draw.outputs.y + 2u * pixel] = before_mask.x;
        output[draw.outputs.y + 2u * pixel + 1u] = before_mask.y;
    }
}
