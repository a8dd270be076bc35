//! Views of a parent, from those of its eight children only.

use glam::{IVec3, Vec3};
use rayon::prelude::*;

use super::direction::Direction;
use super::format::Format;
use super::normals;
use super::reduce::{Sample, reach, reduced_view};
use super::view::{Texel, View, Views};
use crate::base::{Error, Result};
use crate::scene::srgb::linear_from_srgb;

/// A pixel of a parent's picture at twice its size.
#[derive(Clone, Copy, Default)]
struct Shown {
    /// The child's pixel.
    texel: Texel,
    /// Its step of the parent's depth, in the child's steps, from 1; 0 where there is none.
    step: u32,
}

/// A parent of which some children are drawn.
pub struct Parent {
    directions: Vec<Direction>,
    format: Format,
    /// For each direction the picture at twice the size of a view.
    pictures: Vec<Vec<Shown>>,
}

impl Parent {
    /// A parent without children.
    pub fn new(directions: Vec<Direction>, format: Format) -> Self {
        let pictures = directions.iter().map(|_| vec![Shown::default(); 4 * format.pixels()]).collect();
        Self { directions, format, pictures }
    }

    /// Draws a child, whose place is 0 or 1 along each axis. Of equal depths that of the child drawn first stays, so
    /// callers draw children in one order.
    pub fn add(&mut self, octant: [u8; 3], child: &Views) -> Result<()> {
        if octant.iter().any(|&place| place > 1) {
            return Err(Error::value("octant", "0 or 1 along each axis", format!("{octant:?}")));
        }
        if (&child.directions, child.format) != (&self.directions, self.format) {
            return Err(Error::value("child", "the directions and the format of its parent", "others"));
        }
        let (octant, format) = (IVec3::from_array(octant.map(i32::from)), self.format);
        let children = self.directions.par_iter().zip(&child.views);
        children.zip(&mut self.pictures).for_each(|((&direction, view), picture)| {
            draw(view, direction, octant, &format, picture);
        });
        Ok(())
    }

    /// The views, from the children drawn so far.
    pub fn finish(&self) -> Views {
        let pictures = self.directions.par_iter().zip(&self.pictures);
        let views = pictures.map(|(&direction, picture)| finished(picture, direction, &self.format)).collect();
        Views { directions: self.directions.clone(), format: self.format, views }
    }
}

/// Draws a child's view into its parent's picture.
fn draw(view: &View, direction: Direction, octant: IVec3, format: &Format, picture: &mut [Shown]) {
    let (frame, size) = (direction.frame(), format.size);
    let ((column, row), before) = (frame.place(octant, size), frame.steps_before(octant, format.steps));
    for (texels, shown) in view.texels.chunks_exact(size).zip(picture.chunks_exact_mut(2 * size).skip(row)) {
        for (texel, shown) in texels.iter().zip(&mut shown[column..]).filter(|(texel, _)| texel.depth > 0) {
            let step = before + u32::from(texel.depth);
            if shown.step == 0 || step < shown.step {
                *shown = Shown { texel: *texel, step };
            }
        }
    }
}

/// Reduces a parent's picture. The parent's steps are twice as long as its children's; each surface lies in the step
/// that holds its child's step, so the error of depths never exceeds half a step, on whatever level.
fn finished(picture: &[Shown], direction: Direction, format: &Format) -> View {
    let extents = direction.frame().extents();
    let pixel = extents.x.max(extents.y) / format.size as f64;
    let reach = reach(pixel, extents.z / f64::from(format.steps));
    let linear = linear_from_srgb();
    let sample = |at: usize| {
        let Shown { texel, step } = picture[at];
        (step > 0).then(|| Sample {
            depth: step as f32,
            color: Vec3::from_array(texel.color.map(|code| linear[usize::from(code)])),
            normal: normals::decoded(texel.normal, format.normal_bits),
        })
    };
    reduced_view(|| sample, reach, |sample| (sample.depth as u32).div_ceil(2), format)
}
