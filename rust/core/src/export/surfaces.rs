//! Materials, with images referenced by URIs from the caller.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::sync::Arc;

use serde_json::{Value, json};

use super::grid::Grid;
use crate::base::{Result, by_number, ensure};
use crate::scene::{Alpha, Material, Sampler, Scene, Texture};

/// Maximum error of a texture coordinate, in texels of the longer side, up to 2²³ steps of the grid: 2¹¹ repetitions of
/// a texture of up to 1024 texels. Larger coordinates have about the precision of float32.
pub const UV_ERROR_TEXELS: f64 = 1.0 / 8.0;

/// Step of texture coordinates for textures of up to 1024 texels; larger textures get smaller steps.
const MAX_UV_STEP: f64 = 1.0 / 4096.0;

const LINEAR_MIPMAP_LINEAR: u32 = 9987;

/// Extension for textures with WebP images.
const WEBP: &str = "EXT_texture_webp";

/// Optional material extensions: a viewer without them shows different colours only.
const UNLIT: &str = "KHR_materials_unlit";
const STRENGTH: &str = "KHR_materials_emissive_strength";
pub(super) const OPTIONAL: [&str; 2] = [UNLIT, STRENGTH];

/// Materials of a scene and URIs of its textures.
#[derive(Debug)]
pub(super) struct Surfaces {
    /// Materials without missing images.
    materials: Vec<Material>,
    textures: Arc<Vec<Texture>>,
    images: Vec<Option<String>>,
    /// For each material, the first one that looks the same; they may differ in properties that are not drawn.
    first_alike: Vec<i32>,
}

/// JSON lists of materials, textures, images and samplers, and the extensions that they use.
pub(super) type MaterialLists = (BTreeMap<&'static str, Vec<Value>>, BTreeSet<&'static str>);

impl Surfaces {
    /// Creates the materials. `images` has the URI of each texture's image; without it a material is drawn untextured.
    pub fn new(scene: &Scene, images: Vec<Option<String>>) -> Result<Self> {
        let count = scene.textures.len();
        ensure!(images.len() == count, "images", format!("a URI or none for each of {count} textures"), images.len());
        let mut first_by_looks: HashMap<_, i32> = HashMap::new();
        let mut first_alike = Vec::with_capacity(scene.materials.len());
        let materials: Vec<Material> =
            scene.materials.iter().map(|material| without_missing_images(material, &images)).collect();
        for (number, material) in materials.iter().enumerate() {
            let cutoff = match material.alpha {
                Alpha::Opaque => None,
                Alpha::Mask { cutoff } => Some(cutoff.to_bits()),
            };
            let emission = (material.emission.map(f32::to_bits), material.emission_texture);
            let looks = (material.base_color.map(f32::to_bits), material.texture, cutoff, emission, material.unlit);
            first_alike.push(*first_by_looks.entry(looks).or_insert(number as i32));
        }
        Ok(Self { materials, textures: Arc::clone(&scene.textures), images, first_alike })
    }

    /// Returns the first material that looks like this one; −1 for no material.
    #[inline]
    pub fn drawn_material(&self, material: i32) -> i32 {
        by_number(&self.first_alike, material).copied().unwrap_or(-1)
    }

    #[inline]
    fn material(&self, number: i32) -> Material {
        by_number(&self.materials, number).copied().unwrap_or_default()
    }

    /// Returns whether a material has a texture whose image has a URI.
    #[inline]
    pub fn is_textured(&self, material: i32) -> bool {
        self.material(material).textures().next().is_some()
    }

    /// Returns the longest side of a material's textures in texels; 1 without a texture.
    pub fn texels(&self, material: i32) -> f64 {
        let textures = self.material(material).textures().map(|texture| &self.textures[texture as usize]);
        textures.map(|texture| f64::from(texture.width.max(texture.height))).fold(1.0, f64::max)
    }

    /// Returns the grid of a material's texture coordinates up to `reach`. Half its step is at most `UV_ERROR_TEXELS`.
    pub fn uv_grid(&self, material: i32, reach: f64) -> Grid {
        Grid::new((2.0 * UV_ERROR_TEXELS / self.texels(material)).min(MAX_UV_STEP), reach)
    }

    /// Returns the JSON of materials, in this order, given as (number, whether it is textured).
    pub fn describe(&self, used: &[(i32, bool)]) -> MaterialLists {
        let (mut images, mut textures, mut materials) = (Vec::new(), Vec::new(), Vec::new());
        let mut numbers: BTreeMap<u32, usize> = BTreeMap::new();
        let mut samplers: Vec<Sampler> = Vec::new();
        let mut extensions = BTreeSet::new();
        for &(number, textured) in used {
            let material = self.material(number);
            let [base, emission] = [material.texture, material.emission_texture].map(|number| {
                let number = number.filter(|_| textured)?;
                Some(*numbers.entry(number).or_insert_with(|| {
                    let uri = self.images[number as usize].as_deref().unwrap_or_default();
                    let is_webp = uri.to_ascii_lowercase().ends_with(".webp");
                    extensions.extend(is_webp.then_some(WEBP));
                    let source = json!({ "source": images.len() });
                    let mut texture = if is_webp { json!({ "extensions": { WEBP: source } }) } else { source };
                    let sampler = self.textures[number as usize].sampler;
                    texture["sampler"] =
                        json!(samplers.iter().position(|&known| known == sampler).unwrap_or_else(|| {
                            samplers.push(sampler);
                            samplers.len() - 1
                        }));
                    textures.push(texture);
                    images.push(json!({ "uri": uri }));
                    images.len() - 1
                }))
            });
            let mut entry = material_entry(&material, base);
            extensions.extend(add_emission(&mut entry, &material, emission).then_some(STRENGTH));
            if material.unlit {
                entry["extensions"][UNLIT] = json!({});
                extensions.insert(UNLIT);
            }
            materials.push(entry);
        }
        let samplers = samplers.into_iter().map(sampler_entry).collect();
        let lists =
            [("materials", materials), ("textures", textures), ("images", images), ("samplers", samplers)].into();
        (lists, extensions)
    }
}

/// Returns a material without the textures whose images are missing. If the image of the emission is missing, the
/// emission is removed, because its factor alone would light the texture's dark parts.
fn without_missing_images(material: &Material, images: &[Option<String>]) -> Material {
    let has_image = |texture: &u32| images[*texture as usize].is_some();
    let mut drawn = *material;
    drawn.texture = drawn.texture.filter(has_image);
    if !drawn.emission_texture.as_ref().is_none_or(has_image) {
        drawn.emission = [0.0; 3];
    }
    drawn.emission_texture = drawn.emission_texture.filter(|_| drawn.emits());
    drawn
}

fn sampler_entry(sampler: Sampler) -> Value {
    let [wrap_s, wrap_t, filter] = sampler.to_gltf();
    json!({ "magFilter": filter, "minFilter": LINEAR_MIPMAP_LINEAR, "wrapS": wrap_s, "wrapT": wrap_t })
}

fn material_entry(material: &Material, texture: Option<usize>) -> Value {
    // glTF allows factors from 0 to 1. Shading clamps to white anyway.
    let color = material.base_color.map(|x| x.clamp(0.0, 1.0));
    let mut surface = json!({ "baseColorFactor": color, "metallicFactor": 0, "roughnessFactor": 1 });
    if let Some(texture) = texture {
        surface["baseColorTexture"] = json!({ "index": texture });
    }
    let mut entry = json!({ "pbrMetallicRoughness": surface, "doubleSided": true });
    if let Alpha::Mask { cutoff } = material.alpha {
        entry["alphaMode"] = json!("MASK");
        // glTF forbids cutoffs below 0. Like 0, they cut nothing out.
        entry["alphaCutoff"] = json!(cutoff.max(0.0));
    }
    entry
}

/// Adds the emission to a material's entry; returns whether it needs `KHR_materials_emissive_strength`, because its
/// factors exceed glTF's limit of 1. The product of strength and factor, in float64, rounds to the original float32.
fn add_emission(entry: &mut Value, material: &Material, texture: Option<usize>) -> bool {
    if !material.emits() {
        return false;
    }
    let emission = material.emission.map(f64::from);
    let strength = emission.iter().copied().fold(1.0, f64::max);
    entry["emissiveFactor"] = json!(emission.map(|x| x / strength));
    if let Some(texture) = texture {
        entry["emissiveTexture"] = json!({ "index": texture });
    }
    if strength > 1.0 {
        entry["extensions"][STRENGTH] = json!({ "emissiveStrength": strength });
    }
    strength > 1.0
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::scene::Wrap;

    fn surfaces(images: [Option<&str>; 2]) -> Surfaces {
        let material = |texture, tag| Material { texture, tag, ..Material::default() };
        let cut = Material { alpha: Alpha::Mask { cutoff: -0.5 }, ..material(None, 0) };
        let materials = vec![material(Some(0), 1), material(None, 2), material(Some(0), 3), cut, material(Some(1), 0)];
        let texture = |side: u32| Texture::new(side, 1, vec![[0; 4]; side as usize].into()).unwrap();
        let clamped = Sampler { wrap: [Wrap::Clamp, Wrap::Mirror], nearest: true };
        let textures = Arc::new(vec![texture(4), texture(1500).with_sampler(clamped)]);
        let scene = Scene::new(DVec3::ZERO, vec![], vec![], Arc::new(materials), textures).unwrap();
        Surfaces::new(&scene, images.map(|uri| uri.map(Into::into)).into()).unwrap()
    }

    #[test]
    fn materials_that_look_alike_are_merged() {
        let both = surfaces([Some("a.png"), Some("b.WebP")]);
        assert_eq!([0, 1, 2, 3, 4, -1, 9].map(|number| both.drawn_material(number)), [0, 1, 0, 3, 4, -1, -1]);
        let neither = surfaces([None, None]);
        assert_eq!([0, 1, 2, 3, 4].map(|number| neither.drawn_material(number)), [0, 0, 0, 3, 0]);
        assert!(!neither.is_textured(0));
    }

    #[test]
    fn only_used_images_are_listed_and_webp_needs_its_extension() {
        let all = surfaces([Some("a.png"), Some("b.WebP")]);
        let (lists, extensions) = all.describe(&[(0, true), (0, false), (3, false), (-1, false)]);
        assert!(extensions.is_empty());
        assert_eq!(lists["images"], [json!({ "uri": "a.png" })]);
        assert_eq!(lists["textures"], [json!({ "sampler": 0, "source": 0 })]);
        let with = |i: usize| lists["materials"][i]["pbrMetallicRoughness"].get("baseColorTexture").is_some();
        assert_eq!([0, 1, 2, 3].map(with), [true, false, false, false]);
        assert_eq!(lists["materials"][2]["alphaCutoff"], json!(0.0));
        let (lists, extensions) = all.describe(&[(4, true)]);
        assert_eq!(extensions, [WEBP].into());
        assert_eq!(lists["textures"], [json!({ "sampler": 0, "extensions": { WEBP: { "source": 0 } } })]);
        let sampler = json!({ "magFilter": 9728, "minFilter": 9987, "wrapS": 33071, "wrapT": 33648 });
        assert_eq!(lists["samplers"], [sampler]);
        let (lists, _) = all.describe(&[(4, true), (0, true), (2, true)]);
        assert_eq!([0, 1].map(|texture| &lists["textures"][texture]["sampler"]), [&json!(0), &json!(1)]);
        assert_eq!((lists["samplers"].len(), &lists["samplers"][1]["wrapS"]), (2, &json!(10497)));
        assert!(all.describe(&[]).0.values().all(Vec::is_empty));
    }

    #[test]
    fn texture_coordinates_are_exact_to_an_eighth_of_a_texel() {
        let all = surfaces([Some("a.png"), Some("b.png")]);
        assert_eq!(all.uv_grid(0, 1.0).step(), MAX_UV_STEP);
        let step = all.uv_grid(4, 1.0).step();
        assert!(step / 2.0 * 1500.0 <= UV_ERROR_TEXELS && step * 1500.0 > UV_ERROR_TEXELS);
    }

    #[test]
    fn emission_and_unlit_are_written_and_distinguish_materials() {
        let glow = |emission, emission_texture| Material { emission, emission_texture, ..Material::default() };
        let unlit = Material { unlit: true, ..Material::default() };
        let bright = glow([0.0, 3.0, 1.5], Some(0));
        let materials = vec![Material::default(), glow([0.0, 0.25, 1.0], None), bright, unlit, glow([0.0; 3], Some(0))];
        let texture = Texture::new(900, 1, vec![[0; 4]; 900].into()).unwrap();
        let scene = Scene::new(DVec3::ZERO, vec![], vec![], Arc::new(materials), Arc::new(vec![texture])).unwrap();
        let all = Surfaces::new(&scene, vec![Some("a.webp".into())]).unwrap();
        assert_eq!([0, 1, 2, 3, 4].map(|number| all.drawn_material(number)), [0, 1, 2, 3, 0]);
        let textures = [1, 2, 4].map(|number| (all.is_textured(number), all.texels(number)));
        assert_eq!(textures, [(false, 1.0), (true, 900.0), (false, 1.0)]);
        let (lists, extensions) = all.describe(&[(0, false), (1, false), (2, true), (3, false)]);
        assert_eq!(extensions, [STRENGTH, UNLIT, WEBP].into());
        let [plain, dim, bright, unlit] = &lists["materials"][..] else { panic!("four materials") };
        assert!(plain.get("emissiveFactor").is_none() && plain.get("extensions").is_none());
        assert_eq!((&dim["emissiveFactor"], dim.get("extensions")), (&json!([0.0, 0.25, 1.0]), None));
        assert_eq!(bright["emissiveFactor"], json!([0.0, 1.0, 0.5]));
        assert_eq!(bright["extensions"], json!({ STRENGTH: { "emissiveStrength": 3.0 } }));
        assert_eq!(bright["emissiveTexture"], json!({ "index": 0 }));
        assert_eq!(unlit["extensions"], json!({ UNLIT: {} }));
        // Without its image, the lit parts are unknown.
        let without = Surfaces::new(&scene, vec![None]).unwrap();
        assert_eq!(without.drawn_material(2), 0);
    }
}
