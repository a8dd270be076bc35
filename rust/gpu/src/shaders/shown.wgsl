// The style of the near-far method: the morph of Popescu, Lee, Choi, Fahmy (2022), Eq. 1-3, or of CloVR (2024), Alg. 1.
//
// Parameters: from the centre to the eye, and the tangent of two texels; r1, r2, the radius where pixels are split, and
// 1 / (r2 - r1); from the user to the eye, which is the camera's.

const BLEND: u32 = 1u;
const CYLINDER: u32 = 2u;
const FROM_CENTER: u32 = 3u;
const FROM_CENTER_ON_CYLINDER: u32 = 4u;
const CYLINDER_FROM_CENTER: u32 = 5u;

// From the centre's axis to the user, on the ground.
fn user_on_ground() -> vec2<f32> {
    return view.parameters[0].xz - view.parameters[2].xz;
}

// Distance from the user along a unit direction to where it leaves the cylinder of radius rho about the centre's axis;
// negative where it starts outside or never leaves. The larger root in the form that does not cancel.
fn leave_cylinder(direction: vec3<f32>, rho: f32) -> f32 {
    let start = user_on_ground();
    let start_rho = length(start);
    let a = dot(direction.xz, direction.xz);
    if rho <= start_rho || a == 0.0 {
        return -1.0;
    }
    let b = dot(direction.xz, start);
    let c = (start_rho - rho) * (start_rho + rho);
    let discriminant = b * b - a * c;
    if discriminant < 0.0 {
        return -1.0;
    }
    let q = sqrt(discriminant);
    if b > 0.0 {
        return -c / (b + q);
    }
    return (q - b) / a;
}

// Where a point relative to the eye is shown, relative to the eye.
fn shown(p: vec3<f32>) -> vec3<f32> {
    let q = morphed(p);
    if STYLE == CYLINDER_FROM_CENTER {
        return as_far_as_from_center(q);
    }
    return q;
}

// In the direction of a point that is shown beyond r2, the place whose distance is the point's from the centre: the
// inverse of `backdrop_range`.
fn as_far_as_from_center(q: vec3<f32>) -> vec3<f32> {
    let slope = length(q.xz);
    return q * (length(user_on_ground() + q.xz) / max(slope, 1e-30));
}

fn morphed(p: vec3<f32>) -> vec3<f32> {
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
    let w = clamp((view.parameters[1].y - rho) * view.parameters[1].w, 0.0, 1.0);
    let from_user = p + view.parameters[2].xyz;
    let by_user = length(from_user);
    let by_center = length(from_center);
    let user_direction = from_user / max(by_user, 1e-30);
    let mixed = w * user_direction + (1.0 - w) * from_center / max(by_center, 1e-30);
    let size = length(mixed);
    var direction = user_direction;
    if size > 1e-6 {
        direction = mixed / size;
    }
    var distance = w * by_user + (1.0 - w) * by_center;
    if STYLE == CYLINDER || STYLE == CYLINDER_FROM_CENTER {
        let exit = leave_cylinder(direction, rho);
        if exit >= 0.0 {
            distance = exit;
        }
    }
    return distance * direction - view.parameters[2].xyz;
}

// How far away the user is shown what the centre sees at a distance beyond r2.
fn backdrop_range(direction: vec3<f32>, from_center: f32) -> f32 {
    let is_on_cylinder = STYLE == CYLINDER || STYLE == FROM_CENTER_ON_CYLINDER || STYLE == CYLINDER_FROM_CENTER;
    if !is_on_cylinder || from_center > 1e30 {
        return from_center;
    }
    let exit = leave_cylinder(direction, from_center * length(direction.xz));
    return select(from_center, exit, exit >= 0.0);
}

// A surface that is drawn as far away as it is from the centre is shown as far away as the cylinder says.
fn shown_range(direction: vec3<f32>, range: f32) -> f32 {
    if STYLE == FROM_CENTER_ON_CYLINDER || STYLE == CYLINDER_FROM_CENTER {
        return backdrop_range(direction, range);
    }
    return range;
}
