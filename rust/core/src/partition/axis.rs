//! Vertical axis from which ρ is measured.

use glam::DVec3;

use crate::base::{Error, Result};
use crate::scene::Scene;

/// Fails for a centre that is not finite.
pub(super) fn check_center(center: DVec3) -> Result<()> {
    if center.is_finite() { Ok(()) } else { Err(Error::value("center", "three finite numbers", center)) }
}

/// Returns (x, z) of the axis relative to the scene's origin.
pub(super) fn axis_in(scene: &Scene, center: DVec3) -> [f64; 2] {
    let local = center - scene.origin;
    [local.x, local.z]
}
