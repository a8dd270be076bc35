//! Derived scenes with more moving objects or fewer triangles. Unchanged meshes, their trees and textures are shared.

use std::sync::Arc;

use glam::DAffine3;

use super::instance::{Instance, InstanceSet};
use super::merge::{PlacedMesh, merge};
use super::mesh::Mesh;
use super::world::Scene;
use crate::base::mapped::filtered;
use crate::base::memory::{try_concat, try_extend, try_list, try_push};
use crate::base::sort::sort_by_key;
use crate::base::{FaceMap, Progress, Result, by_number, ensure};

impl Scene {
    /// Returns the scene with the objects of `chosen` (a flag per object) moving as well. Faces of merged meshes
    /// become separate meshes, one per object, appended to the moving instances in the order of instances and objects.
    pub fn with_moving(&self, chosen: &[bool], progress: &Progress) -> Result<Self> {
        if !chosen.contains(&true) {
            return Ok(self.clone());
        }
        let is_chosen = |object| contains(chosen, object);
        let (mut standing, mut moving) = (Vec::new(), try_concat(&[self.moving.instances()])?);
        for instance in self.standing.instances() {
            match instance.object {
                Some(object) if is_chosen(object) => try_push(&mut moving, instance.clone())?,
                Some(_) => try_push(&mut standing, instance.clone())?,
                None => match split(&instance.mesh, is_chosen, progress)? {
                    None => try_push(&mut standing, instance.clone())?,
                    Some((unchosen, by_object)) => {
                        if !unchosen.faces.is_empty() {
                            standing.push(instance.with_mesh(Arc::new(unchosen), None));
                        }
                        let placed = |(object, mesh)| instance.with_mesh(Arc::new(mesh), Some(object));
                        try_extend(&mut moving, by_object.into_iter().map(placed))?;
                    }
                },
            }
        }
        if moving.len() == self.moving.instances().len() {
            return Ok(self.clone());
        }
        Ok(self.with_sets(Some(InstanceSet::new(standing)), Some(InstanceSet::new(moving))))
    }

    /// Returns a scene with only the objects of `chosen`, a flag per object.
    pub fn subset_of_objects(&self, chosen: &[bool], progress: &Progress) -> Result<Self> {
        self.subset_by_object(|object| contains(chosen, object), progress)
    }

    /// Returns the scene without the objects of `chosen`, a flag per object; faces without an object stay.
    pub fn without_objects(&self, chosen: &[bool], progress: &Progress) -> Result<Self> {
        self.subset_by_object(|object| !contains(chosen, object), progress)
    }

    fn subset_by_object(&self, stays: impl Fn(i32) -> bool + Sync, progress: &Progress) -> Result<Self> {
        let keep = |_, instance: &Instance| match instance.object {
            Some(object) if stays(object) => Ok(None),
            Some(_) => Ok(Some(Vec::new())),
            None => remaining_faces(&instance.mesh, |face| stays(instance.mesh.objects.get(face)), progress),
        };
        self.subset(keep, progress)
    }

    /// Returns the scene with additional instances, appended to the existing static and moving ones.
    pub fn with_instances(&self, standing: Vec<Instance>, moving: Vec<Instance>) -> Self {
        let appended = |old: &InstanceSet, new: Vec<Instance>| {
            (!new.is_empty()).then(|| InstanceSet::new(old.instances().iter().cloned().chain(new).collect()))
        };
        self.with_sets(appended(&self.standing, standing), appended(&self.moving, moving))
    }

    /// Returns a scene with only the triangles of `chosen`, a flag per triangle.
    pub fn subset_of_triangles(&self, chosen: &[bool], progress: &Progress) -> Result<Self> {
        let count = self.triangle_count();
        let is_complete = chosen.len() as i64 == count;
        ensure!(is_complete, "triangles", format!("a flag for each of {count} triangles"), chosen.len());
        let keep = |first: i64, instance: &Instance| {
            let flags = &chosen[first as usize..][..instance.mesh.faces.len()];
            remaining_faces(&instance.mesh, |face| flags[face as usize], progress)
        };
        self.subset(keep, progress)
    }

    /// Returns one mesh of the given faces (instance, face), relative to the scene's origin. The faces of an instance
    /// must be consecutive. The object of each face is its index in the list.
    pub fn gathered(&self, chosen: &[(u32, u32)], progress: &Progress) -> Result<Mesh> {
        ensure!(chosen.len() <= i32::MAX as usize, "triangles", "fewer than 2^31 in one mesh", chosen.len());
        let mut first = 0;
        let parts = chosen.chunk_by(|a, b| a.0 == b.0).map(|run| {
            let instance = self.instance(run[0].0);
            let faces = try_list(run.iter().map(|&(_, face)| face))?;
            let mut mesh = instance.mesh.selected(&faces, progress)?;
            mesh.objects = FaceMap::PerFace(try_list(first..first + run.len() as i32)?.into());
            first += run.len() as i32;
            Ok(PlacedMesh { mesh: Arc::new(mesh), to_scene: instance.to_scene, object: None })
        });
        merge(&parts.collect::<Result<Vec<_>>>()?, progress)
    }

    /// Returns a scene with some of its faces. `keep` gets the number of an instance's first triangle and the instance,
    /// and returns the faces that stay; `None` for all.
    fn subset(&self, keep: impl Fn(i64, &Instance) -> Result<Option<Vec<u32>>>, progress: &Progress) -> Result<Self> {
        let mut first = 0;
        let mut subset_of_set = |set: &InstanceSet| -> Result<Option<InstanceSet>> {
            let mut is_unchanged = true;
            let mut instances = Vec::new();
            for instance in set.instances() {
                let remaining = keep(first, instance)?;
                first += instance.mesh.faces.len() as i64;
                is_unchanged &= remaining.is_none();
                match remaining {
                    None => try_push(&mut instances, instance.clone())?,
                    Some(faces) if faces.is_empty() => {}
                    Some(faces) => {
                        let mesh = Arc::new(instance.mesh.selected(&faces, progress)?);
                        try_push(&mut instances, instance.with_mesh(mesh, instance.object))?;
                    }
                }
            }
            Ok((!is_unchanged).then(|| InstanceSet::new(instances)))
        };
        Ok(self.with_sets(subset_of_set(&self.standing)?, subset_of_set(&self.moving)?))
    }
}

impl Instance {
    /// Returns the same placement with another mesh.
    pub(super) fn with_mesh(&self, mesh: Arc<Mesh>, object: Option<i32>) -> Self {
        let bounds = mesh.bounds().transformed(&self.to_scene);
        Self { mesh, object, bounds, ..self.clone() }
    }

    /// Returns the same mesh with another transform.
    pub fn with_transform(&self, to_scene: DAffine3) -> Result<Self> {
        Self::new(Arc::clone(&self.mesh), to_scene, self.object)
    }
}

/// Returns the flag of an object; false without one.
pub(super) fn contains(chosen: &[bool], object: i32) -> bool {
    by_number(chosen, object) == Some(&true)
}

/// Returns the faces of a mesh that remain; `None` for all.
fn remaining_faces(mesh: &Mesh, remains: impl Fn(u32) -> bool + Sync, progress: &Progress) -> Result<Option<Vec<u32>>> {
    let faces = filtered(mesh.faces.len() as u32, remains, progress)?;
    Ok(Some(faces).filter(|faces| faces.is_empty() || faces.len() < mesh.faces.len()))
}

/// Mesh of the faces that were not chosen, and a mesh of the faces of each chosen object.
type Split = (Mesh, Vec<(i32, Mesh)>);

/// Splits a mesh; `None` if no face is chosen.
fn split(mesh: &Mesh, is_chosen: impl Fn(i32) -> bool + Sync, progress: &Progress) -> Result<Option<Split>> {
    if !mesh.objects.runs(mesh.faces.len()).any(|(_, object)| is_chosen(object)) {
        return Ok(None);
    }
    let object = |face: &u32| mesh.objects.get(*face);
    let count = mesh.faces.len() as u32;
    let mut chosen = filtered(count, |face| is_chosen(object(&face)), progress)?;
    let unchosen = filtered(count, |face| !is_chosen(object(&face)), progress)?;
    // Stable, so that each object keeps the order of its faces.
    sort_by_key(&mut chosen, object, progress)?;
    let runs = chosen.chunk_by(|a, b| object(a) == object(b));
    let by_object =
        runs.map(|faces| Ok((object(&faces[0]), mesh.selected(faces, progress)?))).collect::<Result<_>>()?;
    Ok(Some((mesh.selected(&unchosen, progress)?, by_object)))
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, Vec3};
    use proptest::collection::vec;
    use proptest::prelude::*;

    use super::*;
    use crate::scene::Material;

    /// A row of triangles along x, one for each entry of `objects`, and a higher instance of the first triangle.
    fn row(objects: &[i32]) -> Scene {
        let corners = |i: usize| [[i as f32, 0.0, 0.0], [i as f32 + 0.5, 0.0, 0.0], [i as f32, 0.5, 0.0]];
        let triangles: Vec<_> = (0..objects.len()).map(corners).collect();
        let row = Mesh::of_triangles(&triangles, FaceMap::PerFace(objects.to_vec().into()));
        let single = Mesh::of_triangles(&[corners(0)], FaceMap::Uniform(-1));
        let standing = vec![
            Instance::new(row, DAffine3::IDENTITY, None).unwrap(),
            Instance::new(single, DAffine3::from_translation(DVec3::Y * 9.0), Some(3)).unwrap(),
        ];
        let materials = Arc::new(vec![Material::default()]);
        Scene::new(DVec3::ZERO, standing, Vec::new(), materials, Arc::default()).unwrap()
    }

    #[test]
    fn gathered_faces_keep_positions_and_indices() {
        let scene = row(&[0, 1, 2, 3]);
        let chosen = [(0, 3), (0, 1), (1, 0)];
        let mesh = scene.gathered(&chosen, &Progress::new()).unwrap();
        for (place, &(instance, face)) in chosen.iter().enumerate() {
            assert_eq!(mesh.objects.get(place as u32), place as i32);
            assert_eq!(mesh.corners(place as u32), scene.instance(instance).corners(face));
        }
        assert!(scene.gathered(&[], &Progress::new()).unwrap().faces.is_empty());
    }

    /// Returns object and corners of each triangle, sorted, so that the order of triangles does not matter.
    fn contents(scene: &Scene) -> Vec<(i32, [Vec3; 3])> {
        let triangles = |instance: &Instance| {
            (0..instance.mesh.faces.len() as u32)
                .map(|face| (instance.object_of(face), instance.corners(face)))
                .collect::<Vec<_>>()
        };
        let mut all: Vec<_> = scene.instances().flat_map(triangles).collect();
        all.sort_by_key(|(object, corners)| (*object, corners.map(|p| p.to_array().map(f32::to_bits))));
        all
    }

    proptest! {
        #[test]
        fn separating_moving_objects_changes_no_surface(objects in vec(0i32..4, 1..30), chosen in vec(any::<bool>(), 4)) {
            let scene = row(&objects);
            let moved = scene.with_moving(&chosen, &Progress::new()).unwrap();
            prop_assert_eq!(contents(&moved), contents(&scene));
            for instance in moved.moving.instances() {
                prop_assert!(chosen[instance.object.unwrap() as usize]);
            }
            for instance in moved.standing.instances() {
                prop_assert!((0..instance.mesh.faces.len() as u32).all(|face| !chosen[instance.object_of(face) as usize]));
            }
        }

        #[test]
        fn subsets_contain_the_chosen_triangles(objects in vec(0i32..4, 1..30), chosen in vec(any::<bool>(), 4)) {
            let scene = row(&objects);
            let expected: Vec<_> =
                contents(&scene).into_iter().filter(|(object, _)| chosen[*object as usize]).collect();
            prop_assert_eq!(contents(&scene.subset_of_objects(&chosen, &Progress::new()).unwrap()), expected.clone());
            let flags: Vec<bool> = (0..scene.triangle_count())
                .map(|triangle| {
                    let (instance, face) = scene.locate(triangle).unwrap();
                    chosen[scene.instance(instance).object_of(face) as usize]
                })
                .collect();
            prop_assert_eq!(contents(&scene.subset_of_triangles(&flags, &Progress::new()).unwrap()), expected);
        }
    }

    #[test]
    fn untouched_parts_are_shared() {
        let scene = row(&[0, 1, 1]);
        let upper = |scene: &Scene| Arc::as_ptr(&scene.standing.instances().last().unwrap().mesh);
        assert_eq!(upper(&scene.with_moving(&[true], &Progress::new()).unwrap()), upper(&scene));
        assert_eq!(
            upper(&scene.subset_of_objects(&[false, true, false, true], &Progress::new()).unwrap()),
            upper(&scene)
        );
        let whole = scene.subset_of_objects(&[true; 4], &Progress::new()).unwrap();
        assert!(Arc::ptr_eq(&whole.standing, &scene.standing));
        assert!(Arc::ptr_eq(&scene.with_moving(&[false; 4], &Progress::new()).unwrap().standing, &scene.standing));
    }

    #[test]
    fn a_wrong_number_of_flags_is_refused() {
        assert!(row(&[0]).subset_of_triangles(&[true], &Progress::new()).is_err());
    }
}
