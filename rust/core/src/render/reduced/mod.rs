//! What a thin client shows: near geometry, morphed for the user's position, before an environment map.

mod backdrop;
mod bent;
mod shown;
mod split;
mod straight;

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;

use super::frame::{Channels, Frame};
use super::tiles::{View, check_reach, draw};
use crate::base::{Error, Progress, Result};
use crate::camera::Camera;
use crate::cubemap::EnvironmentMap;
use crate::morph::{Kind, Morph};
use crate::partition::Partition;
use crate::scene::Scene;

use backdrop::Backdrop;
use shown::NearGeometry;

/// How near and far part are joined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Join {
    /// Near geometry is bent between r₁ and r₂ so that it meets the map without a seam.
    Morph(Kind),
    /// Near geometry stays as it is and ends at this radius, where it breaks off.
    Conventional {
        /// Where the near part ends and the map begins.
        radius: f64,
    },
}

/// How a reduced scene is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Drawing {
    /// Which images.
    pub channels: Channels,
    /// Colour samples of each pixel.
    pub samples: u32,
    /// By how many pixels of this view a straight edge may miss the bent one: longer edges are split for the frame.
    /// None morphs the vertices that there are.
    pub tolerance_px: Option<f64>,
}

/// A scene divided at two radii about a centre, with what surrounds it.
#[derive(Debug)]
pub struct Reduced {
    standing: Scene,
    center: DVec3,
    radii: [f64; 2],
    join: Join,
    map: Option<EnvironmentMap>,
    near: NearGeometry,
    last: [AtomicU64; 2],
}

/// What the last frame took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FrameCounts {
    /// Triangles that were traced instead of the whole scene, after splitting; 0 where the scene's own trees were used.
    pub triangles: u64,
    /// Vertices that user and centre see in opposite directions.
    pub opposed: u64,
}

impl Reduced {
    /// Gathers the near geometry; `map` is none where nothing lies beyond r₂.
    pub fn new(partition: &Partition, join: Join, map: Option<EnvironmentMap>, progress: &Progress) -> Result<Self> {
        let scene = partition.scene();
        let radii = [partition.r1(), partition.r2()];
        let near = match join {
            Join::Morph(_) => NearGeometry::gather(partition, progress)?,
            Join::Conventional { .. } => NearGeometry::default(),
        };
        let standing = Scene { moving: Arc::default(), ..scene.clone() };
        Ok(Self { standing, center: partition.center(), radii, join, map, near, last: Default::default() })
    }

    /// Bytes of the copies of near geometry.
    pub fn near_bytes(&self) -> usize {
        self.near.bytes()
    }

    /// What the last frame took.
    pub fn last_frame(&self) -> FrameCounts {
        let [triangles, opposed] = [0, 1].map(|i| self.last[i].load(Ordering::Relaxed));
        FrameCounts { triangles, opposed }
    }

    /// Draws a view from the user's position, the camera's. `scene` is the reduced one, its moving objects in any pose.
    pub fn render(&self, scene: &Scene, camera: &Camera, drawing: &Drawing, progress: &Progress) -> Result<Frame> {
        if !Arc::ptr_eq(&scene.standing, &self.standing.standing) {
            return Err(Error::value("at", "poses of the scene that was reduced", "another scene"));
        }
        self.check_channels(drawing.channels)?;
        if self.map.is_some() && camera.is_parallel() {
            let expected = "a perspective view or a cube face, because a map shows what one eye sees";
            return Err(Error::value("camera", expected, "parallel rays"));
        }
        if drawing.tolerance_px.is_some_and(|pixels| pixels.is_nan() || pixels <= 0.0) {
            return Err(Error::value("tolerance_px", "a number above 0", drawing.tolerance_px.unwrap_or_default()));
        }
        let view = View { camera, origin: scene.origin, channels: drawing.channels, samples: drawing.samples };
        check_reach("position", camera.position - scene.origin)?;
        let center = self.center - scene.origin;
        let backdrop = Backdrop { map: self.map.as_ref(), center, morph: None };
        match self.join {
            Join::Morph(kind) if camera.position != self.center => {
                let [r1, r2] = self.radii;
                let morph = Morph::new(camera.position - scene.origin, center, r1, r2, kind)?;
                let tolerance = drawing.tolerance_px.map(|pixels| pixels * self.pixel_angle(camera));
                let shown = self.near.morphed(scene, &morph, tolerance, progress)?;
                self.remember(shown.triangle_count(), shown.opposed);
                let backdrop = Backdrop { morph: Some(morph), ..backdrop };
                draw(&view, &bent::Bent { scene, shown, backdrop, center, radius: r2 }, progress)
            }
            join => {
                let radius = if let Join::Conventional { radius } = join { radius } else { self.radii[1] };
                self.remember(0, 0);
                draw(&view, &straight::Straight::new(&self.standing, scene, backdrop, radius, progress)?, progress)
            }
        }
    }

    /// Radians that a pixel covers: in the middle of the image, for parallel rays as seen from r₂ away.
    fn pixel_angle(&self, camera: &Camera) -> f64 {
        camera.pixel_size() / if camera.is_parallel() { self.radii[1] } else { 1.0 }
    }

    fn remember(&self, triangles: u64, opposed: u64) {
        self.last[0].store(triangles, Ordering::Relaxed);
        self.last[1].store(opposed, Ordering::Relaxed);
    }

    /// Far pixels have the channels that were baked.
    fn check_channels(&self, wanted: Channels) -> Result<()> {
        let Some(map) = &self.map else { return Ok(()) };
        for (name, wanted, baked) in
            [("range", wanted.range, map.range.is_some()), ("object_id", wanted.object_id, map.object_id.is_some())]
        {
            if wanted && !baked {
                let expected = format!("an environment map with {name}: reduce with channels=(\"color\", \"{name}\")");
                return Err(Error::value("channels", expected, "a map without"));
            }
        }
        Ok(())
    }
}
