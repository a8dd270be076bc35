//! Chooses the kernels for the instruction set.

#[cfg(target_arch = "x86_64")]
use super::lanes::{Avx2, Avx512};
use super::lanes::{Isa, Level};
use super::single::{Search, walk_set};
use super::{Filter, Hit, Ray};
use crate::scene::Scene;

/// One function for each instruction set around a kernel that is generic over it: what is inlined into them is
/// compiled with their instructions.
macro_rules! kernels {
    ($name:ident, $kernel:ident, $out:ty) => {
        pub(super) fn $name<F: Filter>(level: Level, scene: &Scene, rays: &[Ray], filter: &F, out: &mut [$out]) {
            #[cfg(target_arch = "x86_64")]
            {
                #[target_feature(enable = "avx2")]
                fn avx2<F: Filter>(isa: Avx2, scene: &Scene, rays: &[Ray], filter: &F, out: &mut [$out]) {
                    $kernel(isa, scene, rays, filter, out);
                }
                #[target_feature(enable = "avx2,avx512f,avx512vl,avx512dq")]
                fn avx512<F: Filter>(isa: Avx512, scene: &Scene, rays: &[Ray], filter: &F, out: &mut [$out]) {
                    $kernel(isa, scene, rays, filter, out);
                }
                match level {
                    // SAFETY: the value proves that the processor has the instructions.
                    Level::Avx2(isa) => return unsafe { avx2(isa, scene, rays, filter, out) },
                    // SAFETY: as above.
                    Level::Avx512(isa) => return unsafe { avx512(isa, scene, rays, filter, out) },
                    Level::Portable => {}
                }
            }
            let _ = level;
            $kernel(super::lanes::Portable, scene, rays, filter, out);
        }
    };
}

kernels!(closest_hits, closest, Hit);
kernels!(any_hits, any, bool);

#[inline(always)]
fn closest<I: Isa, F: Filter>(isa: I, scene: &Scene, rays: &[Ray], filter: &F, hits: &mut [Hit]) {
    for (ray, hit) in rays.iter().zip(hits) {
        *hit = trace(isa, scene, Search { ray, filter, best: Hit::MISS, any: false });
    }
}

#[inline(always)]
fn any<I: Isa, F: Filter>(isa: I, scene: &Scene, rays: &[Ray], filter: &F, hits: &mut [bool]) {
    for (ray, hit) in rays.iter().zip(hits) {
        *hit = !trace(isa, scene, Search { ray, filter, best: Hit::MISS, any: true }).is_miss();
    }
}

#[inline(always)]
fn trace<I: Isa, F: Filter>(isa: I, scene: &Scene, mut search: Search<'_, F>) -> Hit {
    let standing = scene.standing.instances().len();
    walk_set(isa, &scene.standing, 0, &mut search);
    if !scene.moving.instances().is_empty() && !search.is_done() {
        walk_set(isa, &scene.moving, standing as u32, &mut search);
    }
    search.best
}
