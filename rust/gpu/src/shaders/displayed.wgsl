// Styles of the near-far method: displacement of points by the functions of `morph.wgsl`.
//
// Parameters:
// 0: vector from the centre to the camera's eye, tangent of two texels
// 1: radius within which points do not move, r2, radius of the cut in `zones.wgsl`, 1 / (r2 - r1)
// 2: vector from the user to the camera's eye, strength of the morph

const BLEND: u32 = 1u;
const CYLINDER: u32 = 2u;
const FROM_CENTER: u32 = 3u;
const FROM_CENTER_ON_CYLINDER: u32 = 4u;
const CYLINDER_FROM_CENTER: u32 = 5u;

// Returns the user's position on the ground.
fn user_place() -> Place {
    return ground_place(view.parameters[0].xyz - view.parameters[2].xyz);
}

// Returns the displayed position of a point; both are relative to the eye.
fn displayed(p: vec3<f32>) -> vec3<f32> {
    let q = morph_point(p);
    if STYLE == CYLINDER_FROM_CENTER {
        return at_distance_from_center(q);
    }
    return q;
}

// Moves a point that is displayed beyond r2 along its direction to the distance at which the centre sees it: the
// inverse of `backdrop_range`.
fn at_distance_from_center(q: vec3<f32>) -> vec3<f32> {
    let ground_length = length(q.xz);
    return q * (length(user_place().xz + q.xz) / max(ground_length, 1e-30));
}

fn morph_point(p: vec3<f32>) -> vec3<f32> {
    let from_center = p + view.parameters[0].xyz;
    if STYLE == FROM_CENTER || STYLE == FROM_CENTER_ON_CYLINDER {
        return from_center;
    }
    let rho = length(from_center.xz);
    if rho <= view.parameters[1].x {
        return p;
    }
    if rho >= view.parameters[1].y && STYLE == BLEND {
        return from_center - view.parameters[2].xyz;
    }
    let w = view.parameters[2].w * user_weight(rho, view.parameters[1].y, view.parameters[1].w);
    let from_user = p + view.parameters[2].xyz;
    var displayed_from_user = blended(from_user, from_center, w);
    if STYLE == CYLINDER || STYLE == CYLINDER_FROM_CENTER {
        displayed_from_user = on_cylinder(user_place(), from_user, from_center, w, rho);
    }
    return displayed_from_user.w * displayed_from_user.xyz - view.parameters[2].xyz;
}

// Returns the displayed distance of a surface that the centre sees at a distance beyond r2.
fn backdrop_range(direction: vec3<f32>, from_center: f32) -> f32 {
    let is_on_cylinder = STYLE == CYLINDER || STYLE == FROM_CENTER_ON_CYLINDER || STYLE == CYLINDER_FROM_CENTER;
    if !is_on_cylinder {
        return from_center;
    }
    return range_on_cylinder(user_place(), direction, from_center);
}

// A surface drawn at its distance from the centre is displayed at the cylinder's distance.
fn displayed_range(direction: vec3<f32>, range: f32) -> f32 {
    if STYLE == FROM_CENTER_ON_CYLINDER || STYLE == CYLINDER_FROM_CENTER {
        return backdrop_range(direction, range);
    }
    return range;
}
