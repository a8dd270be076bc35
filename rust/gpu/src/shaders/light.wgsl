// Shading formula of all renderers, `render::shade`.

fn irradiance(n: vec3<f32>) -> vec3<f32> {
    let sky = 0.5 + 0.5 * dot(n, SKY_DIRECTION);
    let sun = max(dot(n, SUN_DIRECTION), 0.0);
    return SKY_LOW + (SKY_HIGH - SKY_LOW) * sky + SUN * sun;
}

fn background(direction: vec3<f32>) -> vec3<f32> {
    let end = select(ZENITH, NADIR, direction.y < 0.0);
    return HORIZON + (end - HORIZON) * sqrt(abs(direction.y));
}

// Converts sRGB from 0 to 1 to linear colour.
fn linear_from_srgb(code: vec3<f32>) -> vec3<f32> {
    return select(pow((code + 0.055) / 1.055, vec3<f32>(2.4)), code / 12.92, code <= vec3<f32>(0.04045));
}
