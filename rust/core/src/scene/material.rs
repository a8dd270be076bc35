//! Base colours and emission, the surface properties that the shading formula uses.

/// Treatment of a base colour's alpha below 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Alpha {
    /// Alpha is ignored; blended materials are treated like this as well.
    Opaque,
    /// The surface has holes where alpha is below the cutoff.
    Mask {
        /// Least alpha that is drawn.
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
    /// Linear RGB of the light that the surface emits, multiplied by its texture; finite, at least 0, and not bounded by 1.
    pub emission: [f32; 3],
    /// Number of the texture of the emission, which has the coordinates of the base colour's.
    pub emission_texture: Option<u32>,
    /// Whether the base colour is shown as it is, whatever the light.
    pub unlit: bool,
    /// Tells materials apart that are drawn alike, because files hold more of them than is drawn; 0 by default.
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

    /// Numbers of its textures.
    pub fn textures(&self) -> impl Iterator<Item = u32> + use<> {
        self.texture.into_iter().chain(self.emission_texture)
    }
}
