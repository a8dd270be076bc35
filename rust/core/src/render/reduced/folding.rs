//! Cache of the fold margin. Computing it takes ten milliseconds. The margin of a user on the axis depends only on the
//! height, and every metre from the axis reduces it by a metre, so one value serves all users of about the same height.

use std::sync::{Mutex, PoisonError};

use glam::{DVec2, DVec3};

use crate::base::Result;
use crate::bend;
use crate::morph::Morph;

/// Quantisation step of heights relative to r₂: 5 cm for 50 m. The margin hardly changes with the height.
const HEIGHT_STEP: f64 = 1e-3;

/// Height, radii and strength of the last margin, and its value for a user on the axis.
type Entry = ([f64; 4], f64);

/// Cache of the last margin.
#[derive(Debug, Default)]
pub(super) struct Folding(Mutex<Option<Entry>>);

impl Folding {
    /// Returns the metres that a user may still move before the picture folds; infinite without near geometry.
    pub fn margin(&self, morph: &Morph) -> Result<f64> {
        let Morph { user, center, r1, r2, kind, strength, .. } = *morph;
        if r2 == 0.0 {
            return Ok(f64::INFINITY);
        }
        let offset = user - center;
        let distance = DVec2::new(offset.x, offset.z).length();
        let step = HEIGHT_STEP * r2;
        let height = (offset.y / step).round() * step;
        let key = [height, r1, r2, strength];
        let last = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((last_key, margin)) = *last()
            && last_key == key
        {
            return Ok(margin - distance);
        }
        let on_axis = Morph::new(DVec3::Y * height, DVec3::ZERO, r1, r2, kind)?.with_strength(strength)?;
        let margin = bend::margin(&on_axis)?;
        *last() = Some((key, margin));
        Ok(margin - distance)
    }
}
