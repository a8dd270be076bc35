//! The views of a cell and their pixels.

use super::direction::Direction;
use super::format::Format;
use super::normals;
use crate::base::{Error, Result};

/// A pixel of a view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Texel {
    /// sRGB without light.
    pub color: [u8; 3],
    /// Step of the cell's depth in which the surface lies, from 1 at the front; 0 where there is none.
    pub depth: u16,
    /// Octahedral numbers of the normal towards the viewer, in world axes.
    pub normal: [u16; 2],
}

impl Format {
    /// The unit normal of a pixel; NaN where there is no surface.
    pub fn normal_of(&self, texel: &Texel) -> [f32; 3] {
        if texel.depth == 0 { [f32::NAN; 3] } else { normals::decoded(texel.normal, self.normal_bits).to_array() }
    }
}

/// A view of a cell: pixels by rows from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct View {
    /// As many as the format says.
    pub texels: Vec<Texel>,
}

impl View {
    /// Whether no pixel shows a surface.
    pub fn is_empty(&self) -> bool {
        self.texels.iter().all(|texel| texel.depth == 0)
    }
}

/// The views of one cell, one for each of a tree's directions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Views {
    /// The directions.
    pub directions: Vec<Direction>,
    /// The format of all views.
    pub format: Format,
    pub(super) views: Vec<View>,
}

impl Views {
    /// Views from all pixels in turn; fails for another number of them, and for codes that the format does not have.
    pub fn new(directions: Vec<Direction>, format: Format, texels: Vec<Texel>) -> Result<Self> {
        let pixels = format.pixels();
        if texels.len() != pixels * directions.len() {
            return Err(Error::value("views", format!("{} views of {pixels} pixels", directions.len()), texels.len()));
        }
        let most = 1u32 << format.normal_bits;
        let is_wrong = |texel: &&Texel| {
            u32::from(texel.depth) > format.steps || texel.normal.iter().any(|&number| u32::from(number) >= most)
        };
        if let Some(texel) = texels.iter().find(is_wrong) {
            return Err(Error::value(
                "views",
                "depths and normals with the bits of their format",
                format!("{texel:?}"),
            ));
        }
        let views = texels.chunks_exact(pixels).map(|texels| View { texels: texels.to_vec() }).collect();
        Ok(Self { directions, format, views })
    }

    /// The views, in the order of the directions.
    pub fn views(&self) -> &[View] {
        &self.views
    }
}
