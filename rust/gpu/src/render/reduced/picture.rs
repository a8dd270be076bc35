//! Layers of a reduced frame: what lies beyond the near part, then the near part, which covers it.

use std::sync::Arc;

use nearfar_core::base::Result;
use nearfar_core::morph::Kind as MorphKind;
use nearfar_core::render::reduced::Join;
use nearfar_core::scene::Scene;

use super::Reduced;
use super::near::{Geometry, Moving};
use crate::device::Device;
use crate::draw::{Kind, Layer, Names, Picture, Set, Sources, Split};
use crate::upload::EnvTexels;

impl Reduced {
    /// A frame's layers. `kind` is how points are morphed, where they are; without `mapped`, the far part is drawn from
    /// the centre instead of taken from the map.
    pub(super) fn picture(
        &self,
        device: &Device,
        scene: &Scene,
        (kind, bending, moving): (Option<MorphKind>, &Geometry, &Moving),
        texels: Option<Arc<EnvTexels>>,
        mapped: bool,
    ) -> Result<Picture> {
        let near = match kind {
            None => Kind::AsItIs,
            Some(MorphKind::Blend) => Kind::Blend,
            Some(MorphKind::Cylinder) => Kind::Cylinder,
        };
        let beyond = if kind == Some(MorphKind::Cylinder) { Kind::FromCenterOnCylinder } else { Kind::FromCenter };
        let radius = match self.join {
            Join::Conventional { radius } => radius,
            Join::Morph(_) => self.radii[1],
        };
        let layer = |scene: &Scene, set, kind, split, sources: Option<&Arc<Sources>>| {
            Ok(Layer {
                scene: scene.clone(),
                tables: device.residents.scene(device, scene)?,
                set,
                kind,
                split,
                hidden: false,
                covers: false,
                names: sources.map_or(Names::Own, |sources| Names::Of(Arc::clone(sources))),
            })
        };
        let mut layers = Vec::new();
        let covered_far = !mapped && self.map.is_some();
        if covered_far {
            let standing = Scene { moving: Arc::default(), ..scene.clone() };
            layers.push(layer(&standing, Set::Standing, beyond, Split::Beyond, None)?);
        }
        let movers = moving.split.iter().map(|split| (split, Set::Standing)).chain([(&moving.placed, Set::Moving)]);
        let movers: Vec<_> = movers.filter(|(geometry, _)| geometry.scene.triangle_count() > 0).collect();
        let hidden = texels.as_ref().is_some_and(|texels| texels.has_range);
        // Morphed vertices on both sides of r₂, so that nothing gapes where triangles cross it. Without a map, what stands is
        // drawn as far away as it is from the centre, so what moves is too.
        let moved = if kind.is_none() || covered_far { beyond } else { near };
        for (geometry, set) in &movers {
            let one = layer(&geometry.scene, *set, moved, Split::Beyond, Some(&geometry.sources))?;
            layers.push(Layer { hidden, ..one });
        }
        let covered = !layers.is_empty();
        let fixed = &self.near.fixed;
        let first = layer(&fixed.scene, Set::Standing, Kind::AsItIs, Split::Whole, Some(&fixed.sources))?;
        layers.push(Layer { covers: covered, ..first });
        layers.push(layer(&bending.scene, Set::Standing, near, Split::Within, Some(&bending.sources))?);
        for (geometry, set) in &movers {
            layers.push(layer(&geometry.scene, *set, near, Split::Within, Some(&geometry.sources))?);
        }
        let [r1, r2] = self.radii;
        Ok(Picture {
            layers,
            far_objects: self.map.as_ref().filter(|_| mapped).and_then(|map| map.object_id.clone()),
            map: texels,
            center: self.center,
            radii: [r1, r2, radius],
            origin: scene.origin,
            two_texels: 0.0,
            missed: if beyond == Kind::FromCenterOnCylinder { beyond } else { Kind::AsItIs },
            multisampled: true,
        })
    }
}
