// Computes the requested channels of a pixel from its face, along the pixel's own ray.

override MAPPED: bool = false;
// Whether samples without a face are black.
override BARE: bool = false;
// Whether the map is visible only on a segment of each ray.
override LIMITED: bool = false;
// Whether to compute colour and coverage, from all samples.
override COLOR: bool = true;
// Whether to compute the other channels, from one sample at the pixel's centre.
override SURFACE: bool = true;

@group(2) @binding(1) var<storage, read_write> output: array<u32>;

// Returns record and face that a sample of a pixel shows; the record is NONE if there is no face.
fn face_at(pixel: vec2<u32>, sample: u32) -> vec2<u32> {
    let words = load_visible(pixel, sample);
    return vec2<u32>(words.x | (words.y << 16u), words.z | (words.w << 16u));
}

struct Ray {
    start: vec3<f32>,
    direction: vec3<f32>,
    // Width of the ray's pixel at its start, and the width's increase per metre.
    footprint: vec2<f32>,
}

fn ray_of(pixel: vec2<u32>) -> Ray {
    let at = vec2<f32>(pixel);
    let start = view.start.xyz + at.x * view.start_x.xyz + at.y * view.start_y.xyz;
    let remainder = view.remainder.xyz + at.x * view.remainder_x.xyz + at.y * view.remainder_y.xyz;
    let direction = (view.direction.xyz + at.x * view.direction_x.xyz + at.y * view.direction_y.xyz) + remainder;
    let secant = length(direction);
    let size = view.footprint.x;
    let footprint = select(vec2<f32>(0.0, size / (secant * sqrt(secant))), vec2<f32>(size, 0.0), view.footprint.y > 0.0);
    return Ray(start, direction / secant, footprint);
}

struct Surface {
    // Weights of the face's second and third corner.
    at: vec2<f32>,
    // Distance along the ray.
    range: f32,
    // Undisplaced point, relative to the eye.
    point: vec3<f32>,
    // Normal towards the viewer.
    normal: vec3<f32>,
    cosine: f32,
    doubled_area: f32,
}

// Shears a point along a ray, as Woop, Benthin, Wald (2013) and the tracer do: returns two components across the ray,
// and the distance along the ray at which its largest component equals the point's. The components across stay small
// even for corners far along the ray, so that their products keep their precision for large faces seen at a slant.
fn along_ray(p: vec3<f32>, direction: vec3<f32>) -> vec3<f32> {
    let size = abs(direction);
    var d = direction;
    var q = p;
    if size.x >= size.y && size.x >= size.z {
        d = direction.yzx;
        q = p.yzx;
    } else if size.y >= size.z {
        d = direction.zxy;
        q = p.zxy;
    }
    return vec3<f32>(q.x - d.x / d.z * q.z, q.y - d.y / d.z * q.z, q.z / d.z);
}

// Returns the point where a ray intersects a face. If the ray misses by a fraction of a pixel, which rasterisation
// allows, this is the nearest point of the face.
fn surface_of(record: Record, part: Part, face: u32, ray: Ray) -> Surface {
    let a = position_from_eye(record, part, corner_number(part, face, 0u));
    let b = position_from_eye(record, part, corner_number(part, face, 1u));
    let c = position_from_eye(record, part, corner_number(part, face, 2u));
    let displayed_a = displayed(a) - ray.start;
    let displayed_b = displayed(b) - ray.start;
    let displayed_c = displayed(c) - ray.start;
    let along_a = along_ray(displayed_a, ray.direction);
    let along_b = along_ray(displayed_b, ray.direction);
    let along_c = along_ray(displayed_c, ray.direction);
    let areas = vec3<f32>(
        along_c.x * along_b.y - along_c.y * along_b.x,
        along_a.x * along_c.y - along_a.y * along_c.x,
        along_b.x * along_a.y - along_b.y * along_a.x,
    );
    let sum = areas.x + areas.y + areas.z;
    var weights = vec3<f32>(1.0, 0.0, 0.0);
    if sum != 0.0 {
        weights = max(areas / sum, vec3<f32>(0.0));
    }
    weights /= weights.x + weights.y + weights.z;
    let at = weights.yz;
    let range = dot(weights, vec3<f32>(along_a.z, along_b.z, along_c.z));
    let size = max(max(length(b - a), length(c - a)), 1e-30);
    let normal = cross((b - a) / size, (c - a) / size);
    let area = length(normal);
    var unit_normal = -ray.direction;
    if area > 0.0 {
        unit_normal = normal / area;
    }
    let cosine = dot(unit_normal, ray.direction);
    return Surface(
        at,
        max(range, 0.0),
        blend_3(a, b, c, at),
        select(unit_normal, -unit_normal, cosine > 0.0),
        min(abs(cosine), 1.0),
        area * size * size,
    );
}

fn spot_of(face: u32, surface: Surface, ray: Ray) -> Spot {
    let width = ray.footprint.x + ray.footprint.y * surface.range;
    let footprint = width / sqrt(max(surface.cosine, 1e-4));
    return Spot(face, surface.at, footprint, surface.doubled_area);
}

fn surface_color(record: Record, part: Part, face: u32, surface: Surface, ray: Ray) -> vec3<f32> {
    let material = material_of(part, face);
    let spot = spot_of(face, surface, ray);
    var color = albedo(part, material, spot);
    if !GLOWING || material.unlit == 0u {
        color *= irradiance(shading_normal(record, part, face, surface.at, surface.normal));
    }
    if GLOWING && any(material.emission != vec3<f32>(0.0)) {
        color += material.emission * texture_at(part, material.emission_texture, spot, false);
    }
    return color;
}

// Returns whether the map is visible along a direction: the ray's visible segment is unbounded, and the map's surface
// is not nearer than the segment's start.
fn sees_map(direction: vec3<f32>) -> bool {
    if !LIMITED {
        return true;
    }
    let segment = visible_segment(direction);
    if segment.y <= 0.0 || view.environment.w == 0u {
        return segment.y > 0.0;
    }
    let range = map_range_of(texel_number(direction, view.environment.x));
    return range > 1e30 || backdrop_range(direction, range) >= segment.x;
}

fn backdrop_color(ray: Ray) -> vec3<f32> {
    if BARE {
        return vec3<f32>(0.0);
    }
    if MAPPED && sees_map(ray.direction) {
        return environment_color(ray.direction);
    }
    return background(ray.direction);
}

// Returns whether this batch's records and page contain a face.
fn is_in_batch(id: vec2<u32>) -> bool {
    if id.x - batch.records.x >= batch.records.y {
        return false;
    }
    return part_of(record_of(id.x - batch.records.x)).page == batch.records.z;
}

fn store(word: u32, value: f32) {
    output[word] = bitcast<u32>(value);
}

// Stores a pixel's vector in the image that begins at a word, if it is requested.
fn store_3(first: u32, number: u32, value: vec3<f32>) {
    if first != NONE {
        let word = first + 3u * number;
        store(word, value.x);
        store(word + 1u, value.y);
        store(word + 2u, value.z);
    }
}

// Stores a pixel's range and ids, if they are requested.
fn store_range_and_id(number: u32, range: f32, id: vec2<u32>) {
    if view.outputs.y != NONE {
        store(view.outputs.y + number, range);
    }
    if view.outputs.z != NONE {
        output[view.outputs.z + 2u * number] = id.x;
        output[view.outputs.z + 2u * number + 1u] = id.y;
    }
}

fn color_of_sample(id: vec2<u32>, ray: Ray) -> vec3<f32> {
    if id.x == NONE {
        return select(vec3<f32>(0.0), backdrop_color(ray), batch.records.w != 0u);
    }
    if !is_in_batch(id) {
        return vec3<f32>(0.0);
    }
    let record = record_of(id.x - batch.records.x);
    let part = part_of(record);
    return surface_color(record, part, id.y, surface_of(record, part, id.y, ray), ray);
}

// Returns the colour of a pixel's samples that belong to this batch: each face is shaded once, at the pixel's centre.
fn color_of_samples(pixel: vec2<u32>, ray: Ray) -> vec3<f32> {
    var last = face_at(pixel, 0u);
    var color = color_of_sample(last, ray);
    var sum = color;
    for (var i = 1u; i < SAMPLES; i++) {
        let id = face_at(pixel, i);
        if any(id != last) {
            last = id;
            color = color_of_sample(id, ray);
        }
        sum += color;
    }
    return sum / f32(SAMPLES);
}

fn store_color(number: u32, color: vec3<f32>, adds: bool) {
    if view.outputs.x == NONE {
        return;
    }
    let word = view.outputs.x + 3u * number;
    var sum = color * view.footprint.z;
    if adds {
        sum += vec3<f32>(
            bitcast<f32>(output[word]),
            bitcast<f32>(output[word + 1u]),
            bitcast<f32>(output[word + 2u]),
        );
    }
    store_3(view.outputs.x, number, sum);
}

// Stores the fraction of a pixel's samples that show a face.
fn store_coverage(number: u32, pixel: vec2<u32>, adds: bool) {
    let word = view.more_outputs.w + number;
    var count = 0.0;
    for (var i = 0u; i < SAMPLES; i++) {
        count += select(1.0, 0.0, face_at(pixel, i).x == NONE);
    }
    var coverage = count / f32(SAMPLES) * view.footprint.z;
    if adds {
        coverage += bitcast<f32>(output[word]);
    }
    store(word, coverage);
}

@compute @workgroup_size(8, 8)
fn resolve(@builtin(global_invocation_id) pixel: vec3<u32>) {
    if any(pixel.xy >= view.window.xy) {
        return;
    }
    let number = pixel.y * view.window.x + pixel.x;
    let ray = ray_of(pixel.xy);
    let writes_first = batch.records.w != 0u;
    let adds = view.window.w != 0u;
    if COLOR && writes_first && view.more_outputs.w != NONE {
        store_coverage(number, pixel.xy, adds);
    }
    if SAMPLES > 1u {
        // Several batches may own samples of one pixel: the first one writes, the others add.
        store_color(number, color_of_samples(pixel.xy, ray), adds || !writes_first);
        return;
    }
    let id = face_at(pixel.xy, 0u);
    if id.x == NONE {
        if writes_first {
            if COLOR {
                store_color(number, backdrop_color(ray), adds);
            }
            if SURFACE {
                store_miss(number, ray);
            }
        }
        return;
    }
    if !is_in_batch(id) {
        return;
    }
    let record = record_of(id.x - batch.records.x);
    let part = part_of(record);
    let surface = surface_of(record, part, id.y, ray);
    if COLOR {
        store_color(number, surface_color(record, part, id.y, surface, ray), adds);
    }
    if SURFACE {
        store_surface(number, id, surface, ray);
        if view.more_outputs.y != NONE {
            let color = albedo(part, material_of(part, id.y), spot_of(id.y, surface, ray));
            store_3(view.more_outputs.y, number, color);
        }
        if view.more_outputs.z != NONE {
            let normal = shading_normal(record, part, id.y, surface.at, surface.normal);
            store_3(view.more_outputs.z, number, normal);
        }
    }
}

fn store_surface(number: u32, id: vec2<u32>, surface: Surface, ray: Ray) {
    store_range_and_id(number, displayed_range(ray.direction, surface.range), id);
    store_3(view.outputs.w, number, surface.point + view.eye.xyz);
    store_3(view.more_outputs.x, number, surface.normal);
}

// Stores a pixel without a face: the map's range, and the number of its texel in place of a face.
fn store_miss(number: u32, ray: Ray) {
    let infinite = bitcast<f32>(0x7f800000u + view.window.w * 0u);
    let nan = bitcast<f32>(0x7fc00000u + view.window.w * 0u);
    var range = infinite;
    var texel = NONE;
    if MAPPED && sees_map(ray.direction) {
        texel = texel_number(ray.direction, view.environment.x);
        if view.environment.w != 0u {
            range = map_range_of(texel);
        }
    }
    store_range_and_id(number, backdrop_range(ray.direction, range), vec2<u32>(NONE, texel));
    var point = vec3<f32>(nan);
    if range < 1e30 {
        point = view.eye.xyz - view.backdrop.xyz + range * ray.direction;
    }
    store_3(view.outputs.w, number, point);
    for (var i = 0u; i < 3u; i++) {
        store_3(view.more_outputs[i], number, vec3<f32>(nan));
    }
}
