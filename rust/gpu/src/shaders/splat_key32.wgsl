// Keys of samples as two numbers. The first pass finds the nearest depth, the second the first splat at this depth.

@group(0) @binding(8) var<storage, read_write> keys: array<atomic<u32>>;

fn update_key(sample: u32, order: u32, number: u32) {
    if draw.work.z == 0u {
        atomicMax(&keys[2u * sample + 1u], order);
    } else if order == atomicLoad(&keys[2u * sample + 1u]) {
        atomicMax(&keys[2u * sample], number);
    }
}
