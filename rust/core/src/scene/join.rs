//! Joining several scenes, such as the tiles of a world, into one.

use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::sync::Arc;

use glam::DAffine3;

use super::instance::{Instance, InstanceSet};
use super::levels::Surfaces;
use super::mesh::Mesh;
use super::world::Scene;
use crate::base::{Error, Progress, Result, by_number};

/// A scene to be joined with others.
#[derive(Clone, Copy, Debug)]
pub struct Joined<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Object numbers in the joined scene, indexed by this scene's objects.
    pub objects: &'a [i32],
}

impl Scene {
    /// Joins scenes into one, in the frame of the first. Equal materials and textures are stored once. Meshes whose
    /// object and material numbers do not change are shared with their search trees; others share vertices and faces.
    pub fn join(parts: &[Joined<'_>], progress: &Progress) -> Result<Self> {
        let [first, ..] = parts else { return Err(Error::value("scenes", "at least one", 0)) };
        let mut surfaces = Surfaces::from_scene(first.scene);
        let (mut standing, mut moving) = (Vec::new(), Vec::new());
        for part in parts {
            progress.check()?;
            // Renumbered meshes by original mesh; each is created once.
            let mut meshes: HashMap<*const Mesh, Arc<Mesh>> = HashMap::new();
            let (objects, materials) = (part.objects, surfaces.add(part.scene));
            let is_unchanged = |numbers: &[i32]| numbers.iter().zip(0..).all(|(&number, index)| number == index);
            let mut renumber = |instance: &Instance| -> Result<Instance> {
                let object = instance.object.map(|object| by_number(objects, object).copied().unwrap_or(object));
                let shared = &instance.mesh;
                if is_unchanged(objects) && is_unchanged(&materials) {
                    return Ok(instance.with_mesh(Arc::clone(shared), object));
                }
                let mesh = match meshes.entry(Arc::as_ptr(shared)) {
                    Entry::Occupied(known) => Arc::clone(known.get()),
                    Entry::Vacant(place) => {
                        let (objects, materials) =
                            (shared.objects.renumbered(objects)?, shared.materials.renumbered(&materials)?);
                        Arc::clone(place.insert(Arc::new(shared.relabeled(objects, materials))))
                    }
                };
                Ok(instance.with_mesh(mesh, object))
            };
            let shift = DAffine3::from_translation(part.scene.origin - first.scene.origin);
            let mut add = |set: &InstanceSet, list: &mut Vec<Instance>| {
                for instance in set.instances() {
                    let renumbered = renumber(instance)?;
                    list.push(if shift == DAffine3::IDENTITY {
                        renumbered
                    } else {
                        renumbered.with_transform(shift * renumbered.to_scene)?
                    });
                }
                Ok(())
            };
            add(&part.scene.standing, &mut standing)?;
            add(&part.scene.moving, &mut moving)?;
        }
        let (standing, moving) = (InstanceSet::new(standing), InstanceSet::new(moving));
        Ok(surfaces.into_scene(&first.scene.with_sets(Some(standing), Some(moving))))
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::base::FaceMap;
    use crate::scene::Material;

    fn scene(origin: f64, colors: &[f32]) -> Scene {
        let positions = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let objects = FaceMap::PerFace(vec![0, 1].into());
        let materials = FaceMap::Uniform(colors.len() as i32 - 1);
        let faces = vec![[0, 1, 2], [2, 1, 0]];
        let mesh = Arc::new(Mesh::new(positions.into(), faces.into(), None, None, objects, materials).unwrap());
        let moving = Instance::new(Arc::clone(&mesh), DAffine3::from_translation(DVec3::Y), Some(1)).unwrap();
        let standing = Instance::new(mesh, DAffine3::IDENTITY, None).unwrap();
        let color = |&red: &f32| Material { base_color: [red, 0.0, 0.0, 1.0], ..Material::default() };
        let materials = Arc::new(colors.iter().map(color).collect());
        Scene::new(DVec3::X * origin, vec![standing], vec![moving], materials, Arc::default()).unwrap()
    }

    #[test]
    fn joined_scenes_have_all_objects_and_each_material_once() {
        let (first, second) = (scene(0.0, &[0.5]), scene(10.0, &[1.0, 0.5]));
        let parts = [Joined { scene: &first, objects: &[0, 1] }, Joined { scene: &second, objects: &[1, 2] }];
        let all = Scene::join(&parts, &Progress::new()).unwrap();
        assert_eq!(all.materials.len(), 2);
        let objects: Vec<_> = all.instances().map(|i| [i.object_of(0), i.object_of(1)]).collect();
        assert_eq!(objects, [[0, 1], [1, 2], [1, 1], [2, 2]]);
        assert!(all.instances().all(|i| i.mesh.materials.get(0) == 0));
        assert!(Arc::ptr_eq(&all.instance(0).mesh, &first.instance(0).mesh));
        assert!(Arc::ptr_eq(&all.instance(1).mesh, &all.instance(3).mesh));
        assert_eq!(all.instance(1).corners(0)[0].to_array(), [10.0, 0.0, 0.0]);
        assert_eq!(all.instance(3).corners(0)[0].to_array(), [10.0, 1.0, 0.0]);
        assert!(Scene::join(&[], &Progress::new()).is_err());
    }
}
