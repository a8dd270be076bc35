// Keys of samples as two numbers: a first pass finds the nearest splats, a second one the first of equally near ones.

@group(0) @binding(8) var<storage, read_write> keys: array<atomic<u32>>;

fn raise(sample: u32, order: u32, number: u32) {
    if draw.work.z == 0u {
        atomicMax(&keys[2u * sample + 1u], order);
    } else if order == atomicLoad(&keys[2u * sample + 1u]) {
        atomicMax(&keys[2u * sample], number);
    }
}
