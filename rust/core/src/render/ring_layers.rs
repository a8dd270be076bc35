//! Static objects of a scene in layers: everything beyond all rings, then each ring from the last to the first.

use std::collections::HashMap;
use std::ops::RangeInclusive;
use std::sync::Arc;

use crate::base::{Progress, Result, by_object};
use crate::scene::{Instance, Scene};
use crate::trace::{AlphaFilter, FaceHits, HitFilter, Layer, LayerTree};

/// Trees over each layer's instances. An instance with faces of several layers is in the tree of each; a filter then
/// tests its faces per ray.
pub(super) struct RingLayers<'a> {
    scene: &'a Scene,
    rings: &'a [u16],
    /// Whether each instance has faces of several layers.
    mixed: Vec<bool>,
    trees: Vec<(LayerTree, RangeInclusive<u16>)>,
}

impl<'a> RingLayers<'a> {
    /// Creates the layers of rings up to `count` and of everything beyond, for a scene that has been built. `rings`
    /// has the ring of each object, and last that of faces without one; ring 0 is in no layer.
    pub(super) fn new(scene: &'a Scene, rings: &'a [u16], count: u16, progress: &Progress) -> Result<Self> {
        let instances = scene.standing.instances();
        // Meshes with many faces may be placed many times.
        let mut of_meshes = HashMap::new();
        let classes: Vec<Arc<[u16]>> = instances
            .iter()
            .map(|instance| {
                let mesh = instance.object.is_none().then_some(Arc::as_ptr(&instance.mesh));
                Arc::clone(
                    of_meshes.entry((mesh, instance.object)).or_insert_with(|| layers_of(instance, rings, count)),
                )
            })
            .collect();
        let beyond = count.saturating_add(1);
        let tree = |number: u16| {
            let tree = LayerTree::new(scene, |instance| classes[instance].contains(&number), progress)?;
            let numbers = number..=if number == beyond { u16::MAX } else { number };
            Ok((tree, numbers))
        };
        let trees = (1..=beyond).rev().map(tree).collect::<Result<_>>()?;
        Ok(Self { scene, rings, mixed: classes.iter().map(|layers| layers.len() > 1).collect(), trees })
    }

    /// Returns the layers, the one beyond all rings first.
    pub(super) fn layers(&'a self) -> Vec<Layer<'a>> {
        let Self { scene, rings, mixed, trees } = self;
        let layer = |(tree, numbers): &'a (LayerTree, RangeInclusive<u16>)| {
            let of_rings = OfRings { scene, rings, mixed, numbers: numbers.clone() };
            Layer { tree, filter: Box::new(AlphaFilter::new(scene, of_rings)) }
        };
        trees.iter().map(layer).collect()
    }
}

/// Returns the layers that an instance has faces of, ascending; 0 stands for faces that are in none.
fn layers_of(instance: &Instance, rings: &[u16], count: u16) -> Arc<[u16]> {
    let layer = |object: i32| by_object(rings, object).min(count.saturating_add(1));
    let mut layers: Vec<u16> = match instance.object {
        Some(object) => vec![layer(object)],
        None => instance.mesh.objects.runs(instance.mesh.faces.len()).map(|(_, object)| layer(object)).collect(),
    };
    layers.sort_unstable();
    layers.dedup();
    layers.into()
}

/// Filter for faces of some rings; instances are those of a layer's tree.
struct OfRings<'a> {
    scene: &'a Scene,
    rings: &'a [u16],
    mixed: &'a [bool],
    numbers: RangeInclusive<u16>,
}

impl HitFilter for OfRings<'_> {
    fn face_hits(&self, instance: u32, face: u32) -> FaceHits {
        let is_mixed = self.mixed[instance as usize];
        let holds = || self.numbers.contains(&by_object(self.rings, self.scene.instance(instance).object_of(face)));
        if !is_mixed || holds() { FaceHits::All } else { FaceHits::None }
    }
}
