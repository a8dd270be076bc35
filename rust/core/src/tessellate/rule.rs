//! Edge-splitting rule.

use glam::{DVec2, DVec3};

use super::blend::BlendRule;
use super::cut::Cut;
use super::grown::GrownRule;
use super::settings::{Precision, Settings, Stages};
use crate::base::Result;

/// Rule for one centre, region of users and tolerance.
#[derive(Clone, Debug)]
pub struct Rule {
    settings: Settings,
    edges: Edges,
}

#[derive(Clone, Debug)]
enum Edges {
    Blend(BlendRule),
    Grown(GrownRule),
}

impl Rule {
    /// Creates a rule; checks the settings.
    pub fn new(settings: &Settings, precision: Precision) -> Result<Self> {
        settings.check()?;
        let edges = match settings.stages {
            Stages::Blend => Edges::Blend(BlendRule::new(settings, precision)),
            Stages::Cylinder { least, is_full } => Edges::Grown(GrownRule::new(settings, least, is_full, precision)),
        };
        Ok(Self { settings: *settings, edges })
    }

    /// Returns whether the tolerance is a bound for every user of the region: they stay well inside r₁, and the
    /// tolerance is not below the resolution of the coordinates.
    pub fn holds(&self) -> bool {
        match &self.edges {
            Edges::Blend(rule) => rule.holds(),
            Edges::Grown(rule) => rule.holds(),
        }
    }

    /// Fails if the tolerance is not a bound. A cylinder below full strength needs none next to the axis.
    pub fn demand(&self) -> Result<()> {
        match &self.edges {
            Edges::Blend(rule) => rule.demand(),
            Edges::Grown(rule) => rule.demand(),
        }
    }

    /// Returns the length up to which edges have an error below the tolerance wherever they lie, also across the
    /// radii.
    pub fn harmless(&self) -> f64 {
        match &self.edges {
            Edges::Blend(rule) => rule.harmless(),
            Edges::Grown(rule) => rule.harmless(),
        }
    }

    /// Returns where the edge from a to b is split. The caller must order the ends of an edge consistently.
    pub(super) fn cut(&self, a: DVec3, b: DVec3) -> Option<Cut> {
        match &self.edges {
            Edges::Blend(rule) => rule.share(a, b).map(|share| Cut { share, size: (b - a).length() }),
            Edges::Grown(rule) => rule.cut(a, b),
        }
    }

    /// Returns a point at which a triangle must be split although none of its edges is: the triangle contains the
    /// whole cylinder.
    pub(super) fn inner_split_point(&self, corners: &[DVec3; 3]) -> Option<[f64; 3]> {
        match &self.edges {
            Edges::Blend(rule) => rule.inner_split_point(corners),
            Edges::Grown(rule) => rule.inner_split_point(corners),
        }
    }

    /// Returns the radius beyond which no edge is split.
    pub(super) fn outer(&self) -> f64 {
        match &self.edges {
            Edges::Blend(_) => self.settings.r2,
            Edges::Grown(rule) => rule.outer(),
        }
    }

    /// Returns whether a distance from the axis is below that of all ends of split edges. Edges between two points of
    /// r₁ are split too.
    pub(super) fn is_within(&self, rho: f64) -> bool {
        match &self.edges {
            Edges::Blend(rule) => rule.is_within(rho),
            Edges::Grown(rule) => rule.is_within(rho),
        }
    }

    /// Returns whether a triangle can be skipped: by its box and corners, no point of it lies where edges are split.
    pub(super) fn leaves_alone(&self, corners: &[DVec3; 3]) -> bool {
        let p = corners.map(|corner| self.on_ground(corner));
        let (low, high) = (p[0].min(p[1]).min(p[2]), p[0].max(p[1]).max(p[2]));
        low.max(-high).max(DVec2::ZERO).length() >= self.outer() || p.iter().all(|p| self.is_within(p.length()))
    }

    /// Returns whether no point of a triangle is drawn, by a separating line.
    pub fn is_beyond(&self, corners: &[DVec3; 3]) -> bool {
        let drawn = self.settings.drawn;
        let p = corners.map(|corner| self.on_ground(corner));
        let beyond = |axis: DVec2| p.iter().all(|p| p.dot(axis) > drawn);
        // Directions of the corners, and of the edges' normals.
        let normal = |a: DVec2, b: DVec2| {
            let n = (b - a).perp().normalize_or_zero();
            if n.dot(a) < 0.0 { -n } else { n }
        };
        p.iter().any(|p| beyond(p.normalize_or_zero()))
            || [(p[0], p[1]), (p[1], p[2]), (p[2], p[0])].into_iter().any(|(a, b)| beyond(normal(a, b)))
    }

    pub(super) fn on_ground(&self, p: DVec3) -> DVec2 {
        self.settings.on_ground(p)
    }
}
