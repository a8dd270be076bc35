// Computes the farthest order of each tile of samples, behind which pieces are culled.

@group(0) @binding(7) var<storage, read_write> tiles: array<u32>;
@group(0) @binding(8) var<storage, read> keys: array<u32>;

var<workgroup> farthest: atomic<u32>;

@compute @workgroup_size(64)
fn splat_tiles(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let number = group.y * ROW + group.x;
    let rows = (draw.size.y + TILE - 1u) / TILE;
    if number >= tile_columns() * rows {
        return;
    }
    if lane == 0u {
        atomicStore(&farthest, NONE);
    }
    workgroupBarrier();
    let first = vec2<u32>(number % tile_columns(), number / tile_columns()) * TILE;
    var least = NONE;
    for (var n = lane; n < TILE * TILE; n += 64u) {
        let at = first + vec2<u32>(n % TILE, n / TILE);
        if all(at < draw.size.xy) {
            least = min(least, keys[2u * (at.y * draw.size.x + at.x) + 1u]);
        }
    }
    atomicMin(&farthest, least);
    workgroupBarrier();
    if lane == 0u {
        tiles[1u + number] = atomicLoad(&farthest);
    }
}
