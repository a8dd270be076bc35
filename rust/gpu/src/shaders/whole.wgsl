// No cut: all fragments are drawn.

// Returns the vector of a point relative to the eye that is interpolated between vertices for `is_kept`.
fn cut_vector(p: vec3<f32>) -> vec3<f32> {
    return p;
}

// Returns whether a fragment is drawn, from the vector of `cut_vector`, its displayed position and its face's normal.
fn is_kept(vector: vec3<f32>, from_eye: vec3<f32>, normal: vec3<f32>) -> bool {
    return true;
}
