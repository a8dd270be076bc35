//! One kernel compiled for each width of vectors, chosen when it runs.

/// Asks memory for values that are read soon: loads behind hundreds of instructions would wait for their turn.
#[inline(always)]
pub(crate) fn prefetch<P>(values: &[P]) {
    #[cfg(target_arch = "x86_64")]
    for from in (0..size_of_val(values)).step_by(64) {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: prefetching reads nothing; the address lies within the slice.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(values.as_ptr().cast::<i8>().add(from)) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = values;
}

/// Wraps an `#[inline(always)]` kernel in a function that runs it with the widest vectors of this machine.
/// Multiplications and additions are never fused in Rust unless written so: every width gives the same bits.
macro_rules! widest {
    (fn $name:ident($($argument:ident: $type:ty),* $(,)?) $(-> $result:ty)? = $kernel:path;) => {
        fn $name($($argument: $type),*) $(-> $result)? {
            #[cfg(target_arch = "x86_64")]
            {
                #[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
                fn wide($($argument: $type),*) $(-> $result)? {
                    $kernel($($argument),*)
                }
                #[target_feature(enable = "avx2")]
                fn medium($($argument: $type),*) $(-> $result)? {
                    $kernel($($argument),*)
                }
                if is_x86_feature_detected!("avx512vl")
                    && is_x86_feature_detected!("avx512dq")
                    && is_x86_feature_detected!("avx512bw")
                {
                    // SAFETY: the features were just detected; each of them implies avx512f.
                    return unsafe { wide($($argument),*) };
                }
                if is_x86_feature_detected!("avx2") {
                    // SAFETY: the feature was just detected.
                    return unsafe { medium($($argument),*) };
                }
            }
            $kernel($($argument),*)
        }
    };
}

pub(crate) use widest;

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

pub(crate) use fused_kernels;
