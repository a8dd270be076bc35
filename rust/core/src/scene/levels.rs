//! Objects at chosen levels of detail. Each level of a model is a mesh; an instance uses the mesh of the chosen level.
//! A choice creates only lists of instances, so thousands of objects can change within a frame.

use std::sync::Arc;

use glam::DAffine3;

use super::edit::contains;
use super::instance::{Instance, InstanceSet};
use super::material::Material;
use super::merge::{PlacedMesh, merge};
use super::mesh::Mesh;
use super::texture::Texture;
use super::world::Scene;
use crate::base::memory::try_with_capacity;
use crate::base::{Error, Progress, Result, by_number, ensure};

/// Marks an object without a model, and a level that is not drawn.
const NONE: i32 = -1;

/// Meshes of a model, one per level, level 0 first.
pub type LevelMeshes = Vec<Arc<Mesh>>;

/// Returns the mesh of a model's level; `None` for a level that is not drawn.
fn mesh_of(models: &[LevelMeshes], model: usize, level: i32) -> Result<Option<&Arc<Mesh>>> {
    let missing = || Error::value("models", format!("numbers of models below {}", models.len()), model);
    let levels = models.get(model).ok_or_else(missing)?;
    if level == NONE {
        return Ok(None);
    }
    let missing = || Error::value("levels", format!("-1 or levels below {}", levels.len()), level);
    by_number(levels, level).map(Some).ok_or_else(missing)
}

impl Scene {
    /// Adds the materials and textures of other scenes to this scene, without duplicates. Also returns each of the
    /// other scenes as one mesh in its own frame, with the new material numbers.
    pub fn with_surfaces(&self, others: &[&Self], progress: &Progress) -> Result<(Self, Vec<Mesh>)> {
        let mut surfaces = Surfaces::from_scene(self);
        let mut meshes = Vec::new();
        for other in others {
            let numbers = surfaces.add(other);
            let from_origin = DAffine3::from_translation(other.origin);
            let placed = |instance: &Instance| PlacedMesh {
                to_scene: from_origin * instance.to_scene,
                ..PlacedMesh::from_instance(instance)
            };
            let mut mesh = merge(&other.instances().map(placed).collect::<Vec<_>>(), progress)?;
            mesh.materials = mesh.materials.renumbered(&numbers)?;
            meshes.push(mesh);
        }
        Ok((surfaces.into_scene(self), meshes))
    }

    /// Returns the scene with its objects at levels. Per object, `models` holds the index of its model in `meshes` (−1
    /// for none) and `chosen` the level to draw (−1 to omit the object).
    pub fn at_levels(&self, meshes: &[LevelMeshes], models: &[i32], chosen: &[i32]) -> Result<Self> {
        let is_paired = models.len() == chosen.len();
        ensure!(is_paired, "levels", format!("one for each of {} objects", models.len()), chosen.len());
        let [standing, moving] = self.sets().map(|set| set.at_levels(meshes, models, chosen));
        Ok(self.with_sets(standing?, moving?))
    }

    /// Returns the instances that belong entirely to an object of `chosen`, a flag per object.
    pub fn instances_of(&self, chosen: &[bool]) -> impl Iterator<Item = (i32, &Instance)> {
        self.instances().filter_map(move |instance| {
            instance.object.filter(|&object| contains(chosen, object)).map(|object| (object, instance))
        })
    }
}

impl InstanceSet {
    /// Returns the instances at their levels; `None` if no instance changes.
    fn at_levels(&self, meshes: &[LevelMeshes], models: &[i32], chosen: &[i32]) -> Result<Option<Self>> {
        let mut instances = try_with_capacity(self.instances().len())?;
        let mut is_unchanged = true;
        for instance in self.instances() {
            let object = instance.object.and_then(|object| usize::try_from(object).ok());
            let model = object.and_then(|object| models.get(object)).and_then(|&model| usize::try_from(model).ok());
            let (Some(object), Some(model)) = (object, model) else {
                instances.push(instance.clone());
                continue;
            };
            match mesh_of(meshes, model, chosen[object])? {
                Some(mesh) if Arc::ptr_eq(mesh, &instance.mesh) => instances.push(instance.clone()),
                Some(mesh) => {
                    is_unchanged = false;
                    instances.push(instance.with_mesh(Arc::clone(mesh), instance.object));
                }
                None => is_unchanged = false,
            }
        }
        Ok((!is_unchanged).then(|| Self::new(instances)))
    }
}

/// Materials and textures of several scenes, without duplicates.
pub(super) struct Surfaces<'a> {
    materials: Vec<Material>,
    /// Textures of all scenes; the result gets copies that share their texels.
    textures: Vec<&'a Texture>,
}

impl<'a> Surfaces<'a> {
    pub(super) fn from_scene(scene: &'a Scene) -> Self {
        Self { materials: scene.materials.to_vec(), textures: scene.textures.iter().collect() }
    }

    /// Adds a scene's materials and textures; returns the new number of each of its materials.
    pub(super) fn add(&mut self, scene: &'a Scene) -> Vec<i32> {
        let is_same = |a: &&Texture, b: &&Texture| a.is_same(b);
        let add = |texture| index_of(&mut self.textures, texture, is_same) as u32;
        let textures: Vec<u32> = scene.textures.iter().map(add).collect();
        let number = |material: &Material| {
            let link = |texture: Option<u32>| texture.and_then(|texture| textures.get(texture as usize).copied());
            let (texture, emission_texture) = (link(material.texture), link(material.emission_texture));
            let linked = Material { texture, emission_texture, ..*material };
            index_of(&mut self.materials, linked, PartialEq::eq) as i32
        };
        scene.materials.iter().map(number).collect()
    }

    /// Returns `scene` with these materials and textures. A list to which nothing was added is not replaced, because
    /// GPU back ends identify lists by their addresses.
    pub(super) fn into_scene(self, scene: &Scene) -> Scene {
        let mut result = scene.clone();
        if self.textures.len() > scene.textures.len() {
            result.textures = Arc::new(self.textures.into_iter().map(Texture::share).collect());
        }
        if self.materials.len() > scene.materials.len() {
            result.materials = Arc::new(self.materials);
        }
        result
    }
}

/// Returns the index of an item in a list; appends it if the list has no equal one.
fn index_of<T>(list: &mut Vec<T>, item: T, is_same: impl Fn(&T, &T) -> bool) -> usize {
    list.iter().position(|other| is_same(other, &item)).unwrap_or_else(|| {
        list.push(item);
        list.len() - 1
    })
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::base::FaceMap;

    /// A fan of `count` triangles with one material of a scene.
    fn fan(count: u32, material: i32) -> Arc<Mesh> {
        let rim = (0..=count).map(|i| [f64::from(i).cos() as f32, f64::from(i).sin() as f32, 0.0]);
        let positions: Vec<[f32; 3]> = std::iter::once([0.0; 3]).chain(rim).collect();
        let faces: Vec<[u32; 3]> = (1..=count).map(|i| [0, i, i + 1]).collect();
        let (objects, materials) = (FaceMap::Uniform(-1), FaceMap::Uniform(material));
        Arc::new(Mesh::new(positions.into(), faces.into(), None, None, objects, materials).unwrap())
    }

    fn instance(mesh: &Arc<Mesh>, x: f64, object: i32) -> Instance {
        Instance::new(Arc::clone(mesh), DAffine3::from_translation(DVec3::X * x), Some(object)).unwrap()
    }

    fn image(code: u8) -> Texture {
        Texture::new(1, 2, vec![[code; 4]; 2].into()).unwrap()
    }

    fn scene(standing: Vec<Instance>, materials: Vec<Material>, textures: Vec<Texture>) -> Scene {
        Scene::new(DVec3::ZERO, standing, Vec::new(), Arc::new(materials), Arc::new(textures)).unwrap()
    }

    #[test]
    fn surfaces_are_added_once_and_meshes_refer_to_them() {
        let red = |texture| Material { base_color: [1.0, 0.0, 0.0, 1.0], texture, ..Material::default() };
        let own = scene(vec![instance(&fan(2, 0), 0.0, 0)], vec![red(Some(0))], vec![image(7)]);
        let mesh = fan(3, 1);
        let other = || scene(vec![instance(&mesh, 0.0, 0)], vec![red(Some(0)), red(Some(1))], vec![image(9), image(7)]);
        let (joined, meshes) = own.with_surfaces(&[&other(), &other()], &Progress::new()).unwrap();
        assert_eq!(*joined.materials, vec![red(Some(0)), red(Some(1))]);
        assert_eq!(joined.textures.iter().map(|t| t.texels[0][0]).collect::<Vec<_>>(), [7, 9]);
        for level in &meshes {
            // The other scene's material 1 has texels that this scene already had.
            assert_eq!(level.materials.get(2), 0);
            assert_eq!(level.positions.as_ptr(), mesh.positions.as_ptr());
        }
        let (again, _) = joined.with_surfaces(&[&other()], &Progress::new()).unwrap();
        assert!(Arc::ptr_eq(&again.materials, &joined.materials) && Arc::ptr_eq(&again.textures, &joined.textures));
    }

    #[test]
    fn equal_materials_with_different_tags_stay_separate() {
        let tagged = |tag| Material { tag, ..Material::default() };
        let level = |tag| scene(vec![instance(&fan(1, 0), 0.0, 0)], vec![tagged(tag)], vec![]);
        let (joined, meshes) = level(1).with_surfaces(&[&level(2), &level(1)], &Progress::new()).unwrap();
        assert_eq!(*joined.materials, vec![tagged(1), tagged(2)]);
        assert_eq!([meshes[0].materials.get(0), meshes[1].materials.get(0)], [1, 0]);
    }

    #[test]
    fn a_level_of_several_placed_meshes_is_one_mesh_in_its_own_frame() {
        let level =
            scene(vec![instance(&fan(1, 0), 0.0, 0), instance(&fan(2, 0), 5.0, 1)], vec![Material::default()], vec![]);
        let far = Scene { origin: DVec3::Y * 1e5, ..level.clone() };
        let (_, meshes) = scene(vec![], vec![], vec![]).with_surfaces(&[&level, &far], &Progress::new()).unwrap();
        assert_eq!(meshes[0].faces.len(), 3);
        assert_eq!(meshes[0].corners(1)[0].to_array(), [5.0, 0.0, 0.0]);
        assert_eq!(meshes[1].corners(1)[0].to_array(), [5.0, 1e5, 0.0]);
    }

    #[test]
    fn objects_show_their_levels_and_others_are_unchanged() {
        let (fine, coarse, wall) = (fan(9, 0), fan(2, 0), fan(4, 0));
        let meshes = [vec![Arc::clone(&fine), Arc::clone(&coarse)]];
        let all =
            vec![instance(&wall, 0.0, 0), instance(&fine, 1.0, 1), instance(&fine, 2.0, 2), instance(&fine, 3.0, 3)];
        let whole = scene(all, vec![Material::default()], vec![]);
        let models = [-1, 0, 0, 0];
        let shown = whole.at_levels(&meshes, &models, &[-1, 0, 1, -1]).unwrap();
        let found: Vec<_> =
            shown.instances().map(|i| (i.object, i.mesh.faces.len(), i.to_scene.translation.x)).collect();
        assert_eq!(found, [(Some(0), 4, 0.0), (Some(1), 9, 1.0), (Some(2), 2, 2.0)]);
        assert!(Arc::ptr_eq(&shown.instance(2).mesh, &coarse));
        assert_eq!(shown.instance(2).bounds, instance(&coarse, 2.0, 2).bounds);
        let same = whole.at_levels(&meshes, &models, &[5, 0, 0, 0]).unwrap();
        assert!(Arc::ptr_eq(&same.standing, &whole.standing) && Arc::ptr_eq(&same.moving, &whole.moving));
    }

    #[test]
    fn levels_that_do_not_exist_are_refused() {
        let fine = fan(9, 0);
        let whole = scene(vec![instance(&fine, 0.0, 0)], vec![Material::default()], vec![]);
        let meshes = [vec![fine]];
        for (models, chosen) in [(0, 1), (0, -2), (1, 0)] {
            assert!(whole.at_levels(&meshes, &[models], &[chosen]).is_err());
        }
        assert!(whole.at_levels(&meshes, &[0], &[]).is_err());
    }
}
