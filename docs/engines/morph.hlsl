#ifndef NEARFAR_MORPH
#define NEARFAR_MORPH
// The morph of nearfar in HLSL: where the user is shown a point of the world. Licence: MIT or Apache-2.0.
// Written by `python -m scripts.shaders.write` from morph.wgsl and world.wgsl; docs/engines.md tells how to use it.
//
// Call nearfar_morph or nearfar_morph_cylinder in the vertex stage; and, if points are morphed by the cylinder,
// nearfar_range_cylinder where the far map's range is read. Their parameters:
//   p              a point of the world, any unit of length; y is up
//   user           the position U of the eye that the picture is for, same unit and axes; each eye has its own
//   center         the centre O of the reduction, from which the far map was baked, same unit and axes
//   r1, r2         radii of the near zone and of all geometry, same unit
//   strength       1; below it, near points move to where the centre sees them (0), so that they can appear smoothly
//   direction      a unit vector, in which the map is looked up
//   range          what the map holds there: the distance from the centre, same unit

// The morph: Popescu, Lee, Choi, Fahmy (2022), Eq. 1-3, and CloVR (2024), Alg. 1. Renderer and array kernel share these
// functions, so that tests of the kernel cover the renderer.

// A blend of unit vectors below this has no digits left.
static const float OPPOSED = 1e-6;

// Weight of the user's view at full strength, at a distance from the axis: 1 within r1 and 0 beyond r2; slope is 1 / (r2 - r1).
float user_weight(float rho, float r2, float slope) {
    return clamp((r2 - rho) * slope, 0.0, 1.0);
}

// Eq. 1-3 as written: displayed direction, and in w the distance.
float4 blended(float3 from_user, float3 from_center, float w) {
    float by_user = length(from_user);
    float by_center = length(from_center);
    float3 user_direction = from_user / max(by_user, 1e-30);
    float3 mixed = w * user_direction + (1.0 - w) * from_center / max(by_center, 1e-30);
    float size = length(mixed);
    float3 direction = user_direction;
    if (size > OPPOSED) {
        direction = mixed / size;
    }
    return float4(direction, w * by_user + (1.0 - w) * by_center);
}

// User's position on the ground relative to the axis, and its distance from the axis.
struct Place {
    float2 at;
    float rho;
};

Place make_Place(float2 at, float rho) {
    Place made;
    made.at = at;
    made.rho = rho;
    return made;
}

// Returns the ground position of a user at an offset from the centre.
Place ground_place(float3 offset) {
    return make_Place(offset.xz, length(offset.xz));
}

// Returns the distance from the user along a unit direction to the exit from the cylinder of radius rho about the axis;
// negative if the user stands outside or the direction never leaves. Larger root, computed without cancellation.
float leave_cylinder(Place user, float3 direction, float rho) {
    float a = dot(direction.xz, direction.xz);
    if (rho <= user.rho || a == 0.0) {
        return -1.0;
    }
    float b = dot(direction.xz, user.at);
    // Negative inside the cylinder, so that the discriminant is not.
    float c = (user.rho - rho) * (user.rho + rho);
    float q = sqrt(b * b - a * c);
    if (b > 0.0) {
        return -c / (b + q);
    }
    return (q - b) / a;
}

// Returns the blended direction, and in w the distance at which it leaves the point's own cylinder, if it does.
float4 on_cylinder(Place user, float3 from_user, float3 from_center, float w, float rho) {
    float4 to = blended(from_user, from_center, w);
    float exit = leave_cylinder(user, to.xyz, rho);
    return float4(to.xyz, ((exit >= 0.0) ? exit : to.w));
}

// Returns the displayed distance, on cylinders, of a point that the centre sees beyond r2 in a unit direction. (Blended
// points keep their distance.) Infinite distances stay infinite.
float range_on_cylinder(Place user, float3 direction, float from_center) {
    if (from_center > 1e30) {
        return from_center;
    }
    float exit = leave_cylinder(user, direction, from_center * length(direction.xz));
    return ((exit >= 0.0) ? exit : from_center);
}

// The morph of a point of the world, for the kernel of arrays and for engines. Lengths in one unit, y up, either hand.

// Squares beyond this approach float32's maximum.
static const float FAR_SQUARED = 1e28;

// Radius within which points do not move (negative: all move), r2, 1 / (r2 - r1), and the strength of the morph.
struct Zones {
    float stays;
    float r2;
    float slope;
    float strength;
};

Zones make_Zones(float stays, float r2, float slope, float strength) {
    Zones made;
    made.stays = stays;
    made.r2 = r2;
    made.slope = slope;
    made.strength = strength;
    return made;
}

// At strengths below 1 all points move. If r2 is 0, nothing is near.
Zones zones_of(float r1, float r2, float strength) {
    Zones zones = make_Zones(-1.0, r2, 0.0, strength);
    if (r2 > r1) {
        zones.slope = 1.0 / (r2 - r1);
    }
    if (r2 > 0.0 && strength >= 1.0) {
        zones.stays = r1;
    }
    return zones;
}

// Q - P of the blend. With A = |P-U|, B = |P-O|, v = U-O, e = (A-B)^2, h = w(1-w)/(AB) and n^2 = 1 - h (|v|^2 - e) (the
// squared length of the blend of both directions), Q = P + a (P-O) + b v, where a = h (e + (|v|^2-e)/(1+n))/n and
// b = 1 - w (w + (1-w) B/A)/n. Both are of the size of |v|, so that rounding is relative to the user's offset.
float3 shift_of_blend(float3 from_center, float3 offset, float w) {
    float b_squared = dot(from_center, from_center);
    // The limit for points far above: both directions are one.
    if (w == 0.0 || b_squared > FAR_SQUARED) {
        return (1.0 - w) * offset;
    }
    float3 from_user = from_center - offset;
    float offset_squared = dot(offset, offset);
    float a = length(from_user);
    float b = sqrt(b_squared);
    if (offset_squared > a * b) {
        float4 to = blended(from_user, from_center, w);
        return offset + to.w * to.xyz - from_center;
    }
    float difference = (offset_squared - 2.0 * dot(from_center, offset)) / (a + b);
    float e = difference * difference;
    float turn = offset_squared - e;
    float h = w * (1.0 - w) / (a * b);
    float n = sqrt(1.0 - h * turn);
    float along = h * (e + turn / (1.0 + n)) / n;
    float by_offset = 1.0 - w * (w + (1.0 - w) * b / a) / n;
    return along * from_center + by_offset * offset;
}

// Q - P on the cylinder of radius rho.
float3 shift_on_cylinder(float3 from_center, float3 offset, float w, float rho) {
    if (dot(from_center, from_center) > FAR_SQUARED) {
        return offset;
    }
    float4 to = on_cylinder(ground_place(offset), from_center - offset, from_center, w, rho);
    return offset + to.w * to.xyz - from_center;
}

// Returns the displayed position of a point p of the world: on its own cylinder, or by the blend. Pass the point and the
// user relative to the centre, too: subtract large coordinates in more digits than float32 has.
float3 displayed_in_world(float3 p, float3 from_center, float3 offset, Zones zones, bool keeps_rho) {
    float rho = length(from_center.xz);
    if (rho <= zones.stays) {
        return p;
    }
    float w = zones.strength * user_weight(rho, zones.r2, zones.slope);
    if (keeps_rho) {
        return p + shift_on_cylinder(from_center, offset, w, rho);
    }
    return p + shift_of_blend(from_center, offset, w);
}

// Returns the displayed position of the point p of the world, by the blend (2022).
float3 nearfar_morph(float3 p, float3 user, float3 center, float r1, float r2, float strength) {
    return displayed_in_world(p, p - center, user - center, zones_of(r1, r2, strength), false);
}

// Returns the same for the cylinder (CloVR, 2024), which keeps each point's distance from the centre's axis.
float3 nearfar_morph_cylinder(float3 p, float3 user, float3 center, float r1, float r2, float strength) {
    return displayed_in_world(p, p - center, user - center, zones_of(r1, r2, strength), true);
}

// Returns the displayed distance of the far map's surface at a range in a unit direction, with the cylinder.
float nearfar_range_cylinder(float3 direction, float range, float3 user, float3 center) {
    return range_on_cylinder(ground_place(user - center), direction, range);
}

#endif
