//! Rays against a scene: nearest hits through both levels of trees.

mod alpha;
#[cfg(test)]
mod tests;
mod triangle;

use glam::Vec3;
use obvhs::bvh2::Bvh2;

use crate::scene::{InstanceSet, Scene};

pub use alpha::AlphaFilter;
pub use triangle::Shear;

/// A segment of a ray in scene space. The direction needs no particular length; `t` is in units of it.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Start, relative to the scene's origin.
    pub origin: Vec3,
    /// Direction, finite and not zero.
    pub direction: Vec3,
    /// Least parameter that counts as a hit.
    pub t_min: f32,
    /// Greatest parameter that counts as a hit.
    pub t_max: f32,
}

/// Where a ray meets a triangle: the point is (1−u−v) a + u b + v c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Parameter along the ray; infinite for a miss.
    pub t: f32,
    /// Weight of the second corner.
    pub u: f32,
    /// Weight of the third corner.
    pub v: f32,
    /// Instance in the scene; `u32::MAX` for a miss.
    pub instance: u32,
    /// Face in the instance's mesh.
    pub face: u32,
}

impl Hit {
    /// Nothing was hit.
    pub const MISS: Self = Self { t: f32::INFINITY, u: 0.0, v: 0.0, instance: u32::MAX, face: u32::MAX };

    /// True where nothing was hit.
    pub fn is_miss(&self) -> bool {
        self.instance == u32::MAX
    }

    /// Ties go to the lower (instance, face), so that the answer depends neither on the tree nor on the order of visits.
    fn is_before(&self, other: &Self) -> bool {
        self.t < other.t || (self.t == other.t && (self.instance, self.face) < (other.instance, other.face))
    }
}

/// Decides which intersections count: cut-out materials, pixels split at a radius.
pub trait Filter: Sync {
    /// True where the candidate is a hit.
    fn accepts(&self, ray: &Ray, candidate: &Hit) -> bool;
}

/// Everything counts.
pub struct All;

impl Filter for All {
    #[inline(always)]
    fn accepts(&self, _ray: &Ray, _candidate: &Hit) -> bool {
        true
    }
}

/// The nearest hit. The scene must have been built (`Scene::build`).
pub fn closest_hit(scene: &Scene, ray: &Ray, filter: &impl Filter) -> Hit {
    let mut best = Hit::MISS;
    let mut first = 0;
    for set in scene.sets() {
        walk_set(set, first, ray, filter, &mut best);
        first += set.instances().len() as u32;
    }
    best
}

/// Nearest hits of many rays; neighbours in the slice are assumed to be coherent.
pub fn closest_hits(scene: &Scene, rays: &[Ray], filter: &impl Filter, hits: &mut [Hit]) {
    for (ray, hit) in rays.iter().zip(hits) {
        *hit = closest_hit(scene, ray, filter);
    }
}

fn walk_set(set: &InstanceSet, first: u32, ray: &Ray, filter: &impl Filter, best: &mut Hit) {
    let Some(tlas) = set.tlas().and_then(|tlas| tlas.tree.as_ref()) else { return };
    walk(tlas, ray, best, &mut |slot, best| {
        let instance = &set.instances()[slot as usize];
        let Some(tree) = instance.mesh.bvh().and_then(|bvh| bvh.tree.as_ref()) else { return };
        let local = if instance.in_place {
            *ray
        } else {
            let origin = instance.to_object.transform_point3(ray.origin.as_dvec3()).as_vec3();
            let direction = instance.to_object.transform_vector3(ray.direction.as_dvec3()).as_vec3();
            Ray { origin, direction, ..*ray }
        };
        let shear = Shear::new(local.direction);
        walk(tree, &local, best, &mut |face, best| {
            let [a, b, c] = instance.mesh.corners(face);
            if let Some((t, u, v)) = shear.intersect(local.origin, a, b, c) {
                let candidate = Hit { t, u, v, instance: first + slot, face };
                let inside = t >= ray.t_min && t <= ray.t_max;
                if inside && candidate.is_before(best) && filter.accepts(ray, &candidate) {
                    *best = candidate;
                }
            }
        });
    });
}

/// Deeper trees than this do not fit the stack on the stack and go to the heap.
const STACK: usize = 256;

fn walk(tree: &Bvh2, ray: &Ray, best: &mut Hit, visit: &mut impl FnMut(u32, &mut Hit)) {
    if 2 * tree.max_depth + 2 <= STACK {
        walk_with(tree, ray, best, visit, &mut [(0, 0.0); STACK]);
    } else {
        walk_with(tree, ray, best, visit, &mut vec![(0, 0.0); tree.nodes.len()]);
    }
}

fn walk_with(tree: &Bvh2, ray: &Ray, best: &mut Hit, visit: &mut impl FnMut(u32, &mut Hit), stack: &mut [(u32, f32)]) {
    let inverse = ray.direction.recip();
    // Distance at which a node's box is entered; none where it is missed.
    let enter = |index: u32, best: &Hit| {
        let node = &tree.nodes[index as usize];
        let (low, high) = (
            (Vec3::from(node.aabb().min) - ray.origin) * inverse,
            (Vec3::from(node.aabb().max) - ray.origin) * inverse,
        );
        // NaN (0 times infinity: the ray lies in a slab's face) leaves that slab out, which keeps the box.
        let near = low.min(high).max_element().max(ray.t_min);
        // Ize: Robust BVH ray traversal, 2013: two ulps on the far side make the box test conservative.
        let far = (low.max(high).min_element() * 1.000_000_4).min(ray.t_max.min(best.t));
        (near <= far).then_some(near)
    };
    let Some(near) = enter(0, best) else { return };
    stack[0] = (0, near);
    let mut size = 1;
    while size > 0 {
        size -= 1;
        let (index, near) = stack[size];
        if near > best.t {
            continue;
        }
        let node = &tree.nodes[index as usize];
        if node.is_leaf() {
            for slot in node.first_index..node.first_index + node.prim_count {
                visit(tree.primitive_indices[slot as usize], best);
            }
            continue;
        }
        let children = [node.first_index, node.first_index + 1];
        let mut found = children.map(|child| (child, enter(child, best)));
        // The nearer one is visited first.
        if found[0].1 < found[1].1 {
            found.swap(0, 1);
        }
        for (child, near) in found {
            if let Some(near) = near {
                stack[size] = (child, near);
                size += 1;
            }
        }
    }
}
