// Discontinuity, Eq. 5-6 of Popescu, Lee, Choi, Fahmy (2022): points binned by their position in the truth, then all
// pairs of neighbours.

struct Settings {
    // Rows that map a point p, relative to the truth's eye, to its image position: dot(xyz, p) / depth + w, where depth
    // is dot(ahead.xyz, p), or 1 for parallel rays.
    x: vec4<f32>,
    y: vec4<f32>,
    // w: 1 for parallel rays.
    ahead: vec4<f32>,
    // The truth's eye as the sum of two numbers.
    eye_high: vec4<f32>,
    eye_low: vec4<f32>,
    // Square of epsilon, square of the minimum distance, 1 / side of a cell.
    limits: vec4<f32>,
    // Width, pixels, first word of positions, cells.
    size: vec4<u32>,
    // Cells across and down, beyond which cells wrap around; first point and number of points of this call.
    grid: vec4<u32>,
    // Slice of each cell that this call visits, first point and length: software drivers end loops after 65,535
    // iterations.
    slice: vec4<u32>,
}

@group(0) @binding(0) var<uniform> settings: Settings;
@group(0) @binding(1) var<storage, read> frame: array<u32>;
// First the shift from each pixel to its point's position in the truth; later the sum over the point's neighbours, and
// their number.
@group(0) @binding(2) var<storage, read_write> shifts: array<vec2<f32>>;
// Cell of each pixel's point, and the point's number in the cell: first in order of arrival, then in order of pixels.
@group(0) @binding(3) var<storage, read_write> cells: array<vec2<u32>>;
@group(0) @binding(4) var<storage, read_write> counts: array<atomic<u32>>;
// First entry of each cell, and the total.
@group(0) @binding(5) var<storage, read_write> starts: array<u32>;
// Pixels, cell by cell.
@group(0) @binding(6) var<storage, read_write> list: array<u32>;
// Pixel centre and shift, cell by cell, in order of pixels.
@group(0) @binding(7) var<storage, read_write> points: array<vec4<f32>>;
@group(0) @binding(8) var<storage, read_write> discontinuity: array<u32>;
// Maximum number of points in a cell.
@group(0) @binding(9) var<storage, read_write> max_count: array<u32>;

const NONE: u32 = 0xffffffffu;
// Distance in pixels beyond which points have no neighbours.
const MAX_DISTANCE: f32 = 1e7;

fn center_of(pixel: u32) -> vec2<f32> {
    return vec2<f32>(f32(pixel % settings.size.x), f32(pixel / settings.size.x)) + 0.5;
}

@compute @workgroup_size(GROUP)
fn discontinuity_bin(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let pixel = item_number(group, local);
    if pixel >= settings.size.y {
        return;
    }
    discontinuity[pixel] = NAN;
    cells[pixel] = vec2<u32>(NONE, 0u);
    let at = settings.size.z + 3u * pixel;
    let point = bitcast<vec3<f32>>(vec3<u32>(frame[at], frame[at + 1u], frame[at + 2u]));
    if !is_finite(point) {
        return;
    }
    let from_eye = (point - settings.eye_high.xyz) - settings.eye_low.xyz;
    let depth = dot(from_eye, settings.ahead.xyz);
    if depth <= 0.0 {
        return;
    }
    let divisor = select(depth, 1.0, settings.ahead.w > 0.0);
    let position = vec2<f32>(dot(from_eye, settings.x.xyz), dot(from_eye, settings.y.xyz)) / divisor
        + vec2<f32>(settings.x.w, settings.y.w);
    if !is_finite(vec3<f32>(position, 0.0)) || max(abs(position.x), abs(position.y)) >= MAX_DISTANCE {
        return;
    }
    shifts[pixel] = position - center_of(pixel);
    let cell = vec2<i32>(floor(position * settings.limits.z));
    let wrapped = wrap(cell.x, settings.grid.x) + settings.grid.x * wrap(cell.y, settings.grid.y);
    cells[pixel] = vec2<u32>(wrapped, atomicAdd(&counts[wrapped], 1u));
}

// Remainder that is not negative; in OpenGL the operator % is undefined for negative numbers.
fn wrap(i: i32, length: u32) -> u32 {
    return select(u32(i) % length, length - 1u - u32(-1 - i) % length, i < 0);
}

// Sum and maximum of each thread's counts.
var<workgroup> sums: array<u32, GROUP>;
var<workgroup> maxima: array<u32, GROUP>;

// Computes where each cell's points begin: one workgroup, in which each thread sums a run of cells.
@compute @workgroup_size(GROUP)
fn discontinuity_add_counts(@builtin(local_invocation_index) local: u32) {
    let run = (settings.size.w + GROUP - 1u) / GROUP;
    let first = min(local * run, settings.size.w);
    let last = min(first + run, settings.size.w);
    var sum = 0u;
    var max_here = 0u;
    for (var cell = first; cell < last; cell++) {
        let count = atomicLoad(&counts[cell]);
        sum += count;
        max_here = max(max_here, count);
    }
    sums[local] = sum;
    maxima[local] = max_here;
    workgroupBarrier();
    if local == 0u {
        var before = 0u;
        for (var i = 0u; i < GROUP; i++) {
            let count = sums[i];
            sums[i] = before;
            before += count;
            max_here = max(max_here, maxima[i]);
        }
        max_count[0] = max_here;
        starts[settings.size.w] = before;
    }
    workgroupBarrier();
    var start = sums[local];
    for (var cell = first; cell < last; cell++) {
        starts[cell] = start;
        start += atomicLoad(&counts[cell]);
    }
}

@compute @workgroup_size(GROUP)
fn discontinuity_scatter(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let pixel = item_number(group, local);
    if pixel < settings.size.y && cells[pixel].x != NONE {
        list[starts[cells[pixel].x] + cells[pixel].y] = pixel;
    }
}

// Points arrive in their cell in random order. Sorting them by pixel makes the order, and so the sums, deterministic.
@compute @workgroup_size(GROUP)
fn discontinuity_order(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let number = item_number(group, local);
    if number >= starts[settings.size.w] {
        return;
    }
    let pixel = list[number];
    let cell = cells[pixel].x;
    var before = select(cells[pixel].y, 0u, settings.slice.x == 0u);
    let slice = slice_of(cell);
    for (var other = slice.x; other < slice.y; other++) {
        before += select(0u, 1u, list[other] < pixel);
    }
    cells[pixel].y = before;
}

// Returns the first point of a cell's slice and its end.
fn slice_of(cell: u32) -> vec2<u32> {
    let end = starts[cell + 1u];
    let first = min(starts[cell] + settings.slice.x, end);
    return vec2<u32>(first, min(first + settings.slice.y, end));
}

@compute @workgroup_size(GROUP)
fn discontinuity_gather(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let pixel = item_number(group, local);
    if pixel < settings.size.y && cells[pixel].x != NONE {
        points[starts[cells[pixel].x] + cells[pixel].y] = vec4<f32>(center_of(pixel), shifts[pixel]);
    }
}

@compute @workgroup_size(GROUP)
fn discontinuity_sum(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    let number = item_number(group, local);
    if number >= settings.grid.w || settings.grid.z + number >= starts[settings.size.w] {
        return;
    }
    let point_number = settings.grid.z + number;
    let point = points[point_number];
    let pixel = u32(point.y) * settings.size.x + u32(point.x);
    let cell = vec2<u32>(cells[pixel].x % settings.grid.x, cells[pixel].x / settings.grid.x);
    var sum_and_count = vec2<f32>(0.0);
    if settings.slice.x > 0u {
        sum_and_count = shifts[pixel];
    }
    for (var i = 0u; i < 9u; i++) {
        // Neighbouring cells wrap around the grid's end.
        let neighbour = (cell + settings.grid.xy - 1u + vec2<u32>(i % 3u, i / 3u)) % settings.grid.xy;
        let slice = slice_of(neighbour.x + settings.grid.x * neighbour.y);
        // Summed cell by cell, so that long sums lose little precision.
        var cell_sum = vec2<f32>(0.0);
        for (var other = slice.x; other < slice.y; other++) {
            let other_point = points[other];
            let in_frame = other_point.xy - point.xy;
            let in_truth = in_frame + (other_point.zw - point.zw);
            let frame_squared = dot(in_frame, in_frame);
            let truth_squared = dot(in_truth, in_truth);
            if truth_squared < settings.limits.x && other != point_number {
                cell_sum += vec2<f32>(sqrt(frame_squared / max(truth_squared, settings.limits.y)) - 1.0, 1.0);
            }
        }
        sum_and_count += cell_sum;
    }
    shifts[pixel] = sum_and_count;
    if sum_and_count.y > 0.0 {
        discontinuity[pixel] = bitcast<u32>(sum_and_count.x / sum_and_count.y);
    }
}
