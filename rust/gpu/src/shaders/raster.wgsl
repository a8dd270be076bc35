// Writes the face that each pixel shows, as a record and a face of its part. The resolve pass computes everything
// else.

// Variant of the cut, and whether it reads the face's normal.
override CUT: u32 = 0u;
override FACE_NORMALS: bool = false;
// Whether holes of cut-out materials are discarded.
override CUTOUT: bool = false;
// Whether fragments outside the visible volume are discarded.
override LIMITED: bool = false;

@group(0) @binding(6) var<storage, read> order: array<u32>;

// A vertex of a triangle: its record, its position and its displayed position.
struct Corner {
    local: u32,
    record: Record,
    part: Part,
    vertex: u32,
    p: vec3<f32>,
    q: vec3<f32>,
    position: vec4<f32>,
}

fn corner_of(number: u32, instance: u32) -> Corner {
    var local = batch.shifts.y;
    if !ONE_RECORD {
        local = order[instance];
    }
    let record = record_of(local);
    let part = batch.part;
    let vertex = page[part.faces + number];
    let p = position_from_eye(record, part, vertex);
    let q = displayed(p);
    let at = vec4<f32>(q, 1.0);
    let position = vec4<f32>(dot(view.clip_x, at), dot(view.clip_y, at), dot(view.clip_z, at), dot(view.clip_w, at));
    return Corner(local, record, part, vertex, p, q, position);
}

fn id_of(local: u32, number: u32) -> vec2<u32> {
    return vec2<u32>(batch.records.x + local, number / 3u);
}

fn pack_id(id: vec2<u32>) -> vec4<u32> {
    return vec4<u32>(id.x & 0xffffu, id.x >> 16u, id.y & 0xffffu, id.y >> 16u);
}

// Depth that the fragment writes itself: OpenGL would map depths from -1..1 and lose the precision of reversed z.
fn own_depth(position: vec4<f32>) -> f32 {
    return select(position.z, view.eye.w * position.w, view.eye.w > 0.0);
}

struct WithDepth {
    @location(0) id: vec4<u32>,
    @builtin(frag_depth) depth: f32,
}

// Output for triangles that are drawn whole: only their number.
struct Plain {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) id: vec2<u32>,
}

fn plain_corner(number: u32, instance: u32) -> Plain {
    let corner = corner_of(number, instance);
    return Plain(corner.position, id_of(corner.local, number));
}

@vertex
fn plain_vertex(@builtin(vertex_index) number: u32, @builtin(instance_index) instance: u32) -> Plain {
    return plain_corner(number, instance);
}

@fragment
fn plain_fragment(in: Plain) -> @location(0) vec4<u32> {
    return pack_id(in.id);
}

@fragment
fn plain_fragment_with_depth(in: Plain) -> WithDepth {
    return WithDepth(pack_id(in.id), own_depth(in.position));
}

struct Vertex {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) id: vec2<u32>,
    // Vector for the cut.
    @location(1) cut_vector: vec3<f32>,
    // Displayed position, relative to the eye.
    @location(2) from_eye: vec3<f32>,
    @location(3) @interpolate(flat) normal: vec3<f32>,
    @location(4) uv: vec2<f32>,
    @location(5) alpha: f32,
}

@vertex
fn vertex(@builtin(vertex_index) number: u32, @builtin(instance_index) instance: u32) -> Vertex {
    let corner = corner_of(number, instance);
    let part = corner.part;
    var out: Vertex;
    out.position = corner.position;
    out.id = id_of(corner.local, number);
    out.cut_vector = cut_vector(corner.p);
    out.from_eye = corner.q;
    if FACE_NORMALS {
        let face = number / 3u;
        let a = position_from_eye(corner.record, part, corner_number(part, face, 0u));
        let b = position_from_eye(corner.record, part, corner_number(part, face, 1u));
        let c = position_from_eye(corner.record, part, corner_number(part, face, 2u));
        let size = max(max(length(b - a), length(c - a)), 1e-30);
        out.normal = cross((b - a) / size, (c - a) / size);
    }
    if CUTOUT {
        if part.uvs != NONE {
            out.uv = uv_of(part, corner.vertex);
        }
        out.alpha = 1.0;
        if part.colors != NONE {
            out.alpha = color_of(part, corner.vertex).a;
        }
    }
    return out;
}

fn is_drawn(in: Vertex) -> bool {
    var drawn = is_kept(in.cut_vector, in.from_eye, in.normal);
    if CUTOUT {
        drawn = drawn && is_solid(in);
    }
    if LIMITED {
        drawn = drawn && is_within_limits(in.from_eye);
    }
    return drawn;
}

// Tests the displayed position; for parallel rays the distance is measured from the image plane.
fn is_within_limits(from_eye: vec3<f32>) -> bool {
    var distance = length(from_eye);
    var place = from_eye;
    if view.footprint.y > 0.0 {
        distance = dot(from_eye, normalize(view.direction.xyz + view.remainder.xyz));
    } else {
        let direction = from_eye / distance;
        distance = displayed_range(direction, distance);
        place = direction * distance;
    }
    return distance >= view.segment.x && distance <= view.segment.y && is_within_planes(place);
}

fn is_solid(in: Vertex) -> bool {
    let part = batch.part;
    let material = material_of(part, in.id.y);
    if material.cutoff < 0.0 {
        return true;
    }
    var alpha = material.base_color.a * in.alpha;
    if material.texture != NONE && part.uvs != NONE {
        let texture = textures[material.texture];
        alpha *= bilinear(texture.finest, texture.width, texture.height, in.uv).a;
    }
    return alpha >= material.cutoff;
}

@fragment
fn fragment(in: Vertex) -> @location(0) vec4<u32> {
    if !is_drawn(in) {
        discard;
    }
    return pack_id(in.id);
}

@fragment
fn fragment_with_depth(in: Vertex) -> WithDepth {
    if !is_drawn(in) {
        discard;
    }
    return WithDepth(pack_id(in.id), own_depth(in.position));
}
