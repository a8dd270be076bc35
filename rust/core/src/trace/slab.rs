//! Conservative ray–box intersection.
//!
//! Woop, Benthin, Wald: Watertight ray/triangle intersection, JCGT 2(1), 2013, section 5, and Ize: Robust BVH ray
//! traversal, JCGT 2(2), 2013. The triangle test may find a point that lies outside its triangle by the rounding error
//! of the sheared corners. A box must not exclude such a point, or rays would pass through the seams between boxes. So
//! the origin for the near planes is moved towards them, and the origin for the far planes away from them.
//!
//! Nested boxes give monotone results: every operation preserves the order of its operands, so a ray that enters a box
//! enters each box around it no later. The float32 arithmetic is the same at all vector widths.

use glam::Vec3;

use super::lanes::{Isa, Lanes};
use crate::base::Aabb;
use crate::base::simd::{greater, lesser};
use crate::bvh::{Node, WIDTH};

/// Maximum error of the sheared corners, relative to the reach: five roundings of half an ulp, as in the paper, for
/// two coordinates.
pub(super) const ERROR: f32 = 2.0 * 5.0 / (1 << 24) as f32;
/// Factors, towards zero and away from zero, that cover the rounding of a reciprocal and a product.
pub(super) const SHORTER: f32 = 1.0 - 4.0 * f32::EPSILON;
pub(super) const LONGER: f32 = 1.0 + 4.0 * f32::EPSILON;
/// Minimum slope, which replaces smaller ones, so that no product with a plane's distance is NaN. It moves a ray by far
/// less than one rounding over the whole box.
pub(super) const MIN_SLOPE: f32 = 1e-12;

/// A ray prepared for all boxes below one root.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slabs {
    /// First plane of a node that the ray meets on each axis: `2 axis` or `2 axis + 1`.
    pub(crate) first: [usize; 3],
    /// Origins for the near planes.
    pub(crate) near_origin: [f32; 3],
    /// Origins for the far planes.
    pub(crate) far_origin: [f32; 3],
    /// Reciprocal directions for the near planes, rounded towards zero.
    pub(crate) near_scale: [f32; 3],
    /// Reciprocal directions for the far planes, rounded away from zero.
    pub(crate) far_scale: [f32; 3],
}

impl Slabs {
    /// Prepares a ray for boxes inside `bounds`.
    #[inline(always)]
    pub(crate) fn new(origin: Vec3, direction: Vec3, bounds: &Aabb) -> Self {
        let reach = (bounds.min - origin).abs().max((bounds.max - origin).abs()).max_element();
        let error = reach * ERROR + f32::MIN_POSITIVE;
        let min_size = direction.abs().max_element() * MIN_SLOPE;
        let mut slabs = Self {
            first: [0; 3],
            near_origin: [0.0; 3],
            far_origin: [0.0; 3],
            near_scale: [0.0; 3],
            far_scale: [0.0; 3],
        };
        for axis in 0..3 {
            let d = direction[axis];
            let scale = 1.0 / d.abs().max(min_size);
            // −0.0 counts as positive: with the minimum slope, either sign accepts each box that touches the ray.
            let negative = d < 0.0;
            let sign = if negative { -1.0 } else { 1.0 };
            slabs.first[axis] = 2 * axis + usize::from(negative);
            slabs.near_origin[axis] = origin[axis] + sign * error;
            slabs.far_origin[axis] = origin[axis] - sign * error;
            slabs.near_scale[axis] = sign * scale * SHORTER;
            slabs.far_scale[axis] = sign * scale * LONGER;
        }
        slabs
    }

    /// Returns the parameters at which the ray enters and leaves boxes, given the first and last plane on each axis.
    #[inline(always)]
    pub(crate) fn intersect<I: Isa, L: Lanes<I>>(&self, isa: I, first: [L; 3], last: [L; 3]) -> (L, L) {
        let near = self.near(isa, 0, first[0]).max(self.near(isa, 1, first[1])).max(self.near(isa, 2, first[2]));
        let far = self.far(isa, 0, last[0]).min(self.far(isa, 1, last[1])).min(self.far(isa, 2, last[2]));
        (near, far)
    }

    #[inline(always)]
    fn near<I: Isa, L: Lanes<I>>(&self, isa: I, axis: usize, plane: L) -> L {
        plane.sub(L::splat(isa, self.near_origin[axis])).mul(L::splat(isa, self.near_scale[axis]))
    }

    #[inline(always)]
    fn far<I: Isa, L: Lanes<I>>(&self, isa: I, axis: usize, plane: L) -> L {
        plane.sub(L::splat(isa, self.far_origin[axis])).mul(L::splat(isa, self.far_scale[axis]))
    }

    /// Returns the parameters at which the ray enters and leaves the children of a node.
    #[inline(always)]
    pub(crate) fn intersect_node<I: Isa>(&self, isa: I, node: &Node) -> (I::Eight, I::Eight) {
        let [x, y, z] = self.first;
        let planes = &node.planes;
        let first = [load(isa, planes, x), load(isa, planes, y), load(isa, planes, z)];
        let last = [load(isa, planes, x ^ 1), load(isa, planes, y ^ 1), load(isa, planes, z ^ 1)];
        self.intersect(isa, first, last)
    }

    /// Returns the parameters at which the ray enters and leaves one box.
    #[inline(always)]
    pub(crate) fn enter_leave(&self, bounds: &Aabb) -> (f32, f32) {
        let plane = |number: usize| if number & 1 == 0 { bounds.min[number / 2] } else { bounds.max[number / 2] };
        let near = |axis: usize| (plane(self.first[axis]) - self.near_origin[axis]) * self.near_scale[axis];
        let far = |axis: usize| (plane(self.first[axis] ^ 1) - self.far_origin[axis]) * self.far_scale[axis];
        (greater(greater(near(0), near(1)), near(2)), lesser(lesser(far(0), far(1)), far(2)))
    }
}

#[inline(always)]
fn load<I: Isa>(isa: I, planes: &[[f32; WIDTH]; 6], number: usize) -> I::Eight {
    I::Eight::load(isa, &planes[number])
}
