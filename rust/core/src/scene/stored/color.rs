//! Vertex colours of stored meshes: linear fractions in files, sRGB with linear alpha in scenes.

use rayon::prelude::*;

use super::fitness::{ROWS_PER_PIECE, map_pieces};
use super::meshes::{StoredMesh, StoredMeshes, VertexSet};
use super::rows::{ComponentType, Table};
use crate::scene::srgb::{srgb_from_linear, srgb_from_u16};

impl StoredMeshes {
    /// Returns, for each face set given to `new`, whether its vertex colours have alpha below 1.
    pub fn see_through(&self) -> Vec<bool> {
        let flags_of_mesh = |mesh: &StoredMesh| {
            let set_flags: Vec<bool> = mesh.vertices.iter().map(|set| self.is_see_through(set)).collect();
            mesh.faces.iter().map(|faces| set_flags[faces.set]).collect::<Vec<_>>()
        };
        self.meshes.par_iter().flat_map_iter(flags_of_mesh).collect()
    }

    fn is_see_through(&self, set: &VertexSet) -> bool {
        let Some(rows) = set.attributes.colors.filter(|&rows| self.rows[rows].width == 4) else { return false };
        let table = self.table(rows).column(3);
        let is_piece_see_through = |first: usize, slots: &mut [[f32; 1]]| {
            table.fractions(set.first + first, slots);
            slots.iter().any(|&[opacity]| alpha(opacity) != u8::MAX)
        };
        map_pieces(set.count, is_piece_see_through).any(|is_see_through| is_see_through)
    }
}

/// Converts alpha from 0 … 1 to the nearest byte.
fn alpha(value: f32) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0).round_ties_even() as u8
}

impl Table<'_> {
    /// Writes linear colours as sRGB with linear alpha; rows of three components are opaque.
    pub(super) fn colors(&self, first: usize, slots: &mut [[u8; 4]]) {
        if let (ComponentType::U16, 4) = (self.rows.component, self.rows.width) {
            let codes = srgb_from_u16();
            self.shorts(first, slots, |[red, green, blue, opacity]| {
                let [red, green, blue] = [red, green, blue].map(|light| codes[usize::from(light)]);
                // 65535 is 255 · 257.
                [red, green, blue, ((u32::from(opacity) + 128) / 257) as u8]
            });
            return;
        }
        let mut light = [[0.0; 4]; ROWS_PER_PIECE];
        for (piece, slots) in slots.chunks_mut(ROWS_PER_PIECE).enumerate() {
            let light = &mut light[..slots.len()];
            self.linear_colors(first + piece * ROWS_PER_PIECE, light);
            for (slot, [red, green, blue, opacity]) in slots.iter_mut().zip(&*light) {
                *slot = [srgb_from_linear(*red), srgb_from_linear(*green), srgb_from_linear(*blue), alpha(*opacity)];
            }
        }
    }

    /// Writes linear RGB with alpha, 1 for rows of three components.
    fn linear_colors(&self, first: usize, slots: &mut [[f32; 4]]) {
        if self.rows.width == 4 {
            return self.fractions(first, slots);
        }
        let mut opaque = [[0.0; 3]; ROWS_PER_PIECE];
        let opaque = &mut opaque[..slots.len()];
        self.fractions(first, opaque);
        for (slot, &[red, green, blue]) in slots.iter_mut().zip(&*opaque) {
            *slot = [red, green, blue, 1.0];
        }
    }
}
