//! Displayed sizes of objects: through a lens, on the panel, reduced by the eye's acuity, in pixels of their models.

use std::f64::consts::FRAC_PI_2;

use bytemuck::Zeroable;
use glam::DVec3;

use super::curves::Model;
use super::objects::{CHUNK, Objects};
use super::rules::{Acuity, Apparent, EyeLens};
use super::view::{Eye, Sight};
use crate::lens::{Magnification, SPHERES_PER_BLOCK, Sizes, Spheres};

/// The eyes, and the rules for the sizes that they see.
pub(crate) struct EyeSizes<'a> {
    pub eyes: &'a [Eye],
    apparent: Apparent<'a>,
    /// Pixel areas per eye.
    pixel_areas: Vec<PixelAreas>,
}

/// Area of the models' pixels as a multiple of an eye's.
enum PixelAreas {
    Same(f64),
    OfModels(Vec<f64>),
}

/// Sizes of a chunk's open objects, in consecutive entries.
#[derive(Zeroable)]
pub(crate) struct OpenSizes {
    /// Indices of the objects in the chunk.
    pub place: [u16; CHUNK],
    /// σ
    pub sigma: [f64; CHUNK],
    /// σ′, the displayed size.
    pub displayed: [f64; CHUNK],
    /// Size at which curves are evaluated: σ′ in pixels of the model; +∞ if σ′ exceeds its limit.
    pub curve_size: [f64; CHUNK],
    angles: [[f64; CHUNK]; 4],
    factor: [f64; CHUNK],
}

/// Copies the values at some indices into consecutive entries.
fn gather(from: &[f64; CHUNK], places: &[u16], to: &mut [f64; CHUNK]) {
    for (to, &place) in to.iter_mut().zip(places) {
        *to = from[usize::from(place) % CHUNK];
    }
}

impl<'a> EyeSizes<'a> {
    pub fn new(models: &[Model<'_>], eyes: &'a [Eye], apparent: Apparent<'a>) -> Self {
        let areas = |eye: &Eye| {
            let areas: Vec<f64> = models.iter().map(|model| model.pixel_area(eye.pixel)).collect();
            match areas.first() {
                Some(&first) if areas.iter().all(|&area| area == first) => PixelAreas::Same(first),
                _ => PixelAreas::OfModels(areas),
            }
        };
        Self { eyes, apparent, pixel_areas: eyes.iter().map(areas).collect() }
    }

    /// Returns whether a lens or a panel changes sizes.
    pub fn changes_sizes(&self) -> bool {
        !matches!(self.apparent, Apparent::Own)
    }

    /// Computes the sizes of the first `len` open objects of a chunk for an eye; +∞ for curves if σ′ exceeds the limit.
    pub fn write_sizes(
        &self,
        eye: usize,
        objects: &Objects<'_>,
        sight: &Sight,
        open: &mut OpenSizes,
        len: usize,
        limit: f64,
    ) {
        gather(&sight.sigma, &open.place[..len], &mut open.sigma);
        open.displayed[..len].copy_from_slice(&open.sigma[..len]);
        let view = &self.eyes[eye];
        match &self.apparent {
            Apparent::Own => {}
            Apparent::Axis(lens) => lens.apply(view, objects, sight, open, len),
            Apparent::Area(lens) => {
                lens.apply(view, objects, sight, open, len);
                lens.apply_across(sight, open, len);
            }
            Apparent::Panel(lens) => apply_panel(lens.as_ref(), view.view.corner, sight, open, len),
        }
        if let Some(acuity) = &view.acuity {
            for k in 0..len {
                let n = usize::from(open.place[k]);
                let center = DVec3::from_array(objects.centers[n]) - view.view.position;
                let scale = acuity.scale(center, sight.sin_mu[n].atan2(sight.cos_mu[n]));
                open.displayed[k] *= scale * scale;
            }
        }
        let OpenSizes { place, displayed, curve_size, .. } = open;
        let in_pixels = |size: f64, area: f64| if size > limit { f64::INFINITY } else { size * area };
        match &self.pixel_areas[eye] {
            PixelAreas::Same(area) => {
                displayed[..len].iter().zip(curve_size).for_each(|(&size, to)| *to = in_pixels(size, *area));
            }
            PixelAreas::OfModels(areas) => {
                for ((&place, &size), to) in place[..len].iter().zip(&*displayed).zip(curve_size) {
                    *to = in_pixels(size, areas[objects.model[usize::from(place)] as usize]);
                }
            }
        }
    }
}

impl EyeLens<'_> {
    /// Replaces σ by σ′, the size through the lens.
    fn apply(&self, eye: &Eye, objects: &Objects<'_>, sight: &Sight, open: &mut OpenSizes, count: usize) {
        if self.exact {
            let (mut centers, mut radii) = ([[0.0; 3]; CHUNK], [0.0; CHUNK]);
            for (k, &n) in open.place[..count].iter().enumerate() {
                (centers[k], radii[k]) = (objects.centers[usize::from(n)], objects.radii[usize::from(n)]);
            }
            let sizes = Sizes {
                lens: self.lens,
                eye: eye.view.position,
                forward: eye.view.forward(),
                tan_omega: self.tan_omega,
                exact: false,
            };
            sizes.solid_angles(&centers[..count], &radii[..count], &mut open.displayed[..count]);
            return;
        }
        let OpenSizes { place, displayed, angles, factor, .. } = open;
        let parts = [&sight.sin_alpha, &sight.cos_alpha, &sight.sin_mu, &sight.cos_mu];
        for (part, to) in parts.into_iter().zip(&mut *angles) {
            gather(part, &place[..count], to);
        }
        let [sin_alpha, cos_alpha, sin_mu, cos_mu] = angles;
        let spheres = Spheres { sin_alpha, cos_alpha, sin_mu, cos_mu };
        self.lens.stretches(self.tan_omega, &spheres, &mut factor[..count]);
        for (displayed, factor) in displayed.iter_mut().zip(&factor[..count]) {
            *displayed *= factor;
        }
    }

    /// Multiplies σ′ by the magnification around the axis, except for spheres that extend to the lens's fold or to 90°.
    fn apply_across(&self, sight: &Sight, open: &mut OpenSizes, count: usize) {
        tangents(sight, &open.place[..count], f64::INFINITY, &mut open.angles[0]);
        let used = count.next_multiple_of(SPHERES_PER_BLOCK);
        let (from, to) = (&open.angles[0][..used], &mut open.factor[..used]);
        self.lens.magnify(Magnification::Across, self.tan_omega, self.exact, from, to);
        let end = (self.lens.x_max() * self.tan_omega).atan().min(FRAC_PI_2);
        for k in 0..count {
            let n = usize::from(open.place[k]);
            let edge = sight.sin_alpha[n].atan2(sight.cos_alpha[n]) + sight.sin_mu[n].atan2(sight.cos_mu[n]);
            open.displayed[k] *= if edge < end { open.factor[k] } else { 1.0 };
        }
    }
}

/// Multiplies σ by D(α) of the centre; for centres beyond the view's corner, by D(α) of the corner.
fn apply_panel(lens: Option<&EyeLens<'_>>, corner: f64, sight: &Sight, open: &mut OpenSizes, count: usize) {
    tangents(sight, &open.place[..count], corner, &mut open.angles[0]);
    let used = count.next_multiple_of(SPHERES_PER_BLOCK);
    let (from, to) = (&open.angles[0][..used], &mut open.factor[..used]);
    match lens {
        Some(lens) => lens.lens.magnify(Magnification::Panel, lens.tan_omega, lens.exact, from, to),
        None => to.iter_mut().zip(from).for_each(|(to, t)| *to = (1.0 + t * t) * (1.0 + t * t).sqrt()),
    }
    for (displayed, factor) in open.displayed[..count].iter_mut().zip(&open.factor) {
        // A size of 0 stays 0 even if D is infinite.
        *displayed = if *displayed > 0.0 { *displayed * factor } else { *displayed };
    }
}

/// Writes tan α of centres, at most `limit`, also for centres beside or behind the eye; pads the last block with 0.
fn tangents(sight: &Sight, places: &[u16], limit: f64, to: &mut [f64; CHUNK]) {
    for (to, &place) in to.iter_mut().zip(places) {
        let n = usize::from(place) % CHUNK;
        let tangent = sight.sin_alpha[n] / sight.cos_alpha[n];
        *to = if sight.cos_alpha[n] > 0.0 && tangent < limit { tangent } else { limit };
    }
    to[places.len()..places.len().next_multiple_of(SPHERES_PER_BLOCK)].fill(0.0);
}

impl Acuity {
    /// Returns the factor by which acuity reduces lengths at the point of a sphere (half angle μ) nearest the gaze.
    pub fn scale(&self, offset: DVec3, mu: f64) -> f64 {
        let offset = offset / offset.abs().max_element();
        let eccentricity = offset.cross(self.gaze).length().atan2(offset.dot(self.gaze)) - mu;
        (self.best / (self.slope * eccentricity.max(0.0).to_degrees() + self.limit)).min(1.0)
    }
}
