// No cut: all fragments are drawn.

// A vector that is interpolated between vertices for `is_kept`, of a point relative to the eye.
fn cut_place(p: vec3<f32>) -> vec3<f32> {
    return p;
}

// Whether a fragment is drawn: the vector of `cut_place`, where it is shown relative to the eye, and its face's normal.
fn is_kept(place: vec3<f32>, from_eye: vec3<f32>, normal: vec3<f32>) -> bool {
    return true;
}
