//! Parts of a view: in a box, as a substitute for a smaller cell whose own views are missing, and beyond a cylinder.

use glam::DVec3;

use super::splats::{BLOCK, Block, BoxOfBlocks, Extent, Splats};

impl Splats {
    /// Returns the splats with centres in a half-open box, so that adjacent boxes share no splats.
    pub fn clip_to_box(&self, low: DVec3, high: DVec3) -> Self {
        self.part(|middle| middle.cmpge(low).all() && middle.cmplt(high).all())
    }

    /// Returns the splats with centres at least at a distance from the vertical axis through a point.
    pub fn clip_outside_cylinder(&self, center: DVec3, radius: f64) -> Self {
        self.part(|middle| (middle - center).with_y(0.0).length() >= radius)
    }

    /// Returns the splats whose centres are accepted.
    fn part(&self, accepts: impl Fn(DVec3) -> bool) -> Self {
        let mut part = Self { boxes: vec![], blocks: vec![], texels: vec![], ..*self };
        for source in &self.boxes {
            let (first, texel) = (part.blocks.len(), part.texels.len());
            let mut extent = Extent::NOTHING;
            for block in &self.blocks[source.blocks[0] as usize..source.blocks[1] as usize] {
                if let Some(block) = part.take(self, block, &accepts) {
                    extent.add(&block.extent);
                    part.blocks.push(block);
                }
            }
            if first < part.blocks.len() {
                let blocks = [first as u32, part.blocks.len() as u32];
                part.boxes.push(BoxOfBlocks { extent, blocks, count: (part.texels.len() - texel) as u32 });
            }
        }
        part
    }

    /// Adds the accepted splats of a block of a view.
    fn take(&mut self, whole: &Self, block: &Block, accepts: &impl Fn(DVec3) -> bool) -> Option<Block> {
        let mut part = Block {
            extent: Extent::NOTHING,
            first: self.texels.len() as u32,
            shown: 0,
            surfels: 0,
            inner: 0,
            ..*block
        };
        let mut number = block.first as usize;
        for place in 0..BLOCK * BLOCK {
            let bit = 1u64 << place;
            if block.shown & bit == 0 {
                continue;
            }
            let texel = whole.texels[number];
            number += 1;
            let [x, y] = [block.corner[0] + (place % BLOCK) as u16, block.corner[1] + (place / BLOCK) as u16];
            let depth = texel.depth();
            let middle = whole.place(f64::from(x) + 0.5, f64::from(y) + 0.5, f64::from(depth) - 0.5);
            if !accepts(middle) {
                continue;
            }
            part.shown |= bit;
            part.surfels |= block.surfels & bit;
            part.inner |= block.inner & bit;
            part.extent.add(&Extent { low: [x, y, depth - 1], high: [x + 1, y + 1, depth] });
            self.texels.push(texel);
        }
        (part.shown != 0).then_some(part)
    }
}
