// Declarations of all compute kernels. The constants ROW (workgroups per row of a dispatch) and GROUP (threads per
// workgroup) precede them.

const EXPONENT: u32 = 0x7f800000u;
const SIGN: u32 = 0x80000000u;
const NAN: u32 = 0x7fc00000u;

// Returns the number of the row, pixel or point that a thread processes.
fn item_number(group: vec3<u32>, local: u32) -> u32 {
    return (group.y * ROW + group.x) * GROUP + local;
}

// Tests the bits, because compilers may assume that there are no NaNs.
fn is_finite(v: vec3<f32>) -> bool {
    return all((bitcast<vec3<u32>>(v) & vec3<u32>(EXPONENT)) != vec3<u32>(EXPONENT));
}

// Converts the bits of a float to a number, so that numbers have the order of the floats.
fn order_from_bits(bits: u32) -> u32 {
    return select(bits | SIGN, ~bits, (bits & SIGN) != 0u);
}
