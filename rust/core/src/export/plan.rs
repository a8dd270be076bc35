//! Assignment of a scene to files: merged faces, placements of shared meshes, and moving objects, by group.

use std::collections::{BTreeMap, HashMap};
use std::ptr;
use std::sync::Arc;

use super::grid::Grid;
use super::placement::{greatest_stretch, is_trs, stretch};
use crate::base::memory::try_grow;
use crate::base::{Error, FaceMap, Progress, Result, by_object, ensure};
use crate::scene::{Instance, Mesh, Scene, is_mirror};

/// Limits of `Settings::step`, beyond the needs of float32 positions and within the EXPONENTIAL filter's exponents.
pub(super) const MIN_STEP: f64 = 1.0 / (1u64 << 40) as f64;
pub(super) const MAX_STEP: f64 = (1u64 << 20) as f64;

/// Settings of an export.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Step of the grid of positions in metres, rounded down to a power of two. The error of a position is at most
    /// half a step per axis. Coordinates beyond 2²³ steps use larger steps because of float32; `Statistics` has the
    /// maximum error.
    pub step: f64,
    /// Whether arrays are compressed. Uncompressed files need no extension unless images are WebP.
    pub compressed: bool,
}

impl Default for Settings {
    /// 2⁻¹⁰ m: errors of at most half a millimetre, up to 8 km from the origin.
    fn default() -> Self {
        Self { step: 1.0 / 1024.0, compressed: true }
    }
}

/// A mesh with several placements.
#[derive(Clone, Debug)]
pub(super) struct SharedPlan {
    pub mesh: Arc<Mesh>,
    /// Whether all placements mirror the mesh; then its faces are written flipped.
    pub flipped: bool,
    pub grid: Grid,
    /// Maximum factor by which a placement multiplies an error per axis.
    pub stretch: f64,
    /// Groups with a placement, ascending.
    pub groups: Vec<u16>,
}

/// Faces of an instance.
#[derive(Clone, Debug)]
pub(super) struct InstanceFaces {
    /// Number of the instance.
    pub instance: u32,
    /// Numbers of the faces; `None` for all.
    pub faces: Option<Vec<u32>>,
}

/// A moving instance, or the part of it that belongs to one object.
#[derive(Clone, Debug)]
pub(super) struct Moving {
    /// Number of the object, −1 for none.
    pub object: i32,
    pub faces: InstanceFaces,
    /// Number of the shared mesh with these faces, if it is shared.
    pub shared: Option<usize>,
}

/// Content of a group.
#[derive(Clone, Debug, Default)]
pub(super) struct Contents {
    /// Static faces to be merged.
    pub merged: Vec<InstanceFaces>,
    /// Static placements: numbers of the shared mesh and of the instance.
    pub placed: Vec<(usize, u32)>,
    pub moving: Vec<Moving>,
}

/// Contents of all groups.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    pub shared: Vec<SharedPlan>,
    pub groups: Vec<Contents>,
    /// Grid of the merged faces of all files, so that there are no cracks between them.
    pub merged_grid: Grid,
}

/// A mesh, and whether its faces are flipped.
type Shape = (*const Mesh, bool);

/// An instance with faces.
struct PlacedInstance<'a> {
    number: u32,
    instance: &'a Instance,
    /// The object that all faces belong to, if there is one.
    object: Option<i32>,
    moves: bool,
}

impl PlacedInstance<'_> {
    fn shape(&self) -> Shape {
        (ptr::from_ref(&*self.instance.mesh), is_mirror(&self.instance.to_scene))
    }

    /// Returns whether the instance can refer to a shared mesh. A static sheared placement cannot, because glTF nodes
    /// have no shear, nor can an instance with several objects, because they may belong to several groups.
    fn can_share(&self, step: f64) -> bool {
        let (to_scene, bounds) = (&self.instance.to_scene, self.instance.mesh.bounds());
        self.object.is_some() && (self.moves || is_trs(to_scene, &bounds, step / 2.0))
    }
}

impl Plan {
    /// Divides a scene. `groups` has each object's group, below `count`; its last entry is for faces without an object.
    pub fn new(scene: &Scene, groups: &[u16], count: usize, step: f64, progress: &Progress) -> Result<Self> {
        ensure!(!groups.is_empty(), "groups", "at least the group of faces without an object", "none");
        if let Some(wrong) = groups.iter().find(|&&group| usize::from(group) >= count) {
            return Err(Error::value("groups", format!("group numbers below {count}"), wrong));
        }
        let group_of = |object: i32| *by_object(groups, object);
        let all = placed_instances(scene);
        let shared = shared_meshes(&all, step, &group_of);
        let numbers: HashMap<Shape, usize> =
            shared.iter().enumerate().map(|(i, plan)| ((ptr::from_ref(&*plan.mesh), plan.flipped), i)).collect();
        let mut contents = vec![Contents::default(); count];
        let mut reach: f32 = 0.0;
        for placed in &all {
            progress.check()?;
            let sharing = placed.object.filter(|_| placed.can_share(step)).zip(numbers.get(&placed.shape()).copied());
            if let Some((object, number)) = sharing {
                let contents = &mut contents[usize::from(group_of(object))];
                if placed.moves {
                    let faces = InstanceFaces { instance: placed.number, faces: None };
                    contents.moving.push(Moving { object, faces, shared: Some(number) });
                } else {
                    contents.placed.push((number, placed.number));
                }
            } else if placed.moves {
                for (object, faces) in divide(placed, |object| object)? {
                    let faces = InstanceFaces { instance: placed.number, faces };
                    contents[usize::from(group_of(object))].moving.push(Moving { object, faces, shared: None });
                }
            } else {
                reach = reach.max(placed.instance.bounds.max_coordinate());
                for (group, faces) in divide(placed, group_of)? {
                    contents[usize::from(group)].merged.push(InstanceFaces { instance: placed.number, faces });
                }
            }
        }
        Ok(Self { shared, groups: contents, merged_grid: Grid::new(step, f64::from(reach)) })
    }
}

/// Returns the object that all faces of an instance belong to, if there is one.
pub(super) fn only_object(instance: &Instance) -> Option<i32> {
    match instance.mesh.objects {
        FaceMap::Uniform(object) => Some(instance.object.unwrap_or(object)),
        _ => instance.object,
    }
}

/// Returns all instances with faces, in order.
fn placed_instances(scene: &Scene) -> Vec<PlacedInstance<'_>> {
    let static_count = scene.standing.instances().len();
    let with_faces = scene.instances().enumerate().filter(|(_, instance)| !instance.mesh.faces.is_empty());
    let placed = with_faces.map(|(number, instance)| {
        let object = only_object(instance);
        PlacedInstance { number: number as u32, instance, object, moves: number >= static_count }
    });
    placed.collect()
}

/// Returns the meshes with several placements, in the order of their first placements.
fn shared_meshes(all: &[PlacedInstance<'_>], step: f64, group_of: &impl Fn(i32) -> u16) -> Vec<SharedPlan> {
    let mut users: HashMap<Shape, Vec<&PlacedInstance<'_>>> = HashMap::new();
    for placed in all.iter().filter(|placed| placed.can_share(step)) {
        users.entry(placed.shape()).or_default().push(placed);
    }
    let mut shapes: Vec<(Shape, Vec<&PlacedInstance<'_>>)> =
        users.into_iter().filter(|(_, users)| users.len() > 1).collect();
    shapes.sort_by_key(|(_, users)| users[0].number);
    let plan = |((_, flipped), users): (Shape, Vec<&PlacedInstance<'_>>)| {
        let mesh = Arc::clone(&users[0].instance.mesh);
        let stretch_of = |placed: &&PlacedInstance<'_>| {
            let matrix = &placed.instance.to_scene.matrix3;
            if placed.moves { greatest_stretch(matrix) } else { stretch(matrix) }
        };
        let stretch = users.iter().map(stretch_of).fold(f64::MIN_POSITIVE, f64::max);
        let grid = Grid::new(step / stretch, f64::from(mesh.bounds().max_coordinate()));
        let mut groups: Vec<u16> = users.iter().filter_map(|placed| placed.object.map(group_of)).collect();
        groups.sort_unstable();
        groups.dedup();
        SharedPlan { mesh, flipped, grid, stretch, groups }
    };
    shapes.into_iter().map(plan).collect()
}

/// Divides the faces of an instance by a key of their objects; `None` stands for all faces.
fn divide<K: Ord + Copy>(placed: &PlacedInstance<'_>, key_of: impl Fn(i32) -> K) -> Result<Vec<(K, Option<Vec<u32>>)>> {
    if let Some(object) = placed.object {
        return Ok(vec![(key_of(object), None)]);
    }
    let mesh = &placed.instance.mesh;
    let mut by_key: BTreeMap<K, Vec<u32>> = BTreeMap::new();
    let mut run = None;
    let mut close = |run: Option<(usize, K)>, end: usize| {
        let Some((start, key)) = run else { return Ok(()) };
        let faces = by_key.entry(key).or_default();
        try_grow(faces, end - start)?;
        faces.extend(start as u32..end as u32);
        Ok(())
    };
    for (start, object) in mesh.objects.runs(mesh.faces.len()) {
        close(run.replace((start, key_of(object))), start)?;
    }
    close(run, mesh.faces.len())?;
    let all = |faces: &Vec<u32>| faces.len() == mesh.faces.len();
    Ok(by_key.into_iter().map(|(key, faces)| (key, Some(faces).filter(|faces| !all(faces)))).collect())
}
