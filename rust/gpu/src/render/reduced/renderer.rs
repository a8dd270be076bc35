//! Rendering of reduced scenes in layers: objects beyond r₂, then NSF, which covers them.

use std::sync::{Arc, Mutex, Weak};

use glam::DVec3;
use nearfar_core::base::{Error, Progress, Result};
use nearfar_core::camera::Camera;
use nearfar_core::cubemap::EnvironmentMap;
use nearfar_core::morph::{Kind, Morph};
use nearfar_core::partition::Partition;
use nearfar_core::render::reduced::{self, ConventionalDynamic, Drawing, FrameCounts, Join, MorphMethod};
use nearfar_core::scene::{Instance, Scene};
use nearfar_core::tessellate::bent_from;

use super::nsf::{Geometry, Moving, Nsf, StaticParts};
use crate::device::{Device, lock};
use crate::draw::{Backdrop, Job, Layer, Mask, Picture, Set};
use crate::render::near_far::{NearFar, Placement, ZoneCut};
use crate::upload::{EnvTexels, Residents};

/// NSF of a reduced scene in device form, and its map on the last device.
pub struct Reduced {
    nsf: Nsf,
    join: Join,
    center: DVec3,
    radii: [f64; 2],
    map: Option<EnvironmentMap>,
    /// The map on the last device that drew it.
    texels: Mutex<Option<(Weak<Device>, Arc<EnvTexels>)>>,
}

impl Reduced {
    /// Gathers the NSF of a reduced scene; uploads happen when it is drawn.
    pub fn new(partition: &Partition, reduced: &reduced::Reduced, progress: &Progress) -> Result<Self> {
        let radii = [partition.r1, partition.r2];
        let inside = match reduced.join {
            Join::Morph(_) => radii[0],
            Join::Conventional { radius } => radius,
        };
        Ok(Self {
            nsf: Nsf::gather(partition, inside, progress)?,
            join: reduced.join,
            center: partition.center - partition.scene.origin,
            radii,
            map: reduced.map.clone(),
            texels: Mutex::default(),
        })
    }

    /// Begins a frame; also returns the counts of drawn triangles. `scene` is the reduced scene with its moving objects
    /// in any pose; `reduced` checks the drawing.
    pub fn begin(
        &self,
        device: &Arc<Device>,
        (reduced, scene): (&reduced::Reduced, &Scene),
        camera: &Camera,
        drawing: &Drawing<'_>,
        progress: &Progress,
    ) -> Result<(Job, FrameCounts)> {
        reduced.check(scene, camera, drawing)?;
        if drawing.method == MorphMethod::Exact && matches!(self.join, Join::Morph(_)) {
            let expected = "'vertex' on a graphics adapter: rays are bent by the tracer, backend='cpu'";
            return Err(Error::value("method", expected, "'exact'"));
        }
        let kind = reduced.morph_kind(camera, drawing);
        // Without a morph only the camera's position matters.
        let eye = if kind.is_some() { drawing.user(camera) } else { camera.position };
        let (user, camera_offset) = (eye - scene.origin, camera.position - eye);
        let tolerance = drawing.tolerance_px * reduced.pixel_angle(camera);
        let morph = kind.map(|kind| reduced.morph(user, self.center, kind, drawing.growth)).transpose()?;
        let radii = morph.map_or(self.radii, |morph| [morph.r1, morph.r2]);
        let parts = match &morph {
            Some(morph) if tolerance.is_finite() => self.nsf.split(morph, tolerance, progress)?,
            _ => self.nsf.unsplit(morph.as_ref().map_or(radii[0], bent_from), progress)?,
        };
        let moving = self.nsf.moving(scene, parts.moving_rule.as_ref(), progress)?;
        let texels = match &self.map {
            Some(map) if drawing.mapped => Some(self.texels(device, map)?),
            _ => None,
        };
        let count = |geometry: &Geometry, other: &Option<Geometry>| {
            geometry.triangle_count() + other.as_ref().map_or(0, Geometry::triangle_count)
        };
        let moving_triangles = count(&moving.placed, &moving.split);
        let counts = FrameCounts {
            triangles: count(&parts.bent, &parts.fixed) + moving_triangles,
            moving: moving_triangles,
            opposed: morph.map_or(0, |morph| count_opposed(scene, &morph, &parts.bent.scene)),
            bounded: kind.is_none()
                || camera_offset == DVec3::ZERO && parts.moving_rule.as_ref().is_some_and(|rule| rule.holds()),
            fold_margin: reduced.fold_margin(drawing.user(camera), drawing.growth)?,
        };
        let cut_radius = match self.join {
            Join::Conventional { radius } => radius,
            Join::Morph(_) => self.radii[1],
        };
        let (offset, strength) = (user - self.center, morph.map_or(1.0, |morph| morph.strength));
        let view = View {
            scene,
            center: self.center,
            near_far: NearFar { offset, camera_offset, radii, strength, cut_radius, two_texels: 0.0 },
            kind,
            parts: &parts,
            moving: &moving,
            map: self.map.as_ref(),
            texels,
            drawing,
        };
        let picture = Picture { mask: Mask::from_pixels(&drawing.pixels, camera)?, ..view.picture(device)? };
        let job =
            Job::begin(device, picture, std::slice::from_ref(camera), drawing.channels, drawing.samples, progress)?;
        Ok((job, counts))
    }

    fn texels(&self, device: &Arc<Device>, map: &EnvironmentMap) -> Result<Arc<EnvTexels>> {
        match &*lock(&self.texels) {
            Some((owner, texels)) if std::ptr::eq(owner.as_ptr(), Arc::as_ptr(device)) => {
                return Ok(Arc::clone(texels));
            }
            _ => {}
        }
        let texels = Arc::new(EnvTexels::new(device, Some(map))?);
        *lock(&self.texels) = Some((Arc::downgrade(device), Arc::clone(&texels)));
        Ok(texels)
    }
}

/// Counts the vertices that user and centre see in opposite directions. There are none while the user is in the near
/// cylinder, unless the strength is ½.
fn count_opposed(scene: &Scene, morph: &Morph, bending: &Scene) -> u64 {
    let offset = morph.user - morph.center;
    if offset.x.hypot(offset.z) < morph.r1 && morph.strength != 0.5 {
        return 0;
    }
    let opposed = |instance: &Instance| -> u64 {
        let corners = (0..instance.mesh.faces.len() as u32).flat_map(|face| instance.corners(face));
        corners.map(|corner| u64::from(morph.examine(corner.as_dvec3()).opposed)).sum()
    };
    bending.instances().chain(scene.moving.instances()).map(opposed).sum()
}

/// A reduced scene as seen by a user.
pub(super) struct View<'a> {
    /// The reduced scene, with its moving objects in a pose.
    pub scene: &'a Scene,
    /// Centre relative to the scene's origin.
    pub center: DVec3,
    pub near_far: NearFar,
    /// Kind of the morph; `None` without one.
    pub kind: Option<Kind>,
    pub parts: &'a StaticParts,
    pub moving: &'a Moving,
    pub map: Option<&'a EnvironmentMap>,
    /// Device texels of the map, if it shows the far part; otherwise the far part is drawn from the centre.
    pub texels: Option<Arc<EnvTexels>>,
    pub drawing: &'a Drawing<'a>,
}

impl View<'_> {
    /// Returns the frame's layers in front of the map.
    pub fn picture(&self, device: &Device) -> Result<Picture> {
        let near_placement = self.kind.map_or(Placement::Undisplaced, Placement::from);
        let far_placement =
            if self.kind == Some(Kind::Cylinder) { Placement::FromCenterOnCylinder } else { Placement::FromCenter };
        let mut layers = Vec::new();
        let draws_far_part = !self.drawing.mapped && self.map.is_some();
        if draws_far_part {
            let static_scene = Scene { moving: Arc::default(), ..self.scene.clone() };
            layers.push(self.layer(device, &static_scene, Set::Static, far_placement, ZoneCut::Outside)?);
        }
        let split = self.moving.split.iter().map(|split| (split, Set::Static));
        let movers = split.chain([(&self.moving.placed, Set::Moving)]);
        let movers: Vec<_> = movers.filter(|(geometry, _)| geometry.triangle_count() > 0).collect();
        let conventional_dynamic = self.drawing.conventional_dynamic;
        let from_user = conventional_dynamic == ConventionalDynamic::User;
        let has_range = !from_user && self.texels.as_ref().is_some_and(|texels| texels.has_range);
        let zone = if has_range { ZoneCut::OutsideUnhidden } else { ZoneCut::Outside };
        // In front of a map, moving objects are morphed on both sides of r₂, so that no gap opens where triangles cross
        // it. Without a map, static objects beyond r₂ are drawn at their distance from the centre, so moving ones are,
        // too. A camera beside the user sees parallax of moving objects, but none of static objects beyond r₂.
        let is_beside_user = self.near_far.camera_offset != DVec3::ZERO;
        let mover_placement = match self.kind {
            None if from_user => near_placement,
            None => far_placement,
            Some(_) if !draws_far_part => near_placement,
            Some(Kind::Blend) if is_beside_user => near_placement,
            Some(Kind::Cylinder) if is_beside_user => Placement::CylinderFromCenter,
            Some(_) => far_placement,
        };
        if conventional_dynamic != ConventionalDynamic::Omit {
            let first = layers.len();
            for (geometry, set) in &movers {
                layers.push(self.near_layer(device, geometry, *set, mover_placement, zone)?);
            }
            if let Some(layer) = layers.get_mut(first) {
                layer.covers = from_user && first > 0;
            }
        }
        // The first layer inside r₂ covers everything beyond it.
        let first = layers.len();
        if let Some(fixed) = &self.parts.fixed {
            layers.push(self.near_layer(device, fixed, Set::Static, Placement::Undisplaced, ZoneCut::None)?);
        }
        layers.push(self.near_layer(device, &self.parts.bent, Set::Static, near_placement, ZoneCut::Inside)?);
        layers[first].covers = first > 0;
        for (geometry, set) in &movers {
            layers.push(self.near_layer(device, geometry, *set, near_placement, ZoneCut::Inside)?);
        }
        let backdrop = |texels: &Arc<EnvTexels>| Backdrop {
            texels: Arc::clone(texels),
            objects: self.map.and_then(|map| map.object_id.clone()),
            center: self.center,
        };
        let backdrop_placement =
            if far_placement == Placement::FromCenterOnCylinder { far_placement } else { Placement::Undisplaced };
        let limits = self.drawing.limits;
        Ok(Picture {
            parameters: self.near_far.parameters(),
            backdrop: self.texels.as_ref().map(backdrop),
            backdrop_style: backdrop_placement.style(),
            limits: (!limits.is_none()).then(|| limits.relative_to(self.scene.origin)),
            bare: self.drawing.pixels.bare,
            ..Picture::plain(layers, self.scene.origin)
        })
    }

    fn layer(&self, device: &Device, scene: &Scene, set: Set, placement: Placement, zone: ZoneCut) -> Result<Layer> {
        let tables = device.state::<Residents>().scene(device, scene)?;
        Ok(Layer {
            style: placement.style(),
            cut: zone.cut(),
            displacement: placement.displacement(&self.near_far),
            ..Layer::plain(scene.clone(), tables, set)
        })
    }

    fn near_layer(
        &self,
        device: &Device,
        geometry: &Geometry,
        set: Set,
        placement: Placement,
        zone: ZoneCut,
    ) -> Result<Layer> {
        let layer = self.layer(device, &geometry.scene, set, placement, zone)?;
        Ok(Layer { sources: Some(Arc::clone(&geometry.sources)), ..layer })
    }
}
