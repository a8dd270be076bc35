//! How a layer is shown: parts of shaders that a technique brings along, and the numbers that they read.

use std::hash::{Hash, Hasher};

use glam::DVec3;

/// Numbers of a technique in the uniform block of a pass.
pub(crate) type Parameters = [[f32; 4]; 4];

/// WGSL that is compiled together with the shaders of `draw`, and the variant of it that is used.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Snippet {
    /// Identity of the text.
    pub name: &'static str,
    pub text: &'static str,
    /// Value of the override `STYLE` or `CUT`.
    pub variant: u32,
}

impl PartialEq for Snippet {
    fn eq(&self, other: &Self) -> bool {
        (self.name, self.variant) == (other.name, other.variant)
    }
}

impl Eq for Snippet {}

impl Hash for Snippet {
    fn hash<H: Hasher>(&self, state: &mut H) {
        (self.name, self.variant).hash(state);
    }
}

/// Where points are shown. The snippet defines `shown` (a point's place), `shown_range` (a surface's distance) and
/// `backdrop_range` (the distance of what the environment map shows), by the override `STYLE`: see `plain.wgsl`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Style(pub Snippet);

impl Style {
    /// Points are shown where they are.
    pub const PLAIN: Self = Self(Snippet { name: "plain", text: include_str!("../shaders/plain.wgsl"), variant: 0 });
}

/// Which fragments are drawn. The snippet defines `cut_place` (a vector of each vertex, interpolated for `is_kept`) and
/// `is_kept` (of a fragment), by the override `CUT`: see `whole.wgsl`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Cut {
    pub snippet: Snippet,
    /// `is_kept` reads the face's normal.
    pub face_normals: bool,
}

impl Cut {
    /// All fragments are drawn.
    pub const NONE: Self = Self {
        snippet: Snippet { name: "whole", text: include_str!("../shaders/whole.wgsl"), variant: 0 },
        face_normals: false,
    };
}

/// A bound on how far from their places points are shown, for culling by boxes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Displacement {
    /// The shift of all points.
    pub shift: DVec3,
    /// Metres by which points may lie elsewhere, in any direction.
    pub slack: f64,
}

impl Displacement {
    /// Points are shown where they are.
    pub const NONE: Self = Self { shift: DVec3::ZERO, slack: 0.0 };
}
