// Draws pieces of views: one workgroup per piece, one thread per pixel of a block.

@group(0) @binding(6) var<storage, read_write> pieces: array<Piece>;
// Number of splats of drawn pieces, then the farthest order of each tile.
@group(0) @binding(7) var<storage, read_write> tiles: array<atomic<u32>>;

const DRAWN: u32 = 0x80000000u;

var<workgroup> reached: atomic<u32>;

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
    place: vec2<f32>,
    // Inverse axes, row by row.
    inverse: vec4<f32>,
    nearness: f32,
    slope: vec2<f32>,
    low: vec2<i32>,
    high: vec2<i32>,
    middle: vec2<i32>,
}

// Returns the derivative of a position X/W, given the changes of X and W.
fn position_derivative(change: f32, of_distance: f32, place: f32, over: f32) -> f32 {
    if PARALLEL == 1u {
        return change;
    }
    return (change - place * of_distance) * over;
}

// Returns the derivative of nearness, given the change of W.
fn nearer(of_distance: f32, over: f32) -> f32 {
    if PARALLEL == 1u {
        return -of_distance;
    }
    return -of_distance * over * over;
}

// Returns the half extent of a ball along an axis: the length of the gradient of X/W.
fn disc(own: vec3<f32>, distance: vec3<f32>, place: f32, over: f32) -> f32 {
    return length(vec3<f32>(
        position_derivative(own.x, distance.x, place, over),
        position_derivative(own.y, distance.y, place, over),
        position_derivative(own.z, distance.z, place, over),
    ));
}

// Projects a splat, by the formulas of `orthoview::splat::lanes`.
fn projected(view: View, start: vec3<f32>, at: vec2<f32>, splat: Splat) -> Ellipse {
    let along = start + at.x * view.steps[0].xyz + at.y * view.steps[1].xyz + f32(splat.depth) * view.steps[2].xyz;
    let w = along.z;
    let over = select(1.0 / w, 1.0, PARALLEL == 1u);
    let x = along.x * over;
    let y = along.y * over;
    let n = normal_of(splat.normal, view.rest.x);
    let facing = 1.0 / max(dot(view.axes[2].xyz, n), MIN_COSINE * length(n));
    let by_column = dot(view.axes[0].xyz, n) * facing;
    let by_row = -dot(view.axes[1].xyz, n) * facing;
    let factor = select(select(BORDER, 1.0, splat.kind == INNER), 0.0, splat.kind == 0u);
    let is_surfel = splat.kind != 0u;
    let u = view.steps[0].xyz + by_column * view.steps[2].xyz;
    let v = view.steps[1].xyz + by_row * view.steps[2].xyz;
    let ux = position_derivative(u.x, u.z, x, over) * factor;
    let vx = position_derivative(v.x, v.z, x, over) * factor;
    let uy = position_derivative(u.y, u.z, y, over) * factor;
    let vy = position_derivative(v.y, v.z, y, over) * factor;
    let determinant = ux * vy - vx * uy;
    let gradient = view.gradients[2].xyz;
    let ball = vec2<f32>(disc(view.gradients[0].xyz, gradient, x, over), disc(view.gradients[1].xyz, gradient, y, over));
    let is_flat = abs(determinant) <= EPSILON * (abs(ux) + abs(vx)) * (abs(uy) + abs(vy));
    let edge = select(1.0 / determinant, MAX, is_flat);
    var found: Ellipse;
    found.place = vec2<f32>(x, y);
    if is_surfel {
        found.inverse = vec4<f32>(vy, -vx, -uy, ux) * edge;
    } else {
        found.inverse = vec4<f32>(1.0 / ball.x, 0.0, 0.0, 1.0 / ball.y);
    }
    if is_surfel && !is_flat {
        let near = vec2<f32>(nearer(u.z, over), nearer(v.z, over)) * factor;
        found.slope = vec2<f32>(
            near.x * found.inverse.x + near.y * found.inverse.z,
            near.x * found.inverse.y + near.y * found.inverse.w,
        );
    }
    found.nearness = select(over, -w, PARALLEL == 1u);
    let radius = sqrt(SQUARED_RADIUS);
    var half_extent = ball * radius;
    if is_surfel {
        half_extent = vec2<f32>(length(vec2<f32>(ux, vx)), length(vec2<f32>(uy, vy))) * select(radius, 0.0, is_flat);
    }
    let middle = floor(found.place);
    let bottom = f32(draw.size.z);
    let least = vec2<f32>(0.0, bottom);
    let most = vec2<f32>(f32(draw.size.x), bottom + f32(draw.size.y)) - 1.0;
    found.low = vec2<i32>(max(min(ceil(found.place - half_extent - 0.5), middle), least));
    found.high = vec2<i32>(min(max(floor(found.place + half_extent - 0.5), middle), most));
    found.middle = vec2<i32>(middle);
    let depth = radius * factor * length(vec2<f32>(u.z, v.z));
    let nearest = select(w - depth, w, PARALLEL == 1u);
    if !(nearest >= view.rest.y) || !is_seen(found.place, w) {
        found.low.x = 1;
        found.high.x = 0;
    }
    return found;
}

// Returns whether a point at an image position and a distance along the axis lies within the limits.
fn is_seen(place: vec2<f32>, w: f32) -> bool {
    if draw.limits.y == 0u {
        return true;
    }
    let start = draw.start[0].xyz + draw.start[1].xyz * place.x + draw.start[2].xyz * place.y;
    let direction = draw.direction[0].xyz + draw.direction[1].xyz * place.x + draw.direction[2].xyz * place.y;
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
    let own = projected(view, piece.start, at, splat_of(view.place.y, head, lane));
    let number = ~(((view.place.x + block) << LANE_BITS) | lane);
    let low = max(own.low, piece.low);
    let high = min(own.high, piece.high - 1);
    for (var row = low.y; row <= high.y; row++) {
        let down = f32(row) + 0.5 - own.place.y;
        for (var column = low.x; column <= high.x; column++) {
            let across = f32(column) + 0.5 - own.place.x;
            let p = own.inverse.x * across + own.inverse.y * down;
            let q = own.inverse.z * across + own.inverse.w * down;
            let is_inside = p * p + q * q <= SQUARED_RADIUS;
            if is_inside || (row == own.middle.y && column == own.middle.x) {
                let rise = own.slope.x * across + own.slope.y * down;
                let nearness = select(own.nearness, own.nearness + rise, is_inside);
                raise((u32(row) - draw.size.z) * draw.size.x + u32(column), ordered(bitcast<u32>(nearness)), number);
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
    let own = draw.work.x + number;
    let piece = pieces[own];
    if lane == 0u {
        atomicStore(&reached, 0u);
    }
    workgroupBarrier();
    let around = tiles_of(piece);
    for (var n = lane; n < around.z * around.w; n += 64u) {
        let tile = (around.y + n / around.z) * tile_columns() + around.x + n % around.z;
        if atomicLoad(&tiles[1u + tile]) <= piece.order {
            atomicStore(&reached, 1u);
        }
    }
    workgroupBarrier();
    if atomicLoad(&reached) == 0u {
        return;
    }
    if lane == 0u && (piece.blocks & DRAWN) == 0u {
        pieces[own].blocks = piece.blocks | DRAWN;
        atomicAdd(&tiles[0], piece.count);
    }
    let view = views[piece.view];
    let first = piece.blocks & 0xffffffu;
    for (var n = 0u; n < ((piece.blocks >> 24u) & 31u); n++) {
        draw_splat(view, piece, first + n, lane);
    }
}
