//! Rule by which triangles are split.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::blend::BlendRule;
use super::edge::EdgeRule;
use super::grown::GrownRule;
use super::settings::{Precision, Settings, Stages};
use crate::base::Result;

/// Rule for one centre, region of users and tolerance.
#[derive(Clone, Debug)]
pub struct Rule {
    pub(super) settings: Settings,
    pub(super) edges: Arc<dyn EdgeRule>,
}

impl Rule {
    /// Creates a rule; checks the settings.
    pub fn new(settings: &Settings, precision: Precision) -> Result<Self> {
        settings.check()?;
        let edges: Arc<dyn EdgeRule> = match settings.stages {
            Stages::Blend => Arc::new(BlendRule::new(settings, precision)),
            Stages::Cylinder { least, is_full } => Arc::new(GrownRule::new(settings, least, is_full, precision)),
        };
        Ok(Self { settings: *settings, edges })
    }

    /// Returns whether the tolerance is a bound; see `EdgeRule::holds`.
    pub fn holds(&self) -> bool {
        self.edges.holds()
    }

    /// Returns whether a triangle can be skipped: by its box and corners, no point of it lies where edges are split.
    pub(super) fn leaves_alone(&self, corners: &[DVec3; 3]) -> bool {
        let p = corners.map(|corner| self.settings.on_ground(corner));
        let (low, high) = (p[0].min(p[1]).min(p[2]), p[0].max(p[1]).max(p[2]));
        low.max(-high).max(DVec2::ZERO).length() >= self.edges.outer()
            || p.iter().all(|p| self.edges.is_within(p.length()))
    }

    /// Returns whether no point of a triangle is drawn, by a separating line.
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
