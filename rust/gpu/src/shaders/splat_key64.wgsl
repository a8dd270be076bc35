// Keys of samples as one number: the nearest splat wins, and the first of equally near ones.

@group(0) @binding(8) var<storage, read_write> keys: array<atomic<u64>>;

fn raise(sample: u32, order: u32, number: u32) {
    atomicMax(&keys[sample], (u64(order) << 32u) | u64(number));
}
