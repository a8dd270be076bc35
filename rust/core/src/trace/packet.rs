//! Packets of up to 64 rays as arrays, and the beam that contains all rays of a packet.
//!
//! After Overbeck, Ramamoorthi, Mark: Large ray packets for real-time Whitted ray tracing, 2008, and Boulos, Wald,
//! Benthin: Adaptive ray packet reordering, 2008. Inner boxes of the tree are tested against the beam, eight boxes at
//! a time; single rays are tested only at leaves. The beam test accepts every box that one of its rays would accept,
//! and values of rays are computed with the arithmetic of `single`, so packets and single rays give the same bits.

use bytemuck::Zeroable;

use super::lanes::{Isa, Lanes};
use super::ray::{Hit, Ray};
use super::slab::{ERROR, LONGER, MIN_SLOPE, SHORTER};
use super::triangle::Shear;
use crate::base::Aabb;
use crate::base::simd::greater;
use crate::bvh::Node;

/// Maximum number of rays in a packet: a tile of 8 × 8 pixels.
pub(crate) const RAYS: usize = 64;
/// Minimum number of rays for which a packet saves time; fewer are traced one by one.
pub(super) const MIN_PACKET: usize = 8;
/// Maximum difference of the slopes (to the main axis) of rays that form a beam.
const MAX_SLOPE_SPREAD: f32 = 0.35;
/// Relative widening of a beam, far above the rounding difference between a ray's box test and the beam's.
const BEAM_MARGIN: f32 = 16.0 * f32::EPSILON;

type Row = [f32; RAYS];

/// Rays as a structure of arrays. Rows indexed by axis are in the order x, y, z; those of `origin` and `scale` are in
/// the shear's order.
#[derive(Zeroable)]
#[repr(align(64))]
pub(crate) struct Packet {
    pub(crate) count: usize,
    pub(crate) axes: [usize; 3],
    pub(crate) origin: [Row; 3],
    pub(crate) scale: [Row; 3],
    near_origin: [Row; 3],
    far_origin: [Row; 3],
    near_scale: [Row; 3],
    far_scale: [Row; 3],
    /// Rays with a negative direction on each axis, as bit masks.
    backwards: [u64; 3],
    pub(crate) t_min: Row,
    pub(crate) t_max: Row,
    pub(crate) floor: Row,
    /// Distance along the main axis per unit of t.
    step: Row,
    pub(crate) best: Best,
    /// Number of times that best hits have been stored.
    pub(crate) changes: u32,
    beam: Beam,
}

/// Best hits as a structure of arrays; numbers of instances and faces are stored as bits.
#[derive(Zeroable)]
pub(crate) struct Best {
    pub(crate) t: Row,
    pub(crate) u: Row,
    pub(crate) v: Row,
    pub(crate) instance: Row,
    pub(crate) face: Row,
}

/// Bounds of all rays as functions of the distance along their common main axis.
#[derive(Clone, Copy, Zeroable)]
struct Beam {
    first: [usize; 3],
    near_origin: [f32; 3],
    near_scale: [f32; 3],
    far_origin: [f32; 3],
    far_scale: [f32; 3],
    /// Axes on which ray directions have both signs: there both planes bound the entry and neither bounds the exit.
    has_both_signs: [bool; 3],
    /// Distance beyond which no ray can find a nearer hit.
    limit: f32,
}

impl Packet {
    /// Creates an empty packet.
    pub(crate) fn new() -> Self {
        Self { floor: [f32::NEG_INFINITY; RAYS], ..Self::zeroed() }
    }

    /// Fills the packet with rays, for boxes inside `bounds`. Returns false if the rays do not form a beam.
    #[inline(always)]
    pub(crate) fn fill<I: Isa>(&mut self, isa: I, rays: &[Ray], bounds: &Aabb) -> bool {
        let Some(lead) = rays.first() else { return false };
        self.count = rays.len();
        self.axes = Shear::new(lead.direction).axes;
        // `near_origin` and `near_scale` temporarily hold the origins and directions.
        for i in 0..RAYS {
            let ray = rays.get(i).unwrap_or(lead);
            for axis in 0..3 {
                self.near_origin[axis][i] = ray.origin[axis];
                self.near_scale[axis][i] = ray.direction[axis];
            }
            let is_ray = i < rays.len();
            self.t_min[i] = ray.t_min;
            // Unused slots, which pad the last group, get an empty segment.
            self.t_max[i] = if is_ray { ray.t_max.min(f32::MAX) } else { f32::NEG_INFINITY };
            if ray.t_min < 0.0 {
                return false;
            }
        }
        self.backwards = [0; 3];
        let main = self.axes[2];
        let lead_backwards = lead.direction[main] < 0.0;
        let mut extent = Extent::new(isa);
        for start in (0..RAYS).step_by(I::Group::N) {
            if !self.fill_group(isa, start, bounds, lead_backwards, &mut extent) {
                return false;
            }
        }
        self.set_beam(&extent.rows(), lead_backwards)
    }

    /// Resets the best hits.
    pub(crate) fn clear(&mut self) {
        self.best.t = [f32::INFINITY; RAYS];
        self.best.instance = [f32::from_bits(u32::MAX); RAYS];
        self.best.face = [f32::from_bits(u32::MAX); RAYS];
        self.best.u = [0.0; RAYS];
        self.best.v = [0.0; RAYS];
        self.beam.limit = f32::INFINITY;
    }

    /// Fills a group of rays, with the arithmetic of `Shear::new` and `Slabs::new`. Returns false if their main axis or
    /// its sign differs from the first ray's.
    #[inline(always)]
    fn fill_group<I: Isa>(
        &mut self,
        isa: I,
        start: usize,
        bounds: &Aabb,
        lead_backwards: bool,
        extent: &mut Extent<I>,
    ) -> bool {
        let zero = I::Group::splat(isa, 0.0);
        let all = u32::MAX >> (32 - I::Group::N);
        let load = Loader(isa);
        let d = load.rows(&self.near_scale, start);
        let o = load.rows(&self.near_origin, start);
        let size = [d[0].abs(), d[1].abs(), d[2].abs()];
        let is_x = size[1].lt(size[0]) & size[2].lt(size[0]);
        let is_y = !is_x & size[2].lt(size[1]);
        let [x, y, main] = self.axes;
        let same = [is_x, is_y, !is_x & !is_y][main] & all;
        let backwards = d[main].lt(zero);
        if same != all || backwards != if lead_backwards { all } else { 0 } {
            return false;
        }
        let one = I::Group::splat(isa, 1.0);
        d[x].div(d[main]).store(&mut self.scale[0][start..]);
        d[y].div(d[main]).store(&mut self.scale[1][start..]);
        one.div(d[main]).store(&mut self.scale[2][start..]);
        o[x].store(&mut self.origin[0][start..]);
        o[y].store(&mut self.origin[1][start..]);
        o[main].store(&mut self.origin[2][start..]);
        size[main].store(&mut self.step[start..]);
        let mut reach = zero;
        for (axis, &o) in o.iter().enumerate() {
            let low = I::Group::splat(isa, bounds.min[axis]).sub(o).abs();
            let high = I::Group::splat(isa, bounds.max[axis]).sub(o).abs();
            reach = reach.max(low).max(high);
        }
        let error = reach.mul(I::Group::splat(isa, ERROR)).add(I::Group::splat(isa, f32::MIN_POSITIVE));
        let min_size = size[main].mul(I::Group::splat(isa, MIN_SLOPE));
        for axis in 0..3 {
            let scale = one.div(size[axis].max(min_size));
            let negative = d[axis].lt(zero);
            self.backwards[axis] |= u64::from(negative) << start;
            let scale = zero.sub(scale).select(negative, scale);
            let error = zero.sub(error).select(negative, error);
            let (near, far) = (o[axis].add(error), o[axis].sub(error));
            near.store(&mut self.near_origin[axis][start..]);
            far.store(&mut self.far_origin[axis][start..]);
            scale.mul(I::Group::splat(isa, SHORTER)).store(&mut self.near_scale[axis][start..]);
            scale.mul(I::Group::splat(isa, LONGER)).store(&mut self.far_scale[axis][start..]);
            extent.extend(axis, near, far, d[axis].div(size[main]));
        }
        true
    }

    /// Computes the beam. Returns false if it would be too wide.
    fn set_beam(&mut self, extent: &[[f32; 4]; 3], lead_backwards: bool) -> bool {
        let main = self.axes[2];
        for (axis, &[low, high, min, max]) in extent.iter().enumerate() {
            if max - min > MAX_SLOPE_SPREAD {
                return false;
            }
            let (min, max) = if axis == main {
                if lead_backwards { (-1.0, -1.0) } else { (1.0, 1.0) }
            } else {
                (min - min.abs() * BEAM_MARGIN, max + max.abs() * BEAM_MARGIN)
            };
            let beam = &mut self.beam;
            beam.has_both_signs[axis] = min < MIN_SLOPE && max > -MIN_SLOPE;
            let backwards = !beam.has_both_signs[axis] && max < 0.0;
            beam.first[axis] = 2 * axis + usize::from(backwards);
            let (shorter, longer) = (1.0 - BEAM_MARGIN, 1.0 + BEAM_MARGIN);
            (beam.near_origin[axis], beam.far_origin[axis]) = if backwards { (low, high) } else { (high, low) };
            (beam.near_scale[axis], beam.far_scale[axis]) = if beam.has_both_signs[axis] {
                (shorter / max.max(MIN_SLOPE), shorter / min.min(-MIN_SLOPE))
            } else if backwards {
                (shorter / min, longer / max)
            } else {
                (shorter / max, longer / min)
            };
        }
        true
    }

    /// Returns a mask of the children of a node that the beam enters, and the distances at which it does.
    #[inline(always)]
    pub(crate) fn intersect_node<I: Isa>(&self, isa: I, node: &Node) -> (u32, I::Eight) {
        let beam = &self.beam;
        let mut near = I::Eight::splat(isa, 0.0);
        let mut far = I::Eight::splat(isa, beam.limit);
        for axis in 0..3 {
            let first = I::Eight::load(isa, &node.planes[beam.first[axis]]);
            let last = I::Eight::load(isa, &node.planes[beam.first[axis] ^ 1]);
            let enter = first.sub(I::Eight::splat(isa, beam.near_origin[axis]));
            near = near.max(enter.mul(I::Eight::splat(isa, beam.near_scale[axis])));
            let leave = last.sub(I::Eight::splat(isa, beam.far_origin[axis]));
            let leave = leave.mul(I::Eight::splat(isa, beam.far_scale[axis]));
            if beam.has_both_signs[axis] {
                near = near.max(leave);
            } else {
                far = far.min(leave);
            }
        }
        (near.le(far), near)
    }

    /// Ends the traversal.
    #[inline(always)]
    pub(crate) fn stop(&mut self) {
        self.beam.limit = f32::NEG_INFINITY;
    }

    /// Returns whether `stop` has ended the traversal.
    #[inline(always)]
    pub(crate) fn is_stopped(&self) -> bool {
        self.beam.limit == f32::NEG_INFINITY
    }

    /// Returns the distance beyond which no box needs to be visited.
    #[inline(always)]
    pub(crate) fn limit(&self) -> f32 {
        self.beam.limit
    }

    /// Returns a mask of the rays of a group that enter a box within their segments and not beyond their best hits.
    #[inline(always)]
    pub(crate) fn entering_rays<I: Isa>(&self, isa: I, start: usize, planes: &[f32; 6]) -> u32 {
        let (near, far) = self.slabs(isa, start, planes);
        let load = Loader(isa);
        let near = near.max(load.row(&self.t_min, start));
        let limit = load.row(&self.best.t, start).min(load.row(&self.t_max, start));
        near.le(far.min(limit))
    }

    /// Returns the distances at which a group's rays enter and leave a box, with the arithmetic of `Slabs::intersect`.
    #[inline(always)]
    pub(crate) fn slabs<I: Isa>(&self, isa: I, start: usize, planes: &[f32; 6]) -> (I::Group, I::Group) {
        let (x, y, z) =
            (self.slab(isa, start, 0, planes), self.slab(isa, start, 1, planes), self.slab(isa, start, 2, planes));
        (x.0.max(y.0).max(z.0), x.1.min(y.1).min(z.1))
    }

    #[inline(always)]
    fn slab<I: Isa>(&self, isa: I, start: usize, axis: usize, planes: &[f32; 6]) -> (I::Group, I::Group) {
        let low = I::Group::splat(isa, planes[2 * axis]);
        let high = I::Group::splat(isa, planes[2 * axis + 1]);
        let backwards = (self.backwards[axis] >> start) as u32 & (u32::MAX >> (32 - I::Group::N));
        let (first, last) = if self.beam.has_both_signs[axis] {
            (high.select(backwards, low), low.select(backwards, high))
        } else if backwards != 0 {
            (high, low)
        } else {
            (low, high)
        };
        let load = Loader(isa);
        let near = first.sub(load.row(&self.near_origin[axis], start)).mul(load.row(&self.near_scale[axis], start));
        let far = last.sub(load.row(&self.far_origin[axis], start)).mul(load.row(&self.far_scale[axis], start));
        (near, far)
    }

    /// Sets the limit of the beam to the farthest best hit or end of a segment.
    #[inline(always)]
    pub(crate) fn update_limit<I: Isa>(&mut self, isa: I) {
        let load = Loader(isa);
        let mut farthest = I::Group::splat(isa, 0.0);
        for start in (0..self.count).step_by(I::Group::N) {
            let t = load.row(&self.best.t, start).min(load.row(&self.t_max, start));
            farthest = farthest.max(t.mul(load.row(&self.step, start)));
        }
        let mut lanes = [0.0; 16];
        farthest.store(&mut lanes);
        let farthest = lanes[..I::Group::N].iter().fold(0.0, |farthest, &lane| greater(farthest, lane));
        self.beam.limit = farthest * (1.0 + BEAM_MARGIN);
    }

    #[inline(always)]
    pub(crate) fn hit(&self, ray: usize) -> Hit {
        let best = &self.best;
        let (instance, face) = (best.instance[ray].to_bits(), best.face[ray].to_bits());
        Hit { t: best.t[ray], u: best.u[ray], v: best.v[ray], instance, face }
    }

    #[inline(always)]
    pub(crate) fn set_hit(&mut self, ray: usize, hit: &Hit) {
        self.changes = self.changes.wrapping_add(1);
        let best = &mut self.best;
        (best.t[ray], best.u[ray], best.v[ray]) = (hit.t, hit.u, hit.v);
        (best.instance[ray], best.face[ray]) = (f32::from_bits(hit.instance), f32::from_bits(hit.face));
    }
}

/// Minimum and maximum of ray origins and slopes, per lane and axis.
struct Extent<I: Isa>([[I::Group; 4]; 3]);

impl<I: Isa> Extent<I> {
    #[inline(always)]
    fn new(isa: I) -> Self {
        let (low, high) = (I::Group::splat(isa, f32::INFINITY), I::Group::splat(isa, f32::NEG_INFINITY));
        Self([[low, high, low, high]; 3])
    }

    #[inline(always)]
    fn extend(&mut self, axis: usize, near: I::Group, far: I::Group, slope: I::Group) {
        let [low, high, min, max] = self.0[axis];
        self.0[axis] = [low.min(near).min(far), high.max(near).max(far), min.min(slope), max.max(slope)];
    }

    /// Returns the extremes over all lanes.
    #[inline(always)]
    fn rows(&self) -> [[f32; 4]; 3] {
        let mut rows = [[0.0; 4]; 3];
        let mut lanes = [0.0f32; 16];
        for (row, extremes) in rows.iter_mut().zip(&self.0) {
            for (number, (slot, extreme)) in row.iter_mut().zip(extremes).enumerate() {
                extreme.store(&mut lanes);
                let mut extreme = lanes[0];
                for &x in &lanes[1..I::Group::N] {
                    let is_beyond = if number & 1 == 0 { x < extreme } else { x > extreme };
                    extreme = if is_beyond { x } else { extreme };
                }
                *slot = extreme;
            }
        }
        rows
    }
}

/// Loads lanes from rows.
#[derive(Clone, Copy)]
pub(crate) struct Loader<I>(pub(crate) I);

impl<I: Isa> Loader<I> {
    #[inline(always)]
    pub(crate) fn row(self, row: &Row, start: usize) -> I::Group {
        I::Group::load(self.0, &row[start..])
    }

    #[inline(always)]
    pub(crate) fn rows(self, rows: &[Row; 3], start: usize) -> [I::Group; 3] {
        [self.row(&rows[0], start), self.row(&rows[1], start), self.row(&rows[2], start)]
    }
}
