//! Static objects of a scene in layers: everything beyond all rings, then each ring from the last to the first.

use std::collections::HashMap;
use std::ops::RangeInclusive;
use std::sync::Arc;

use crate::base::{Progress, Result, by_object};
use crate::scene::{Instance, Scene};
use crate::trace::{AlphaFilter, FaceHits, HitFilter, Layer, LayerTree};

/// Trees over each layer's instances. An instance with faces of several layers is in the tree of each of them, and a
/// filter tests its faces.
pub(super) struct RingLayers<'a> {
    scene: &'a Scene,
    rings: &'a [u16],
    /// Whether each instance has faces of several layers.
    is_mixed: Vec<bool>,
    trees: Vec<(LayerTree, RangeInclusive<u16>)>,
}

impl<'a> RingLayers<'a> {
    /// Creates the layers of rings up to `count` and of everything beyond, for a scene that has been built. `rings` has
    /// the ring of each object, and as last entry the ring of faces without an object. Ring 0 is in no layer.
    pub(super) fn new(scene: &'a Scene, rings: &'a [u16], count: u16, progress: &Progress) -> Result<Self> {
        let instances = scene.standing.instances();
        // Cached, because a mesh with many faces may be placed many times.
        let mut known_layers: HashMap<_, Arc<[u16]>> = HashMap::new();
        let instance_layers = instances.iter().map(|instance| {
            let mesh = instance.object.is_none().then_some(Arc::as_ptr(&instance.mesh));
            let layers = known_layers.entry((mesh, instance.object));
            Arc::clone(layers.or_insert_with(|| layers_of(instance, rings, count)))
        });
        let instance_layers: Vec<Arc<[u16]>> = instance_layers.collect();
        let last_layer = count.saturating_add(1);
        let tree = |number: u16| {
            let tree = LayerTree::new(scene, |instance| instance_layers[instance].contains(&number), progress)?;
            let ring_range = number..=if number == last_layer { u16::MAX } else { number };
            Ok((tree, ring_range))
        };
        let trees = (1..=last_layer).rev().map(tree).collect::<Result<_>>()?;
        Ok(Self { scene, rings, is_mixed: instance_layers.iter().map(|layers| layers.len() > 1).collect(), trees })
    }

    /// Returns the layers, the one beyond all rings first.
    pub(super) fn layers(&'a self) -> Vec<Layer<'a>> {
        let Self { scene, rings, is_mixed, trees } = self;
        let layer = |(tree, ring_range): &'a (LayerTree, RangeInclusive<u16>)| {
            let ring_filter = RingFilter { scene, rings, is_mixed, ring_range: ring_range.clone() };
            Layer { tree, filter: Box::new(AlphaFilter::new(scene, ring_filter)) }
        };
        trees.iter().map(layer).collect()
    }
}

/// Returns the layers of an instance's faces, ascending; 0 stands for faces in no layer.
fn layers_of(instance: &Instance, rings: &[u16], count: u16) -> Arc<[u16]> {
    let layer = |object: i32| *by_object(rings, object).min(&count.saturating_add(1));
    let mut layers: Vec<u16> = match instance.object {
        Some(object) => vec![layer(object)],
        None => instance.mesh.objects.runs(instance.mesh.faces.len()).map(|(_, object)| layer(object)).collect(),
    };
    layers.sort_unstable();
    layers.dedup();
    layers.into()
}

/// Filter for faces of some rings, on instances of a layer's tree.
struct RingFilter<'a> {
    scene: &'a Scene,
    rings: &'a [u16],
    is_mixed: &'a [bool],
    ring_range: RangeInclusive<u16>,
}

impl HitFilter for RingFilter<'_> {
    fn face_hits(&self, instance: u32, face: u32) -> FaceHits {
        let is_mixed = self.is_mixed[instance as usize];
        let ring = || by_object(self.rings, self.scene.instance(instance).object_of(face));
        if !is_mixed || self.ring_range.contains(ring()) { FaceHits::All } else { FaceHits::None }
    }
}
