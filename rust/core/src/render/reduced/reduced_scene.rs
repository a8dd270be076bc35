//! A reduced scene: near geometry, its join with the map, and its frames.

use std::sync::Arc;

use glam::DVec3;

use super::super::frame::{Channels, Frame};
use super::super::limits::{Limits, Segment};
use super::super::tiles::{Pixels, RenderView, check_position, draw};
use super::backdrop::{Backdrop, Far, VisibleVolume};
use super::folding::Folding;
use super::moving::{ConventionalDynamic, Moving};
use super::near_geometry::NearGeometry;
use super::{bent, exact, straight};
use crate::base::{Progress, Result, ensure};
use crate::camera::Camera;
use crate::cubemap::EnvironmentMap;
use crate::morph::{Kind, Morph};
use crate::partition::Partition;
use crate::scene::Scene;

/// Join of the near and the far part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Join {
    /// Near geometry is morphed between r₁ and r₂ so that it meets the map without a seam.
    Morph(Kind),
    /// Near geometry is not morphed and ends at a radius, with a visible break.
    Conventional {
        /// Radius, in metres, at which the near part ends and the map begins.
        radius: f64,
    },
}

impl Join {
    fn kind(self) -> Option<Kind> {
        match self {
            Self::Morph(kind) => Some(kind),
            Self::Conventional { .. } => None,
        }
    }
}

/// Primitives to which the morph is applied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MorphMethod {
    /// Vertices, as in a vertex shader.
    Vertex,
    /// Rays: each pixel shows the first hit of its bent ray.
    Exact,
}

/// Growth of the morph in a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Growth {
    /// Radius of the morph, metres; `None` for r₂. r₁ shrinks in proportion.
    pub radius: Option<f64>,
    /// Strength of the morph, 0 to 1.
    pub strength: f64,
}

/// Settings of a frame of a reduced scene.
#[derive(Clone, Copy, Debug)]
pub struct Drawing<'a> {
    /// Requested images.
    pub channels: Channels,
    /// Number of colour samples per pixel.
    pub samples: u32,
    /// Visible volume, by displayed distances and displayed world positions.
    pub limits: Limits,
    /// Pixels to draw.
    pub pixels: Pixels<'a>,
    /// World position of the user's eye U, for which near geometry is morphed; `None` for the camera's position.
    pub user: Option<DVec3>,
    /// Growth of the morph in this frame.
    pub growth: Growth,
    /// Primitives to which the morph is applied.
    pub method: MorphMethod,
    /// True for the baked map; false for the ideal picture, whose far part is traced from the centre.
    pub mapped: bool,
    /// Tolerance of the morph in units of this view's finest pixel. With `Vertex`, triangles that exceed it are split
    /// for the frame; infinity splits none. With `Exact`, it limits the error of a bent ray.
    pub tolerance_px: f64,
    /// Placement of moving objects beyond the near part without a morph.
    pub conventional_dynamic: ConventionalDynamic,
}

impl Drawing<'_> {
    /// Returns the world position of the user's eye U for a camera's picture.
    pub fn user(&self, camera: &Camera) -> DVec3 {
        self.user.unwrap_or(camera.position)
    }
}

/// A scene partitioned at two radii about a centre, with its environment map.
#[derive(Debug)]
pub struct Reduced {
    static_scene: Scene,
    center: DVec3,
    radii: [f64; 2],
    /// Join of the near and the far part.
    pub join: Join,
    /// Environment map; `None` if nothing lies beyond the near part.
    pub map: Option<EnvironmentMap>,
    near: NearGeometry,
    folding: Folding,
}

/// Counts of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameCounts {
    /// Triangles traced in place of the whole scene, after splitting; 0 if the scene's own trees were used.
    pub triangles: u64,
    /// Moving triangles that rays were tested against; 0 without a pass for them.
    pub moving: u64,
    /// Number of vertices that user and centre see in opposite directions.
    pub opposed: u64,
    /// Whether the tolerance was an upper bound: no vertex was morphed, or the tolerance was finite and the camera is
    /// the user's eye, well inside r₁.
    pub bounded: bool,
    /// Metres that the user may still move before the picture folds.
    pub fold_margin: f64,
}

impl Reduced {
    /// Gathers the near geometry; `map` is `None` if nothing lies beyond r₂.
    pub fn new(partition: &Partition, join: Join, map: Option<EnvironmentMap>, progress: &Progress) -> Result<Self> {
        let scene = &partition.scene;
        let radii = [partition.r1, partition.r2];
        let near = match join {
            Join::Morph(_) => NearGeometry::gather(partition, progress)?,
            Join::Conventional { .. } => NearGeometry::default(),
        };
        let static_scene = Scene { moving: Arc::default(), ..scene.clone() };
        Ok(Self { static_scene, center: partition.center, radii, join, map, near, folding: Folding::default() })
    }

    /// Returns the size of the copies of near geometry, bytes.
    pub fn near_bytes(&self) -> usize {
        self.near.bytes()
    }

    /// Renders a view. `scene` is the reduced scene with its moving objects in any pose.
    pub fn render(
        &self,
        scene: &Scene,
        camera: &Camera,
        drawing: &Drawing<'_>,
        progress: &Progress,
    ) -> Result<(Frame, FrameCounts)> {
        self.check(scene, camera, drawing)?;
        let Drawing { channels, samples, limits, pixels, .. } = *drawing;
        let view = RenderView { camera, origin: scene.origin, channels, samples, limits, pixels };
        let center = self.center - scene.origin;
        let boundary = if let Join::Conventional { radius } = self.join { radius } else { self.radii[1] };
        let visible = VisibleVolume { limits: limits.relative_to(scene.origin), eye: camera.position - scene.origin };
        let backdrop = Backdrop { far: self.far(drawing.mapped, boundary, progress)?, center, morph: None, visible };
        let fold_margin = self.fold_margin(drawing.user(camera), drawing.growth)?;
        let traced = |moving: &Option<Moving>| {
            let moving = moving.as_ref().map_or(0, Moving::triangles);
            FrameCounts { triangles: 0, moving, opposed: 0, bounded: true, fold_margin }
        };
        let Some(kind) = self.morph_kind(camera, drawing) else {
            let picture = straight::Straight::new(scene, backdrop, boundary, drawing.conventional_dynamic, progress)?;
            return Ok((draw(&view, &picture, progress)?, traced(&picture.moving)));
        };
        let user = drawing.user(camera);
        let morph = self.morph(user - scene.origin, center, kind, drawing.growth)?;
        let backdrop = Backdrop { morph: Some(morph), ..backdrop };
        let tolerance = drawing.tolerance_px * self.pixel_angle(camera);
        if drawing.method == MorphMethod::Exact {
            let picture =
                exact::Exact::new(scene, camera, (morph, boundary), backdrop, drawing.tolerance_px, progress)?;
            return Ok((draw(&view, &picture, progress)?, traced(&picture.moving)));
        }
        let near = self.near.morphed(scene, &morph, tolerance.is_finite().then_some(tolerance), progress)?;
        let counts = FrameCounts {
            triangles: near.triangle_count(),
            moving: near.moving_triangles(),
            opposed: near.opposed,
            bounded: near.bounded && user == camera.position,
            fold_margin,
        };
        Ok((draw(&view, &bent::Bent { scene, near, backdrop, radius: boundary }, progress)?, counts))
    }

    /// Returns the kind of the morph; `None` without one and if user and camera are at the centre: nothing moves then.
    pub fn morph_kind(&self, camera: &Camera, drawing: &Drawing<'_>) -> Option<Kind> {
        let at_center = [camera.position, drawing.user(camera)] == [self.center; 2];
        self.join.kind().filter(|_| !at_center)
    }

    /// Returns the morph for a user and a centre in the same frame of coordinates.
    pub fn morph(&self, user: DVec3, center: DVec3, kind: Kind, growth: Growth) -> Result<Morph> {
        let [r1, r2] = self.radii;
        let reduced_radius = growth.radius.filter(|&radius| radius < r2);
        let [near, far] = reduced_radius.map_or(self.radii, |radius| [r1 * (radius / r2), radius]);
        Morph::new(user, center, near, far, kind)?.with_strength(growth.strength)
    }

    /// Returns the metres that a user at a world position may still move before the picture folds; infinite without a
    /// morph. The user's height is rounded to a thousandth of r₂.
    pub fn fold_margin(&self, user: DVec3, growth: Growth) -> Result<f64> {
        self.check_growth(growth)?;
        match self.join.kind() {
            Some(kind) => self.folding.margin(&self.morph(user, self.center, kind, growth)?),
            None => Ok(f64::INFINITY),
        }
    }

    /// Returns the far part; `Far::Nothing` if nothing was baked.
    fn far(&self, mapped: bool, radius: f64, progress: &Progress) -> Result<Far<'_>> {
        match &self.map {
            None => Ok(Far::Nothing),
            Some(map) if mapped => Ok(Far::Map(map)),
            Some(_) => {
                self.static_scene.build_to_shade(progress)?;
                Ok(Far::Traced(&self.static_scene, radius))
            }
        }
    }

    /// Fails for invalid requests, such as another scene, parallel rays with a map, or channels that were not baked.
    pub fn check(&self, scene: &Scene, camera: &Camera, drawing: &Drawing<'_>) -> Result<()> {
        let is_own = Arc::ptr_eq(&scene.standing, &self.static_scene.standing);
        ensure!(is_own, "at", "poses of the scene that was reduced", "another scene");
        check_position("position", camera.position - scene.origin)?;
        let user = drawing.user(camera);
        check_position("user", user - scene.origin)?;
        if drawing.mapped {
            self.check_channels(drawing.channels)?;
        }
        self.check_growth(drawing.growth)?;
        let (is_morphed, tolerance, placement) =
            (self.join.kind().is_some(), drawing.tolerance_px, drawing.conventional_dynamic);
        let expected = "'center' with a morph, which shows what moves beyond the near part as the centre sees it";
        let is_valid = !is_morphed || placement == ConventionalDynamic::Center;
        ensure!(is_valid, "conventional_dynamic", expected, placement.name());
        let bends = drawing.method == MorphMethod::Exact && is_morphed;
        let expected = "the camera's own position with method='exact', because bent rays start at the eye that they are \
                        bent for; method='vertex' takes any";
        ensure!(!bends || user == camera.position, "user", expected, user);
        check_limits(drawing, bends)?;
        let expected = "a perspective view or a cube face, because a map and bent rays show what one eye sees";
        let is_one_eye = !camera.is_parallel() || (self.map.is_none() && !bends);
        ensure!(is_one_eye, "camera", expected, "parallel rays");
        ensure!(tolerance > 0.0, "tolerance_px", "a number above 0", tolerance);
        let is_finite = !bends || tolerance.is_finite();
        ensure!(is_finite, "tolerance_px", "a finite number of pixels for bent rays", "infinity");
        Ok(())
    }

    fn check_growth(&self, Growth { radius, strength }: Growth) -> Result<()> {
        let (is_morphed, r2) = (self.join.kind().is_some(), self.radii[1]);
        ensure!(is_morphed || strength == 1.0, "strength", "1 without a morph", strength);
        let Some(radius) = radius else { return Ok(()) };
        ensure!(is_morphed, "radius", "None without a morph", radius);
        ensure!((0.0..=r2).contains(&radius), "radius", format!("0 to r2 = {r2} metres"), radius);
        Ok(())
    }

    /// Returns the angle of the finest pixel, radians; for parallel rays as seen from the distance r₂.
    pub fn pixel_angle(&self, camera: &Camera) -> f64 {
        camera.least_pixel_angle() / if camera.is_parallel() { self.radii[1] } else { 1.0 }
    }

    /// Checks that the map has the channels that far pixels need; positions need the range.
    fn check_channels(&self, channels: Channels) -> Result<()> {
        let Some(map) = &self.map else { return Ok(()) };
        let (has_range, has_objects) = (map.range.is_some(), map.object_id.is_some());
        for (is_requested, needed, is_baked, reason) in [
            (channels.range, "range", has_range, ""),
            (channels.position, "range", has_range, ", from which far pixels get their position"),
            (channels.object_id, "object_id", has_objects, ""),
        ] {
            let expected =
                format!("an environment map with {needed}{reason}: reduce with channels=(\"color\", \"{needed}\")");
            ensure!(!is_requested || is_baked, "channels", expected, "a map without it");
        }
        Ok(())
    }
}

/// Fails for limits if rays are bent or the far part is traced.
fn check_limits(drawing: &Drawing<'_>, bends: bool) -> Result<()> {
    let Segment { t_min, t_max } = drawing.limits.segment;
    let method = match (bends, drawing.mapped) {
        (true, _) => "method='exact'; method='vertex' takes any",
        (_, false) => "env=False; env=True takes any",
        _ => return Ok(()),
    };
    ensure!(t_min <= 0.0, "t_min", format!("0 with {method}"), t_min);
    ensure!(t_max == f32::INFINITY, "t_max", format!("infinity with {method}"), t_max);
    ensure!(drawing.limits.planes().is_empty(), "clip", format!("None with {method}"), "planes");
    Ok(())
}
