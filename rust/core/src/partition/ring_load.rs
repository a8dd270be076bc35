//! Triangle counts per ring of objects.

use std::collections::HashMap;
use std::ptr;

use rayon::prelude::*;

use crate::base::{Progress, Result, by_object, ensure};
use crate::scene::{Instance, Mesh, Scene};

/// Triangle counts of one ring.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RingLoad {
    /// Drawn triangles, counted once per instance.
    pub drawn: i64,
    /// Triangles not stored by an earlier ring; a shared mesh counts once.
    pub stored: i64,
    /// Instances that place a shared mesh.
    pub placed: i64,
}

/// Counts the static triangles of each of `count` rings. `rings` has the ring of each object, and as last entry the
/// ring of faces without an object.
pub fn ring_loads(scene: &Scene, rings: &[u16], count: usize, progress: &Progress) -> Result<Vec<RingLoad>> {
    ensure!(!rings.is_empty(), "rings", "a ring for faces without an object", "none");
    for &ring in rings {
        ensure!(usize::from(ring) < count, "rings", format!("ring numbers below {count}"), ring);
    }
    let ring_of = |object: i32| usize::from(*by_object(rings, object));
    let parts_of = |instance: &Instance| match instance.object {
        Some(object) => Ok(vec![(ring_of(object), instance.mesh.faces.len() as i64)]),
        None => parts_by_ring(&instance.mesh, ring_of, count, progress),
    };
    let instances = scene.standing.instances();
    let parts: Vec<Vec<(usize, i64)>> = instances.par_iter().map(parts_of).collect::<Result<_>>()?;
    let mut uses_and_ring: HashMap<*const Mesh, (usize, usize)> = HashMap::new();
    for (instance, parts) in instances.iter().zip(&parts) {
        let first = parts.first().map_or(count, |part| part.0);
        let entry = uses_and_ring.entry(ptr::from_ref(&*instance.mesh)).or_insert((0, count));
        *entry = (entry.0 + 1, entry.1.min(first));
    }
    let mut loads = vec![RingLoad::default(); count];
    for (instance, parts) in instances.iter().zip(&parts) {
        parts.iter().for_each(|&(ring, faces)| loads[ring].drawn += faces);
        let Some((uses, first)) = uses_and_ring.get_mut(&ptr::from_ref(&*instance.mesh)) else { continue };
        if *uses > 1
            && let Some(&(ring, _)) = parts.first()
        {
            loads[ring].placed += 1;
        }
        // The first ring that uses a mesh stores it once. If its faces have objects, each ring stores its own faces.
        if *first < count && (instance.object.is_none() || parts[0].0 == *first) {
            parts.iter().for_each(|&(ring, faces)| loads[ring].stored += faces);
            *first = count;
        }
    }
    Ok(loads)
}

/// Returns the number of faces per ring in a mesh whose face map names the objects.
fn parts_by_ring(
    mesh: &Mesh,
    ring_of: impl Fn(i32) -> usize,
    count: usize,
    progress: &Progress,
) -> Result<Vec<(usize, i64)>> {
    progress.check()?;
    let mut faces = vec![0; count];
    let mut open = None;
    for (start, object) in mesh.objects.runs(mesh.faces.len()) {
        if let Some((first, ring)) = open.replace((start, ring_of(object))) {
            faces[ring] += (start - first) as i64;
        }
    }
    if let Some((first, ring)) = open {
        faces[ring] += (mesh.faces.len() - first) as i64;
    }
    Ok(faces.into_iter().enumerate().filter(|&(_, faces)| faces > 0).collect())
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::{DAffine3, DVec3};

    use super::*;
    use crate::base::FaceMap;

    fn mesh(objects: FaceMap, faces: usize) -> Arc<Mesh> {
        Mesh::of_triangles(&vec![[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]; faces], objects)
    }

    fn place(mesh: &Arc<Mesh>, x: f64, object: Option<i32>) -> Instance {
        Instance::new(Arc::clone(mesh), DAffine3::from_translation(DVec3::new(x, 0.0, 0.0)), object).unwrap()
    }

    #[test]
    fn shared_meshes_are_stored_by_the_first_ring_that_uses_them() {
        let tree = mesh(FaceMap::Uniform(-1), 10);
        let merged = mesh(FaceMap::PerFace(vec![0, 0, 1, 3, -1, -1, -1].into()), 7);
        let standing = vec![
            place(&tree, 3.0, Some(2)),
            place(&tree, 1.0, Some(4)),
            place(&tree, 5.0, Some(5)),
            place(&merged, 0.0, None),
        ];
        let moving = vec![place(&tree, 0.0, Some(6))];
        let scene = Scene::of_instances(standing, moving);
        // Objects 0 to 6, and faces without an object.
        let rings = [1, 2, 2, 3, 1, 3, 0, 2];
        let loads = ring_loads(&scene, &rings, 4, &Progress::new()).unwrap();
        let expected = [(0, 0, 0), (12, 12, 1), (14, 4, 1), (11, 1, 1)];
        let expected = expected.map(|(drawn, stored, placed)| RingLoad { drawn, stored, placed });
        assert_eq!(loads, expected);
        let drawn: i64 = loads.iter().map(|load| load.drawn).sum();
        assert_eq!(drawn, scene.standing.triangle_count());
    }

    #[test]
    fn wrong_rings_are_refused() {
        let scene = Scene::of_instances(vec![], vec![]);
        assert!(ring_loads(&scene, &[], 1, &Progress::new()).is_err());
        assert!(ring_loads(&scene, &[1], 1, &Progress::new()).is_err());
    }
}
