//! Views of a parent, computed from the views of its eight children alone.

use glam::{IVec3, Vec3};
use rayon::prelude::*;

use super::direction::Direction;
use super::normals;
use super::reduce::{Sample, reach, reduce_view};
use super::view::{Format, Texel, View, Views};
use crate::base::memory::room_for_values;
use crate::base::{Result, ensure};
use crate::scene::srgb::linear_from_srgb;

/// A pixel of a parent's picture at twice its size.
#[derive(Clone, Copy, Default)]
struct ParentPixel {
    /// The child's pixel.
    texel: Texel,
    /// Depth in the parent's range, in steps of the child's length from 1 on; 0 for no surface.
    step: u32,
}

/// A parent, into which some of its children have been drawn.
pub struct Parent {
    directions: Vec<Direction>,
    format: Format,
    /// Picture at twice the size of a view, for each direction.
    pictures: Vec<Vec<ParentPixel>>,
    /// Children and their octants, if there is a second layer. It can be drawn only when all first surfaces are known,
    /// because it has the pixels more than a gap behind them.
    children: Option<Vec<(IVec3, Views)>>,
}

impl Parent {
    /// Creates a parent without children; it has a second layer if `has_second_layer`.
    pub fn new(directions: Vec<Direction>, format: Format, has_second_layer: bool) -> Result<Self> {
        room_for_values::<[ParentPixel; 4]>(format.pixels() * directions.len())?;
        let pictures = directions.iter().map(|_| blank(&format)).collect();
        Ok(Self { directions, format, pictures, children: has_second_layer.then(Vec::new) })
    }

    /// Draws a child; `octant` is its position, 0 or 1 along each axis. At equal depths the child drawn first wins, so
    /// callers must add children in a fixed order.
    pub fn add(&mut self, octant: [u8; 3], child: &Views) -> Result<()> {
        let is_octant = octant.iter().all(|&coordinate| coordinate <= 1);
        ensure!(is_octant, "octant", "0 or 1 along each axis", format!("{octant:?}"));
        let is_alike = (&child.directions, child.format) == (&self.directions, self.format);
        ensure!(is_alike, "child", "the directions and the format of its parent", "different ones");
        let (octant, format) = (IVec3::from_array(octant.map(i32::from)), self.format);
        let children = self.directions.par_iter().zip(child.views());
        children.zip(&mut self.pictures).for_each(|((&direction, view), picture)| {
            draw(view, direction, octant, &format, picture, |_, _| true);
        });
        if let Some(children) = &mut self.children {
            children.push((octant, child.clone()));
        }
        Ok(())
    }

    /// Returns the views from the children drawn so far.
    pub fn finish(&self) -> Result<Views> {
        // The views of both layers, and one picture of the second layer per thread.
        let pixels = self.format.pixels();
        room_for_values::<[Texel; 2]>(pixels * self.directions.len())?;
        room_for_values::<[ParentPixel; 4]>(pixels * rayon::current_num_threads())?;
        let pictures = self.directions.par_iter().zip(&self.pictures);
        let views = pictures.map(|(&direction, picture)| reduce_picture(picture, direction, &self.format)).collect();
        let second_views = self.children.as_ref().map(|children| {
            let indices = (0..self.directions.len()).into_par_iter();
            indices.map(|index| self.second_layer_view(children, index)).collect()
        });
        Ok(Views::from_layers(&self.directions, self.format, (views, second_views)))
    }

    /// Returns the second-layer view of one direction.
    fn second_layer_view(&self, children: &[(IVec3, Views)], index: usize) -> View {
        let (direction, first) = (self.directions[index], &self.pictures[index]);
        let reach = reach_of(direction, &self.format);
        let is_behind = |pixel: usize, step: u32| step as f32 > first[pixel].step as f32 + reach;
        let mut picture = blank(&self.format);
        for (octant, child) in children {
            for view in child.layers(index) {
                draw(view, direction, *octant, &self.format, &mut picture, is_behind);
            }
        }
        reduce_picture(&picture, direction, &self.format)
    }
}

/// Creates a picture without surfaces.
fn blank(format: &Format) -> Vec<ParentPixel> {
    vec![ParentPixel::default(); 4 * format.pixels()]
}

/// Draws those surfaces of a child's view into its parent's picture that `accepts` accepts, given the pixel's index
/// and the step in the parent's depth range.
fn draw(
    view: &View,
    direction: Direction,
    octant: IVec3,
    format: &Format,
    picture: &mut [ParentPixel],
    accepts: impl Fn(usize, u32) -> bool,
) {
    let (frame, size) = (direction.frame(), format.size);
    let ((column, row), steps_before) = (frame.place(octant, size), frame.steps_before(octant, format.steps));
    let rows = view.chunks_exact(size).zip(picture.chunks_exact_mut(2 * size).skip(row));
    for ((texels, target), row) in rows.zip(row..) {
        let pixels = texels.iter().zip(&mut target[column..]).zip(2 * size * row + column..);
        for ((texel, target), pixel) in pixels.filter(|((texel, _), _)| texel.depth > 0) {
            let step = steps_before + u32::from(texel.depth);
            if (target.step == 0 || step < target.step) && accepts(pixel, step) {
                *target = ParentPixel { texel: *texel, step };
            }
        }
    }
}

/// Returns the reach (see `reduce::reach`) of a parent's picture, in steps of its children.
fn reach_of(direction: Direction, format: &Format) -> f32 {
    let extents = direction.frame().extents();
    let pixel = extents.x.max(extents.y) / format.size as f64;
    reach(pixel, extents.z / f64::from(format.steps))
}

/// Reduces a parent's picture. The parent's steps are twice as long as its children's; each surface lies in the step
/// that contains its child's step, so depth errors never exceed half a step, on any level.
fn reduce_picture(picture: &[ParentPixel], direction: Direction, format: &Format) -> View {
    let linear = linear_from_srgb();
    let sample = |pixel: usize| {
        let ParentPixel { texel, step } = picture[pixel];
        (step > 0).then(|| Sample {
            depth: step as f32,
            color: Vec3::from_array(texel.color.map(|code| linear[usize::from(code)])),
            normal: normals::decode(texel.normal, format.normal_bits),
        })
    };
    reduce_view(|| sample, reach_of(direction, format), |sample| (sample.depth as u32).div_ceil(2), format)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_nearer_child_moves_the_surface_of_a_farther_one_to_the_second_layer_in_either_order() {
        let format = Format::new(4, 12, 16).unwrap();
        let directions = vec![Direction::new([0, 0, 1]).unwrap()];
        let child = |depth: u16| {
            let texels = vec![Texel { depth, color: [depth as u8; 3], ..Texel::default() }; format.pixels()];
            Views::new(directions.clone(), format, texels).unwrap()
        };
        let gap = reach_of(directions[0], &format) as u16;
        assert_eq!(u32::from(gap), format.steps);
        // The far child's first surface lies within the gap behind the near child's, its second surface beyond the gap.
        let near = child(5);
        let far = child(3).with_behind(&child(8)).unwrap();
        for order in [[1, 0], [0, 1]] {
            let mut parent = Parent::new(directions.clone(), format, true).unwrap();
            for z in order {
                parent.add([0, 0, z], if z == 1 { &near } else { &far }).unwrap();
            }
            let views = parent.finish().unwrap();
            let (first, behind) = (&views.views()[0], &views.second_layer().unwrap().views()[0].clone());
            // A child of 4 × 4 pixels fills the lower left quarter.
            let depths = |texels: &[Texel]| texels.iter().map(|texel| texel.depth).collect::<Vec<_>>();
            let quarter = |depth: u16| {
                (0..16).map(|pixel| if pixel / 4 > 1 && pixel % 4 < 2 { depth } else { 0 }).collect::<Vec<_>>()
            };
            assert_eq!(depths(first), quarter(3));
            assert_eq!(depths(behind), quarter((format.steps as u16 + 8) / 2));
        }
    }
}
