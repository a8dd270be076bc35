//! Impostors: the far part of a scene as textured quads in world space, baked from several centres, so that it keeps
//! its parallax for users within a region.
//!
//! Each centre adds a layer: the texels of a cube map that no earlier layer shows. Quads are pieces of planes, each
//! chosen so that no user in the region sees a texel farther from its place than a given angle.
//!
//! Related: Seurat (Lall et al., 2018), QUASAR (2025), layered meshes (Broxton et al., 2020).

mod atlas;
mod cover;
mod layer;
mod paint;
mod plane;
mod probe;
mod sample;
mod sheet;
mod small;
mod strips;
#[cfg(test)]
mod tests;
mod tile;
mod world;

use std::sync::Arc;

use glam::DVec3;
use rayon::prelude::*;

use crate::base::memory::room_for_values;
use crate::base::{Progress, Result, ensure};
use crate::cubemap::MAX_SIZE;
use crate::partition::Partition;
use crate::render::bake::without_moving;
use crate::scene::Scene;

pub use atlas::Mesh;
use layer::{Layer, place, tiles_across};
use paint::Quad;
use probe::Probe;
pub use sheet::Sheet;
use tile::{SIDE, Tile};
use world::{Seen, World};

/// Settings of a bake.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// World position of the middle O of the users' region.
    pub center: DVec3,
    /// Radius of the users' region about O, metres: a sphere.
    pub reach: f64,
    /// Distance above and below O, metres, up to `reach`, at which probes stand beside those at the height of O.
    pub height: f64,
    /// Radius, metres, of the cylinder about the vertical axis through O; triangles that reach into it are no impostors.
    pub r2: f64,
    /// Width of a face of each layer's cube map, texels.
    pub size: u32,
    /// Greatest angle, radians, by which a user sees a texel's centre off its place.
    pub angle: f64,
    /// Greatest number of centres.
    pub centers: u32,
    /// Share of the probes' pixels that may be missing.
    pub missing: f64,
}

/// A baked far part and its measures.
#[derive(Debug, Default)]
pub struct Impostors {
    /// The quads as textured triangles relative to O.
    pub mesh: Mesh,
    /// Centre of each layer relative to O, and its number of quads; layers of the earlier bake are first.
    pub layers: Vec<([f64; 3], usize)>,
    /// Number of quads of the earlier bake.
    pub shared: usize,
    /// New quads of each layer, which the bake of another region can use again.
    pub sheets: Vec<Sheet>,
    /// Share of the probes' pixels missing before each layer was chosen, and at the end.
    pub missing: Vec<f64>,
    /// Numbers of the static triangles that users of the region see, ascending.
    pub seen: Vec<i64>,
}

/// Directions of the first centres around O.
const ROUND: usize = 6;
/// Fraction of the layers' width that probes' maps have.
const PROBE_SIZE: u32 = 4;

/// Returns a position that rays have, rounded to float32.
fn single_precision(position: DVec3) -> DVec3 {
    position.as_vec3().as_dvec3()
}

/// Bakes the far part of a scene. `earlier` has the quads of another region of the same scene: those that keep the bound
/// here are used again, and new ones show what is left.
pub fn bake(scene: &Scene, settings: &Settings, earlier: &[Sheet], progress: &Progress) -> Result<Impostors> {
    let Settings { center, reach, height, r2, size, .. } = *settings;
    ensure!((64..=MAX_SIZE / 2).contains(&size), "face_size", format!("64 to {} texels", MAX_SIZE / 2), size);
    ensure!(reach.is_finite() && reach > 0.0, "reach", "a finite radius above 0", reach);
    ensure!((0.0..=reach).contains(&height), "height", format!("0 to reach = {reach} m"), height);
    ensure!(r2.is_finite() && r2 > reach, "r2", format!("a finite radius greater than reach = {reach}"), r2);
    let is_angle = settings.angle > 0.0 && settings.angle < 0.5;
    ensure!(is_angle, "angle", "an angle above 0 and below 0.5 radians", settings.angle);
    let partition = Partition::new(scene, center, 0.0, r2, progress)?;
    let still = without_moving(scene, progress)?;
    let eye = center - scene.origin;
    let world =
        World { scene: &still, partition: &partition, eye, reach, angle: settings.angle, seen: Seen::new(&still)? };
    let around = |radius: f64, n: usize, count: usize, height: f64| {
        let (sin, cos) = (std::f64::consts::TAU * n as f64 / count as f64).sin_cos();
        single_precision(eye + DVec3::new(radius * cos, height, radius * sin))
    };
    let mut places = vec![single_precision(eye)];
    let heights = if height > 0.0 { &[0.0, height, -height][..] } else { &[0.0] };
    for &height in heights {
        let radius = (reach * reach - height * height).sqrt();
        places.extend((0..12).map(|n| around(radius, n, 12, height)));
        places.extend((0..6).map(|n| around(0.5 * radius, n, 6, height)));
    }
    let width = (size / PROBE_SIZE).max(32);
    let probes = places.iter().map(|&at| Probe::trace(&world, at, width, progress)).collect::<Result<Vec<_>>>()?;
    let shared = earlier.iter().map(|sheet| sheet.shared_with(&world, &probes, size as usize, progress));
    let mut sheets = shared.collect::<Result<Vec<_>>>()?;
    sheets.retain(|sheet| !sheet.quads.is_empty());
    let shared = sheets.len();
    let mut baked = Baked { layers: sheets.iter().map(|sheet| sheet.layer(&world)).collect(), sheets };
    baked.add(&world, places[0], size as usize, &probes, progress)?;
    // Shared layers replace the circle's. The circle's layers would show more than the probes ask for, so fewer pixels
    // may be missing without them.
    let (round, allowed) = if shared > 0 { (0, 0.5 * settings.missing) } else { (ROUND, settings.missing) };
    let round = round.min(settings.centers.saturating_sub(1) as usize);
    for n in 0..round {
        baked.add(&world, around(reach, n, ROUND, 0.0), size as usize, &probes, progress)?;
    }
    let mut missing_shares = Vec::new();
    let total: usize = probes.iter().map(Probe::texels).sum();
    loop {
        let missing = probes.iter().map(|probe| probe.missing(&baked.layers, progress)).collect::<Result<Vec<_>>>()?;
        let share = missing.iter().sum::<usize>() as f64 / total as f64;
        missing_shares.push(share);
        let own = &baked.layers[shared..];
        if share <= allowed || own.len() >= settings.centers as usize {
            break;
        }
        // No place is baked twice: groups that were too small for the first layer would be too small again.
        let is_new = |n: &usize| own.iter().all(|layer| layer.center != probes[*n].position);
        let others = (0..probes.len()).filter(|n| missing[*n] > 0).filter(is_new);
        // The first of equals, so that the choice does not depend on how probes are counted.
        let Some(worst) = others.max_by_key(|&n| (missing[n], std::cmp::Reverse(n))) else { break };
        baked.add(&world, probes[worst].position, size as usize, &probes, progress)?;
    }
    small::note_small(&world, &probes, progress)?;
    let mut sheets = baked.sheets;
    let layers: Vec<_> = sheets.iter().map(|sheet| ((sheet.center - eye).to_array(), sheet.quads.len())).collect();
    let shared_quads = layers[..shared].iter().map(|(_, count)| count).sum();
    let (mesh, seen) = (atlas::build(&sheets, eye)?, world.seen.numbers().collect());
    // A quad is used again once: chains of bakes would keep ever more of them, each only just exact enough.
    sheets.drain(..shared);
    Ok(Impostors { mesh, layers, shared: shared_quads, sheets, missing: missing_shares, seen })
}

struct Baked {
    layers: Vec<Layer>,
    sheets: Vec<Sheet>,
}

impl Baked {
    /// Adds the layer of a centre; with probes also of far surfaces that these see behind near ones.
    fn add(
        &mut self,
        world: &World<'_>,
        center: DVec3,
        size: usize,
        probes: &[Probe],
        progress: &Progress,
    ) -> Result<()> {
        let count = 6 * tiles_across(size).pow(2);
        // Owners of texels and their colours, if every tile shows something.
        room_for_values::<([u16; SIDE * SIDE], [[u8; 4]; SIDE * SIDE])>(count)?;
        progress.expect((count * SIDE * SIDE) as u64);
        let tile = |number: usize| {
            let tile = Tile::trace(world, center, size, place(number, size), &self.layers, probes);
            let covers = cover::cover(&tile);
            let quads = covers.iter().map(|cover| Arc::new(paint::paint(world, center, &tile, cover)));
            let quads: Vec<Arc<Quad>> = quads.collect();
            progress.report((SIDE * SIDE) as u64).map(|()| quads)
        };
        let quads = (0..count).into_par_iter().map(tile).collect::<Result<Vec<_>>>()?;
        let sheet = Sheet { center, size, quads: quads.concat() };
        self.layers.push(sheet.layer(world));
        self.sheets.push(sheet);
        Ok(())
    }
}
