//! Kernels whose multiplications and additions are fused where the machine can: half the instructions, and one
//! rounding less. Machines without it round once more; everything else about the results is the same.

/// Pixels side by side.
pub(super) const LANES: usize = 32;

/// The first of a row of lanes.
#[inline(always)]
pub(super) fn lanes<R>(values: &[R]) -> &[R; LANES] {
    &values.as_chunks::<LANES>().0[0]
}

/// Asks for values that are read soon.
#[inline(always)]
pub(super) fn prefetch<P>(values: &[P]) {
    #[cfg(target_arch = "x86_64")]
    for from in (0..size_of_val(values)).step_by(64) {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: prefetching reads nothing; the address lies within the slice.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(values.as_ptr().cast::<i8>().add(from)) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = values;
}

/// Wraps `#[inline(always)]` kernels, generic in `FUSED` and where they say `<_>` in a type before it, in functions that run
/// them with the widest vectors.
macro_rules! fused_kernels {
    ($(fn $name:ident($($argument:ident: $type:ty),* $(,)?) $(-> $result:ty)? = $kernel:ident $(<$any:tt>)?;)*) => {$(
        fn $name($($argument: $type),*) $(-> $result)? {
            #[cfg(target_arch = "x86_64")]
            {
                #[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw,fma")]
                fn wide($($argument: $type),*) $(-> $result)? {
                    $kernel::<$($any,)? true>($($argument),*)
                }
                #[target_feature(enable = "avx2,fma")]
                fn medium($($argument: $type),*) $(-> $result)? {
                    $kernel::<$($any,)? true>($($argument),*)
                }
                if is_x86_feature_detected!("avx512vl")
                    && is_x86_feature_detected!("avx512dq")
                    && is_x86_feature_detected!("avx512bw")
                    && is_x86_feature_detected!("fma")
                {
                    // SAFETY: the features were just detected; each of the first three implies avx512f.
                    return unsafe { wide($($argument),*) };
                }
                if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
                    // SAFETY: the features were just detected.
                    return unsafe { medium($($argument),*) };
                }
            }
            $kernel::<$($any,)? { cfg!(target_arch = "aarch64") }>($($argument),*)
        }
    )*};
}

pub(super) use fused_kernels;
