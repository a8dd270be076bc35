use super::*;

const INF: f32 = f32::INFINITY;
const NAN: f32 = f32::NAN;
const SPECIAL: [f32; 16] =
    [0.0, -0.0, 1.0, -1.5, INF, -INF, NAN, 1e-45, -1e-45, 3.4e38, -3.4e38, 0.1, 1.0 / 3.0, 1e20, -7e-20, 2.5];

/// Returns the bits of all operations on all pairs; all NaN payloads count as equal.
fn results<I: Copy, L: Lanes<I>>(isa: I) -> Vec<u32> {
    let mut out = vec![];
    for shift in 0..16 {
        let (a, mut b) = (SPECIAL, SPECIAL);
        b.rotate_left(shift);
        for start in (0..16).step_by(L::N) {
            let (a, b) = (L::load(isa, &a[start..]), L::load(isa, &b[start..]));
            let mask = 0b1010_0110_1100_0101 >> start;
            let values = [a.add(b), a.sub(b), a.mul(b), a.div(b), a.min(b), a.max(b), a.select(mask, b), a.abs()];
            let mut lanes = [[0.0; 16]; 8];
            values.iter().zip(&mut lanes).for_each(|(value, row)| value.store(row));
            let masks = [a.lt(b), a.le(b), a.eq(b)];
            for lane in 0..L::N {
                let bits = |x: f32| if x.is_nan() { NAN.to_bits() } else { x.to_bits() };
                out.extend(lanes.iter().map(|row| bits(row[lane])));
                out.extend(masks.map(|mask| mask >> lane & 1));
            }
        }
    }
    out
}

#[test]
fn all_widths_agree_bit_for_bit() {
    let expected = results::<_, array::Array<8>>(Portable);
    assert_eq!(expected, results::<_, array::Array<4>>(Portable));
    #[cfg(target_arch = "x86_64")]
    {
        if let Some(isa) = Avx2::detect() {
            assert_eq!(expected, results::<_, <Avx2 as Isa>::Four>(isa));
            assert_eq!(expected, results::<_, <Avx2 as Isa>::Eight>(isa));
        }
        if let Some(isa) = Avx512::detect() {
            assert_eq!(expected, results::<_, <Avx512 as Isa>::Group>(isa));
        }
    }
}

#[test]
fn instruction_sets_are_chosen_by_name() {
    assert!(use_instruction_set("mmx").is_err());
    assert_eq!(instruction_sets()[0], "portable");
    // The loop ends with the best set, which restores the default. Tests that trace at the same time get the same bits
    // either way.
    for name in instruction_sets() {
        assert_eq!(use_instruction_set(name), Ok(()));
    }
}
