//! Compilation of one kernel for several vector widths, run-time dispatch, prefetching, and minima without branches.

/// Prefetches values that will be read soon. Without it the load would wait for the hundreds of instructions before it.
#[inline(always)]
pub(crate) fn prefetch<P>(values: &[P]) {
    #[cfg(target_arch = "x86_64")]
    for from in (0..size_of_val(values)).step_by(64) {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: a prefetch does not access memory; the address lies within the slice.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(values.as_ptr().cast::<i8>().add(from)) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = values;
}

/// Returns the lesser of two numbers; the second if one is NaN.
#[inline(always)]
pub(crate) fn lesser<T: PartialOrd>(a: T, b: T) -> T {
    if a < b { a } else { b }
}

/// Returns the greater of two numbers; the second if one is NaN.
#[inline(always)]
pub(crate) fn greater<T: PartialOrd>(a: T, b: T) -> T {
    if a > b { a } else { b }
}

/// Defines functions, also generic ones, that run an `#[inline(always)]` kernel with this machine's widest vectors.
///
/// - `fn name(…) = kernel;`: all widths return the same bits, because Rust never fuses a multiplication and an addition
///   by itself.
/// - `fn name(…) = fused kernel;` calls a kernel with the constant parameter `FUSED`; `fused kernel<_>` if a type
///   parameter precedes it. `FUSED` is true if the machine has fused multiply-add, which saves time and one rounding.
macro_rules! vectorized {
    () => {};
    (
        $(#[$attribute:meta])*
        $visibility:vis fn $name:ident $(<$($generic:ident: $bound:path),+>)? ($($argument:ident: $type:ty),* $(,)?)
            $(-> $result:ty)? = fused $kernel:ident $(<$any:tt>)?;
        $($others:tt)*
    ) => {
        vectorized! {
            @versions $(#[$attribute])* $visibility fn $name $(<$($generic: $bound),+>)? ($($argument: $type),*)
            $(-> $result)?, "fma",
            $kernel::<$($any,)? true>($($argument),*),
            $kernel::<$($any,)? { cfg!(target_arch = "aarch64") }>($($argument),*)
        }
        vectorized! { $($others)* }
    };
    (
        $(#[$attribute:meta])*
        $visibility:vis fn $name:ident $(<$($generic:ident: $bound:path),+>)? ($($argument:ident: $type:ty),* $(,)?)
            $(-> $result:ty)? = $kernel:path;
        $($others:tt)*
    ) => {
        // "avx" adds no condition: every processor with AVX2 has AVX.
        vectorized! {
            @versions $(#[$attribute])* $visibility fn $name $(<$($generic: $bound),+>)? ($($argument: $type),*)
            $(-> $result)?, "avx",
            $kernel($($argument),*), $kernel($($argument),*)
        }
        vectorized! { $($others)* }
    };
    (
        @versions $(#[$attribute:meta])* $visibility:vis fn $name:ident $(<$($generic:ident: $bound:path),+>)?
        ($($argument:ident: $type:ty),*) $(-> $result:ty)?, $feature:tt,
        $vectors:expr, $portable:expr
    ) => {
        $(#[$attribute])*
        $visibility fn $name $(<$($generic: $bound),+>)? ($($argument: $type),*) $(-> $result)? {
            #[cfg(target_arch = "x86_64")]
            {
                #[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
                #[target_feature(enable = $feature)]
                fn wide $(<$($generic: $bound),+>)? ($($argument: $type),*) $(-> $result)? {
                    $vectors
                }
                #[target_feature(enable = "avx2")]
                #[target_feature(enable = $feature)]
                fn medium $(<$($generic: $bound),+>)? ($($argument: $type),*) $(-> $result)? {
                    $vectors
                }
                let has_feature = is_x86_feature_detected!($feature);
                if has_feature
                    && is_x86_feature_detected!("avx512vl")
                    && is_x86_feature_detected!("avx512dq")
                    && is_x86_feature_detected!("avx512bw")
                {
                    // SAFETY: the features were just detected; each of the last three implies avx512f.
                    return unsafe { wide($($argument),*) };
                }
                if has_feature && is_x86_feature_detected!("avx2") {
                    // SAFETY: the features were just detected.
                    return unsafe { medium($($argument),*) };
                }
            }
            $portable
        }
    };
}

pub(crate) use vectorized;
