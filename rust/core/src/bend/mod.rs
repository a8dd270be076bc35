//! Inverse of the morph for one direction: the curve of points that the morph shows there.
//!
//! U is the user's eye, O the centre, w the weight of the user's view, v = O − U, and d a unit direction. The
//! directions from U and O to a point and the line U O are coplanar, so the points that the morph shows in direction d
//! form a plane curve:
//!
//! ```text
//! P(s) = U + s d + y(s) e,   e the unit vector of v⊥ = v − (v·d) d
//! ```
//!
//! Here y in [0, |v⊥|] is the root of w y/|P−U| + (1−w)(y−|v⊥|)/|P−O|. This is the component across d of the blend of
//! the directions from U and O (Eq. 1). The curve leaves U along d, ends on the parallel ray from O, and is the same
//! for both kinds of the morph.
//!
//! With a strength below 1, w is a constant below 1 within r₁, and the curve bends there too. Let α and β be the angles
//! from d to the directions in which U and O see P. On the curve w sin α = (1−w) sin β. If w > ½, w |cos α| exceeds
//! (1−w) |cos β|: the blend points along d where U sees P ahead, and the curve starts at U. If w < ½, it starts at O
//! for the same reason.

mod curve;
mod fold;
mod rays;
#[cfg(test)]
mod tests;

pub use curve::{RayCurve, Stretch};
pub(crate) use curve::{on_ground, within_cylinder};
pub use fold::margin;
pub use rays::bend_rays;
