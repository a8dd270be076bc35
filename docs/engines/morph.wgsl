// The morph of nearfar in WGSL: displayed position of a point of the world. Licence: MIT or Apache-2.0.
// Written by `NEARFAR_WRITE=1 cargo test -p nearfar-gpu --test engines`; docs/engines.md says how to use it, and
// rust/gpu/src/shaders has its two parts.
//
// Call nearfar_morph or nearfar_morph_cylinder in the vertex stage; and, if points are morphed by the cylinder,
// nearfar_range_cylinder where the far map's range is read. Their parameters, in this order:
//   p              point of the world, any unit of length; y is up
//   user           position U of the eye that the picture is for, same unit and axes; each eye has its own
//   center         centre O of the reduction, from which the far map was baked, same unit and axes
//   r1, r2         radii of the near zone and of all geometry, same unit
//   strength       1 for the full morph. With less, near points move towards the direction in which the centre sees them,
//                  and reach it at 0; a client raises it from 0 to 1, so that geometry appears without a jump
// and of nearfar_range_cylinder:
//   direction      unit vector in which the map is looked up
//   range          value of the map: distance from the centre, same unit
//   user, center   as above

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

// The morph of a point of the world, for the kernel of arrays and for engines. All lengths have the same unit; y is up;
// axes are left- or right-handed.

// Squares beyond this approach float32's maximum.
const FAR_SQUARED: f32 = 1e28;

// Radius within which points do not move (negative: all move), r2, 1 / (r2 - r1), and the strength of the morph.
struct Zones {
    fixed_radius: f32,
    r2: f32,
    slope: f32,
    strength: f32,
}

// At strengths below 1 all points move. If r2 is 0, nothing is near.
fn zones_of(r1: f32, r2: f32, strength: f32) -> Zones {
    var zones = Zones(-1.0, r2, 0.0, strength);
    if r2 > r1 {
        zones.slope = 1.0 / (r2 - r1);
    }
    if r2 > 0.0 && strength >= 1.0 {
        zones.fixed_radius = r1;
    }
    return zones;
}

// Returns Q - P of the blend. Let A = |P-U|, B = |P-O|, v = U-O, e = (A-B)^2, h = w(1-w)/(AB), and let n be the length
// of the blend of both directions: n^2 = 1 - h (|v|^2-e). Then Q - P = a (P-O) + b v with
// a = h (e + (|v|^2-e)/(1+n))/n and b = 1 - w (w + (1-w) B/A)/n. Both terms are of the size of |v|, so that rounding is
// relative to the user's offset.
fn shift_of_blend(from_center: vec3<f32>, offset: vec3<f32>, w: f32) -> vec3<f32> {
    let b_squared = dot(from_center, from_center);
    // The limit for points far above: both directions are equal.
    if w == 0.0 || b_squared > FAR_SQUARED {
        return (1.0 - w) * offset;
    }
    let from_user = from_center - offset;
    let offset_squared = dot(offset, offset);
    let a = length(from_user);
    let b = sqrt(b_squared);
    if offset_squared > a * b {
        let to = blended(from_user, from_center, w);
        return offset + to.w * to.xyz - from_center;
    }
    let difference = (offset_squared - 2.0 * dot(from_center, offset)) / (a + b);
    let e = difference * difference;
    let turn = offset_squared - e;
    let h = w * (1.0 - w) / (a * b);
    let n = sqrt(1.0 - h * turn);
    let along = h * (e + turn / (1.0 + n)) / n;
    let by_offset = 1.0 - w * (w + (1.0 - w) * b / a) / n;
    return along * from_center + by_offset * offset;
}

// Returns Q - P on the cylinder of radius rho.
fn shift_on_cylinder(from_center: vec3<f32>, offset: vec3<f32>, w: f32, rho: f32) -> vec3<f32> {
    if dot(from_center, from_center) > FAR_SQUARED {
        return offset;
    }
    let to = on_cylinder(ground_place(offset), from_center - offset, from_center, w, rho);
    return offset + to.w * to.xyz - from_center;
}

// Returns the displayed position of a point p of the world: on its own cylinder, or by the blend. The point and the
// user are also passed relative to the centre; if coordinates are large, subtract them in more precision than float32.
fn displayed_in_world(
    p: vec3<f32>,
    from_center: vec3<f32>,
    offset: vec3<f32>,
    zones: Zones,
    keeps_rho: bool,
) -> vec3<f32> {
    let rho = length(from_center.xz);
    if rho <= zones.fixed_radius {
        return p;
    }
    let w = zones.strength * user_weight(rho, zones.r2, zones.slope);
    if keeps_rho {
        return p + shift_on_cylinder(from_center, offset, w, rho);
    }
    return p + shift_of_blend(from_center, offset, w);
}

// Returns the displayed position of the point p of the world, by the blend (2022).
fn nearfar_morph(p: vec3<f32>, user: vec3<f32>, center: vec3<f32>, r1: f32, r2: f32, strength: f32) -> vec3<f32> {
    return displayed_in_world(p, p - center, user - center, zones_of(r1, r2, strength), false);
}

// Returns the same for the cylinder (CloVR, 2024), which keeps each point's distance from the centre's axis.
fn nearfar_morph_cylinder(
    p: vec3<f32>,
    user: vec3<f32>,
    center: vec3<f32>,
    r1: f32,
    r2: f32,
    strength: f32,
) -> vec3<f32> {
    return displayed_in_world(p, p - center, user - center, zones_of(r1, r2, strength), true);
}

// Returns the displayed distance of the far map's surface at a range in a unit direction, with the cylinder.
fn nearfar_range_cylinder(direction: vec3<f32>, range: f32, user: vec3<f32>, center: vec3<f32>) -> f32 {
    return range_on_cylinder(ground_place(user - center), direction, range);
}
