//! Lanes as x86 registers of 128, 256 and 512 bits.

use std::arch::is_x86_feature_detected;
use std::arch::x86_64::*;

use super::isa::{Isa, Lanes};

/// Proof that the processor supports AVX2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Avx2(());

/// Proof that the processor supports AVX-512 F, VL and DQ, and AVX2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Avx512(());

impl Avx2 {
    /// Returns the proof if the processor supports the instructions.
    pub(crate) fn detect() -> Option<Self> {
        is_x86_feature_detected!("avx2").then_some(Self(()))
    }
}

impl Avx512 {
    /// Returns the proof if the processor supports the instructions.
    pub(crate) fn detect() -> Option<Self> {
        let has_all = is_x86_feature_detected!("avx2")
            && is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("avx512vl")
            && is_x86_feature_detected!("avx512dq");
        has_all.then_some(Self(()))
    }
}

impl Isa for Avx2 {
    type Four = F32x4;
    type Eight = F32x8;
    type Group = F32x8;
}

impl Isa for Avx512 {
    type Four = F32x4;
    type Eight = F32x8;
    type Group = F32x16;
}

/// Instruction sets that include AVX2.
pub(crate) trait HasAvx2 {}
impl HasAvx2 for Avx2 {}
impl HasAvx2 for Avx512 {}

/// A 128-bit vector. Values are created only with a proof that the processor has AVX2.
#[derive(Clone, Copy)]
pub(crate) struct F32x4(__m128);

/// A 256-bit vector. Values are created only with a proof that the processor has AVX2.
#[derive(Clone, Copy)]
pub(crate) struct F32x8(__m256);

/// A 512-bit vector. Values are created only with a proof that the processor has AVX-512.
#[derive(Clone, Copy)]
pub(crate) struct F32x16(__m512);

/// Operations that have the same form at all widths.
macro_rules! arithmetic {
    ($($method:ident: $intrinsic:ident),*) => {$(
        #[inline(always)]
        fn $method(self, other: Self) -> Self {
            // SAFETY: a value of this type proves that the processor has the instruction.
            Self(unsafe { $intrinsic(self.0, other.0) })
        }
    )*};
}

/// Comparisons of two registers; they return masks with one bit for each lane.
macro_rules! comparisons {
    ($($method:ident: |$a:ident, $b:ident| $mask:expr),*) => {$(
        #[inline(always)]
        fn $method(self, other: Self) -> u32 {
            let ($a, $b) = (self.0, other.0);
            // SAFETY: a value of this type proves that the processor has the instructions.
            unsafe { $mask }
        }
    )*};
}

/// Constructors and stores. `$isa` is the type of the proof; lengths are checked.
macro_rules! memory {
    ($n:literal, $isa:ty, $set1:ident, $load:ident, $store:ident) => {
        const N: usize = $n;

        #[inline(always)]
        fn splat(_isa: $isa, x: f32) -> Self {
            // SAFETY: `_isa` proves that the processor has the instruction.
            Self(unsafe { $set1(x) })
        }

        #[inline(always)]
        fn load(_isa: $isa, from: &[f32]) -> Self {
            assert!(from.len() >= $n);
            // SAFETY: `_isa` proves that the processor has the instruction, and the slice is long enough.
            Self(unsafe { $load(from.as_ptr()) })
        }

        #[inline(always)]
        fn store(self, to: &mut [f32]) {
            assert!(to.len() >= $n);
            // SAFETY: a value of this type proves that the processor has the instruction; the slice is long enough.
            unsafe { $store(to.as_mut_ptr(), self.0) }
        }
    };
}

impl<I: HasAvx2> Lanes<I> for F32x4 {
    memory!(4, I, _mm_set1_ps, _mm_loadu_ps, _mm_storeu_ps);
    arithmetic!(add: _mm_add_ps, sub: _mm_sub_ps, mul: _mm_mul_ps, div: _mm_div_ps, min: _mm_min_ps, max: _mm_max_ps);

    comparisons!(
        lt: |a, b| _mm_movemask_ps(_mm_cmplt_ps(a, b)) as u32,
        le: |a, b| _mm_movemask_ps(_mm_cmple_ps(a, b)) as u32,
        eq: |a, b| _mm_movemask_ps(_mm_cmpeq_ps(a, b)) as u32
    );

    #[inline(always)]
    fn select(self, mask: u32, other: Self) -> Self {
        // SAFETY: a value of this type proves that the processor has the instructions.
        unsafe {
            let bits = _mm_setr_epi32(1, 2, 4, 8);
            let lanes = _mm_cmpeq_epi32(_mm_and_si128(_mm_set1_epi32(mask as i32), bits), bits);
            Self(_mm_blendv_ps(other.0, self.0, _mm_castsi128_ps(lanes)))
        }
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: a value of this type proves that the processor has the instructions.
        Self(unsafe { _mm_andnot_ps(_mm_set1_ps(-0.0), self.0) })
    }
}

impl<I: HasAvx2> Lanes<I> for F32x8 {
    memory!(8, I, _mm256_set1_ps, _mm256_loadu_ps, _mm256_storeu_ps);
    arithmetic!(add: _mm256_add_ps, sub: _mm256_sub_ps, mul: _mm256_mul_ps, div: _mm256_div_ps, min: _mm256_min_ps,
                max: _mm256_max_ps);

    comparisons!(
        lt: |a, b| _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LT_OQ>(a, b)) as u32,
        le: |a, b| _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(a, b)) as u32,
        eq: |a, b| _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_EQ_OQ>(a, b)) as u32
    );

    #[inline(always)]
    fn select(self, mask: u32, other: Self) -> Self {
        // SAFETY: a value of this type proves that the processor has the instructions.
        unsafe {
            let bits = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
            let lanes = _mm256_cmpeq_epi32(_mm256_and_si256(_mm256_set1_epi32(mask as i32), bits), bits);
            Self(_mm256_blendv_ps(other.0, self.0, _mm256_castsi256_ps(lanes)))
        }
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: a value of this type proves that the processor has the instructions.
        Self(unsafe { _mm256_andnot_ps(_mm256_set1_ps(-0.0), self.0) })
    }
}

impl Lanes<Avx512> for F32x16 {
    memory!(16, Avx512, _mm512_set1_ps, _mm512_loadu_ps, _mm512_storeu_ps);
    arithmetic!(add: _mm512_add_ps, sub: _mm512_sub_ps, mul: _mm512_mul_ps, div: _mm512_div_ps, min: _mm512_min_ps,
                max: _mm512_max_ps);

    comparisons!(
        lt: |a, b| u32::from(_mm512_cmp_ps_mask::<_CMP_LT_OQ>(a, b)),
        le: |a, b| u32::from(_mm512_cmp_ps_mask::<_CMP_LE_OQ>(a, b)),
        eq: |a, b| u32::from(_mm512_cmp_ps_mask::<_CMP_EQ_OQ>(a, b))
    );

    #[inline(always)]
    fn select(self, mask: u32, other: Self) -> Self {
        // SAFETY: a value of this type proves that the processor has the instructions.
        Self(unsafe { _mm512_mask_blend_ps(mask as u16, other.0, self.0) })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: a value of this type proves that the processor has the instructions.
        Self(unsafe { _mm512_abs_ps(self.0) })
    }
}
