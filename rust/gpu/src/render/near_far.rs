//! Near–far method in shaders: styles that morph points, and cuts at the radii of its zones.

use glam::DVec3;
use nearfar_core::morph::Kind;

use crate::draw::{Cut, Displacement, Parameters, Snippet, Style};

const DISPLACEMENT: &str = concat!(include_str!("../shaders/morph.wgsl"), include_str!("../shaders/displayed.wgsl"));
const ZONES: &str = include_str!("../shaders/zones.wgsl");

/// Displacement of points: variants of `displayed.wgsl`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Placement {
    Undisplaced = 0,
    /// Morphed by the blend of 2022.
    Blend = 1,
    /// Morphed by CloVR's cylinder.
    Cylinder = 2,
    /// As the centre sees them: moved by the user's offset from the centre.
    FromCenter = 3,
    /// In the direction from the centre, at the distance of CloVR's cylinder.
    FromCenterOnCylinder = 4,
    /// Morphed by CloVR's cylinder, but drawn at its distance from the centre, to compare depths with layers drawn
    /// from there.
    CylinderFromCenter = 5,
}

impl From<Kind> for Placement {
    fn from(kind: Kind) -> Self {
        match kind {
            Kind::Blend => Self::Blend,
            Kind::Cylinder => Self::Cylinder,
        }
    }
}

impl Placement {
    pub fn style(self) -> Style {
        match self {
            Self::Undisplaced => Style::PLAIN,
            _ => Style(Snippet { name: "displayed", text: DISPLACEMENT, variant: self as u32 }),
        }
    }

    /// Returns a bound of the displacement; `None` if unbounded.
    pub fn displacement(self, near_far: &NearFar) -> Option<Displacement> {
        let NearFar { offset, camera_offset, radii: [r1, _], .. } = *near_far;
        match self {
            Self::Undisplaced => Some(Displacement::NONE),
            Self::FromCenter | Self::FromCenterOnCylinder => {
                Some(Displacement { shift: offset + camera_offset, slack: 0.0 })
            }
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
pub(super) enum ZoneCut {
    /// Keeps all fragments.
    None = 0,
    /// Keeps fragments inside the radius.
    Inside = 1,
    /// Keeps fragments outside the radius.
    Outside = 2,
    /// Keeps fragments outside the radius that the map's range does not hide.
    OutsideUnhidden = 3,
    /// Keeps fragments outside the radius, and those inside it that are at most two texels of a map away from it.
    OutsideOverlapping = 4,
}

impl ZoneCut {
    pub fn cut(self) -> Cut {
        match self {
            Self::None => Cut::NONE,
            _ => Cut {
                snippet: Snippet { name: "zones", text: ZONES, variant: self as u32 },
                face_normals: self == Self::OutsideOverlapping,
            },
        }
    }
}

/// Positions and radii that define the zones.
#[derive(Clone, Copy, Debug)]
pub(super) struct NearFar {
    /// User's position relative to the centre O.
    pub offset: DVec3,
    /// Camera's position relative to the user's.
    pub camera_offset: DVec3,
    /// r₁ and r₂.
    pub radii: [f64; 2],
    /// Strength of the morph; below 1 every point moves.
    pub strength: f64,
    /// Radius of `ZoneCut`.
    pub cut_radius: f64,
    /// Tangent of two texels of the map, for `ZoneCut::OutsideOverlapping`.
    pub two_texels: f64,
}

impl NearFar {
    /// Returns the parameters of `displayed.wgsl` and `zones.wgsl`.
    pub fn parameters(&self) -> Parameters {
        let [r1, r2] = self.radii;
        let slope = if r2 > r1 { 1.0 / (r2 - r1) } else { 0.0 };
        let fixed_radius = if self.strength == 1.0 { r1 } else { -1.0 };
        let mut parameters = Parameters::default();
        parameters[0] = (self.offset + self.camera_offset).as_vec3().extend(self.two_texels as f32).to_array();
        parameters[1] = [fixed_radius, r2, self.cut_radius, slope].map(|x| x as f32);
        parameters[2] = self.camera_offset.as_vec3().extend(self.strength as f32).to_array();
        parameters
    }
}
