//! Base colours and emission, the surface properties that the shading formula uses.

/// Treatment of base-colour alpha below 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Alpha {
    /// Alpha is ignored; blended materials are drawn like this as well.
    Opaque,
    /// The surface has holes where alpha is below the cutoff.
    Mask {
        /// Minimum alpha that is drawn.
        cutoff: f32,
    },
}

/// Base colour and emission of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Linear RGB and alpha, multiplied by texture and vertex colour.
    pub base_color: [f32; 4],
    /// Number of a texture.
    pub texture: Option<u32>,
    /// Treatment of alpha.
    pub alpha: Alpha,
    /// Linear RGB of the emitted light, multiplied by its texture; finite, at least 0, not bounded by 1.
    pub emission: [f32; 3],
    /// Number of the emission texture; it uses the base colour's texture coordinates.
    pub emission_texture: Option<u32>,
    /// Whether the base colour is drawn without shading.
    pub unlit: bool,
    /// Distinguishes materials that are drawn alike but differ in their file; 0 by default.
    pub tag: u64,
}

impl Default for Material {
    /// Light grey, for scenes without materials.
    fn default() -> Self {
        Self {
            base_color: [0.8, 0.8, 0.8, 1.0],
            texture: None,
            alpha: Alpha::Opaque,
            emission: [0.0; 3],
            emission_texture: None,
            unlit: false,
            tag: 0,
        }
    }
}

impl Material {
    /// Whether the surface emits light.
    #[inline]
    pub fn emits(&self) -> bool {
        self.emission != [0.0; 3]
    }

    /// Returns the numbers of its textures.
    pub fn textures(&self) -> impl Iterator<Item = u32> + use<> {
        self.texture.into_iter().chain(self.emission_texture)
    }
}
