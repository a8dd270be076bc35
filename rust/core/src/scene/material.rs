//! Base colours, the only surface property that the shading formula uses.

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

/// Base colour of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Linear RGB and alpha, multiplied by texture and vertex colour.
    pub base_color: [f32; 4],
    /// Number of a texture.
    pub texture: Option<u32>,
    /// Treatment of alpha.
    pub alpha: Alpha,
    /// Tells materials apart that are drawn alike, because files hold more of them than is drawn; 0 by default.
    pub tag: u64,
}

impl Default for Material {
    /// Light grey, for scenes without materials.
    fn default() -> Self {
        Self { base_color: [0.8, 0.8, 0.8, 1.0], texture: None, alpha: Alpha::Opaque, tag: 0 }
    }
}
