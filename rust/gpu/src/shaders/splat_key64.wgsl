// Keys of samples as one number, whose maximum is the nearest splat, or the first of equally near ones.

@group(0) @binding(8) var<storage, read_write> keys: array<atomic<u64>>;

fn update_key(sample: u32, order: u32, number: u32) {
    atomicMax(&keys[sample], (u64(order) << 32u) | u64(number));
}
