//! Lanes as plain arrays, for any processor.

use std::array::from_fn;

use super::isa::{Isa, Lanes};

/// Baseline instruction set of the target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Portable;

impl Isa for Portable {
    type Four = Array<4>;
    type Eight = Array<8>;
    type Group = Array<8>;
}

/// A vector of `N` float32 numbers.
#[derive(Clone, Copy, Debug)]
#[repr(align(16))]
pub(crate) struct Array<const N: usize>([f32; N]);

impl<const N: usize> Array<N> {
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f32, f32) -> f32) -> Self {
        Self(from_fn(|i| f(self.0[i], other.0[i])))
    }

    #[inline(always)]
    fn compare(self, other: Self, f: impl Fn(f32, f32) -> bool) -> u32 {
        (0..N).fold(0, |bits, i| bits | u32::from(f(self.0[i], other.0[i])) << i)
    }
}

/// Operations that apply a function to each pair of lanes.
macro_rules! lane_by_lane {
    ($apply:ident -> $result:ty: $($method:ident |$a:ident, $b:ident| $value:expr),*) => {$(
        #[inline(always)]
        fn $method(self, other: Self) -> $result {
            self.$apply(other, |$a, $b| $value)
        }
    )*};
}

impl<I, const N: usize> Lanes<I> for Array<N> {
    const N: usize = N;

    #[inline(always)]
    fn splat(_isa: I, x: f32) -> Self {
        Self([x; N])
    }

    #[inline(always)]
    fn load(_isa: I, from: &[f32]) -> Self {
        let from = &from[..N];
        Self(from_fn(|i| from[i]))
    }

    #[inline(always)]
    fn store(self, to: &mut [f32]) {
        to[..N].copy_from_slice(&self.0);
    }

    lane_by_lane!(
        zip -> Self: add |a, b| a + b, sub |a, b| a - b, mul |a, b| a * b, div |a, b| a / b,
        min |a, b| if a < b { a } else { b }, max |a, b| if a > b { a } else { b }
    );
    lane_by_lane!(compare -> u32: lt |a, b| a < b, le |a, b| a <= b, eq |a, b| a == b);

    #[inline(always)]
    fn select(self, mask: u32, other: Self) -> Self {
        Self(from_fn(|i| if mask >> i & 1 == 1 { self.0[i] } else { other.0[i] }))
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.map(f32::abs))
    }
}
