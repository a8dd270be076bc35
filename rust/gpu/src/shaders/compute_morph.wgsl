// The morph of arrays, by the functions of `morph.wgsl`.

struct Morph {
    // The centre as the sum of two numbers; w of the first: the strength.
    center_high: vec4<f32>,
    center_low: vec4<f32>,
    // From the centre to the user; w: its squared length.
    offset: vec4<f32>,
    // Radius within which points stay, r2, 1 / (r2 - r1), length of the offset across the axis.
    radii: vec4<f32>,
    // Points.
    count: vec4<u32>,
}

@group(0) @binding(0) var<uniform> morph: Morph;
@group(0) @binding(1) var<storage, read> points: array<f32>;
@group(0) @binding(2) var<storage, read_write> moved: array<f32>;

// Squares beyond this come near to float32's end.
const FAR: f32 = 1e28;

fn number_of(group: vec3<u32>, local: u32) -> u32 {
    return (group.y * ROW + group.x) * GROUP + local;
}

fn point_of(number: u32) -> vec3<f32> {
    return vec3<f32>(points[3u * number], points[3u * number + 1u], points[3u * number + 2u]);
}

fn store(number: u32, point: vec3<f32>) {
    moved[3u * number] = point.x;
    moved[3u * number + 1u] = point.y;
    moved[3u * number + 2u] = point.z;
}

// Comparisons don't tell: compilers may assume that there is nothing but numbers.
fn is_finite(p: vec3<f32>) -> bool {
    return all((bitcast<vec3<u32>>(p) & vec3<u32>(0x7f800000u)) != vec3<u32>(0x7f800000u));
}

fn relative_to_center(p: vec3<f32>) -> vec3<f32> {
    return (p - morph.center_high.xyz) - morph.center_low.xyz;
}

fn in_the_world(from_center: vec3<f32>) -> vec3<f32> {
    return morph.center_high.xyz + (from_center + morph.center_low.xyz);
}

// With A = |P-U|, B = |P-O|, v = U-O, e = (A-B)^2, h = w(1-w)/(AB) and n^2 = 1 - h (|v|^2 - e) (the squared length of
// the blend of both directions), Q = P + a (P-O) + b v, where a = h (e + (|v|^2-e)/(1+n))/n and
// b = 1 - w (w + (1-w) B/A)/n. Both are of the size of |v|, so that rounding is relative to the user's offset.
fn moved_by_blend(p: vec3<f32>, from_center: vec3<f32>, rho: f32) -> vec3<f32> {
    let v = morph.offset.xyz;
    let w = morph.center_high.w * user_weight(rho, morph.radii.y, morph.radii.z);
    let from_user = from_center - v;
    let b_squared = dot(from_center, from_center);
    if b_squared > FAR {
        // The limit for points far above: both directions are one.
        return p + (1.0 - w) * v;
    }
    let a = length(from_user);
    let b = sqrt(b_squared);
    if morph.offset.w > a * b {
        let to = blended(from_user, from_center, w);
        return in_the_world(v + to.w * to.xyz);
    }
    let difference = (morph.offset.w - 2.0 * dot(from_center, v)) / (a + b);
    let e = difference * difference;
    let turn = morph.offset.w - e;
    let h = w * (1.0 - w) / (a * b);
    let n = sqrt(1.0 - h * turn);
    let along = h * (e + turn / (1.0 + n)) / n;
    let by_offset = 1.0 - w * (w + (1.0 - w) * b / a) / n;
    return p + (along * from_center + by_offset * v);
}

@compute @workgroup_size(GROUP)
fn morph_blend(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let number = number_of(group, local);
    if number >= morph.count.x {
        return;
    }
    let p = point_of(number);
    let from_center = relative_to_center(p);
    let rho = length(from_center.xz);
    if !is_finite(p) || rho >= morph.radii.y {
        store(number, p + morph.offset.xyz);
    } else if rho <= morph.radii.x {
        store(number, p);
    } else {
        store(number, moved_by_blend(p, from_center, rho));
    }
}

@compute @workgroup_size(GROUP)
fn morph_cylinder(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let number = number_of(group, local);
    if number >= morph.count.x {
        return;
    }
    let p = point_of(number);
    let from_center = relative_to_center(p);
    let rho = length(from_center.xz);
    if !is_finite(p) || dot(from_center, from_center) > FAR {
        store(number, p + morph.offset.xyz);
    } else if rho <= morph.radii.x {
        store(number, p);
    } else {
        let w = morph.center_high.w * user_weight(rho, morph.radii.y, morph.radii.z);
        let user = Place(morph.offset.xz, morph.radii.w);
        let to = on_cylinder(user, from_center - morph.offset.xyz, from_center, w, rho);
        store(number, in_the_world(morph.offset.xyz + to.w * to.xyz));
    }
}
