//! Similarity of a pair, image reduction, and similarity at several scales. Wang, Simoncelli, Bovik: Multiscale
//! structural similarity for image quality assessment, 2003.

use rayon::prelude::*;

use super::super::extremes::ValueRange;
use super::super::pair::Pair;
use super::super::pixel_rows::PixelRows;
use super::super::plane::{Pixel, Plane, mirror};
use super::global::global;
use super::masked::Masked;
use super::tiles::Windows;
use super::window::{Mask, Selection, Similarity, SimilaritySums, Window};
use crate::base::memory::try_vec;
use crate::base::{Progress, Real, Result, ensure};

/// Returns the sum of the windows' similarities and, if requested, writes a map of them, in rows of the image's width.
/// Images are mirrored at their borders. Without a map, only windows that count are computed.
pub fn similarity<P: PixelRows>(
    pair: &Pair<'_, P>,
    window: &Window,
    constants: Similarity,
    selection: Selection<'_>,
    map: Option<&mut [P::Real]>,
) -> Result<SimilaritySums> {
    let size = [pair.reference.height, pair.reference.width];
    if let Some(mask) = selection.mask {
        pair.reference.expect_size("mask", [mask.plane().height, mask.plane().width])?;
    }
    let map_length = map.as_ref().map_or(size[0] * size[1], |map| map.len());
    ensure!(map_length == size[0] * size[1], "map", format!("{} × {} values", size[0], size[1]), map_length);
    let constants = [constants.c1, constants.c2];
    let sums = match (window, selection.mask) {
        (Window::Global, _) => global(pair, constants, selection, map),
        (Window::Weights(weights), Some(Mask::Windows(mask))) => {
            let Selection { contrast, progress, .. } = selection;
            Masked { pair: *pair, weights, constants, mask, contrast, progress }.sums(map)
        }
        (Window::Weights(weights), _) => Windows::new(*pair, weights, constants, selection).sums(map),
    };
    selection.progress.check().map(|()| sums)
}

/// A pair of images reduced in size.
pub struct Shrunk<R> {
    images: [Vec<R>; 2],
    size: [usize; 2],
}

impl<R: Pixel> Shrunk<R> {
    /// Reduces both images: an output pixel is the mean of the `factor` × `factor` pixels around every `factor`-th
    /// pixel. Images are mirrored at their borders.
    pub fn new<P: PixelRows<Real = R>>(pair: &Pair<'_, P>, factor: usize, progress: &Progress) -> Result<Self> {
        let size = [pair.reference.height, pair.reference.width].map(|length| length.div_ceil(factor));
        let images = [shrink(&pair.reference, factor, progress)?, shrink(&pair.test, factor, progress)?];
        Ok(Self { images, size })
    }

    pub fn pair(&self) -> Result<Pair<'_, R>>
    where
        R: PixelRows,
    {
        let [reference, test] =
            [&self.images[0], &self.images[1]].map(|image| Plane::new(image, self.size, [self.size[1], 1]));
        Pair::new(reference?, test?)
    }
}

fn shrink<P: Pixel>(image: &Plane<'_, P>, factor: usize, progress: &Progress) -> Result<Vec<P::Real>> {
    let reach = (factor - 1) / 2;
    let [height, width] = [image.height, image.width].map(|length| length.div_ceil(factor));
    let mirrored = |n: usize, length: usize| mirror(n as i64 - reach as i64, length);
    // Boxes that do not cross a border; the first begins at `reach`.
    let unmirrored = usize::from(reach > 0)..((image.width + reach) / factor).max(usize::from(reach > 0));
    let weight = 1.0 / (factor * factor) as f64;
    let mut means = try_vec(P::Real::default(), height * width)?;
    means.par_chunks_mut(width).enumerate().try_for_each(|(row, means)| {
        let mut sums = vec![0.0; width];
        for row in (row * factor..(row + 1) * factor).map(|row| mirrored(row, image.height)) {
            let run = image.run(row, 0..image.width);
            for (n, sum) in sums.iter_mut().enumerate() {
                match run {
                    Some(run) if unmirrored.contains(&n) => {
                        for value in &run[n * factor - reach..][..factor] {
                            *sum += value.real().wide();
                        }
                    }
                    _ => {
                        for k in 0..factor {
                            *sum += image.value(row, mirrored(n * factor + k, image.width)).wide();
                        }
                    }
                }
            }
        }
        for (mean, sum) in means.iter_mut().zip(sums) {
            *mean = P::Real::narrow(sum * weight);
        }
        progress.check()
    })?;
    Ok(means)
}

/// Means of similarity and contrast factor at each scale.
#[derive(Clone, Debug)]
pub struct Scales {
    /// Means, the finest scale first.
    pub means: Vec<[f64; 2]>,
    /// Range of both images' values at the finest scale, if requested.
    pub range: ValueRange,
}

/// Compares at `scales` scales, each half as large as the previous one.
pub fn multiscale<P>(
    pair: &Pair<'_, P>,
    window: &Window,
    constants: Similarity,
    scales: usize,
    range: bool,
    progress: &Progress,
) -> Result<Scales>
where
    P: PixelRows<Real: PixelRows<Real = P::Real>>,
{
    let finest = compare_whole_windows(pair, window, constants, range, progress)?;
    let mut means = vec![finest.means()];
    let mut smaller: Option<Shrunk<P::Real>> = None;
    for _ in 1..scales {
        let next = match &smaller {
            Some(shrunk) => Shrunk::new(&shrunk.pair()?, 2, progress)?,
            None => Shrunk::new(pair, 2, progress)?,
        };
        means.push(compare_whole_windows(&next.pair()?, window, constants, false, progress)?.means());
        smaller = Some(next);
    }
    Ok(Scales { means, range: finest.range })
}

/// Compares a pair at one scale by the windows inside the images.
fn compare_whole_windows<P: PixelRows>(
    pair: &Pair<'_, P>,
    window: &Window,
    constants: Similarity,
    range: bool,
    progress: &Progress,
) -> Result<SimilaritySums> {
    if let Window::Weights(weights) = window {
        let (size, min_size) = ([pair.reference.height, pair.reference.width], weights.len());
        let expected = format!("windows of {min_size} pixels within the picture at every scale");
        let got = format!("{} × {} at one of them", size[0], size[1]);
        ensure!(size[0].min(size[1]) >= min_size, "reference", expected, got);
    }
    let selection = Selection { includes_border: false, mask: None, contrast: true, range, progress };
    similarity(pair, window, constants, selection, None)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_begin_at_the_pixel_or_before_it() {
        let values: Vec<f64> = (0..15).map(f64::from).collect();
        let plane = Plane::new(&values, [3, 5], [5, 1]).unwrap();
        // Factor 2: pixels 0–1, 2–3, 4 and its mirror image; rows 0–1, 2 and its mirror image.
        assert_eq!(shrink(&plane, 2, &Progress::new()).unwrap(), [3.0, 5.0, 6.5, 10.5, 12.5, 14.0]);
        // Factor 3: boxes begin one pixel earlier.
        let first = [0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 5.0, 5.0, 6.0].iter().sum::<f64>() / 9.0;
        let found = shrink(&plane, 3, &Progress::new()).unwrap();
        assert!((found[0] - first).abs() < 1e-15 && found.len() == 2);
        // The second box, about pixel 3.
        let second = [2.0, 3.0, 4.0, 2.0, 3.0, 4.0, 7.0, 8.0, 9.0].iter().sum::<f64>() / 9.0;
        assert!((found[1] - second).abs() < 1e-15);
    }
}
