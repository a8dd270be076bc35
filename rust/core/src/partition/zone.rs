//! Zones of triangles, classes of instances, and the named sets of a partition.

/// Zone of a triangle, and whether it crosses r₂.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Zone {
    /// Minimum ρ ≤ r₁, and the whole triangle within r₂.
    Near,
    /// Minimum ρ ≤ r₁, and a part beyond r₂.
    NearStraddling,
    /// r₁ < minimum ρ ≤ r₂, and the whole triangle within r₂.
    Intermediate,
    /// r₁ < minimum ρ ≤ r₂, and a part beyond r₂.
    IntermediateStraddling,
    /// The whole triangle beyond r₂.
    Far,
}

impl Zone {
    /// Returns whether minimum ρ ≤ r₁.
    pub fn is_near(self) -> bool {
        matches!(self, Self::Near | Self::NearStraddling)
    }

    /// Returns whether the triangle lies on both sides of r₂.
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
    /// The zones differ, or the box did not decide them.
    Mixed(Mixed),
}

/// Zones of the triangles of an instance whose box does not decide its class.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Mixed {
    /// Faces that are not far, ascending; all other faces are far.
    pub faces: Vec<u32>,
    /// Zone of each of these faces.
    pub zones: Vec<Zone>,
    /// Number of faces whose radii were computed; the other faces were proved far by coordinates alone.
    pub measured: u32,
}

/// A selection of an instance's faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChosenFaces<'a> {
    /// All faces.
    All,
    /// These faces, ascending.
    Some(&'a [u32]),
}

/// A named set of a partition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TriangleSet {
    /// Triangles with minimum ρ ≤ r₁.
    Near,
    /// Triangles with r₁ < minimum ρ ≤ r₂.
    Intermediate,
    /// Triangles with minimum ρ > r₂.
    Far,
    /// Triangles drawn as geometry: near, intermediate and all moving ones.
    Nsf,
    /// Baked triangles: static ones that reach beyond r₂.
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
