//! Minimum distance of each object from the axis.

use std::sync::atomic::{AtomicU32, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use super::classify::{lies_beyond, secure_bounds};
use super::radii::{CHUNK, axis_in, measure_faces};
use crate::base::{Progress, Result, by_object, ensure};
use crate::scene::{Instance, Scene};

/// Points of an object whose distances count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// All points of its triangles.
    Surface,
    /// Only the corners of its triangles.
    Vertex,
}

/// Minimum ρ of objects, and the work that it took.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjectRadii {
    /// Minimum ρ of each object's static triangles, and as last entry that of static triangles without an object.
    /// Infinite beyond the reach, and without triangles.
    pub least: Vec<f32>,
    /// Triangles whose distances were computed. The others belong to instances whose boxes lie beyond the reach.
    pub measured: i64,
}

/// Measures `object_count` objects up to a distance `reach` from the axis through a centre in world coordinates.
pub fn object_radii(
    scene: &Scene,
    object_count: usize,
    center: DVec3,
    reach: f64,
    rule: Rule,
    progress: &Progress,
) -> Result<ObjectRadii> {
    let axis = axis_in(scene, center)?;
    ensure!(reach >= 0.0, "reach", "a radius of at least 0", reach);
    let instances = scene.standing.instances();
    let near: Vec<&Instance> =
        instances.iter().filter(|instance| !lies_beyond(&secure_bounds(instance), axis, reach)).collect();
    let measured = near.iter().map(|instance| instance.mesh.faces.len() as i64).sum();
    progress.expect(measured as u64);
    let minima = Minima((0..=object_count).map(|_| AtomicU32::new(f32::INFINITY.to_bits())).collect());
    near.into_par_iter().try_for_each(|instance| {
        instance.mesh.faces.par_chunks(CHUNK).enumerate().try_for_each(|(chunk, faces)| {
            let first = chunk * CHUNK;
            minima.add_faces(instance, first..first + faces.len(), axis, rule);
            progress.report(faces.len() as u64)
        })
    })?;
    let within = |bits: AtomicU32| Some(f32::from_bits(bits.into_inner())).filter(|&rho| f64::from(rho) <= reach);
    let least = minima.0.into_iter().map(|bits| within(bits).unwrap_or(f32::INFINITY)).collect();
    Ok(ObjectRadii { least, measured })
}

/// Bits of the minimum ρ found so far for each object. They sort like the numbers, because none is negative.
struct Minima(Vec<AtomicU32>);

impl Minima {
    fn add_faces(&self, instance: &Instance, faces: std::ops::Range<usize>, axis: [f64; 2], rule: Rule) {
        let mut run = (-1, f32::INFINITY);
        let mut add_face = |face: usize, rho: f32| {
            let object = instance.object_of(face as u32);
            if object != run.0 {
                self.add(run);
                run = (object, rho);
            }
            run.1 = run.1.min(rho);
        };
        let first = faces.start;
        match rule {
            Rule::Surface => measure_faces(instance, faces, axis, |start, radii| {
                (first + start..).zip(radii).for_each(|(face, radii)| add_face(face, radii[0]));
            }),
            Rule::Vertex => faces.for_each(|face| {
                let corners = instance.corners(face as u32);
                let rho =
                    corners.map(|corner| (f64::from(corner.x) - axis[0]).hypot(f64::from(corner.z) - axis[1]) as f32);
                add_face(face, rho.into_iter().fold(f32::INFINITY, f32::min));
            }),
        }
        self.add(run);
    }

    fn add(&self, (object, rho): (i32, f32)) {
        by_object(&self.0, object).fetch_min(rho.to_bits(), Ordering::Relaxed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::FaceMap;
    use crate::base::random::uniform;
    use crate::partition::radii_of;
    use crate::scene::Mesh;
    use glam::DAffine3;
    use std::sync::Arc;

    const OBJECTS: i32 = 6;

    /// A thousand triangles in short runs of the same object.
    fn mesh(seed: u64) -> Arc<Mesh> {
        let coordinate = |n: u64| (uniform(seed, n, 0) * 60.0 - 30.0) as f32;
        let corner = |n: u64| [3 * n, 3 * n + 1, 3 * n + 2].map(coordinate);
        let triangles: Vec<_> = (0..1000).map(|n| [3 * n, 3 * n + 1, 3 * n + 2].map(corner)).collect();
        Mesh::of_triangles(&triangles, FaceMap::PerFace((0..1000).map(|n| n / 7 % (OBJECTS + 1) - 1).collect()))
    }

    fn scene() -> Scene {
        let turned = DAffine3::from_rotation_y(0.7) * DAffine3::from_translation(DVec3::new(40.0, 1.0, -3.0));
        let far = DAffine3::from_translation(DVec3::new(900.0, 0.0, 0.0));
        let place = |seed, to_scene, object| Instance::new(mesh(seed), to_scene, object).unwrap();
        let standing = vec![
            place(1, DAffine3::from_translation(DVec3::new(45.0, 0.0, 45.0)), None),
            place(2, turned, Some(2)),
            place(3, far, Some(4)),
        ];
        let moving = vec![place(4, DAffine3::IDENTITY, Some(0))];
        Scene::new(DVec3::new(0.0, 5.0, 0.0), standing, moving, Arc::default(), Arc::default()).unwrap()
    }

    /// Computes the minimum ρ by definition, over all triangles one by one.
    fn one_by_one(scene: &Scene, center: DVec3, rule: Rule) -> Vec<f32> {
        let axis = axis_in(scene, center).unwrap();
        let mut least = vec![f32::INFINITY; OBJECTS as usize + 1];
        for instance in scene.standing.instances() {
            for face in 0..instance.mesh.faces.len() as u32 {
                let [a, b, c] = instance.corners(face).map(|corner| [f64::from(corner.x), f64::from(corner.z)]);
                let rho = match rule {
                    Rule::Surface => radii_of(a, b, c, axis)[0],
                    Rule::Vertex => {
                        let rhos = [a, b, c].map(|corner| (corner[0] - axis[0]).hypot(corner[1] - axis[1]));
                        rhos.into_iter().fold(f64::INFINITY, f64::min)
                    }
                };
                let object = instance.object_of(face);
                let place = if object < 0 { OBJECTS as usize } else { object as usize };
                least[place] = least[place].min(rho as f32);
            }
        }
        least
    }

    #[test]
    fn minimum_radii_equal_those_of_single_triangles() {
        let scene = scene();
        for center in [DVec3::ZERO, DVec3::new(30.0, 2.0, 20.0)] {
            for rule in [Rule::Surface, Rule::Vertex] {
                let measure =
                    |reach| object_radii(&scene, OBJECTS as usize, center, reach, rule, &Progress::new()).unwrap();
                let expected = one_by_one(&scene, center, rule);
                let all = measure(f64::INFINITY);
                assert_eq!((&all.least, all.measured), (&expected, 3000));
                for reach in [0.0, 5.0, 30.0, 100.0] {
                    let found = measure(reach);
                    let within = |&rho: &f32| if f64::from(rho) <= reach { rho } else { f32::INFINITY };
                    assert_eq!(found.least, expected.iter().map(within).collect::<Vec<_>>());
                    assert!(found.measured <= 2000, "the instance 900 m away was measured");
                }
            }
        }
    }

    #[test]
    fn wrong_reaches_and_centres_are_refused() {
        let scene = scene();
        for (center, reach) in [(DVec3::NAN, 1.0), (DVec3::ZERO, -1.0), (DVec3::ZERO, f64::NAN)] {
            assert!(object_radii(&scene, 6, center, reach, Rule::Surface, &Progress::new()).is_err());
        }
    }
}
