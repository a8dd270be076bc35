//! Layers of a reduced frame: objects beyond the near part, then the near part, which covers them.

use std::sync::Arc;

use glam::DVec3;
use nearfar_core::base::Result;
use nearfar_core::cubemap::EnvironmentMap;
use nearfar_core::morph::Kind;
use nearfar_core::render::Limits;
use nearfar_core::render::reduced::ConventionalDynamic;
use nearfar_core::scene::Scene;

use super::near::{Geometry, Moving};
use crate::device::Device;
use crate::draw::{Backdrop, Layer, Picture, Set};
use crate::render::near_far::{NearFar, Shown, Zone};
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
    /// Near triangles that no morph moves, if there are any, and triangles that it bends.
    pub fixed: Option<&'a Geometry>,
    pub bending: &'a Geometry,
    /// Moving objects.
    pub moving: &'a Moving,
    pub map: Option<&'a EnvironmentMap>,
    /// Device texels of the map, if the far part is taken from it.
    pub texels: Option<Arc<EnvTexels>>,
    /// Whether the far part is taken from the map, or else drawn from the centre.
    pub mapped: bool,
    /// Visible volume, in world coordinates.
    pub limits: Limits,
    /// Whether samples without a triangle are black.
    pub bare: bool,
    /// Placement of moving objects beyond the near part without a morph.
    pub conventional_dynamic: ConventionalDynamic,
}

impl View<'_> {
    /// Returns the frame's layers in front of the map.
    pub fn picture(&self, device: &Device) -> Result<Picture> {
        let near = self.kind.map_or(Shown::AsItIs, Shown::from);
        let beyond = if self.kind == Some(Kind::Cylinder) { Shown::FromCenterOnCylinder } else { Shown::FromCenter };
        let mut layers = Vec::new();
        let covered_far = !self.mapped && self.map.is_some();
        if covered_far {
            let standing = Scene { moving: Arc::default(), ..self.scene.clone() };
            layers.push(self.layer(device, &standing, Set::Static, beyond, Zone::Beyond)?);
        }
        let split = self.moving.split.iter().map(|split| (split, Set::Static));
        let movers = split.chain([(&self.moving.placed, Set::Moving)]);
        let movers: Vec<_> = movers.filter(|(geometry, _)| geometry.scene.triangle_count() > 0).collect();
        let from_user = self.conventional_dynamic == ConventionalDynamic::User;
        let has_range = !from_user && self.texels.as_ref().is_some_and(|texels| texels.has_range);
        let zone = if has_range { Zone::BeyondAndUnhidden } else { Zone::Beyond };
        // Morphed vertices on both sides of r₂, so that no gap opens where triangles cross it. Without a map, static
        // objects are drawn at their distance from the centre, so moving ones are too. Away from the user's eye they
        // have parallax, which static objects beyond r₂ have not.
        let is_apart = self.near_far.apart != DVec3::ZERO;
        let moved = match self.kind {
            None if from_user => near,
            None => beyond,
            Some(_) if !covered_far => near,
            Some(Kind::Blend) if is_apart => near,
            Some(Kind::Cylinder) if is_apart => Shown::CylinderFromCenter,
            Some(_) => beyond,
        };
        if self.conventional_dynamic != ConventionalDynamic::Omit {
            let first = layers.len();
            for (geometry, set) in &movers {
                layers.push(self.near_layer(device, geometry, *set, moved, zone)?);
            }
            if let Some(layer) = layers.get_mut(first) {
                layer.covers = from_user && first > 0;
            }
        }
        // The first layer of the near part covers everything beyond it.
        let first = layers.len();
        if let Some(fixed) = self.fixed {
            layers.push(self.near_layer(device, fixed, Set::Static, Shown::AsItIs, Zone::Whole)?);
        }
        layers.push(self.near_layer(device, self.bending, Set::Static, near, Zone::Within)?);
        layers[first].covers = first > 0;
        for (geometry, set) in &movers {
            layers.push(self.near_layer(device, geometry, *set, near, Zone::Within)?);
        }
        let backdrop = |texels: &Arc<EnvTexels>| Backdrop {
            texels: Arc::clone(texels),
            objects: self.map.and_then(|map| map.object_id.clone()),
            center: self.center,
        };
        let missed = if beyond == Shown::FromCenterOnCylinder { beyond } else { Shown::AsItIs };
        Ok(Picture {
            parameters: self.near_far.parameters(),
            backdrop: self.texels.as_ref().map(backdrop),
            backdrop_style: missed.style(),
            limits: (!self.limits.is_none()).then(|| self.limits.relative_to(self.scene.origin)),
            bare: self.bare,
            ..Picture::plain(layers, self.scene.origin)
        })
    }

    fn layer(&self, device: &Device, scene: &Scene, set: Set, shown: Shown, zone: Zone) -> Result<Layer> {
        let tables = device.state::<Residents>().scene(device, scene)?;
        Ok(Layer {
            style: shown.style(),
            cut: zone.cut(),
            displacement: shown.displacement(&self.near_far),
            ..Layer::plain(scene.clone(), tables, set)
        })
    }

    fn near_layer(&self, device: &Device, geometry: &Geometry, set: Set, shown: Shown, zone: Zone) -> Result<Layer> {
        let layer = self.layer(device, &geometry.scene, set, shown, zone)?;
        Ok(Layer { sources: Some(Arc::clone(&geometry.sources)), ..layer })
    }
}
