// The morph: Popescu, Lee, Choi, Fahmy (2022), Eq. 1-3, and CloVR (2024), Alg. 1. Renderer and array kernel share these
// functions, so that tests of the kernel cover the renderer.

// Length below which a blend of unit vectors has lost all precision.
const MIN_BLEND_LENGTH: f32 = 1e-6;

// Returns the weight of the user's view at full strength, at a distance from the axis: 1 within r1 and 0 beyond r2.
// `slope` is 1 / (r2 - r1).
fn user_weight(rho: f32, r2: f32, slope: f32) -> f32 {
    return clamp((r2 - rho) * slope, 0.0, 1.0);
}

// Returns the blend by Eq. 1-3: the displayed direction, and in w the displayed distance.
fn blended(from_user: vec3<f32>, from_center: vec3<f32>, w: f32) -> vec4<f32> {
    let by_user = length(from_user);
    let by_center = length(from_center);
    let user_direction = from_user / max(by_user, 1e-30);
    let mixed = w * user_direction + (1.0 - w) * from_center / max(by_center, 1e-30);
    let size = length(mixed);
    var direction = user_direction;
    if size > MIN_BLEND_LENGTH {
        direction = mixed / size;
    }
    return vec4<f32>(direction, w * by_user + (1.0 - w) * by_center);
}

// A user's position on the ground relative to the axis, and its distance from the axis.
struct Place {
    xz: vec2<f32>,
    rho: f32,
}

// Returns the ground position of a user at an offset from the centre.
fn ground_place(offset: vec3<f32>) -> Place {
    return Place(offset.xz, length(offset.xz));
}

// Returns the distance from the user along a unit direction to the exit from the cylinder of radius rho about the axis;
// negative if the user stands outside or the direction never leaves it. The larger root, computed without cancellation.
fn leave_cylinder(user: Place, direction: vec3<f32>, rho: f32) -> f32 {
    let a = dot(direction.xz, direction.xz);
    if rho <= user.rho || a == 0.0 {
        return -1.0;
    }
    let b = dot(direction.xz, user.xz);
    // Negative inside the cylinder, so that the discriminant is not.
    let c = (user.rho - rho) * (user.rho + rho);
    let q = sqrt(b * b - a * c);
    if b > 0.0 {
        return -c / (b + q);
    }
    return (q - b) / a;
}

// Returns the blended direction, and in w the distance at which it leaves the point's own cylinder, if it does.
fn on_cylinder(user: Place, from_user: vec3<f32>, from_center: vec3<f32>, w: f32, rho: f32) -> vec4<f32> {
    let to = blended(from_user, from_center, w);
    let exit = leave_cylinder(user, to.xyz, rho);
    return vec4<f32>(to.xyz, select(to.w, exit, exit >= 0.0));
}

// Returns the displayed distance, on cylinders, of a point that the centre sees beyond r2 in a unit direction. (Blended
// points keep their distance.) Infinite distances stay infinite.
fn range_on_cylinder(user: Place, direction: vec3<f32>, from_center: f32) -> f32 {
    if from_center > 1e30 {
        return from_center;
    }
    let exit = leave_cylinder(user, direction, from_center * length(direction.xz));
    return select(from_center, exit, exit >= 0.0);
}
