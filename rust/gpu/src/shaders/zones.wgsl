// Cuts of the near-far method: select fragments by their distance from the centre's axis before the morph.

const INSIDE: u32 = 1u;
const OUTSIDE: u32 = 2u;
const OUTSIDE_UNHIDDEN: u32 = 3u;
const OUTSIDE_OVERLAPPING: u32 = 4u;

// A fragment counts as hidden only if it lies behind the map by more than this fraction of the range.
const BIAS: f32 = 4e-3;

fn cut_vector(p: vec3<f32>) -> vec3<f32> {
    return p + view.parameters[0].xyz;
}

// Returns the distance from the centre beyond which the map hides objects beyond the near part.
fn range_limit(d: vec3<f32>) -> f32 {
    let taps = taps_of(d, view.environment.x);
    let farthest = max(
        max(map_range_of(taps.texel.x), map_range_of(taps.texel.y)),
        max(map_range_of(taps.texel.z), map_range_of(taps.texel.w)),
    );
    return farthest * (1.0 + BIAS);
}

// Returns by how much the distance from the axis grows along a surface if the direction from the centre turns by two
// texels.
fn reach(from_center: vec3<f32>, normal: vec3<f32>) -> f32 {
    let direction = normalize(from_center);
    let flat_part = vec3<f32>(direction.x, 0.0, direction.z);
    let outward = flat_part / max(length(flat_part), 1e-30);
    let slant = dot(outward, direction) / dot(normal, direction);
    return length(outward - normal * slant) * length(from_center) * view.parameters[0].w;
}

fn is_kept(from_center: vec3<f32>, from_eye: vec3<f32>, normal: vec3<f32>) -> bool {
    let cut_radius = view.parameters[1].z;
    let rho = length(from_center.xz);
    if CUT == INSIDE {
        return rho <= cut_radius;
    }
    if CUT == OUTSIDE_OVERLAPPING {
        return rho >= cut_radius || rho + reach(from_center, normal) >= cut_radius;
    }
    var is_outside = rho > cut_radius;
    if CUT == OUTSIDE_UNHIDDEN {
        let distance = length(from_eye);
        let direction = from_eye / distance;
        let limit = backdrop_range(direction, range_limit(direction));
        // A surface of the map nearer than the visible segment hides nothing.
        is_outside = is_outside && (distance <= limit || limit < visible_segment(direction).x);
    }
    return is_outside;
}
