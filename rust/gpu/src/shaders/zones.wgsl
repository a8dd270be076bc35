// Zones of the near-far method: fragments by their distance from the centre's axis, before the morph.

const WITHIN: u32 = 1u;
const BEYOND: u32 = 2u;
const BEYOND_AND_UNHIDDEN: u32 = 3u;
const OVERLAPPING: u32 = 4u;

// Relative range by which a fragment may lie behind the map before it counts as hidden.
const BIAS: f32 = 4e-3;

fn cut_place(p: vec3<f32>) -> vec3<f32> {
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

// Returns the growth of the distance from the axis along a surface when the direction turns by two texels.
fn reach(from_center: vec3<f32>, normal: vec3<f32>) -> f32 {
    let direction = normalize(from_center);
    let flat_part = vec3<f32>(direction.x, 0.0, direction.z);
    let away = flat_part / max(length(flat_part), 1e-30);
    let slant = dot(away, direction) / dot(normal, direction);
    return length(away - normal * slant) * length(from_center) * view.parameters[0].w;
}

fn is_kept(from_center: vec3<f32>, from_eye: vec3<f32>, normal: vec3<f32>) -> bool {
    let split = view.parameters[1].z;
    let rho = length(from_center.xz);
    if CUT == WITHIN {
        return rho <= split;
    }
    if CUT == OVERLAPPING {
        return rho >= split || rho + reach(from_center, normal) >= split;
    }
    var kept = rho > split;
    if CUT == BEYOND_AND_UNHIDDEN {
        let distance = length(from_eye);
        let direction = from_eye / distance;
        let limit = backdrop_range(direction, range_limit(direction));
        // A surface of the map nearer than the visible segment hides nothing.
        kept = kept && (distance <= limit || limit < seen_along(direction).x);
    }
    return kept;
}
