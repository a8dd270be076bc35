// A scene as tables: pages of words, parts of meshes in them, and instances that place parts.

struct Pass {
    // Rows that map (point relative to the eye, 1) to clip space.
    clip_x: vec4<f32>,
    clip_y: vec4<f32>,
    clip_z: vec4<f32>,
    clip_w: vec4<f32>,
    // The eye relative to the scene's origin; w: distance of the near plane, 0 for parallel rays.
    eye: vec4<f32>,
    // Vector from the centre of the environment map to the eye.
    backdrop: vec4<f32>,
    // Start of the ray of pixel (0, 0) relative to the eye, and its change per pixel.
    start: vec4<f32>,
    start_x: vec4<f32>,
    start_y: vec4<f32>,
    // Direction of the ray, of any length.
    direction: vec4<f32>,
    direction_x: vec4<f32>,
    direction_y: vec4<f32>,
    // Remainders of the three vectors: the vectors above are multiples of a grid, so that shaders add them exactly.
    remainder: vec4<f32>,
    remainder_x: vec4<f32>,
    remainder_y: vec4<f32>,
    // Size of a sample's square at one metre ahead, 1 for parallel rays, weight of the sample, unused.
    footprint: vec4<f32>,
    // Width and height of the window, unused, whether colour is added to that of earlier passes.
    window: vec4<u32>,
    // Environment map: texels across, shifts of its colour and its range, whether it has ranges.
    environment: vec4<u32>,
    // First words of colour, range, ids and position in the output; NONE if not requested.
    outputs: vec4<u32>,
    // First words of normals, albedo, shading normals and coverage.
    more_outputs: vec4<u32>,
    // Visible segment of each ray: start, end, 1 if it is unbounded, and the number of planes.
    segment: vec4<f32>,
    // Clip half-spaces: visible points p, relative to the eye, have dot(xyz, p) + w >= 0.
    planes: array<vec4<f32>, 8>,
    // Parameters of the style and the cut.
    parameters: array<vec4<f32>, 4>,
    unused: array<vec4<f32>, 15>,
}

struct Record {
    x: vec4<f32>,
    y: vec4<f32>,
    z: vec4<f32>,
    part: vec4<u32>,
}

struct Part {
    positions: u32,
    faces: u32,
    uvs: u32,
    colors: u32,
    materials: u32,
    material: u32,
    page: u32,
    normals: u32,
}

struct Batch {
    // First record number in the frame, number of records, page, whether it writes first.
    records: vec4<u32>,
    // Shift of the scene's texels, number of the call's first record or of the batch's only one, unused.
    shifts: vec4<u32>,
    // The call's first record, and the part that all records of the call place.
    record: Record,
    part: Part,
}

struct Material {
    base_color: vec4<f32>,
    emission: vec3<f32>,
    unlit: u32,
    texture: u32,
    cutoff: f32,
    emission_texture: u32,
    unused: u32,
}

struct Texture {
    finest: u32,
    coarser: u32,
    coarser_cutout: u32,
    width: u32,
    height: u32,
    unused_0: u32,
    unused_1: u32,
    unused_2: u32,
}

const NONE: u32 = 0xffffffffu;

@group(0) @binding(0) var<storage, read> page: array<u32>;
@group(0) @binding(1) var<storage, read> records: array<Record>;
@group(0) @binding(2) var<storage, read> parts: array<Part>;
@group(0) @binding(3) var<storage, read> materials: array<Material>;
@group(0) @binding(4) var<storage, read> textures: array<Texture>;
@group(0) @binding(5) var texels: texture_2d_array<u32>;
@group(1) @binding(1) var<uniform> batch: Batch;

// Variant of the style.
override STYLE: u32 = 0u;
// Whether all faces belong to the batch's single record, so that no look-up is needed.
override ONE_RECORD: bool = false;

fn record_of(local: u32) -> Record {
    if ONE_RECORD {
        return batch.record;
    }
    return records[local];
}

fn part_of(record: Record) -> Part {
    if ONE_RECORD {
        return batch.part;
    }
    return parts[record.part.x];
}

// Returns column, row and layer of the nth texel, with 2^shift texels per row and 2^shift rows per layer.
fn texel_position(n: u32, shift: u32) -> vec3<i32> {
    let mask = (1u << shift) - 1u;
    return vec3<i32>(vec3<u32>(n & mask, (n >> shift) & mask, (n >> shift) >> shift));
}

fn corner_number(part: Part, face: u32, corner: u32) -> u32 {
    return page[part.faces + 3u * face + corner];
}

fn vector_at(word: u32) -> vec3<f32> {
    return vec3<f32>(bitcast<f32>(page[word]), bitcast<f32>(page[word + 1u]), bitcast<f32>(page[word + 2u]));
}

// Returns the position of a placed vertex relative to the eye.
fn position_from_eye(record: Record, part: Part, vertex: u32) -> vec3<f32> {
    let p = vector_at(part.positions + 3u * vertex);
    let turned = vec3<f32>(dot(record.x.xyz, p), dot(record.y.xyz, p), dot(record.z.xyz, p));
    // This order is precise for both kinds of instances: the translation of a placed mesh and the eye nearly cancel,
    // and a merged mesh has no translation, so that its vertex and the eye are subtracted directly.
    return turned + (vec3<f32>(record.x.w, record.y.w, record.z.w) - view.eye.xyz);
}

fn uv_of(part: Part, vertex: u32) -> vec2<f32> {
    let at = part.uvs + 2u * vertex;
    return vec2<f32>(bitcast<f32>(page[at]), bitcast<f32>(page[at + 1u]));
}

fn color_of(part: Part, vertex: u32) -> vec4<f32> {
    return unpack4x8unorm(page[part.colors + vertex]);
}

fn normal_of(part: Part, vertex: u32) -> vec3<f32> {
    return vector_at(part.normals + 3u * vertex);
}

fn material_of(part: Part, face: u32) -> Material {
    var number = part.material;
    if part.materials != NONE {
        number = page[part.materials + face];
    }
    // The last material is for faces without one.
    return materials[min(number, arrayLength(&materials) - 1u)];
}

// Returns whether a point relative to the eye passes the planes.
fn is_within_planes(p: vec3<f32>) -> bool {
    for (var i = 0u; i < u32(view.segment.w); i++) {
        if dot(view.planes[i].xyz, p) + view.planes[i].w < 0.0 {
            return false;
        }
    }
    return true;
}

// Returns the start of the visible segment of a ray from the eye, and 1 if it is unbounded.
fn visible_segment(direction: vec3<f32>) -> vec2<f32> {
    var start = view.segment.x;
    var is_unbounded = view.segment.z;
    for (var i = 0u; i < u32(view.segment.w); i++) {
        let slope = dot(view.planes[i].xyz, direction);
        if slope > 0.0 {
            start = max(start, -view.planes[i].w / slope);
        } else if slope < 0.0 || view.planes[i].w < 0.0 {
            is_unbounded = 0.0;
        }
    }
    return vec2<f32>(start, is_unbounded);
}
