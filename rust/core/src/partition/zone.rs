//! Zones of triangles, classes of instances, and the sets that a partition names.

/// Zone of a triangle, and whether it crosses r₂.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Zone {
    /// Least ρ ≤ r₁, and all of it within r₂.
    Near,
    /// Least ρ ≤ r₁, and part of it beyond r₂.
    NearStraddling,
    /// r₁ < least ρ ≤ r₂, and all of it within r₂.
    Intermediate,
    /// r₁ < least ρ ≤ r₂, and part of it beyond r₂.
    IntermediateStraddling,
    /// All of it beyond r₂.
    Far,
}

impl Zone {
    /// Least ρ ≤ r₁.
    pub fn is_near(self) -> bool {
        matches!(self, Self::Near | Self::NearStraddling)
    }

    /// On both sides of r₂.
    pub fn is_straddling(self) -> bool {
        matches!(self, Self::NearStraddling | Self::IntermediateStraddling)
    }
}

/// Zones of an instance's triangles.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Class {
    /// All are [`Zone::Near`].
    Near,
    /// All are [`Zone::Intermediate`].
    Intermediate,
    /// All are [`Zone::Far`].
    Far,
    /// Looked at one by one.
    Mixed(Mixed),
}

/// Zones of the triangles of an instance that its box does not decide.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Mixed {
    /// Faces that are not far, ascending; all others are.
    pub faces: Vec<u32>,
    /// Zone of each of them.
    pub zones: Vec<Zone>,
    /// Faces whose radii were needed: the others are far by their coordinates alone.
    pub measured: u32,
}

/// Faces of an instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChosenFaces<'a> {
    /// Every one.
    All,
    /// These, ascending.
    Some(&'a [u32]),
}

/// One of the sets that a partition names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TriangleSet {
    /// Least ρ ≤ r₁.
    Near,
    /// r₁ < least ρ ≤ r₂.
    Intermediate,
    /// Least ρ > r₂.
    Far,
    /// Triangles drawn as geometry: near, intermediate, and everything that moves.
    Nsf,
    /// Baked triangles: standing ones that reach beyond r₂.
    Sf,
}

impl TriangleSet {
    pub(super) fn holds(self, zone: Zone, moving: bool) -> bool {
        match self {
            Self::Near => zone.is_near(),
            Self::Intermediate => !zone.is_near() && zone != Zone::Far,
            Self::Far => zone == Zone::Far,
            Self::Nsf => moving || zone != Zone::Far,
            Self::Sf => !moving && (zone == Zone::Far || zone.is_straddling()),
        }
    }
}
