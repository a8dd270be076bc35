//! Windows: parts of an image drawn one after the other.

use nearfar_core::camera::{Camera, Fov};

/// A part of an image drawn at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Window {
    pub column: u32,
    pub row: u32,
    pub width: u32,
    pub height: u32,
}

impl Window {
    pub fn pixels(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// Returns the bounds of the view that it covers, with a margin of one pixel for samples beside the centres.
    pub fn part_of(&self, camera: &Camera, fov: &Fov) -> Fov {
        let (across, down) = (fov.right - fov.left, fov.up - fov.down);
        let column = |pixel: f64| fov.left + across * pixel / f64::from(camera.width);
        let row = |pixel: f64| fov.up - down * pixel / f64::from(camera.height);
        Fov {
            left: column(f64::from(self.column) - 1.0),
            right: column(f64::from(self.column + self.width) + 1.0),
            down: row(f64::from(self.row + self.height) + 1.0),
            up: row(f64::from(self.row) - 1.0),
        }
    }

    /// Splits an image into windows with limited pixels and side length.
    pub fn split(width: u32, height: u32, pixels: u64, side: u32) -> Vec<Self> {
        let across = side.min(width).min(pixels.min(u64::from(u32::MAX)) as u32).max(1);
        let down = ((pixels / u64::from(across)).min(u64::from(side)) as u32).clamp(1, height);
        let mut windows = Vec::new();
        for row in (0..height).step_by(down as usize) {
            for column in (0..width).step_by(across as usize) {
                windows.push(Self { column, row, width: across.min(width - column), height: down.min(height - row) });
            }
        }
        windows
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_cover_every_pixel_once() {
        for (width, height, pixels, side) in [(7, 5, 1, 9), (100, 3, 250, 64), (64, 64, 1 << 20, 64), (1, 900, 100, 50)]
        {
            let windows = Window::split(width, height, pixels, side);
            let mut seen = vec![0; (width * height) as usize];
            for window in windows {
                assert!(window.pixels() as u64 <= pixels && window.width <= side && window.height <= side);
                for row in window.row..window.row + window.height {
                    for column in window.column..window.column + window.width {
                        seen[(row * width + column) as usize] += 1;
                    }
                }
            }
            assert!(seen.iter().all(|&count| count == 1));
        }
    }
}
