// Two views drawn in one pass: each vertex is placed in both.

@group(1) @binding(0) var<uniform> views: array<Pass, 2>;

// Pass of the view in which the current vertex is placed.
var<private> view: Pass;

@vertex
fn plain_vertex_of_two(
    @builtin(vertex_index) number: u32, @builtin(instance_index) instance: u32, @builtin(view_index) side: u32
) -> Plain {
    view = views[side];
    return plain_corner(number, instance);
}
