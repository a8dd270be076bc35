//! Rule by which triangles are split.

use glam::{DVec2, DVec3};

use super::blend::BlendRule;
use super::edge::Cut;
use super::grown::CylinderRule;
use super::settings::{Precision, ServedMorphs, Settings};
use crate::base::Result;

/// Rule for one centre, region of users and tolerance.
#[derive(Clone, Debug)]
pub struct Rule {
    pub(super) settings: Settings,
    edges: EdgeRule,
}

/// Edge-splitting rule for one kind of morph. It depends only on the two ends of an edge, so all triangles with an edge
/// split it alike.
#[derive(Clone, Debug)]
enum EdgeRule {
    Blend(BlendRule),
    Cylinder(CylinderRule),
}

/// Declares methods of `Rule` that call those of its edge rule. They are called in inner loops, where dynamic dispatch
/// would cost a fifth of the time.
macro_rules! edge_methods {
    ($($(#[$doc:meta])* $visibility:vis fn $name:ident($($argument:ident: $type:ty),*) -> $result:ty;)*) => {$(
        $(#[$doc])*
        #[inline]
        $visibility fn $name(&self, $($argument: $type),*) -> $result {
            match &self.edges {
                EdgeRule::Blend(rule) => rule.$name($($argument),*),
                EdgeRule::Cylinder(rule) => rule.$name($($argument),*),
            }
        }
    )*};
}

impl Rule {
    edge_methods! {
        /// Returns whether the tolerance is a bound for every user of the region: the region lies well inside r₁, and
        /// the tolerance is not below the resolution of the coordinates.
        pub fn holds() -> bool;

        /// Fails if the tolerance is not a bound. A cylinder below full strength need not have one next to the axis,
        /// where points within r₁ move.
        pub(super) fn require_bound() -> Result<()>;

        /// Returns the length below which edges anywhere, even across the radii, have an error below the tolerance.
        pub(super) fn harmless_length() -> f64;

        /// Returns where the edge from a to b is split. The caller must order the ends of an edge consistently.
        ///
        /// If an edge is left whole, each part of it must be, too; otherwise thin triangles would be split for ever.
        pub(super) fn cut(a: DVec3, b: DVec3) -> Option<Cut>;

        /// Returns where a triangle must be split, although none of its edges is, because it contains the cylinder.
        pub(super) fn inner_split_point(corners: &[DVec3; 3]) -> Option<[f64; 3]>;

        /// Returns the radius beyond which no edge is split.
        pub(super) fn outer() -> f64;

        /// Returns whether no split edge has an end at this distance from the axis or nearer. Edges between two points
        /// of r₁ are split, too.
        pub(super) fn is_within(rho: f64) -> bool;
    }

    /// Creates a rule; checks the settings.
    pub fn new(settings: &Settings, precision: Precision) -> Result<Self> {
        settings.check()?;
        let edges = match settings.served {
            ServedMorphs::Blend => EdgeRule::Blend(BlendRule::new(settings, precision)),
            ServedMorphs::Cylinder { least, is_full } => {
                EdgeRule::Cylinder(CylinderRule::new(settings, least, is_full, precision))
            }
        };
        Ok(Self { settings: *settings, edges })
    }

    /// Returns whether a triangle's box and corners prove that none of its points lies where edges are split.
    pub(super) fn can_skip(&self, corners: &[DVec3; 3]) -> bool {
        let p = corners.map(|corner| self.settings.on_ground(corner));
        let (low, high) = (p[0].min(p[1]).min(p[2]), p[0].max(p[1]).max(p[2]));
        low.max(-high).max(DVec2::ZERO).length() >= self.outer() || p.iter().all(|p| self.is_within(p.length()))
    }

    /// Returns whether a separating line proves that no point of a triangle is drawn.
    pub fn is_beyond(&self, corners: &[DVec3; 3]) -> bool {
        let drawn = self.settings.drawn;
        let p = corners.map(|corner| self.settings.on_ground(corner));
        let beyond = |axis: DVec2| p.iter().all(|p| p.dot(axis) > drawn);
        // Directions of the corners, and of the edges' normals.
        let normal = |a: DVec2, b: DVec2| {
            let n = (b - a).perp().normalize_or_zero();
            if n.dot(a) < 0.0 { -n } else { n }
        };
        p.iter().any(|p| beyond(p.normalize_or_zero()))
            || [(p[0], p[1]), (p[1], p[2]), (p[2], p[0])].into_iter().any(|(a, b)| beyond(normal(a, b)))
    }
}
