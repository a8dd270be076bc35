//! Test whether a box may contain geometry, used to skip empty regions.

use crate::base::Aabb;
use crate::bvh::{LEAF, NO_CHILD, Node, WIDTH, Wide};
use crate::scene::{Instance, InstanceSet, Scene};

/// Returns false if no triangle of a scene reaches into a box. It may return true for an empty box, because leaves and
/// transformed instances are tested by their boxes. The scene must have been built.
pub fn touches(scene: &Scene, region: &Aabb) -> bool {
    scene.sets().into_iter().any(|set| set_touches(set, region))
}

fn set_touches(set: &InstanceSet, region: &Aabb) -> bool {
    let Some(tlas) = set.tlas() else { return false };
    let instances = set.instances();
    any_leaf(&tlas.wide, 0, region, &|leaf| {
        tlas.instance(leaf).is_some_and(|slot| instance_touches(&instances[slot as usize], region))
    })
}

fn instance_touches(instance: &Instance, region: &Aabb) -> bool {
    // Only meshes without a transform have their search tree in scene axes.
    if !instance.in_place {
        return instance.bounds.touches(region);
    }
    instance.mesh.bvh().is_some_and(|bvh| any_leaf(&bvh.wide, 0, region, &|_| true))
}

/// Returns whether some leaf below a node overlaps the region with its box and satisfies a condition.
fn any_leaf(wide: &Wide, node: u32, region: &Aabb, condition: &impl Fn(u32) -> bool) -> bool {
    let Some(node) = wide.nodes.get(node as usize) else { return false };
    let inside = overlaps(node, region);
    (0..WIDTH).filter(|&slot| inside[slot] && node.children[slot] != NO_CHILD).any(|slot| {
        let child = node.children[slot];
        if child & LEAF == 0 { any_leaf(wide, child, region, condition) } else { condition(child) }
    })
}

#[inline]
fn overlaps(node: &Node, region: &Aabb) -> [bool; WIDTH] {
    let mut inside = [true; WIDTH];
    for axis in 0..3 {
        let (low, high) = (&node.planes[2 * axis], &node.planes[2 * axis + 1]);
        for slot in 0..WIDTH {
            inside[slot] &= (low[slot] <= region.max[axis]) & (high[slot] >= region.min[axis]);
        }
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::{FaceMap, Progress};
    use crate::scene::Mesh;
    use glam::{DAffine3, DVec3, Vec3};
    use proptest::prelude::*;

    fn instance(position: DVec3, points: &[[f32; 3]]) -> Instance {
        let mesh = Mesh::of_triangles(points.as_chunks().0, FaceMap::Uniform(0));
        Instance::new(mesh, DAffine3::from_translation(position), None).unwrap()
    }

    proptest! {
        #[test]
        fn all_intersecting_triangles_are_found(
            points in prop::collection::vec(prop::array::uniform3(-20.0..20.0f32), 3..90),
            low in prop::array::uniform3(-25.0..25.0f32), size in prop::array::uniform3(0.0..10.0f32),
        ) {
            let points = &points[..points.len() / 3 * 3];
            let region = Aabb { min: Vec3::from_array(low), max: Vec3::from_array(low) + Vec3::from_array(size) };
            for shift in [DVec3::ZERO, DVec3::new(4.0, -2.0, 7.0)] {
                let scene = Scene::of_instances(vec![instance(shift, points)], vec![]);
                scene.build(&Progress::new()).unwrap();
                let inside = |p: &[f32; 3]| {
                    let p = Vec3::from_array(*p) + shift.as_vec3();
                    p.cmpge(region.min).all() && p.cmple(region.max).all()
                };
                prop_assert!(touches(&scene, &region) || !points.iter().any(inside));
            }
        }
    }

    #[test]
    fn empty_regions_and_scenes_are_distinguished() {
        let corner = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let far = [[9.0, 9.0, 9.0], [9.5, 9.0, 9.0], [9.0, 9.5, 9.0]];
        let scene = Scene::of_instances(vec![instance(DVec3::ZERO, &corner), instance(DVec3::X, &far)], vec![]);
        scene.build(&Progress::new()).unwrap();
        let cube_at = |p: f32| Aabb { min: Vec3::splat(p), max: Vec3::splat(p + 0.5) };
        assert!(touches(&scene, &cube_at(0.0)));
        assert!(!touches(&scene, &cube_at(4.0)));
        assert!(!touches(&Scene::of_instances(vec![], vec![]), &cube_at(0.0)));
    }
}
