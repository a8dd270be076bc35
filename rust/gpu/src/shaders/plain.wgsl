// Plain style: points are not displaced.

// Returns the displayed position of a point; both are relative to the eye.
fn displayed(p: vec3<f32>) -> vec3<f32> {
    return p;
}

// Returns the displayed distance of a surface drawn at a distance along a unit direction.
fn displayed_range(direction: vec3<f32>, range: f32) -> f32 {
    return range;
}

// Returns the displayed distance of the environment map's surface at a distance along a unit direction.
fn backdrop_range(direction: vec3<f32>, range: f32) -> f32 {
    return range;
}
