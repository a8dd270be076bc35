#ifndef NEARFAR_MORPH
#define NEARFAR_MORPH
// The morph of nearfar in HLSL: displayed position of a point of the world. Licence: MIT or Apache-2.0.
// Written by `NEARFAR_WRITE=1 cargo test -p nearfar-gpu --test engines`; docs/engines.md says how to use it, and
// docs/engines/morph.wgsl, from which naga translates it, has the comments.
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

struct Place {
    float2 xz;
    float rho;
    int _end_pad_0;
};

struct Zones {
    float fixed_radius;
    float r2_;
    float slope;
    float strength;
};

static const float MIN_BLEND_LENGTH = 1e-6;
static const float FAR_SQUARED = 1e28;

float user_weight(float rho, float r2_, float slope)
{
    return clamp(((r2_ - rho) * slope), 0.0, 1.0);
}

float4 blended(float3 from_user, float3 from_center, float w)
{
    float3 direction = (float3)0;

    float by_user = length(from_user);
    float by_center = length(from_center);
    float3 user_direction = (from_user / (max(by_user, 1e-30)).xxx);
    float3 mixed = ((w * user_direction) + (((1.0 - w) * from_center) / (max(by_center, 1e-30)).xxx));
    float size = length(mixed);
    direction = user_direction;
    if ((size > MIN_BLEND_LENGTH)) {
        direction = (mixed / (size).xxx);
    }
    float3 _e24 = direction;
    return float4(_e24, ((w * by_user) + ((1.0 - w) * by_center)));
}

Place ConstructPlace(float2 arg0, float arg1) {
    Place ret = (Place)0;
    ret.xz = arg0;
    ret.rho = arg1;
    return ret;
}

Place ground_place(float3 offset)
{
    const Place place = ConstructPlace(offset.xz, length(offset.xz));
    return place;
}

float leave_cylinder(Place user, float3 direction_1, float rho_1)
{
    bool local = (bool)0;

    float a = dot(direction_1.xz, direction_1.xz);
    if (!((rho_1 <= user.rho))) {
        local = (a == 0.0);
    } else {
        local = true;
    }
    bool _e14 = local;
    if (_e14) {
        return -1.0;
    }
    float b = dot(direction_1.xz, user.xz);
    float c = ((user.rho - rho_1) * (user.rho + rho_1));
    float q = sqrt(((b * b) - (a * c)));
    if ((b > 0.0)) {
        return (-(c) / (b + q));
    }
    return ((q - b) / a);
}

float4 on_cylinder(Place user_1, float3 from_user_1, float3 from_center_1, float w_1, float rho_2)
{
    const float4 _e5 = blended(from_user_1, from_center_1, w_1);
    const float _e7 = leave_cylinder(user_1, _e5.xyz, rho_2);
    return float4(_e5.xyz, ((_e7 >= 0.0) ? _e7 : _e5.w));
}

float range_on_cylinder(Place user_2, float3 direction_2, float from_center_2)
{
    if ((from_center_2 > 1e30)) {
        return from_center_2;
    }
    const float _e8 = leave_cylinder(user_2, direction_2, (from_center_2 * length(direction_2.xz)));
    return ((_e8 >= 0.0) ? _e8 : from_center_2);
}

Zones ConstructZones(float arg0, float arg1, float arg2, float arg3) {
    Zones ret = (Zones)0;
    ret.fixed_radius = arg0;
    ret.r2_ = arg1;
    ret.slope = arg2;
    ret.strength = arg3;
    return ret;
}

Zones zones_of(float r1_, float r2_1, float strength)
{
    Zones zones = (Zones)0;
    bool local_1 = (bool)0;

    zones = ConstructZones(-1.0, r2_1, 0.0, strength);
    if ((r2_1 > r1_)) {
        zones.slope = (1.0 / (r2_1 - r1_));
    }
    if ((r2_1 > 0.0)) {
        local_1 = (strength >= 1.0);
    } else {
        local_1 = false;
    }
    bool _e19 = local_1;
    if (_e19) {
        zones.fixed_radius = r1_;
    }
    Zones _e21 = zones;
    const Zones zones_2 = _e21;
    return zones_2;
}

float3 shift_of_blend(float3 from_center_3, float3 offset_1, float w_2)
{
    bool local_2 = (bool)0;

    float b_squared = dot(from_center_3, from_center_3);
    if (!((w_2 == 0.0))) {
        local_2 = (b_squared > FAR_SQUARED);
    } else {
        local_2 = true;
    }
    bool _e12 = local_2;
    if (_e12) {
        return ((1.0 - w_2) * offset_1);
    }
    float3 from_user_2 = (from_center_3 - offset_1);
    float offset_squared = dot(offset_1, offset_1);
    float a_1 = length(from_user_2);
    float b_1 = sqrt(b_squared);
    if ((offset_squared > (a_1 * b_1))) {
        const float4 _e22 = blended(from_user_2, from_center_3, w_2);
        return ((offset_1 + (_e22.w * _e22.xyz)) - from_center_3);
    }
    float difference = ((offset_squared - (2.0 * dot(from_center_3, offset_1))) / (a_1 + b_1));
    float e = (difference * difference);
    float turn = (offset_squared - e);
    float h = ((w_2 * (1.0 - w_2)) / (a_1 * b_1));
    float n = sqrt((1.0 - (h * turn)));
    float along = ((h * (e + (turn / (1.0 + n)))) / n);
    float by_offset = (1.0 - ((w_2 * (w_2 + (((1.0 - w_2) * b_1) / a_1))) / n));
    return ((along * from_center_3) + (by_offset * offset_1));
}

float3 shift_on_cylinder(float3 from_center_4, float3 offset_2, float w_3, float rho_3)
{
    if ((dot(from_center_4, from_center_4) > FAR_SQUARED)) {
        return offset_2;
    }
    const Place _e7 = ground_place(offset_2);
    const float4 _e9 = on_cylinder(_e7, (from_center_4 - offset_2), from_center_4, w_3, rho_3);
    return ((offset_2 + (_e9.w * _e9.xyz)) - from_center_4);
}

float3 displayed_in_world(float3 p, float3 from_center_5, float3 offset_3, Zones zones_1, bool keeps_rho)
{
    float rho_4 = length(from_center_5.xz);
    if ((rho_4 <= zones_1.fixed_radius)) {
        return p;
    }
    const float _e12 = user_weight(rho_4, zones_1.r2_, zones_1.slope);
    float w_4 = (zones_1.strength * _e12);
    if (keeps_rho) {
        const float3 _e14 = shift_on_cylinder(from_center_5, offset_3, w_4, rho_4);
        return (p + _e14);
    }
    const float3 _e16 = shift_of_blend(from_center_5, offset_3, w_4);
    return (p + _e16);
}

float3 nearfar_morph(float3 p_1, float3 user_3, float3 center_, float r1_1, float r2_2, float strength_1)
{
    const Zones _e8 = zones_of(r1_1, r2_2, strength_1);
    const float3 _e10 = displayed_in_world(p_1, (p_1 - center_), (user_3 - center_), _e8, false);
    return _e10;
}

float3 nearfar_morph_cylinder(float3 p_2, float3 user_4, float3 center_1, float r1_2, float r2_3, float strength_2)
{
    const Zones _e8 = zones_of(r1_2, r2_3, strength_2);
    const float3 _e10 = displayed_in_world(p_2, (p_2 - center_1), (user_4 - center_1), _e8, true);
    return _e10;
}

float nearfar_range_cylinder(float3 direction_3, float range, float3 user_5, float3 center_2)
{
    const Place _e5 = ground_place((user_5 - center_2));
    const float _e6 = range_on_cylinder(_e5, direction_3, range);
    return _e6;
}
#endif
