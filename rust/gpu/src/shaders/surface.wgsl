// Base colours and emission, filtered as in `scene::Texture`, and the common shading formula.

// Whether the scene has textures, vertex colours and vertex normals; whether some material emits light or is unlit.
override TEXTURED: bool = true;
override COLORED: bool = true;
override SMOOTH: bool = true;
override GLOWING: bool = true;

fn texel_color(n: u32) -> vec4<f32> {
    let at = texel_position(n, batch.shifts.x);
    return vec4<f32>(textureLoad(texels, at.xy, at.z, 0)) * (1.0 / 65535.0);
}

// Returns a coordinate's place in the image, from 0 to 1; see `scene::Sampler`.
fn place_in_image(coordinate: f32, wrap: u32) -> f32 {
    if wrap == 2u {
        return clamp(coordinate, 0.0, 1.0);
    }
    if wrap == 1u {
        let within_pair = coordinate - 2.0 * floor(coordinate * 0.5);
        return select(within_pair, 2.0 - within_pair, within_pair > 1.0);
    }
    return coordinate - floor(coordinate);
}

// Returns the two texels whose centres enclose a coordinate, given `count` per period of 1, and the second one's
// weight; with `nearest`, twice the texel that contains the coordinate.
fn neighbours(coordinate: f32, count: u32, wrap: u32, nearest: bool) -> vec3<f32> {
    let place = place_in_image(coordinate, wrap) * f32(count);
    let last = f32(count - 1u);
    if nearest {
        let texel = min(floor(place), last);
        return vec3<f32>(texel, texel, 0.0);
    }
    let x = place - 0.5;
    let low = floor(x);
    let before = select(0.0, last, wrap == 0u);
    let after = select(last, 0.0, wrap == 0u);
    let first = select(min(low, last), before, low < 0.0);
    let second = select(select(first + 1.0, after, first == last), 0.0, low < 0.0);
    return vec3<f32>(first, second, x - low);
}

// Samples level 0 with the texture's filter; v upwards.
fn magnified(texture: Texture, uv: vec2<f32>) -> vec4<f32> {
    return sample_level(texture, texture.finest, vec2<u32>(texture.width, texture.height), uv, texture.nearest == 1u);
}

// Samples a level of `size` texels from `first` on; v upwards.
fn sample_level(texture: Texture, first: u32, size: vec2<u32>, uv: vec2<f32>, nearest: bool) -> vec4<f32> {
    let column = neighbours(uv.x, size.x, texture.wrap_u, nearest);
    let row = neighbours(1.0 - uv.y, size.y, texture.wrap_v, nearest);
    let columns = vec2<u32>(column.xy);
    let rows = first + vec2<u32>(row.xy) * size.x;
    let upper = mix(texel_color(rows.x + columns.x), texel_color(rows.x + columns.y), column.z);
    let lower = mix(texel_color(rows.y + columns.x), texel_color(rows.y + columns.y), column.z);
    return mix(upper, lower, row.z);
}

fn texture_at_level(texture: Texture, uv: vec2<f32>, level: u32, cutout: bool) -> vec3<f32> {
    if level == 0u {
        return sample_level(texture, texture.finest, vec2<u32>(texture.width, texture.height), uv, false).rgb;
    }
    var first = select(texture.coarser, texture.coarser_cutout, cutout);
    var width = max(texture.width / 2u, 1u);
    var height = max(texture.height / 2u, 1u);
    for (var i = 1u; i < level; i++) {
        first += width * height;
        width = max(width / 2u, 1u);
        height = max(height / 2u, 1u);
    }
    return sample_level(texture, first, vec2<u32>(width, height), uv, false).rgb;
}

fn texture_color(texture: Texture, uv: vec2<f32>, wanted: f32, cutout: bool) -> vec3<f32> {
    let last = firstLeadingBit(max(texture.width, texture.height));
    if wanted <= 0.0 {
        return magnified(texture, uv).rgb;
    }
    let level = min(wanted, f32(last));
    let fine = u32(floor(level));
    let between = level - floor(level);
    let color = texture_at_level(texture, uv, fine, cutout);
    if between == 0.0 {
        return color;
    }
    return mix(color, texture_at_level(texture, uv, fine + 1u, cutout), between);
}

fn blend_2(a: vec2<f32>, b: vec2<f32>, c: vec2<f32>, at: vec2<f32>) -> vec2<f32> {
    return a + (b - a) * at.x + (c - a) * at.y;
}

fn blend_3(a: vec3<f32>, b: vec3<f32>, c: vec3<f32>, at: vec2<f32>) -> vec3<f32> {
    return a + (b - a) * at.x + (c - a) * at.y;
}

// A spot on a face: weights of its second and third corner, width of the ray on it, and twice its area.
struct Spot {
    face: u32,
    at: vec2<f32>,
    footprint: f32,
    doubled_area: f32,
}

fn corners_of(part: Part, face: u32) -> vec3<u32> {
    return vec3<u32>(corner_number(part, face, 0u), corner_number(part, face, 1u), corner_number(part, face, 2u));
}

// Returns the linear colour of a texture; white without texture or texture coordinates.
fn texture_at(part: Part, number: u32, spot: Spot, cutout: bool) -> vec3<f32> {
    if !TEXTURED || number == NONE || part.uvs == NONE {
        return vec3<f32>(1.0);
    }
    let texture = textures[number];
    let corners = corners_of(part, spot.face);
    let a = uv_of(part, corners.x);
    let b = uv_of(part, corners.y);
    let c = uv_of(part, corners.z);
    let ab = b - a;
    let ac = c - a;
    let area = abs(ab.x * ac.y - ab.y * ac.x) * f32(texture.width) * f32(texture.height);
    let level = log2(max(spot.footprint * sqrt(area / spot.doubled_area), 1e-30));
    return texture_color(texture, blend_2(a, b, c, spot.at), level, cutout);
}

// Returns the linear base colour.
fn albedo(part: Part, material: Material, spot: Spot) -> vec3<f32> {
    var color = material.base_color.rgb;
    if COLORED && part.colors != NONE {
        let corners = corners_of(part, spot.face);
        let a = linear_from_srgb(color_of(part, corners.x).rgb);
        let b = linear_from_srgb(color_of(part, corners.y).rgb);
        let c = linear_from_srgb(color_of(part, corners.z).rgb);
        color *= blend_3(a, b, c, spot.at);
    }
    return color * texture_at(part, material.texture, spot, material.cutoff >= 0.0);
}

// Normalises a vector; zero stays zero.
fn normalize_or_zero(v: vec3<f32>) -> vec3<f32> {
    let length_squared = dot(v, v);
    return select(vec3<f32>(0.0), v * inverseSqrt(length_squared), length_squared > 0.0);
}

// Returns the shading normal at weights `at` of a face whose own normal, towards the viewer, is `normal`. Corner
// normals are transformed by the cofactors of the instance's matrix and flipped to the face's side; see
// `scene::facing_normals`.
fn shading_normal(record: Record, part: Part, face: u32, at: vec2<f32>, normal: vec3<f32>) -> vec3<f32> {
    if !SMOOTH || part.normals == NONE {
        return normal;
    }
    let sizes = max(max(abs(record.x.xyz), abs(record.y.xyz)), abs(record.z.xyz));
    let scale = 1.0 / max(max(sizes.x, sizes.y), max(sizes.z, 1e-30));
    let x = record.x.xyz * scale;
    let y = record.y.xyz * scale;
    let z = record.z.xyz * scale;
    let cofactors = transpose(mat3x3<f32>(cross(y, z), cross(z, x), cross(x, y)));
    var a = normalize_or_zero(cofactors * normal_of(part, corner_number(part, face, 0u)));
    var b = normalize_or_zero(cofactors * normal_of(part, corner_number(part, face, 1u)));
    var c = normalize_or_zero(cofactors * normal_of(part, corner_number(part, face, 2u)));
    let sum = a + b + c;
    if all(sum == vec3<f32>(0.0)) {
        return normal;
    }
    let side = select(1.0, -1.0, dot(sum, normal) < 0.0);
    a = select(a * side, normal, all(a == vec3<f32>(0.0)));
    b = select(b * side, normal, all(b == vec3<f32>(0.0)));
    c = select(c * side, normal, all(c == vec3<f32>(0.0)));
    let between = normalize_or_zero(blend_3(a, b, c, at));
    return select(between, normal, all(between == vec3<f32>(0.0)));
}
