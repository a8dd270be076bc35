//! Layers of a reduced frame: objects beyond the near part, then the near part, which covers them.

use std::sync::Arc;

use glam::DVec3;
use nearfar_core::base::Result;
use nearfar_core::cubemap::EnvironmentMap;
use nearfar_core::morph::Kind;
use nearfar_core::render::reduced::{ConventionalDynamic, Drawing};
use nearfar_core::scene::Scene;

use super::near::{Bent, Geometry, Moving};
use crate::device::Device;
use crate::draw::{Backdrop, Layer, Picture, Set};
use crate::render::near_far::{NearFar, Placement, ZoneCut};
use crate::upload::{EnvTexels, Residents};

/// A reduced scene as seen by a user.
pub(super) struct View<'a> {
    /// The reduced scene, with its moving objects in a pose.
    pub scene: &'a Scene,
    /// Centre relative to the scene's origin.
    pub center: DVec3,
    pub near_far: NearFar,
    /// Kind of the morph; `None` without one.
    pub kind: Option<Kind>,
    pub bent: &'a Bent,
    pub moving: &'a Moving,
    pub map: Option<&'a EnvironmentMap>,
    /// Device texels of the map, if the far part is taken from it; otherwise it is drawn from the centre.
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
        // Morphed vertices on both sides of r₂, so that no gap opens where triangles cross it. Without a map, static
        // objects are drawn at their distance from the centre, so moving ones are too. Away from the user's eye they
        // have parallax, which static objects beyond r₂ have not.
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
        // The first layer of the near part covers everything beyond it.
        let first = layers.len();
        if let Some(fixed) = &self.bent.fixed {
            layers.push(self.near_layer(device, fixed, Set::Static, Placement::Undisplaced, ZoneCut::None)?);
        }
        layers.push(self.near_layer(device, &self.bent.geometry, Set::Static, near_placement, ZoneCut::Inside)?);
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
