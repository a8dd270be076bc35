// The plain style: points are shown where they are.

// Where a point relative to the eye is shown, relative to the eye.
fn shown(p: vec3<f32>) -> vec3<f32> {
    return p;
}

// How far away a surface is shown that is drawn at a distance along a unit direction.
fn shown_range(direction: vec3<f32>, range: f32) -> f32 {
    return range;
}

// How far away is shown what the environment map has at a distance along a unit direction.
fn backdrop_range(direction: vec3<f32>, range: f32) -> f32 {
    return range;
}
