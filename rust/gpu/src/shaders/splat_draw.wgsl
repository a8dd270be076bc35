// Draws pieces of views: one workgroup per piece, one thread per pixel of a block.

@group(0) @binding(6) var<storage, read_write> pieces: array<Piece>;
// Number of splats of drawn pieces, then the farthest order of each tile.
@group(0) @binding(7) var<storage, read_write> tiles: array<atomic<u32>>;

const DRAWN: u32 = 0x80000000u;

var<workgroup> is_visible: atomic<u32>;

// Returns the first tile and the number of tiles that a piece may cover, along both axes.
fn tiles_of(piece: Piece) -> vec4<u32> {
    let rows = vec2<i32>(i32(draw.size.z), i32(draw.size.z + draw.size.y));
    let low = vec2<i32>(piece.low.x, max(piece.low.y, rows.x) - rows.x);
    let high = vec2<i32>(piece.high.x, min(piece.high.y, rows.y) - rows.x);
    if high.y <= low.y || high.x <= low.x {
        return vec4<u32>(0u);
    }
    let first = vec2<u32>(low) / TILE;
    return vec4<u32>(first, (vec2<u32>(high) + TILE - 1u) / TILE - first);
}

struct Ellipse {
    position: vec2<f32>,
    // Inverse axes, row by row.
    inverse: vec4<f32>,
    nearness: f32,
    slope: vec2<f32>,
    low: vec2<i32>,
    high: vec2<i32>,
    middle: vec2<i32>,
}

// Returns the derivative of a position X/W, given the changes of X and W.
fn position_derivative(x_change: f32, w_change: f32, position: f32, inverse_w: f32) -> f32 {
    if PARALLEL == 1u {
        return x_change;
    }
    return (x_change - position * w_change) * inverse_w;
}

// Returns the derivative of nearness, given the change of W.
fn nearness_derivative(w_change: f32, inverse_w: f32) -> f32 {
    if PARALLEL == 1u {
        return -w_change;
    }
    return -w_change * inverse_w * inverse_w;
}

// Returns the half extent of a ball along an axis: the length of the gradient of X/W.
fn ball_extent(x_gradient: vec3<f32>, w_gradient: vec3<f32>, position: f32, inverse_w: f32) -> f32 {
    return length(vec3<f32>(
        position_derivative(x_gradient.x, w_gradient.x, position, inverse_w),
        position_derivative(x_gradient.y, w_gradient.y, position, inverse_w),
        position_derivative(x_gradient.z, w_gradient.z, position, inverse_w),
    ));
}

// Projects a splat, by the formulas of `orthoview::splat::lanes`.
fn project_splat(view: View, start: vec3<f32>, at: vec2<f32>, splat: Splat) -> Ellipse {
    let along = start + at.x * view.steps[0].xyz + at.y * view.steps[1].xyz + f32(splat.depth) * view.steps[2].xyz;
    let w = along.z;
    let inverse_w = select(1.0 / w, 1.0, PARALLEL == 1u);
    let x = along.x * inverse_w;
    let y = along.y * inverse_w;
    let n = normal_of(splat.normal, view.rest.x);
    let facing = 1.0 / max(dot(view.axes[2].xyz, n), MIN_COSINE * length(n));
    let depth_per_column = dot(view.axes[0].xyz, n) * facing;
    let depth_per_row = -dot(view.axes[1].xyz, n) * facing;
    let factor = select(select(BORDER, 1.0, splat.kind == INNER), 0.0, splat.kind == 0u);
    let is_surfel = splat.kind != 0u;
    let u = view.steps[0].xyz + depth_per_column * view.steps[2].xyz;
    let v = view.steps[1].xyz + depth_per_row * view.steps[2].xyz;
    let ux = position_derivative(u.x, u.z, x, inverse_w) * factor;
    let vx = position_derivative(v.x, v.z, x, inverse_w) * factor;
    let uy = position_derivative(u.y, u.z, y, inverse_w) * factor;
    let vy = position_derivative(v.y, v.z, y, inverse_w) * factor;
    let determinant = ux * vy - vx * uy;
    let gradient = view.gradients[2].xyz;
    let ball_width = ball_extent(view.gradients[0].xyz, gradient, x, inverse_w);
    let ball = vec2<f32>(ball_width, ball_extent(view.gradients[1].xyz, gradient, y, inverse_w));
    let is_flat = abs(determinant) <= EPSILON * (abs(ux) + abs(vx)) * (abs(uy) + abs(vy));
    let edge = select(1.0 / determinant, MAX, is_flat);
    var ellipse: Ellipse;
    ellipse.position = vec2<f32>(x, y);
    if is_surfel {
        ellipse.inverse = vec4<f32>(vy, -vx, -uy, ux) * edge;
    } else {
        ellipse.inverse = vec4<f32>(1.0 / ball.x, 0.0, 0.0, 1.0 / ball.y);
    }
    if is_surfel && !is_flat {
        let near = vec2<f32>(nearness_derivative(u.z, inverse_w), nearness_derivative(v.z, inverse_w)) * factor;
        ellipse.slope = vec2<f32>(
            near.x * ellipse.inverse.x + near.y * ellipse.inverse.z,
            near.x * ellipse.inverse.y + near.y * ellipse.inverse.w,
        );
    }
    ellipse.nearness = select(inverse_w, -w, PARALLEL == 1u);
    let radius = sqrt(SQUARED_RADIUS);
    var half_extent = ball * radius;
    if is_surfel {
        half_extent = vec2<f32>(length(vec2<f32>(ux, vx)), length(vec2<f32>(uy, vy))) * select(radius, 0.0, is_flat);
    }
    let middle = floor(ellipse.position);
    let bottom = f32(draw.size.z);
    let first_sample = vec2<f32>(0.0, bottom);
    let last_sample = vec2<f32>(f32(draw.size.x), bottom + f32(draw.size.y)) - 1.0;
    ellipse.low = vec2<i32>(max(min(ceil(ellipse.position - half_extent - 0.5), middle), first_sample));
    ellipse.high = vec2<i32>(min(max(floor(ellipse.position + half_extent - 0.5), middle), last_sample));
    ellipse.middle = vec2<i32>(middle);
    let depth = radius * factor * length(vec2<f32>(u.z, v.z));
    let nearest = select(w - depth, w, PARALLEL == 1u);
    if !(nearest >= view.rest.y) || !is_seen(ellipse.position, w) {
        ellipse.low.x = 1;
        ellipse.high.x = 0;
    }
    return ellipse;
}

// Returns whether a point at an image position and a distance along the axis lies within the limits.
fn is_seen(position: vec2<f32>, w: f32) -> bool {
    if draw.limits.y == 0u {
        return true;
    }
    let start = draw.start[0].xyz + draw.start[1].xyz * position.x + draw.start[2].xyz * position.y;
    let direction = draw.direction[0].xyz + draw.direction[1].xyz * position.x + draw.direction[2].xyz * position.y;
    let point = start + direction * w;
    let range = select(length(point), w, PARALLEL == 1u);
    var seen = range >= draw.segment.x && range <= draw.segment.y;
    for (var n = 0u; n < draw.limits.x; n++) {
        seen = seen && dot(draw.planes[n].xyz, point) + draw.planes[n].w >= 0.0;
    }
    return seen;
}

fn draw_splat(view: View, piece: Piece, block: u32, lane: u32) {
    let head = head_of(view.place, block);
    if !is_shown(head, lane) {
        return;
    }
    let at = vec2<f32>(vec2<i32>(head.corner + vec2<u32>(lane % BLOCK, lane / BLOCK)) - vec2<i32>(piece.corner));
    let ellipse = project_splat(view, piece.start, at, splat_of(view.place.y, head, lane));
    let number = ~(((view.place.x + block) << LANE_BITS) | lane);
    let low = max(ellipse.low, piece.low);
    let high = min(ellipse.high, piece.high - 1);
    for (var row = low.y; row <= high.y; row++) {
        let dy = f32(row) + 0.5 - ellipse.position.y;
        for (var column = low.x; column <= high.x; column++) {
            let dx = f32(column) + 0.5 - ellipse.position.x;
            let p = ellipse.inverse.x * dx + ellipse.inverse.y * dy;
            let q = ellipse.inverse.z * dx + ellipse.inverse.w * dy;
            let is_inside = p * p + q * q <= SQUARED_RADIUS;
            if is_inside || (row == ellipse.middle.y && column == ellipse.middle.x) {
                let rise = ellipse.slope.x * dx + ellipse.slope.y * dy;
                let nearness = select(ellipse.nearness, ellipse.nearness + rise, is_inside);
                let sample = (u32(row) - draw.size.z) * draw.size.x + u32(column);
                update_key(sample, order_from_bits(bitcast<u32>(nearness)), number);
            }
        }
    }
}

@compute @workgroup_size(64)
fn splat_draw(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let number = group.y * ROW + group.x;
    if number >= draw.work.y {
        return;
    }
    let piece_number = draw.work.x + number;
    let piece = pieces[piece_number];
    if lane == 0u {
        atomicStore(&is_visible, 0u);
    }
    workgroupBarrier();
    let covered = tiles_of(piece);
    for (var n = lane; n < covered.z * covered.w; n += 64u) {
        let tile = (covered.y + n / covered.z) * tile_columns() + covered.x + n % covered.z;
        if atomicLoad(&tiles[1u + tile]) <= piece.nearness_bits {
            atomicStore(&is_visible, 1u);
        }
    }
    workgroupBarrier();
    if atomicLoad(&is_visible) == 0u {
        return;
    }
    if lane == 0u && (piece.blocks & DRAWN) == 0u {
        pieces[piece_number].blocks = piece.blocks | DRAWN;
        atomicAdd(&tiles[0], piece.count);
    }
    let view = views[piece.view];
    let first = piece.blocks & 0xffffffu;
    for (var n = 0u; n < ((piece.blocks >> 24u) & 31u); n++) {
        draw_splat(view, piece, first + n, lane);
    }
}
