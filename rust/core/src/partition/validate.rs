//! Validation of a partition against the radii of every triangle.

use std::ops::Range;

use rayon::prelude::*;

use super::classify::{Class, Ruler, Zone};
use super::divide::Partition;
use super::radii::{TILE, radii_of};
use crate::base::mapped::in_ranges;
use crate::base::{Error, Progress, Result};

impl Partition {
    /// Measures every triangle again, without boxes and thresholds, and compares. An error is a bug in nearfar.
    pub fn validate(&self, progress: &Progress) -> Result<()> {
        let axis = self.axis;
        let ruler = Ruler::new(axis, self.r1, self.r2);
        progress.expect(self.counts.triangles as u64);
        (0..self.classes.len() as u32).into_par_iter().try_for_each(|number| {
            let instance = self.scene.instance(number);
            if let Class::Mixed(mixed) = &self.classes[number as usize]
                && !(mixed.faces.is_sorted_by(|a, b| a < b) && mixed.faces.len() == mixed.zones.len())
            {
                return Err(Error::Scene(format!("partition: the faces of instance {number} are out of order")));
            }
            let task = |faces: Range<usize>| {
                self.validate_faces(number, faces.clone(), &ruler, axis)?;
                progress.report(faces.len() as u64)
            };
            in_ranges(instance.mesh.faces.len(), TILE, task).map(drop)
        })?;
        let counts = &self.counts;
        let by_zone = counts.near + counts.intermediate + counts.far;
        let by_set = counts.nsf + counts.sf - counts.straddling;
        if by_zone != counts.triangles || by_set != counts.triangles || self.count() != *counts {
            return Err(Error::Scene(format!("partition: the counts do not add up: {counts:?}")));
        }
        Ok(())
    }

    fn validate_faces(&self, number: u32, faces: Range<usize>, ruler: &Ruler, axis: [f64; 2]) -> Result<()> {
        let instance = self.scene.instance(number);
        for face in faces.start as u32..faces.end as u32 {
            let [a, b, c] = instance.corners(face).map(|corner| [f64::from(corner.x), f64::from(corner.z)]);
            let radii = radii_of(a, b, c, axis).map(|radius| radius as f32);
            let expected = ruler.zone(radii).unwrap_or(Zone::Far);
            let zone = self.zone(number, face);
            if zone != expected {
                let text = format!("partition: face {face} of instance {number} is {expected:?}, not {zone:?}");
                return Err(Error::Scene(text));
            }
        }
        Ok(())
    }
}
