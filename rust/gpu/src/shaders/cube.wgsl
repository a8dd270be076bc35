// Seamless look-ups in the environment map, by the formulas of `cubemap::Taps`.

@group(1) @binding(2) var map_color: texture_2d_array<f32>;
@group(1) @binding(3) var map_range: texture_2d_array<f32>;

struct Taps {
    texel: vec4<u32>,
    weight: vec4<f32>,
}

// Returns the face, and the position on it from -1 to 1 to the right and down.
fn face_of(d: vec3<f32>) -> vec3<f32> {
    let size = abs(d);
    if size.x >= size.y && size.x >= size.z {
        let s = select(1.0, -1.0, d.x < 0.0);
        return vec3<f32>(select(0.0, 1.0, d.x < 0.0), vec2<f32>(-s * d.z, -d.y) / size.x);
    }
    if size.y >= size.z {
        let s = select(1.0, -1.0, d.y < 0.0);
        return vec3<f32>(select(2.0, 3.0, d.y < 0.0), vec2<f32>(d.x, s * d.z) / size.y);
    }
    let s = select(1.0, -1.0, d.z < 0.0);
    return vec3<f32>(select(4.0, 5.0, d.z < 0.0), vec2<f32>(s * d.x, -d.y) / size.z);
}

fn texel_number(d: vec3<f32>, size: u32) -> u32 {
    let at = face_of(d);
    let last = f32(size - 1u);
    let place = vec2<u32>(clamp(floor((at.yz + 1.0) * 0.5 * f32(size)), vec2<f32>(0.0), vec2<f32>(last)));
    return (u32(at.x) * size + place.y) * size + place.x;
}

// Returns the texel whose centre lies at or below a position, and the fraction of the way to the next one.
fn texel_below(place: f32, size: u32) -> vec2<f32> {
    let x = max((place + 1.0) * 0.5 * f32(size) - 0.5, 0.0);
    let index = min(floor(x), f32(size - 1u));
    return vec2<f32>(index, select(0.0, x - index, index + 1.0 < f32(size)));
}

fn taps_of(d: vec3<f32>, size: u32) -> Taps {
    let at = face_of(d);
    let half = 1.0 / f32(size);
    if max(abs(at.y), abs(at.z)) > 1.0 - half {
        return taps_at_seam(d, size);
    }
    let column = texel_below(at.y, size);
    let row = texel_below(at.z, size);
    let first = (u32(at.x) * size + u32(row.x)) * size + u32(column.x);
    let right = select(0u, 1u, u32(column.x) + 1u < size);
    let down = select(0u, size, u32(row.x) + 1u < size);
    let s = column.y;
    let t = row.y;
    return Taps(
        vec4<u32>(first, first + right, first + down, first + down + right),
        vec4<f32>((1.0 - s) * (1.0 - t), s * (1.0 - t), (1.0 - s) * t, s * t),
    );
}

// Returns the axes from the largest component to the smallest, in alphabetical order for ties.
fn axes_by_size(size: vec3<f32>) -> vec3<u32> {
    var axes = vec3<u32>(0u, 1u, 2u);
    if size[axes.x] < size[axes.y] {
        axes = axes.yxz;
    }
    if size[axes.y] < size[axes.z] {
        axes = axes.xzy;
    }
    if size[axes.x] < size[axes.y] {
        axes = axes.yxz;
    }
    return axes;
}

// Returns the texel of the point that has these components along the axes and lies in the octant of d.
fn texel_along(d: vec3<f32>, axes: vec3<u32>, components: vec3<f32>, size: u32) -> u32 {
    var p = vec3<f32>(0.0);
    p[axes.x] = select(components.x, -components.x, d[axes.x] < 0.0);
    p[axes.y] = select(components.y, -components.y, d[axes.y] < 0.0);
    p[axes.z] = select(components.z, -components.z, d[axes.z] < 0.0);
    return texel_number(p, size);
}

fn center_of(index: f32, size: u32) -> f32 {
    return (index + 0.5) * 2.0 / f32(size) - 1.0;
}

fn taps_at_seam(d: vec3<f32>, size: u32) -> Taps {
    let axes = axes_by_size(abs(d));
    let components = vec3<f32>(abs(d[axes.x]), abs(d[axes.y]), abs(d[axes.z])) / abs(d[axes.x]);
    let half = 1.0 / f32(size);
    let row = 1.0 - half;
    let s = (components.y - row) / (half * (1.0 + components.y));
    let along = components.z * (1.0 - s * half);
    if along <= row {
        let at = texel_below(along, size);
        let low = center_of(at.x, size);
        let high = center_of(min(at.x + 1.0, f32(size - 1u)), size);
        return Taps(
            vec4<u32>(
                texel_along(d, axes, vec3<f32>(1.0, row, low), size),
                texel_along(d, axes, vec3<f32>(1.0, row, high), size),
                texel_along(d, axes, vec3<f32>(row, 1.0, low), size),
                texel_along(d, axes, vec3<f32>(row, 1.0, high), size),
            ),
            vec4<f32>((1.0 - s) * (1.0 - at.y), (1.0 - s) * at.y, s * (1.0 - at.y), s * at.y),
        );
    }
    let sum = (components.x + components.y + components.z) / (1.0 + 2.0 * row);
    let weight = max((components / sum - vec3<f32>(row)) / half, vec3<f32>(0.0));
    let total = weight.x + weight.y + weight.z;
    let first = texel_along(d, axes, vec3<f32>(1.0, row, row), size);
    return Taps(
        vec4<u32>(
            first,
            texel_along(d, axes, vec3<f32>(row, 1.0, row), size),
            texel_along(d, axes, vec3<f32>(row, row, 1.0), size),
            first,
        ),
        vec4<f32>(weight / total, 0.0),
    );
}

fn map_color_of(texel: u32) -> vec3<f32> {
    let at = texel_position(texel, view.environment.y);
    return textureLoad(map_color, at.xy, at.z, 0).rgb;
}

fn map_range_of(texel: u32) -> f32 {
    let at = texel_position(texel, view.environment.z);
    return textureLoad(map_range, at.xy, at.z, 0).r;
}

// Returns the linear RGB of the map along a direction.
fn environment_color(d: vec3<f32>) -> vec3<f32> {
    let taps = taps_of(d, view.environment.x);
    return taps.weight.x * map_color_of(taps.texel.x) + taps.weight.y * map_color_of(taps.texel.y)
        + taps.weight.z * map_color_of(taps.texel.z) + taps.weight.w * map_color_of(taps.texel.w);
}
