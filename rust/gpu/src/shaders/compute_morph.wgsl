// Morph of arrays, by the functions of `morph.wgsl` and `world.wgsl`.

struct Morph {
    // Centre as the sum of two vectors, for precision; center_high.w is the strength of the morph.
    center_high: vec4<f32>,
    center_low: vec4<f32>,
    // Vector from the centre to the user.
    offset: vec4<f32>,
    // Radius within which points do not move, r2, 1 / (r2 - r1).
    radii: vec4<f32>,
    // Number of points.
    count: vec4<u32>,
}

@group(0) @binding(0) var<uniform> morph: Morph;
@group(0) @binding(1) var<storage, read> points: array<f32>;
@group(0) @binding(2) var<storage, read_write> displayed_points: array<f32>;

fn point_of(number: u32) -> vec3<f32> {
    return vec3<f32>(points[3u * number], points[3u * number + 1u], points[3u * number + 2u]);
}

fn store(number: u32, point: vec3<f32>) {
    displayed_points[3u * number] = point.x;
    displayed_points[3u * number + 1u] = point.y;
    displayed_points[3u * number + 2u] = point.z;
}

fn relative_to_center(p: vec3<f32>) -> vec3<f32> {
    return (p - morph.center_high.xyz) - morph.center_low.xyz;
}

// Keeps each point on its own cylinder if KEEPS_RHO is 1, and blends otherwise.
@compute @workgroup_size(GROUP)
fn morph_points(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let number = item_number(group, local);
    if number >= morph.count.x {
        return;
    }
    let p = point_of(number);
    var displayed = p + morph.offset.xyz;
    if is_finite(p) {
        let zones = Zones(morph.radii.x, morph.radii.y, morph.radii.z, morph.center_high.w);
        displayed = displayed_in_world(p, relative_to_center(p), morph.offset.xyz, zones, KEEPS_RHO == 1u);
    }
    store(number, displayed);
}
