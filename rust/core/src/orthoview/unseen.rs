//! Pixels of a second layer that no first-layer view shows.

use glam::DVec3;
use rayon::prelude::*;

use super::cell::{Cell, Sight};
use super::reduce::reach;
use super::view::{Format, Texel, View, Views};

/// Returns, for each direction, the number of the second layer's pixels that no first-layer view shows, divided by the
/// number of the first layer's pixels with a surface.
///
/// A view shows a point if the depth of one of the 3 × 3 pixels around its position is within the reach of one
/// surface.
pub fn unseen(views: &Views) -> Vec<f32> {
    let Some(behind) = views.second_layer() else { return vec![0.0; views.directions.len()] };
    // Ratios do not depend on the cell.
    let cell = Cell { corner: DVec3::ZERO, side: 1.0 };
    let sights = views.directions.iter().map(|direction| Sight::new(&cell, direction.frame(), views.format.size));
    let firsts: Vec<First> =
        sights.zip(views.views()).map(|(sight, view)| First::new(sight, view, &views.format)).collect();
    let ratio = |(first, behind): (&First<'_>, &View)| {
        let is_unseen = |&pixel: &usize| {
            let texel = &behind[pixel];
            let point = first.point(pixel, texel);
            texel.depth > 0 && !firsts.iter().any(|first| first.shows(point))
        };
        let unseen_count = (0..behind.len()).into_par_iter().filter(is_unseen).count();
        let surface_count = first.view.iter().filter(|texel| texel.depth > 0).count();
        unseen_count as f32 / surface_count.max(1) as f32
    };
    firsts.par_iter().zip(behind.views()).map(ratio).collect()
}

/// A view of the first layer.
struct First<'a> {
    sight: Sight,
    view: &'a View,
    /// Length of a step, in sides of the cell.
    step: f64,
    /// Maximum depth difference of one surface, in steps.
    reach: f64,
}

impl<'a> First<'a> {
    fn new(sight: Sight, view: &'a View, format: &Format) -> Self {
        let step = sight.extents.z / f64::from(format.steps);
        // Reach of the picture at twice the size from which the view was reduced.
        Self { sight, view, step, reach: f64::from(reach(sight.pixel() / 2.0, step)) }
    }

    /// Returns the point of a pixel in the middle of its depth step.
    fn point(&self, pixel: usize, texel: &Texel) -> DVec3 {
        self.sight.point_of_pixel(pixel, (f64::from(texel.depth) - 0.5) * self.step)
    }

    fn shows(&self, point: DVec3) -> bool {
        let place = self.sight.project(point);
        let (size, code) = (self.sight.pixels as i64, place.z / self.step + 0.5);
        let neighbourhood = |value: f64| {
            let pixel = (value as i64).min(size - 1);
            (pixel - 1).max(0)..(pixel + 2).min(size)
        };
        let columns = neighbourhood(place.x);
        neighbourhood(place.y).any(|row| {
            let row = &self.view[(row * size) as usize..][..size as usize];
            let near = |texel: &Texel| texel.depth > 0 && (f64::from(texel.depth) - code).abs() <= self.reach;
            row[columns.start as usize..columns.end as usize].iter().any(near)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::orthoview::Direction;

    const SIZE: usize = 8;

    /// Creates views of constant depths, one for each direction; 0 for no surface.
    fn views(directions: &[[i8; 3]], depths: &[u16]) -> Views {
        let directions: Vec<Direction> = directions.iter().map(|&numbers| Direction::new(numbers).unwrap()).collect();
        let texels = depths.iter().flat_map(|&depth| vec![Texel { depth, ..Texel::default() }; SIZE * SIZE]);
        Views::new(directions, Format::new(SIZE, 12, 16).unwrap(), texels.collect()).unwrap()
    }

    #[test]
    fn hidden_surfaces_are_visible_only_from_the_other_side() {
        let (down, up) = ([0, 1, 0], [0, -1, 0]);
        let steps = views(&[], &[]).format.steps as u16;
        // A floor 1,500 steps below the top, under a roof 10 steps below it.
        let from = |below: u16| views(&[down, up], &[10, below]).with_behind(&views(&[down, up], &[1500, 0])).unwrap();
        assert_eq!(unseen(&from(0)), [1.0, 0.0]);
        assert_eq!(unseen(&from(steps + 1 - 1500)), [0.0, 0.0]);
        // A surface reaches two of eight pixels in depth.
        let reach = steps / 4;
        assert_eq!(unseen(&from(steps + 1 - 1500 + reach)), [0.0, 0.0]);
        assert_eq!(unseen(&from(steps + 2 - 1500 + reach)), [1.0, 0.0]);
    }

    #[test]
    fn shares_count_non_empty_pixels() {
        let mut first = views(&[[0, 0, 1]], &[0]).views()[0].clone();
        first[..4].fill(Texel { depth: 3, ..Texel::default() });
        let mut second = vec![Texel::default(); SIZE * SIZE];
        second[0].depth = 3000;
        let of = |texels: Vec<Texel>| {
            let bare = views(&[[0, 0, 1]], &[0]);
            Views::new(bare.directions, bare.format, texels).unwrap()
        };
        let both = of(first).with_behind(&of(second)).unwrap();
        assert_eq!(unseen(&both), [0.25]);
        assert_eq!(unseen(&both.keep_behind(&[false]).unwrap()), [0.0]);
    }
}
