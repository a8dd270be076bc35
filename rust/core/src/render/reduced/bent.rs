//! Morphed near geometry before the map. Pixels are split: a standing fragment is drawn where its unmorphed point lies
//! within r₂, whatever its triangle reaches, and a moving one beyond r₂ where nothing far hides it.

use super::super::frame::{Channels, Sample};
use super::super::surface::Surface;
use super::super::tiles::{Picture, Spots};
use super::backdrop::{Backdrop, sample_of};
use super::shown::Shown;
use crate::camera::Footprint;
use crate::scene::Scene;
use crate::trace::{Filter, Hit, Ray, closest_hits};

pub(super) struct Bent<'a> {
    pub scene: &'a Scene,
    pub shown: Shown,
    pub backdrop: Backdrop<'a>,
    pub radius: f64,
}

struct Split<'a> {
    bent: &'a Bent<'a>,
    standing: u32,
    cutouts: bool,
}

impl Filter for Split<'_> {
    #[inline]
    fn accepts(&self, ray: &Ray, candidate: &Hit) -> bool {
        let Bent { scene, shown, backdrop, radius } = self.bent;
        let piece = shown.piece(candidate.instance, candidate.face);
        let (u, v) = piece.on_face(candidate.u, candidate.v);
        if !Shown::is_fixed(candidate.instance) {
            let [a, b, c] = scene.instance(piece.instance).corners(piece.face).map(|corner| corner.as_dvec3());
            let point = a + (b - a) * f64::from(u) + (c - a) * f64::from(v);
            let stands = piece.instance < self.standing;
            let from_axis = point - backdrop.center;
            if from_axis.x.hypot(from_axis.z) > *radius
                && (stands || candidate.t > backdrop.hides_beyond(ray.direction))
            {
                return false;
            }
        }
        !self.cutouts || scene.is_solid(&scene.instance(piece.instance).mesh, piece.face, (u, v))
    }
}

impl Bent<'_> {
    /// The unmorphed surface, seen along the displayed ray.
    fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let piece = self.shown.piece(hit.instance, hit.face);
        Surface::new(self.scene, piece.instance, piece.face, piece.on_face(hit.u, hit.v), ray.direction)
    }
}

impl Picture for Bent<'_> {
    fn trace(&self, rays: &mut [Ray], hits: &mut [Hit], _spots: &Spots<'_>) {
        let standing = self.scene.standing.instances().len() as u32;
        let split = Split { bent: self, standing, cutouts: self.scene.has_cutouts() };
        closest_hits(&self.shown.scene, rays, &split, hits);
    }

    fn color(&self, ray: &Ray, hit: &Hit, footprint: Footprint) -> [f32; 3] {
        if hit.is_miss() {
            return self.backdrop.color(ray.direction, footprint);
        }
        self.surface(ray, hit).color(self.scene, footprint.at(hit.t))
    }

    fn sample(&self, ray: &Ray, hit: &Hit, _wanted: Channels) -> Sample {
        if hit.is_miss() {
            return self.backdrop.sample(ray.direction);
        }
        sample_of(&self.surface(ray, hit), self.scene, hit.t)
    }
}
