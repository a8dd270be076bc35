//! Time to find the third camera's needed pixels and build their mask pyramid, against reading both depth buffers.
//!
//! `cargo bench -p nearfar-core --bench needed`: both eyes of the paper's Vive, 1344 × 1512 pixels, plane at 8 m.

use std::hint::black_box;
use std::time::Instant;

use glam::{DQuat, DVec3};
use nearfar_core::base::{Progress, Result, pool};
use nearfar_core::camera::Fov;
use nearfar_core::render::MaskPyramid;
use nearfar_core::stereo::{Eye, Planes, Rig};
use rayon::prelude::*;

const SIZE: (u32, u32) = (1344, 1512);
const TIMES: usize = 50;

fn main() -> Result<()> {
    let left = Fov { left: -1.391_937, right: 1.247_409, down: -1.464_287, up: 1.468_819 };
    let right = Fov { left: -1.246_557, right: 1.398_447, down: -1.472_458, up: 1.465_505 };
    let eye = |fov, x| Eye { fov, position: DVec3::new(x, 0.0, 0.0), orientation: DQuat::IDENTITY };
    let rig = Rig::new([eye(left, -0.032), eye(right, 0.032)], Planes { begin: 8.0, end: 8.0 }, SIZE)?;
    println!("{} threads; milliseconds, the least of {TIMES}", pool::thread_count()?);
    println!(
        "| eyes' own surfaces | three reads of both buffers | needed pixels | their pyramid | share of three reads |"
    );
    println!("| --- | ---: | ---: | ---: | ---: |");
    for (name, covered) in [("none", none as Cover), ("ground and discs", discs), ("every other pixel", checkers)] {
        let shares: Vec<f32> = (0..SIZE.0 * SIZE.1).map(|n| f32::from(covered(n % SIZE.0, n / SIZE.0))).collect();
        let depths = [shares.clone(), shares.clone()];
        let reads = least(|| {
            for depth in depths.iter().cycle().take(6) {
                black_box(greatest(depth));
            }
        })?;
        let find = || rig.needed([&shares, &shares], 1, &Progress::new());
        let needed = least(|| drop(black_box(find())))?;
        let mask = find()?;
        let pyramid = least(|| drop(black_box(MaskPyramid::new(&mask, rig.center_size.0 as usize))))?;
        println!("| {name} | {reads:.2} | {needed:.2} | {pyramid:.2} | {:.2} |", (needed + pyramid) / reads);
    }
    Ok(())
}

type Cover = fn(u32, u32) -> bool;

fn none(_: u32, _: u32) -> bool {
    false
}

/// The lower half of the picture, and discs of 32 to 64 pixels across in every block of 128 × 128.
fn discs(x: u32, y: u32) -> bool {
    let [dx, dy] = [x, y].map(|at| i64::from(at % 128) - 64);
    let radius = i64::from(16 + (x / 128 * 7 + y / 128 * 3) % 17);
    y > SIZE.1 / 2 || dx * dx + dy * dy < radius * radius
}

fn checkers(x: u32, y: u32) -> bool {
    (x + y).is_multiple_of(2)
}

/// Reads a buffer at the speed of memory: eight running maxima for each thread's part.
fn greatest(values: &[f32]) -> f32 {
    let part = |values: &[f32]| {
        let mut found = [0.0_f32; 8];
        for eight in values.chunks_exact(8) {
            found.iter_mut().zip(eight).for_each(|(found, value)| *found = if value > found { *value } else { *found });
        }
        found.into_iter().fold(0.0, f32::max)
    };
    values.par_chunks(1 << 16).map(part).reduce(|| 0.0, f32::max)
}

/// Returns the least time of the work in milliseconds, in the thread pool that kernels use.
fn least(work: impl Fn() + Sync) -> Result<f64> {
    let mut best = f64::INFINITY;
    for _ in 0..TIMES {
        let start = Instant::now();
        pool::install(&work)?;
        best = best.min(start.elapsed().as_secs_f64() * 1e3);
    }
    Ok(best)
}
