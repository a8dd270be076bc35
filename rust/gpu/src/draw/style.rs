//! How a layer is shown: parts of shaders that a technique brings along, and the numbers that they read.

use std::hash::{Hash, Hasher};

use glam::DVec3;

/// Vectors of a technique's own in the uniform block of a pass.
pub(crate) type Parameters = [[f32; 4]; 4];

/// WGSL that stands among the shaders of `draw`, and a number by which it takes one of its ways.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Snippet {
    /// Tells snippets apart, with the number.
    pub name: &'static str,
    pub text: &'static str,
    /// The override `STYLE` or `CUT`.
    pub way: u32,
}

impl PartialEq for Snippet {
    fn eq(&self, other: &Self) -> bool {
        (self.name, self.way) == (other.name, other.way)
    }
}

impl Eq for Snippet {}

impl Hash for Snippet {
    fn hash<H: Hasher>(&self, state: &mut H) {
        (self.name, self.way).hash(state);
    }
}

/// Where points are shown. The snippet defines `shown` (a point's place), `shown_range` (a surface's distance) and
/// `backdrop_range` (the distance of what the environment map shows), by the override `STYLE`: see `plain.wgsl`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Style(pub Snippet);

impl Style {
    /// Points are shown where they are.
    pub const PLAIN: Self = Self(Snippet { name: "plain", text: include_str!("../shaders/plain.wgsl"), way: 0 });
}

/// Which fragments are drawn. The snippet defines `cut_place` (for each vertex, what `is_kept` gets interpolated) and
/// `is_kept`, by the override `CUT`: see `whole.wgsl`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Cut {
    pub snippet: Snippet,
    /// `is_kept` reads the face's normal.
    pub face_normals: bool,
}

impl Cut {
    /// All fragments are drawn.
    pub const NONE: Self = Self {
        snippet: Snippet { name: "whole", text: include_str!("../shaders/whole.wgsl"), way: 0 },
        face_normals: false,
    };
}

/// How far from their places points are shown at most, so that boxes tell what is out of sight.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Displacement {
    /// By this much all of them,
    pub shift: DVec3,
    /// and by at most so many metres in any direction.
    pub slack: f64,
}

impl Displacement {
    /// Points are shown where they are.
    pub const NONE: Self = Self { shift: DVec3::ZERO, slack: 0.0 };
}
