// Writes the nearest depth to pixels that are not drawn, so that all their fragments are hidden before shaders run.

// `Pass` of `scene.wgsl`. Only the window is used here.
struct Pass {
    before: array<vec4<f32>, 16>,
    // Width and height of the window, and two unused numbers.
    window: vec4<u32>,
}

// One bit per pixel of the window, row by row; 1 is drawn.
@group(0) @binding(0) var<storage, read> bits: array<u32>;
@group(1) @binding(0) var<uniform> view: Pass;

@vertex
fn whole_window(@builtin(vertex_index) n: u32) -> @builtin(position) vec4<f32> {
    // One triangle that covers the window, at the nearest depth, 1 in reversed depth.
    return vec4<f32>(f32(n & 1u) * 4.0 - 1.0, f32(n >> 1u) * 4.0 - 1.0, 1.0, 1.0);
}

@fragment
fn hide(@builtin(position) at: vec4<f32>) {
    let n = u32(at.y) * view.window.x + u32(at.x);
    if ((bits[n >> 5u] >> (n & 31u)) & 1u) != 0u {
        discard;
    }
}
