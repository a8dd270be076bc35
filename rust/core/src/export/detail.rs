//! Resolution of a scene's textures as seen by the user, which decides how far their images may be reduced.

use std::collections::HashMap;
use std::ops::Range;
use std::ptr;
use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use rayon::prelude::*;

use super::placement::scale;
use super::plan::only_object;
use crate::base::{Error, Progress, Result, by_number, by_object, ensure};
use crate::scene::{Material, Mesh, Scene};

/// Number of faces per task.
const CHUNK: usize = 1 << 14;

/// Returns, for each texture, the minimum number of texels per radian over the faces that show it; ∞ if none does. For
/// a face this is its texels per metre, along the direction of the highest density, times the distance of its object.
/// `distances` has the minimum distance of each object in metres; its last entry is for faces without an object.
///
/// A mesh with several placements is read once. A placement with a non-uniform scale counts with its maximum scale.
pub fn texels_per_radian(scene: &Scene, distances: &[f64], progress: &Progress) -> Result<Vec<f64>> {
    ensure!(!distances.is_empty(), "distances", "at least the distance of faces without an object", "none");
    if let Some(wrong) = distances.iter().find(|distance| distance.is_nan() || **distance < 0.0) {
        return Err(Error::value("distances", "distances of at least 0", wrong));
    }
    let seen_meshes = seen_meshes(scene, distances);
    progress.expect(seen_meshes.iter().map(|seen| seen.mesh.faces.len() as u64).sum());
    let min_texels = MinTexels(scene.textures.iter().map(|_| AtomicU64::new(f64::INFINITY.to_bits())).collect());
    seen_meshes.par_iter().try_for_each(|seen| {
        seen.mesh.faces.par_chunks(CHUNK).enumerate().try_for_each(|(chunk, faces)| {
            let first = (chunk * CHUNK) as u32;
            min_texels.lower_by_faces(scene, seen, distances, first..first + faces.len() as u32);
            progress.report(faces.len() as u64)
        })
    })?;
    Ok(min_texels.0.into_iter().map(|bits| f64::from_bits(bits.into_inner())).collect())
}

/// A mesh with textures, and the distances of its placements.
struct SeenMesh<'a> {
    mesh: &'a Mesh,
    /// Minimum of distance / scale over the placements that are one object.
    distance: f64,
    /// Maximum scale of the placements whose faces belong to several objects; 0 if there are none.
    scale: f64,
}

/// Returns the textured meshes of a scene that are at a finite distance.
fn seen_meshes<'a>(scene: &'a Scene, distances: &[f64]) -> Vec<SeenMesh<'a>> {
    let mut indices: HashMap<*const Mesh, usize> = HashMap::new();
    let mut seen_meshes: Vec<SeenMesh<'a>> = Vec::new();
    for instance in scene.instances().filter(|instance| is_textured(scene, &instance.mesh)) {
        let index = *indices.entry(ptr::from_ref(&*instance.mesh)).or_insert_with(|| {
            seen_meshes.push(SeenMesh { mesh: &instance.mesh, distance: f64::INFINITY, scale: 0.0 });
            seen_meshes.len() - 1
        });
        let seen = &mut seen_meshes[index];
        let scale = scale(&instance.to_scene.matrix3);
        match only_object(instance) {
            Some(object) => seen.distance = seen.distance.min(*by_object(distances, object) / scale),
            None => seen.scale = seen.scale.max(scale),
        }
    }
    seen_meshes.retain(|seen| seen.scale > 0.0 || seen.distance < f64::INFINITY);
    seen_meshes
}

fn is_textured(scene: &Scene, mesh: &Mesh) -> bool {
    let has_texture = |number: i32| textures_of(scene, number).next().is_some();
    mesh.uvs.is_some() && mesh.materials.runs(mesh.faces.len()).any(|(_, number)| has_texture(number))
}

fn textures_of(scene: &Scene, material: i32) -> impl Iterator<Item = usize> {
    by_number(&scene.materials, material).into_iter().flat_map(Material::textures).map(|texture| texture as usize)
}

/// Minimum number of texels per radian found so far for each texture, as float bits. The bits sort like the numbers,
/// because no number is negative.
struct MinTexels(Vec<AtomicU64>);

impl MinTexels {
    fn lower_by_faces(&self, scene: &Scene, seen: &SeenMesh<'_>, distances: &[f64], faces: Range<u32>) {
        let Some(uvs) = seen.mesh.uvs.as_deref() else { return };
        let mut run = (None, f64::INFINITY);
        for face in faces {
            let mut distance = seen.distance;
            if seen.scale > 0.0 {
                distance = distance.min(*by_object(distances, seen.mesh.objects.get(face)) / seen.scale);
            }
            if distance == f64::INFINITY {
                continue;
            }
            for texture in textures_of(scene, seen.mesh.materials.get(face)) {
                let image = &scene.textures[texture];
                let size = [f64::from(image.width), f64::from(image.height)];
                let corners = seen.mesh.corners(face).map(|corner| corner.as_dvec3());
                let texels = seen.mesh.faces[face as usize].map(|vertex| {
                    let [u, v] = uvs[vertex as usize].map(f64::from);
                    [u * size[0], v * size[1]]
                });
                let Some(density) = texels_per_metre(corners, texels) else { continue };
                if run.0 != Some(texture) {
                    self.lower(run);
                    run = (Some(texture), f64::INFINITY);
                }
                run.1 = f64::min(run.1, density * distance);
            }
        }
        self.lower(run);
    }

    fn lower(&self, (texture, texels): (Option<usize>, f64)) {
        if let Some(texture) = texture {
            self.0[texture].fetch_min(texels.to_bits(), Ordering::Relaxed);
        }
    }
}

/// Returns the texels per metre of a face in the direction in which they are densest; `None` for faces without area; 0
/// if texture coordinates are not finite.
///
/// This is the maximum singular value of the map J = T E⁻¹ from the face's plane to the image. E and T have two edges
/// of the face as columns, in the plane and in the image. JᵀJ has the eigenvalues of A B⁻¹ with A = TᵀT, B = EᵀE.
fn texels_per_metre(corners: [DVec3; 3], texels: [[f64; 2]; 3]) -> Option<f64> {
    let [p, q] = [corners[1] - corners[0], corners[2] - corners[0]];
    let [s, t] = [1, 2].map(|i| [texels[i][0] - texels[0][0], texels[i][1] - texels[0][1]]);
    let area = p.cross(q).length_squared();
    if area == 0.0 {
        return None;
    }
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let trace = (dot(s, s) * q.dot(q) - 2.0 * dot(s, t) * p.dot(q) + dot(t, t) * p.dot(p)) / area;
    let determinant = (s[0] * t[1] - s[1] * t[0]).powi(2) / area;
    let half_trace = trace / 2.0;
    let max_eigenvalue = half_trace + (half_trace * half_trace - determinant).max(0.0).sqrt();
    Some(if max_eigenvalue.is_finite() { max_eigenvalue.max(0.0).sqrt() } else { 0.0 })
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::{DAffine3, DQuat};

    use super::*;
    use crate::base::FaceMap;
    use crate::base::random::uniform;
    use crate::scene::{Instance, Texture};

    const FACES: u64 = 40;

    /// Random triangles with two textured materials, one of them emissive, and one without a texture.
    fn mesh(seed: u64, objects: FaceMap) -> Arc<Mesh> {
        let number = |stream: u64, row: u64| (4.0 * uniform(seed, stream, row) - 2.0) as f32;
        let positions = (0..3 * FACES).map(|row| [0, 1, 2].map(|stream| number(stream, row))).collect();
        let uvs = (0..3 * FACES).map(|row| [3, 4].map(|stream| number(stream, row))).collect();
        let faces = (0..FACES as u32).map(|n| [3 * n, 3 * n + 1, 3 * n + 2]).collect();
        let materials = FaceMap::PerFace((0..FACES as i32).map(|n| n % 4 - 1).collect());
        Arc::new(Mesh::new(positions, faces, Some(uvs), None, objects, materials).unwrap())
    }

    fn scene() -> Scene {
        let image =
            |width, height| Texture::new(width, height, vec![[9; 4]; (width * height) as usize].into()).unwrap();
        let material = |texture| Material { texture, ..Material::default() };
        let own = mesh(1, FaceMap::PerFace((0..FACES as i32).map(|n| n / 9 - 1).collect()));
        let shared = mesh(2, FaceMap::Uniform(-1));
        let place = |mesh: &Arc<Mesh>, scale: f64, object| {
            let turn = DQuat::from_rotation_y(0.4 + scale);
            let to_scene = DAffine3::from_scale_rotation_translation(DVec3::splat(scale), turn, DVec3::ONE);
            Instance::new(Arc::clone(mesh), to_scene, object).unwrap()
        };
        let standing = vec![place(&own, 1.0, None), place(&shared, 2.0, Some(1)), place(&shared, 0.5, Some(2))];
        let moving = vec![place(&own, 3.0, Some(4))];
        let glowing = Material { emission: [1.0; 3], emission_texture: Some(3), ..material(Some(0)) };
        let materials = vec![material(Some(1)), material(None), glowing];
        let textures = vec![image(8, 2), image(3, 50), image(1, 1), image(64, 5)];
        Scene::new(DVec3::ZERO, standing, moving, Arc::new(materials), Arc::new(textures)).unwrap()
    }

    /// Computes the definition by brute force: the image's fastest change over many directions in each face's plane.
    fn brute_force(scene: &Scene, distances: &[f64]) -> Vec<f64> {
        let mut least = vec![f64::INFINITY; scene.textures.len()];
        for instance in scene.instances() {
            let mesh = &instance.mesh;
            for face in 0..mesh.faces.len() as u32 {
                if mesh.materials.get(face) < 0 {
                    continue;
                }
                for texture in scene.material_of(mesh, face).textures() {
                    let image = &scene.textures[texture as usize];
                    let corners = mesh.corners(face).map(|at| instance.to_scene.transform_point3(at.as_dvec3()));
                    let uvs = mesh.uvs.as_ref().unwrap();
                    let uvs = mesh.faces[face as usize].map(|vertex| uvs[vertex as usize].map(f64::from));
                    let (p, q) = (corners[1] - corners[0], corners[2] - corners[0]);
                    let fastest = (0..20_000).map(|n| {
                        let turn = std::f64::consts::PI * f64::from(n) / 20_000.0;
                        let (a, b) = (turn.cos(), turn.sin());
                        let across = |i: usize| a * (uvs[1][i] - uvs[0][i]) + b * (uvs[2][i] - uvs[0][i]);
                        let texels = (across(0) * f64::from(image.width)).hypot(across(1) * f64::from(image.height));
                        texels / (a * p + b * q).length()
                    });
                    let object = usize::try_from(instance.object_of(face)).unwrap_or(distances.len() - 1);
                    let texels_per_radian = fastest.fold(0.0, f64::max) * distances[object];
                    least[texture as usize] = least[texture as usize].min(texels_per_radian);
                }
            }
        }
        least
    }

    #[test]
    fn texture_detail_follows_the_coarsest_face() {
        let scene = scene();
        let far = f64::INFINITY;
        for distances in [[3.0, 5.0, 2.0, 9.0, 4.0, 7.0], [far, 50.0, 20.0, far, far, 30.0], [0.0; 6]] {
            let found = texels_per_radian(&scene, &distances, &Progress::new()).unwrap();
            let expected = brute_force(&scene, &distances);
            // One of 20,000 directions is within 2e-4 rad of the fastest; slivers have almost parallel edges.
            let is_close = |(a, b): (&f64, &f64)| a == b || (b <= a && (a - b) / a < 1e-3);
            assert!(found.iter().zip(&expected).all(is_close), "{found:?}, expected {expected:?}");
            assert_eq!(found[2], far, "nothing shows this texture");
        }
        assert_eq!(texels_per_radian(&scene, &[far; 6], &Progress::new()).unwrap(), [far; 4]);
    }

    #[test]
    fn density_is_that_of_the_densest_direction() {
        let corners = [DVec3::ZERO, DVec3::new(4.0, 0.0, 0.0), DVec3::new(0.0, 1.0, 0.0)];
        let density = |texels| texels_per_metre(corners, texels).unwrap();
        assert!((density([[5.0, 0.0], [13.0, 0.0], [5.0, 6.0]]) - 6.0).abs() < 1e-12);
        assert!((density([[0.0, 0.0], [8.0, 0.0], [0.0, 0.5]]) - 2.0).abs() < 1e-12);
        assert_eq!(density([[7.0, 7.0]; 3]), 0.0);
        assert_eq!(density([[0.0, f64::NAN], [1.0, 0.0], [0.0, 1.0]]), 0.0);
        assert!(texels_per_metre([corners[0], corners[1], corners[1] * 2.0], [[0.0; 2]; 3]).is_none());
    }

    #[test]
    fn wrong_distances_are_refused_and_work_can_be_cancelled() {
        let scene = scene();
        for wrong in [&[][..], &[-1.0], &[f64::NAN]] {
            assert!(texels_per_radian(&scene, wrong, &Progress::new()).is_err());
        }
        let progress = Progress::new();
        progress.cancel();
        assert!(texels_per_radian(&scene, &[1.0], &progress).is_err());
    }
}
