//! Pixels of a second layer that no first-layer view shows.

use glam::DVec3;
use rayon::prelude::*;

use super::cell::{Cell, OrthoCamera};
use super::reduce::reach;
use super::view::{Format, Texel, View, Views};

/// Returns, for each direction, the number of the second layer's pixels that no first-layer view shows, divided by the
/// number of the first layer's pixels with a surface.
///
/// A view shows a point if one of the 3 × 3 pixels around the point's position has a depth at most `reduce::reach`
/// from the point's.
pub fn unseen(views: &Views) -> Vec<f32> {
    let Some(behind) = views.second_layer() else { return vec![0.0; views.directions.len()] };
    // Ratios do not depend on the cell.
    let cell = Cell { corner: DVec3::ZERO, side: 1.0 };
    let cameras =
        views.directions.iter().map(|direction| OrthoCamera::new(&cell, direction.frame(), views.format.size));
    let first_views: Vec<FirstView> =
        cameras.zip(views.views()).map(|(ortho, view)| FirstView::new(ortho, view, &views.format)).collect();
    let ratio = |(first, behind): (&FirstView<'_>, &View)| {
        let is_unseen = |&pixel: &usize| {
            let texel = &behind[pixel];
            let point = first.point(pixel, texel);
            texel.depth > 0 && !first_views.iter().any(|first| first.shows(point))
        };
        let unseen_count = (0..behind.len()).into_par_iter().filter(is_unseen).count();
        let surface_count = first.view.iter().filter(|texel| texel.depth > 0).count();
        unseen_count as f32 / surface_count.max(1) as f32
    };
    first_views.par_iter().zip(behind.views()).map(ratio).collect()
}

/// A view of the first layer.
struct FirstView<'a> {
    ortho: OrthoCamera,
    view: &'a View,
    /// Length of a step, in sides of the cell.
    step: f64,
    /// Maximum depth difference of points of one surface, in steps.
    reach: f64,
}

impl<'a> FirstView<'a> {
    fn new(ortho: OrthoCamera, view: &'a View, format: &Format) -> Self {
        let step = ortho.extents.z / f64::from(format.steps);
        // Reach of the picture at twice the size from which the view was reduced.
        Self { ortho, view, step, reach: f64::from(reach(ortho.pixel() / 2.0, step)) }
    }

    /// Returns the point of a pixel in the middle of its depth step.
    fn point(&self, pixel: usize, texel: &Texel) -> DVec3 {
        self.ortho.point_of_pixel(pixel, (f64::from(texel.depth) - 0.5) * self.step)
    }

    fn shows(&self, point: DVec3) -> bool {
        let place = self.ortho.project(point);
        let (size, code) = (self.ortho.pixels as i64, place.z / self.step + 0.5);
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
        let with_depth_from_below =
            |depth: u16| views(&[down, up], &[10, depth]).with_behind(&views(&[down, up], &[1500, 0])).unwrap();
        assert_eq!(unseen(&with_depth_from_below(0)), [1.0, 0.0]);
        assert_eq!(unseen(&with_depth_from_below(steps + 1 - 1500)), [0.0, 0.0]);
        // The reach is two pixel widths, a quarter of the cell.
        let reach = steps / 4;
        assert_eq!(unseen(&with_depth_from_below(steps + 1 - 1500 + reach)), [0.0, 0.0]);
        assert_eq!(unseen(&with_depth_from_below(steps + 2 - 1500 + reach)), [1.0, 0.0]);
    }

    #[test]
    fn shares_count_non_empty_pixels() {
        let mut first = views(&[[0, 0, 1]], &[0]).views()[0].clone();
        first[..4].fill(Texel { depth: 3, ..Texel::default() });
        let mut second = vec![Texel::default(); SIZE * SIZE];
        second[0].depth = 3000;
        let views_of = |texels: Vec<Texel>| {
            let empty = views(&[[0, 0, 1]], &[0]);
            Views::new(empty.directions, empty.format, texels).unwrap()
        };
        let both = views_of(first).with_behind(&views_of(second)).unwrap();
        assert_eq!(unseen(&both), [0.25]);
        assert_eq!(unseen(&both.keep_behind(&[false]).unwrap()), [0.0]);
    }
}
