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
