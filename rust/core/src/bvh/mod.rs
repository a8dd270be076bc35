//! Trees of boxes: one over a mesh's triangles, one over a scene's instances. Built by obvhs, walked by `trace`.

use std::time::Duration;

use obvhs::bvh2::Bvh2;
use obvhs::{BvhBuildParams, aabb, bvh2::builder::build_bvh2};

use crate::base::{Progress, Result};
use crate::scene::Aabb;

/// A tree over the triangles of one mesh.
pub struct Bvh {
    pub(crate) tree: Option<Bvh2>,
}

/// A tree over the boxes of instances.
pub struct Tlas {
    pub(crate) tree: Option<Bvh2>,
}

impl Bvh {
    /// Builds over finite triangles.
    pub fn build(positions: &[[f32; 3]], faces: &[[u32; 3]], progress: &Progress) -> Result<Self> {
        progress.expect(faces.len() as u64);
        let boxes: Vec<Aabb> = faces
            .iter()
            .map(|face| {
                let mut bounds = Aabb::EMPTY;
                face.iter().for_each(|&v| bounds.extend(positions[v as usize].into()));
                bounds
            })
            .collect();
        progress.report(faces.len() as u64)?;
        Ok(Self { tree: build(&boxes) })
    }
}

impl Tlas {
    /// Builds over boxes.
    pub fn build(boxes: &[Aabb]) -> Self {
        Self { tree: build(boxes) }
    }
}

fn build(boxes: &[Aabb]) -> Option<Bvh2> {
    let boxes: Vec<aabb::Aabb> = boxes.iter().map(|b| aabb::Aabb::new(b.min.into(), b.max.into())).collect();
    (!boxes.is_empty()).then(|| build_bvh2(&boxes, BvhBuildParams::medium_build(), &mut Duration::default()))
}

impl std::fmt::Debug for Bvh {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Bvh")
    }
}

impl std::fmt::Debug for Tlas {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Tlas")
    }
}
