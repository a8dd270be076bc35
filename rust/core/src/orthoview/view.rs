//! Views of a cell, their pixels and their format.

use std::sync::Arc;

use super::direction::Direction;
use super::normals;
use crate::base::memory::room_for_values;
use crate::base::{Error, Result, ensure};

/// Format of views: size, depth steps and normal bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Format {
    /// Width and height of a view, pixels; a multiple of 4.
    pub size: usize,
    /// Number of steps that a cell's depth is divided into.
    pub steps: u32,
    /// Bits of each of a normal's two components.
    pub normal_bits: u32,
}

/// Maximum size of a view, pixels.
const MAX_SIZE: usize = 4096;

impl Format {
    /// Creates a format. The number of steps is the largest multiple of 6 that `depth_bits` bits can code: then
    /// children lie on whole steps of their parents' ranges.
    pub fn new(size: usize, depth_bits: u32, normal_bits: u32) -> Result<Self> {
        let is_valid = size.is_multiple_of(4) && (1..=MAX_SIZE).contains(&size);
        ensure!(is_valid, "size", format!("a multiple of 4, at most {MAX_SIZE}"), size);
        ensure!((8..=16).contains(&depth_bits), "depth_bits", "8 to 16", depth_bits);
        ensure!(matches!(normal_bits, 16 | 24), "normal_bits", "16 or 24", normal_bits);
        let max_code = (1 << depth_bits) - 1;
        Ok(Self { size, steps: max_code / 6 * 6, normal_bits: normal_bits / 2 })
    }

    /// Returns the number of a view's pixels.
    pub fn pixels(&self) -> usize {
        self.size * self.size
    }

    /// Returns the unit normal of a pixel; NaN without a surface.
    pub fn normal_of(&self, texel: &Texel) -> [f32; 3] {
        if texel.depth == 0 { [f32::NAN; 3] } else { normals::decode(texel.normal, self.normal_bits).to_array() }
    }
}

/// A pixel of a view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Texel {
    /// Unlit colour, sRGB.
    pub color: [u8; 3],
    /// Step of the cell's depth that contains the surface, from 1 at the front; 0 for no surface.
    pub depth: u16,
    /// Octahedral code of the normal towards the viewer, in world axes.
    pub normal: [u16; 2],
}

/// A view of a cell: as many pixels as the format requires, row by row from the top.
pub type View = Vec<Texel>;

/// Views of one cell, one for each of a tree's directions. Copies share the pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Views {
    /// The directions.
    pub directions: Vec<Direction>,
    /// The format of all views.
    pub format: Format,
    views: Arc<[View]>,
    /// Second-layer view of each direction; `None` if all are empty.
    behind: Option<Arc<[View]>>,
}

impl Views {
    /// Creates views from drawn layers.
    pub(super) fn from_layers(directions: &[Direction], format: Format, views: (Vec<View>, Option<Vec<View>>)) -> Self {
        let behind = views.1.and_then(|views| non_empty(views.into()));
        Self { directions: directions.to_vec(), format, views: views.0.into(), behind }
    }

    /// Creates views from the pixels of all views in order; fails for a wrong number of pixels or codes outside the
    /// format.
    pub fn new(directions: Vec<Direction>, format: Format, texels: Vec<Texel>) -> Result<Self> {
        let pixels = format.pixels();
        let is_complete = texels.len() == pixels * directions.len();
        ensure!(is_complete, "views", format!("{} views of {pixels} pixels", directions.len()), texels.len());
        let normal_codes = 1u32 << format.normal_bits;
        let is_wrong = |texel: &&Texel| {
            u32::from(texel.depth) > format.steps || texel.normal.iter().any(|&code| u32::from(code) >= normal_codes)
        };
        if let Some(texel) = texels.iter().find(is_wrong) {
            let expected = "depths and normals with the bits of their format";
            return Err(Error::value("views", expected, format!("depth {}, normal {:?}", texel.depth, texel.normal)));
        }
        room_for_values::<Texel>(texels.len())?;
        let views = texels.chunks_exact(pixels).map(<[Texel]>::to_vec).collect();
        Ok(Self { directions, format, views, behind: None })
    }

    /// Returns the views, in the order of the directions.
    pub fn views(&self) -> &[View] {
        &self.views
    }

    /// Returns the views of one direction, by its number: first layer, then second layer if there is one.
    pub(super) fn layers(&self, number: usize) -> impl Iterator<Item = &View> {
        [Some(&self.views), self.behind.as_ref()].into_iter().flatten().map(move |views| &views[number])
    }

    /// Returns the second layer: views of the nearest surfaces more than a gap behind the first. `None` if it is empty.
    pub fn second_layer(&self) -> Option<Self> {
        let views = self.behind.clone()?;
        Some(Self { directions: self.directions.clone(), format: self.format, views, behind: None })
    }

    /// Returns the views with another second layer, which must have the same directions and format.
    pub fn with_behind(&self, behind: &Self) -> Result<Self> {
        let is_alike = (&behind.directions, behind.format) == (&self.directions, self.format);
        ensure!(is_alike, "behind", "the directions and the format of the first layer", "different ones");
        Ok(Self { behind: non_empty(behind.views.clone()), ..self.clone() })
    }

    /// Returns the views without the second layers of the directions for which `keep` is false.
    pub fn keep_behind(&self, keep: &[bool]) -> Result<Self> {
        let count = self.directions.len();
        ensure!(keep.len() == count, "keep", format!("{count} values"), keep.len());
        room_for_values::<Texel>((count + 1) * self.format.pixels())?;
        let empty = vec![Texel::default(); self.format.pixels()];
        let choose = |(view, keep): (&View, &bool)| if *keep { view.clone() } else { empty.clone() };
        let behind = self.behind.as_ref().and_then(|views| non_empty(views.iter().zip(keep).map(choose).collect()));
        Ok(Self { behind, ..self.clone() })
    }
}

/// Returns a second layer; `None` if no pixel shows a surface.
fn non_empty(views: Arc<[View]>) -> Option<Arc<[View]>> {
    views.iter().flatten().any(|texel| texel.depth > 0).then_some(views)
}
