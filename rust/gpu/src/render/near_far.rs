//! Near–far method in shaders: styles that morph points, and cuts at the radii of its zones.

use glam::DVec3;
use nearfar_core::morph::Kind;

use crate::draw::{Cut, Displacement, Parameters, Snippet, Style};

const SHOWN: &str = concat!(include_str!("../shaders/morph.wgsl"), include_str!("../shaders/displayed.wgsl"));
const ZONES: &str = include_str!("../shaders/zones.wgsl");

/// Displacement of points: variants of `displayed.wgsl`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shown {
    /// Not displaced.
    AsItIs = 0,
    /// Morphed by the blend of 2022.
    Blend = 1,
    /// Morphed by CloVR's cylinder.
    Cylinder = 2,
    /// As the centre sees them: moved by the user's offset from it.
    FromCenter = 3,
    /// In the direction from the centre, at the distance of CloVR's cylinder.
    FromCenterOnCylinder = 4,
    /// Morphed by CloVR's cylinder, but drawn at its distance from the centre, to compare depths with layers drawn
    /// from there.
    CylinderFromCenter = 5,
}

impl From<Kind> for Shown {
    fn from(kind: Kind) -> Self {
        match kind {
            Kind::Blend => Self::Blend,
            Kind::Cylinder => Self::Cylinder,
        }
    }
}

impl Shown {
    /// Returns the style of a layer.
    pub fn style(self) -> Style {
        match self {
            Self::AsItIs => Style::PLAIN,
            _ => Style(Snippet { name: "shown", text: SHOWN, variant: self as u32 }),
        }
    }

    /// Returns a bound of the displacement; `None` if unbounded.
    pub fn displacement(self, near_far: &NearFar) -> Option<Displacement> {
        let NearFar { offset, apart, radii: [r1, _], .. } = *near_far;
        match self {
            Self::AsItIs => Some(Displacement::NONE),
            Self::FromCenter | Self::FromCenterOnCylinder => Some(Displacement { shift: offset + apart, slack: 0.0 }),
            // Points move at most by the user's offset, unless user and centre see them in opposite directions.
            Self::Blend if offset.length() < r1 => {
                Some(Displacement { shift: DVec3::ZERO, slack: 2.0 * offset.length() })
            }
            Self::Blend | Self::Cylinder | Self::CylinderFromCenter => None,
        }
    }
}

/// Cut of fragments by their distance from the centre's axis: variants of `zones.wgsl`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Zone {
    /// All fragments.
    Whole = 0,
    /// Fragments within the radius.
    Within = 1,
    /// Fragments beyond the radius.
    Beyond = 2,
    /// Fragments beyond the radius that the map's range does not hide.
    BeyondAndUnhidden = 3,
    /// Fragments beyond the radius, and inside it within the reach of two texels of a map.
    Overlapping = 4,
}

impl Zone {
    /// Returns the cut of a layer.
    pub fn cut(self) -> Cut {
        match self {
            Self::Whole => Cut::NONE,
            _ => Cut {
                snippet: Snippet { name: "zones", text: ZONES, variant: self as u32 },
                face_normals: self == Self::Overlapping,
            },
        }
    }
}

/// Lengths that define the zones.
#[derive(Clone, Copy, Debug)]
pub(super) struct NearFar {
    /// User's position relative to the centre O.
    pub offset: DVec3,
    /// Camera's position relative to the user's.
    pub apart: DVec3,
    /// r₁ and r₂.
    pub radii: [f64; 2],
    /// Strength of the morph; below 1 every point moves.
    pub strength: f64,
    /// Radius at which pixels are split.
    pub split: f64,
    /// Tangent of two texels of the map, for `Zone::Overlapping`.
    pub two_texels: f64,
}

impl NearFar {
    /// Returns the parameters of `displayed.wgsl` and `zones.wgsl`.
    pub fn parameters(&self) -> Parameters {
        let [r1, r2] = self.radii;
        let slope = if r2 > r1 { 1.0 / (r2 - r1) } else { 0.0 };
        let stays = if self.strength == 1.0 { r1 } else { -1.0 };
        let mut parameters = Parameters::default();
        parameters[0] = (self.offset + self.apart).as_vec3().extend(self.two_texels as f32).to_array();
        parameters[1] = [stays, r2, self.split, slope].map(|x| x as f32);
        parameters[2] = self.apart.as_vec3().extend(self.strength as f32).to_array();
        parameters
    }
}
