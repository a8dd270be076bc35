//! Partition of a scene at two radii, with its counts, and its validation against the radii of every triangle.

use std::collections::BTreeSet;
use std::ops::Range;

use glam::{DVec3, Vec3};
use rayon::prelude::*;

use super::classify::{ChosenFaces, Class, Ruler, Zone};
use super::radii::{CHUNK, axis_in, radii_of};
use crate::base::mapped::in_ranges;
use crate::base::memory::room_for_values;
use crate::base::{Error, Progress, Result, ensure};
use crate::scene::Scene;

/// Tolerance, relative to r₂, within which a point counts as lying on a radius. It exceeds the rounding of edge splits.
const RADIUS_TOLERANCE: f64 = 1.0 / 8192.0;

/// Numbers of triangles and instances.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PartitionCounts {
    /// All triangles.
    pub triangles: i64,
    /// Triangles with minimum ρ ≤ r₁.
    pub near: i64,
    /// Triangles with r₁ < minimum ρ ≤ r₂.
    pub intermediate: i64,
    /// Triangles with minimum ρ > r₂.
    pub far: i64,
    /// Static triangles that cross r₂.
    pub straddling: i64,
    /// Triangles drawn as geometry.
    pub nsf: i64,
    /// Triangles drawn as geometry if geometry ended at r₁: near triangles and all moving ones.
    pub nsf_at_r1: i64,
    /// Triangles baked into the map.
    pub sf: i64,
    /// Instances whose triangles are all near.
    pub near_instances: i64,
    /// Instances whose triangles are all intermediate.
    pub intermediate_instances: i64,
    /// Instances whose triangles are all far.
    pub far_instances: i64,
    /// Instances whose boxes did not decide their class.
    pub mixed_instances: i64,
    /// Triangles of mixed instances; corners of other triangles were not read.
    pub examined: i64,
    /// Examined triangles whose radii were computed. The coordinates of all others proved that they are far.
    pub measured: i64,
}

/// A scene partitioned at two radii about a vertical axis.
#[derive(Clone, Debug)]
pub struct Partition {
    /// The partitioned scene.
    pub scene: Scene,
    /// World position of the centre O.
    pub center: DVec3,
    /// (x, z) of the axis through the centre, relative to the scene's origin.
    pub(super) axis: [f64; 2],
    /// r₁: radius of the near zone, metres.
    pub r1: f64,
    /// r₂: outer radius of the intermediate zone, metres.
    pub r2: f64,
    /// Class of each instance, ordered by instance number.
    pub classes: Vec<Class>,
    /// Numbers of triangles and instances.
    pub counts: PartitionCounts,
}

impl Partition {
    /// Partitions a scene about a centre in world coordinates; 0 ≤ r₁ < r₂.
    pub fn new(scene: &Scene, center: DVec3, r1: f64, r2: f64, progress: &Progress) -> Result<Self> {
        let axis = axis_in(scene, center)?;
        ensure!(r1.is_finite() && r1 >= 0.0, "r1", "a finite radius of at least 0", r1);
        ensure!(r2.is_finite() && r2 > r1, "r2", format!("a finite radius greater than r1 = {r1}"), r2);
        let ruler = Ruler::new(axis, r1, r2);
        ruler.room_for(scene.instances())?;
        progress.expect(scene.triangle_count() as u64);
        let classes = (0..scene.instance_count() as u32)
            .into_par_iter()
            .map(|number| ruler.classify(scene.instance(number), progress))
            .collect::<Result<Vec<_>>>()?;
        let (scene, counts) = (scene.clone(), PartitionCounts::default());
        let mut partition = Self { scene, center, axis, r1, r2, classes, counts };
        partition.counts = partition.count();
        Ok(partition)
    }

    /// Returns the instances with faces that are drawn as geometry, ordered by instance number.
    pub fn nsf_instances(&self) -> impl Iterator<Item = (u32, ChosenFaces<'_>)> {
        let standing = self.scene.standing.instances().len();
        self.classes.iter().enumerate().filter_map(move |(number, class)| {
            let faces = match class {
                _ if number >= standing => ChosenFaces::All,
                Class::Near | Class::Intermediate => ChosenFaces::All,
                Class::Mixed(mixed) if !mixed.faces.is_empty() => ChosenFaces::Some(&mixed.faces),
                Class::Mixed(_) | Class::Far => return None,
            };
            Some((number as u32, faces))
        })
    }

    /// Returns (instance, face) of each triangle that is drawn as geometry, ordered by triangle number.
    pub fn nsf(&self) -> impl Iterator<Item = (u32, u32)> {
        self.nsf_instances().flat_map(|(number, faces)| {
            let (all, some) = match faces {
                ChosenFaces::All => (0..self.scene.instance(number).mesh.faces.len() as u32, &[][..]),
                ChosenFaces::Some(some) => (0..0, some),
            };
            all.chain(some.iter().copied()).map(move |face| (number, face))
        })
    }

    /// Returns the numbers of the objects with static triangles that are drawn as geometry, ascending.
    pub fn near_objects(&self) -> Vec<i32> {
        let standing = self.nsf().take_while(|&(instance, _)| !self.is_moving(instance as usize));
        let objects = standing.filter_map(|(number, face)| {
            let instance = self.scene.instance(number);
            instance.object.or_else(|| Some(instance.mesh.objects.get(face)).filter(|&object| object >= 0))
        });
        objects.collect::<BTreeSet<i32>>().into_iter().collect()
    }

    /// Returns (instance, face) of the static triangles drawn as geometry, in two lists ordered by triangle number:
    /// triangles with all corners inside a radius, and all others. Points on the radius count as outside, even if
    /// rounding moved them slightly inwards.
    pub fn nsf_inside(&self, radius: f64) -> Result<[Vec<(u32, u32)>; 2]> {
        let [x, z] = self.axis;
        let limit = radius - self.r2 * RADIUS_TOLERANCE;
        let is_inside = |corner: Vec3| (f64::from(corner.x) - x).hypot(f64::from(corner.z) - z) < limit;
        let standing = self.nsf().take_while(|&(instance, _)| !self.is_moving(instance as usize));
        let corners = |&(number, face): &(u32, u32)| self.scene.instance(number).corners(face);
        // Growing vectors take up to twice their length.
        room_for_values::<[(u32, u32); 2]>(self.counts.nsf as usize)?;
        Ok(standing.partition::<Vec<_>, _>(|triangle| corners(triangle).into_iter().all(is_inside)).into())
    }

    /// Returns the zone of a triangle.
    pub fn zone(&self, instance: u32, face: u32) -> Zone {
        match &self.classes[instance as usize] {
            Class::Near => Zone::Near,
            Class::Intermediate => Zone::Intermediate,
            Class::Far => Zone::Far,
            Class::Mixed(mixed) => mixed.faces.binary_search(&face).map_or(Zone::Far, |index| mixed.zones[index]),
        }
    }

    /// Measures every triangle without boxes and thresholds, and compares the zones. An error is a bug in nearfar.
    pub fn validate(&self, progress: &Progress) -> Result<()> {
        let ruler = Ruler::new(self.axis, self.r1, self.r2);
        progress.expect(self.counts.triangles as u64);
        (0..self.classes.len() as u32).into_par_iter().try_for_each(|number| {
            let instance = self.scene.instance(number);
            if let Class::Mixed(mixed) = &self.classes[number as usize]
                && !(mixed.faces.is_sorted_by(|a, b| a < b) && mixed.faces.len() == mixed.zones.len())
            {
                return Err(Error::Scene(format!("partition: the faces of instance {number} are out of order")));
            }
            let task = |faces: Range<usize>| {
                for face in faces.start as u32..faces.end as u32 {
                    let [a, b, c] = instance.corners(face).map(|corner| [f64::from(corner.x), f64::from(corner.z)]);
                    let radii = radii_of(a, b, c, self.axis).map(|radius| radius as f32);
                    let (expected, zone) = (ruler.zone(radii).unwrap_or(Zone::Far), self.zone(number, face));
                    if zone != expected {
                        let text = format!("partition: face {face} of instance {number} is in a wrong zone");
                        return Err(Error::Scene(text));
                    }
                }
                progress.report(faces.len() as u64)
            };
            in_ranges(instance.mesh.faces.len(), CHUNK, task).map(drop)
        })?;
        let counts = &self.counts;
        let by_zone = counts.near + counts.intermediate + counts.far;
        let by_set = counts.nsf + counts.sf - counts.straddling;
        if by_zone != counts.triangles || by_set != counts.triangles || self.count() != *counts {
            return Err(Error::Scene(format!(
                "partition: the counts do not add up: {by_zone} triangles by zone and {by_set} by set, of {}",
                counts.triangles
            )));
        }
        Ok(())
    }

    pub(super) fn is_moving(&self, instance: usize) -> bool {
        instance >= self.scene.standing.instances().len()
    }

    fn count(&self) -> PartitionCounts {
        let mut counts = PartitionCounts { triangles: self.scene.triangle_count(), ..PartitionCounts::default() };
        for (number, class) in self.classes.iter().enumerate() {
            let triangles = self.scene.instance(number as u32).mesh.faces.len() as i64;
            let is_moving = self.is_moving(number);
            let (near, intermediate, far, straddling, instances) = match class {
                Class::Near => (triangles, 0, 0, 0, &mut counts.near_instances),
                Class::Intermediate => (0, triangles, 0, 0, &mut counts.intermediate_instances),
                Class::Far => (0, 0, triangles, 0, &mut counts.far_instances),
                Class::Mixed(mixed) => {
                    let count = |test: fn(Zone) -> bool| mixed.zones.iter().filter(|&&zone| test(zone)).count() as i64;
                    let (near, not_far) = (count(Zone::is_near), mixed.zones.len() as i64);
                    let straddling = if is_moving { 0 } else { count(Zone::is_straddling) };
                    counts.examined += triangles;
                    counts.measured += i64::from(mixed.measured);
                    (near, not_far - near, triangles - not_far, straddling, &mut counts.mixed_instances)
                }
            };
            *instances += 1;
            counts.near += near;
            counts.intermediate += intermediate;
            counts.far += far;
            counts.straddling += straddling;
            counts.nsf += if is_moving { triangles } else { near + intermediate };
            counts.nsf_at_r1 += if is_moving { triangles } else { near };
            counts.sf += if is_moving { 0 } else { far + straddling };
        }
        counts
    }
}
