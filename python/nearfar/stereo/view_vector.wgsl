// Unit vector from a surface point to its viewer: the eye before the mono plane, the third camera beyond it, and a mixture
// over the last `blend` metres before it. Positions are in one frame of reference, metres; `ahead` is the head's unit
// forward axis, `plane` the plane's distance from the plane of the eyes, `setback` the third camera's behind the latter.
fn view_vector(
    point: vec3<f32>,
    eye: vec3<f32>,
    center: vec3<f32>,
    ahead: vec3<f32>,
    plane: f32,
    setback: f32,
    blend: f32,
) -> vec3<f32> {
    let depth = dot(point - center, ahead) - setback;
    let share = clamp((plane - depth) / blend, 0.0, 1.0);
    return normalize(mix(normalize(center - point), normalize(eye - point), share));
}
