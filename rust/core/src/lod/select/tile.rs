//! A tile of objects, eye by eye: what one stage settles, the next does not see.

use glam::DVec3;

use super::curves::Asked;
use super::view::{HIDDEN, Sight};
use super::{Acuity, COLUMNS, Counts, Eye, Glass, Objects, Selection, TILE, refused};
use crate::base::Result;
use crate::lens::{Sizes, Spheres};

/// No eye has seen an object yet.
const UNSEEN: i32 = -1;

/// Objects and their results.
pub(super) struct Tile<'a> {
    /// Number of the first.
    pub first: usize,
    pub objects: Objects<'a>,
    pub level: &'a mut [i32],
    pub columns: Option<[&'a mut [f64]; COLUMNS]>,
}

/// Room for what is known of a tile.
#[derive(Default)]
pub(super) struct Room {
    sight: Box<Sight>,
    left: Box<Left>,
}

/// Those that are left to be asked for: their places in the tile, and their numbers side by side.
struct Left {
    place: [u16; TILE],
    sigma: [f64; TILE],
    sin_alpha: [f64; TILE],
    cos_alpha: [f64; TILE],
    sin_mu: [f64; TILE],
    cos_mu: [f64; TILE],
    seen: [f64; TILE],
}

impl Default for Left {
    fn default() -> Self {
        let [sigma, sin_alpha, cos_alpha, sin_mu, cos_mu, seen] = [[0.0; TILE]; 6];
        Self { place: [0; TILE], sigma, sin_alpha, cos_alpha, sin_mu, cos_mu, seen }
    }
}

impl Selection<'_> {
    pub(super) fn tile(&self, room: &mut Room, mut tile: Tile<'_>) -> Result<Counts> {
        self.check(&tile)?;
        let mut counts = Counts::default();
        tile.level.fill(if self.eyes.is_empty() { 0 } else { UNSEEN });
        if let Some(columns) = &mut tile.columns {
            let none = f64::from(tile.level.first().copied().unwrap_or(UNSEEN));
            let values = [f64::NAN, f64::NAN, f64::NAN, if none < 0.0 { f64::NAN } else { 1.0 }, none];
            for (column, value) in columns.iter_mut().zip(values) {
                column.fill(value);
            }
        }
        for eye in self.eyes {
            let Objects { centers, radii, .. } = tile.objects;
            eye.view.see(centers, radii, tile.first, self.rules.cull, &mut room.sight)?;
            let asked = self.sort(&room.sight, &mut tile, &mut room.left, &mut counts);
            self.sizes(eye, &tile.objects, &mut room.left, asked, &mut counts);
            self.levels(&room.left, asked, &mut tile, &mut counts);
        }
        Ok(counts)
    }

    fn check(&self, tile: &Tile<'_>) -> Result<()> {
        let count = self.models.len();
        for (n, &model) in tile.objects.model.iter().enumerate() {
            if model as u64 >= count as u64 {
                return Err(refused("model_index", 0, count, model, tile.first + n));
            }
        }
        let Some(previous) = tile.objects.previous else { return Ok(()) };
        for (n, (&level, &model)) in previous.iter().zip(tile.objects.model).enumerate() {
            let most = self.models[model as usize].curves.len() as i32;
            if level < UNSEEN || level > most {
                return Err(refused("previous", -1, most as usize + 1, level.into(), tile.first + n));
            }
        }
        Ok(())
    }

    /// Settles what needs no curve, and tells how many are left.
    fn sort(&self, sight: &Sight, tile: &mut Tile<'_>, left: &mut Left, counts: &mut Counts) -> usize {
        let mut asked = 0;
        for (n, (level, &model)) in tile.level.iter_mut().zip(tile.objects.model).enumerate() {
            let (sigma, limit) = (sight.sigma[n], self.limits[model as usize]);
            let is_culled = sigma == HIDDEN;
            let is_settled = !is_culled & (*level == 0);
            let is_done = !is_culled & !is_settled & (sigma > limit);
            let is_one = is_done & (limit == f64::NEG_INFINITY);
            let is_left = !(is_culled | is_settled | is_done);
            counts.culled += u64::from(is_culled);
            counts.settled += u64::from(is_settled);
            counts.one_level += u64::from(is_one);
            counts.large += u64::from(is_done & !is_one);
            if is_done {
                *level = 0;
                if let Some(columns) = &mut tile.columns {
                    let values = [if is_one { f64::NAN } else { sigma }, f64::NAN, f64::NAN, 1.0, 0.0];
                    for (column, value) in columns.iter_mut().zip(values) {
                        column[n] = value;
                    }
                }
            }
            // Written in any case, and kept where it counts: a branch would be guessed wrong every other time.
            left.place[asked] = n as u16;
            left.sigma[asked] = sigma;
            left.sin_alpha[asked] = sight.sin_alpha[n];
            left.cos_alpha[asked] = sight.cos_alpha[n];
            left.sin_mu[asked] = sight.sin_mu[n];
            left.cos_mu[asked] = sight.cos_mu[n];
            asked += usize::from(is_left);
        }
        counts.asked += asked as u64;
        asked
    }

    /// σ′ of those that are left, and what the eye sees of it.
    fn sizes(&self, eye: &Eye, objects: &Objects<'_>, left: &mut Left, asked: usize, counts: &mut Counts) {
        left.seen[..asked].copy_from_slice(&left.sigma[..asked]);
        if let Some(glass) = &self.glass {
            glass.look(eye, objects, left, asked);
            counts.lens += asked as u64;
        }
        if let Some(acuity) = &eye.acuity {
            for k in 0..asked {
                let center = DVec3::from_array(objects.centers[usize::from(left.place[k])]) - eye.view.position();
                let scale = acuity.scale(center, left.sin_mu[k].atan2(left.cos_mu[k]));
                left.seen[k] *= scale * scale;
            }
        }
    }

    fn levels(&self, left: &Left, asked: usize, tile: &mut Tile<'_>, counts: &mut Counts) {
        let rules = &self.rules;
        for k in 0..asked {
            let n = usize::from(left.place[k]);
            let number = tile.objects.model[n] as usize;
            let (sigma, seen) = (left.sigma[k], left.seen[k]);
            let table = self.tables.get(number).and_then(Option::as_ref);
            let model = &self.models[number];
            let question = Asked { sigma, seen, threshold: rules.line.at(sigma) };
            let previous = tile.objects.previous.and_then(|previous| usize::try_from(previous[n]).ok());
            let previous = previous.filter(|_| rules.hysteresis > 0.0);
            let (most, is_sure) = match table {
                Some(table) if seen <= model.range[1] => table.level(sigma, seen),
                Some(_) => (0, true),
                None => (model.curves.len(), false),
            };
            // A level of the table that is no coarser than the previous one stands as it is.
            let is_sure = is_sure && previous.is_none_or(|previous| most <= previous);
            let level = match previous {
                _ if is_sure => most,
                Some(previous) => model.held(previous, &question, rules),
                None => model.coarsest(most, &question),
            };
            counts.table += u64::from(is_sure);
            counts.formula += u64::from(!is_sure);
            let best = &mut tile.level[n];
            let is_finer = *best == UNSEEN || (level as i32) < *best;
            if let Some(columns) = &mut tile.columns {
                let shown = model.shown(level, &question, rules);
                if is_finer {
                    let values = [sigma, seen, question.threshold, model.score(level, seen)];
                    for (column, value) in columns.iter_mut().zip(values) {
                        column[n] = value;
                    }
                }
                columns[4][n] = if *best == UNSEEN { shown } else { columns[4][n].min(shown) };
            }
            if is_finer {
                *best = level as i32;
            }
        }
    }
}

impl Glass<'_> {
    /// σ′ in place of σ.
    fn look(&self, eye: &Eye, objects: &Objects<'_>, left: &mut Left, asked: usize) {
        if self.exact {
            let (mut centers, mut radii) = ([[0.0; 3]; TILE], [0.0; TILE]);
            for (k, &n) in left.place[..asked].iter().enumerate() {
                (centers[k], radii[k]) = (objects.centers[usize::from(n)], objects.radii[usize::from(n)]);
            }
            let sizes = Sizes {
                lens: self.lens,
                eye: eye.view.position(),
                forward: eye.view.forward(),
                tan_omega: self.tan_omega,
                exact: false,
            };
            sizes.each(&centers[..asked], &radii[..asked], &mut left.seen[..asked]);
            return;
        }
        let Left { sin_alpha, cos_alpha, sin_mu, cos_mu, seen, .. } = left;
        let spheres = Spheres { sin_alpha, cos_alpha, sin_mu, cos_mu };
        let mut ratios = [0.0; TILE];
        self.lens.stretches(self.tan_omega, &spheres, &mut ratios[..asked]);
        for (seen, ratio) in seen[..asked].iter_mut().zip(ratios) {
            *seen *= ratio;
        }
    }
}

impl Acuity {
    /// How much smaller, along a line, the nearest edge of a sphere with half the angle μ looks.
    fn scale(&self, offset: DVec3, mu: f64) -> f64 {
        let offset = offset / offset.abs().max_element();
        let away = offset.cross(self.gaze).length().atan2(offset.dot(self.gaze)) - mu;
        (self.best / (self.slope * away.max(0.0).to_degrees() + self.limit)).min(1.0)
    }
}
