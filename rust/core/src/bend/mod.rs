//! The morph per pixel: the curve of points that it shows in one direction.
//!
//! The directions from user and centre to a point and the line between both are coplanar, so that the points shown in a
//! direction d form a plane curve P(s) = U + s d + y(s) e, with v = O−U, e the unit vector of v⊥ = v − (v·d) d, and y
//! in [0, |v⊥|] the root of w y/|P−U| + (1−w)(y−|v⊥|)/|P−O|: what the blend of both directions (Eq. 1) has across d.
//! It leaves U along d, ends on the parallel ray from O, and is the same for both kinds of the morph.

mod curve;
mod fold;
mod rays;
#[cfg(test)]
mod tests;

pub use curve::{RayCurve, Stretch};
pub(crate) use curve::{on_ground, within_cylinder};
pub use fold::margin;
pub use rays::bend_rays;
