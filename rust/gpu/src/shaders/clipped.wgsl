// Vertices of triangles that the adapter clips at planes, so that fragments need no test and edges are smooth.

struct Clipped {
    @builtin(position) position: vec4<f32>,
    @builtin(clip_distances) above: array<f32, 8>,
    @location(0) @interpolate(flat) id: vec2<u32>,
}

@vertex
fn clipped_vertex(@builtin(vertex_index) number: u32, @builtin(instance_index) instance: u32) -> Clipped {
    let corner = corner_of(number, instance);
    var out: Clipped;
    out.position = corner.position;
    out.id = id_of(corner.local, number);
    let count = u32(view.segment.w);
    for (var i = 0u; i < 8u; i++) {
        out.above[i] = select(1.0, dot(view.planes[i].xyz, corner.q) + view.planes[i].w, i < count);
    }
    return out;
}
