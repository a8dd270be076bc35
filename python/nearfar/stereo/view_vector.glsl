// Unit vector from a surface point to its viewer: the eye before the mono plane, the third camera beyond it, and a mixture
// over the last `blend` metres before it. Positions are in one frame of reference, metres; `ahead` is the head's unit
// forward axis, `plane` the plane's distance from the plane of the eyes, `setback` the third camera's behind the latter.
vec3 view_vector(vec3 point, vec3 eye, vec3 center, vec3 ahead, float plane, float setback, float blend) {
    float depth = dot(point - center, ahead) - setback;
    float share = clamp((plane - depth) / blend, 0.0, 1.0);
    return normalize(mix(normalize(center - point), normalize(eye - point), share));
}
