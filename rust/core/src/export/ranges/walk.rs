//! Visits the texels of a map and predicts each from texels visited before.

use super::planes::{Flag, Link, Trust, damage_error};
use super::scale::{Faces, NOTHING, Scale};
use crate::base::{Progress, Result};

/// A run of more texels is fitted as if it had this many, so that it follows slow changes.
const MEMORY: u32 = 128;
/// Minimum number of texels in a run that predicts the next texel.
const MIN_RUN: u32 = 3;
/// Longer runs are trusted; two runs that agree are trusted if their sum exceeds twice this number of texels.
const TRUSTED_RUN: u32 = 8;
/// Maximum code difference between a texel and the prediction of its run.
const MAX_DIFFERENCE: u16 = 1;
/// Maximum code difference between the first two texels of a run.
const MAX_FIRST_DIFFERENCE: u16 = 64;
/// Maximum code difference between the left and the upper neighbour for `Trust::Calm`.
const MAX_CALM_DIFFERENCE: u16 = 8;

/// Least-squares line through the values of consecutive texels of a row or column that lie on one plane in space.
#[derive(Clone, Copy, Debug, Default)]
struct Run {
    /// Value of the line at the last texel.
    value: f64,
    slope: f64,
    /// Number of texels in the run.
    count: u32,
}

impl Run {
    /// Extrapolates the line to the next texel.
    fn next(&self) -> f64 {
        self.value + self.slope
    }

    /// Adds the next texel; starts a new line if it does not fit.
    ///
    /// The n-th texel moves the end of the least-squares line by (4n − 2)/(n(n + 1)) times the line's error there, and
    /// its slope by 6/(n(n + 1)) times the error.
    fn add(&mut self, value: f64, fits: bool) {
        if !fits || self.count == 0 {
            *self = Self { value, slope: 0.0, count: 1 };
            return;
        }
        let error = value - self.next();
        self.count = (self.count + 1).min(MEMORY);
        let n = f64::from(self.count);
        let scale = 1.0 / (n * (n + 1.0));
        self.value = self.next() + (4.0 * n - 2.0) * scale * error;
        self.slope += 6.0 * scale * error;
    }
}

/// State of the walk between texels.
pub(super) struct Walk<'a> {
    faces: Faces<'a>,
    scale: Scale,
    columns: Vec<Run>,
    /// Code of the last visited texel with a surface.
    last: u16,
}

/// The face that is visited.
struct Face<'a, L> {
    codes: &'a mut [u16],
    before: Option<&'a [u16]>,
    changed: &'a mut [bool],
    link: &'a mut L,
}

impl<'a> Walk<'a> {
    pub fn new(faces: Faces<'a>) -> Self {
        Self { faces, scale: Scale::new(faces.step), columns: vec![Run::default(); faces.size], last: 0 }
    }

    /// Visits the texels of a face: those in listed tiles, or all if there are no previous codes.
    pub fn face(
        &mut self,
        number: usize,
        codes: &mut [u16],
        before: Option<&[u16]>,
        changed: &mut [bool],
        link: &mut impl Link,
        progress: &Progress,
    ) -> Result<()> {
        let Faces { size, tile, .. } = self.faces;
        let tiles_per_row = size / tile;
        self.last = 0;
        let mut face = Face { codes, before, changed, link };
        for band in 0..tiles_per_row {
            let tiles =
                (number * tiles_per_row + band) * tiles_per_row..(number * tiles_per_row + band + 1) * tiles_per_row;
            let listed: Vec<bool> = tiles.map(|tile| self.faces.lists(tile)).collect();
            let visited: Vec<bool> = listed.iter().map(|&is_listed| is_listed || before.is_none()).collect();
            for (run, column) in self.columns.iter_mut().zip(0..) {
                if band == 0 || !visited[column / tile] {
                    *run = Run::default();
                }
            }
            for y in band * tile..(band + 1) * tile {
                progress.check()?;
                self.row(y, &visited, &listed, &mut face)?;
            }
        }
        Ok(())
    }

    fn row(&mut self, y: usize, visited: &[bool], listed: &[bool], face: &mut Face<'_, impl Link>) -> Result<()> {
        let Faces { size, tile, .. } = self.faces;
        let centre = |texel: usize| (2 * texel + 1) as f64 / size as f64 - 1.0;
        let v = centre(y);
        let mut run = Run::default();
        for x in 0..size {
            if !visited[x / tile] {
                run = Run::default();
                continue;
            }
            let texel = Texel::new(x, y, size);
            if listed[x / tile] {
                let is_changed = face.changed[texel.index];
                face.changed[texel.index] = face.link.flag(Flag::Changed, texel.predict_change(face), is_changed)?;
            }
            let u = centre(x);
            self.visit(&texel, (1.0 + u * u + v * v).sqrt(), &mut run, face)?;
        }
        Ok(())
    }

    /// Writes or reads a texel that changes or has no previous code, and adds it to the runs of its row and column.
    fn visit(&mut self, texel: &Texel, distance: f64, row: &mut Run, face: &mut Face<'_, impl Link>) -> Result<()> {
        let (index, column) = (texel.index, &mut self.columns[texel.x]);
        let is_new = face.before.is_none() || face.changed[index];
        let mut is_nothing = face.codes[index] == NOTHING;
        if is_new {
            is_nothing = face.link.flag(Flag::Nothing, texel.predict_nothing(face.codes), is_nothing)?;
        }
        if is_nothing {
            face.codes[index] = NOTHING;
            (*row, *column) = (Run::default(), Run::default());
            return Ok(());
        }
        let neighbour = texel.predict_code(face.codes, self.last);
        let run_code = |run: &Run| (run.count > 0).then(|| self.scale.code(run.next(), distance, neighbour));
        let (by_row, by_column) = (run_code(row), run_code(column));
        if is_new {
            let run_codes = (by_row.filter(|_| row.count >= MIN_RUN), by_column.filter(|_| column.count >= MIN_RUN));
            let (guess, trust) = match run_codes {
                (Some(a), Some(b)) if a.abs_diff(b) <= MAX_DIFFERENCE => {
                    let (n, m) = (f64::from(row.count), f64::from(column.count));
                    let mean = (row.next() * n + column.next() * m) / (n + m);
                    let trust = if row.count + column.count > 2 * TRUSTED_RUN { Trust::High } else { Trust::Some };
                    (self.scale.code(mean, distance, a), trust)
                }
                (Some(a), Some(b)) => (if a.abs_diff(neighbour) <= b.abs_diff(neighbour) { a } else { b }, Trust::Some),
                (Some(code), None) if code.abs_diff(neighbour) <= MAX_DIFFERENCE => (code, trust_in(row)),
                (None, Some(code)) if code.abs_diff(neighbour) <= MAX_DIFFERENCE => (code, trust_in(column)),
                _ => (neighbour, texel.trust(face.codes)),
            };
            let residual = face.link.residual(trust, fold(face.codes[index].wrapping_sub(guess)))?;
            face.codes[index] = guess.wrapping_add(unfold(residual));
            if face.codes[index] == NOTHING {
                return Err(damage_error("a surface without range"));
            }
        }
        let code = face.codes[index];
        let nearness = self.scale.nearness(code, distance);
        for (run, guess) in [(row, by_row), (column, by_column)] {
            let max_difference = if run.count < 2 { MAX_FIRST_DIFFERENCE } else { MAX_DIFFERENCE };
            run.add(nearness, guess.is_some_and(|guess| guess.abs_diff(code) <= max_difference));
        }
        self.last = code;
        Ok(())
    }
}

fn trust_in(run: &Run) -> Trust {
    if run.count > TRUSTED_RUN { Trust::High } else { Trust::Some }
}

/// A texel and those of its neighbours that are visited before it.
struct Texel {
    x: usize,
    index: usize,
    left: Option<usize>,
    above: Option<usize>,
    /// Above left.
    corner: Option<usize>,
    /// Above right.
    right: Option<usize>,
}

impl Texel {
    fn new(x: usize, y: usize, size: usize) -> Self {
        let index = y * size + x;
        Self {
            x,
            index,
            left: (x > 0).then(|| index - 1),
            above: (y > 0).then(|| index - size),
            corner: (x > 0 && y > 0).then(|| index - size - 1),
            right: (x + 1 < size && y > 0).then(|| index - size + 1),
        }
    }

    /// Predicts that the texel changes if the neighbour with the most similar previous range does.
    fn predict_change(&self, face: &Face<'_, impl Link>) -> bool {
        let changes = |texel: usize| face.changed[texel];
        let (Some(left), Some(above)) = (self.left, self.above) else {
            return self.left.or(self.above).is_some_and(changes);
        };
        match face.before {
            Some(before) => {
                let difference = |texel: usize| before[texel].abs_diff(before[self.index]);
                changes(if difference(left) <= difference(above) { left } else { above })
            }
            None => median(changes(left), changes(above), self.corner.is_some_and(changes)),
        }
    }

    fn predict_nothing(&self, codes: &[u16]) -> bool {
        let is_nothing = |texel: Option<usize>| texel.is_none_or(|texel| codes[texel] == NOTHING);
        median(is_nothing(self.left), is_nothing(self.above), is_nothing(self.corner))
    }

    /// Returns the trust in `predict_code`.
    fn trust(&self, codes: &[u16]) -> Trust {
        match (surface_code(codes, self.left), surface_code(codes, self.above)) {
            (Some(left), Some(above)) if left.abs_diff(above) <= MAX_CALM_DIFFERENCE => Trust::Calm,
            _ => Trust::Low,
        }
    }

    /// Returns the median of left, above and left + above − corner. If one of them has no surface, returns the first
    /// neighbour that has one, else `last`.
    fn predict_code(&self, codes: &[u16], last: u16) -> u16 {
        let code = |texel| surface_code(codes, texel);
        let (left, above, corner) = (code(self.left), code(self.above), code(self.corner));
        let (Some(left), Some(above), Some(corner)) = (left, above, corner) else {
            return left.or(above).or(corner).or(code(self.right)).unwrap_or(last);
        };
        let (low, high) = (left.min(above), left.max(above));
        let plane = i32::from(left) + i32::from(above) - i32::from(corner);
        plane.clamp(low.into(), high.into()) as u16
    }
}

/// Returns the code of a texel; `None` outside the face and without a surface.
fn surface_code(codes: &[u16], texel: Option<usize>) -> Option<u16> {
    texel.map(|texel| codes[texel]).filter(|&code| code != NOTHING)
}

/// Returns the median of left, above and left + above − corner, for flags as 0 and 1.
fn median(left: bool, above: bool, corner: bool) -> bool {
    if corner { left && above } else { left || above }
}

/// Maps 0, −1, 1, −2, … to 0, 1, 2, 3, ….
fn fold(difference: u16) -> u16 {
    (difference << 1) ^ ((difference as i16 >> 15) as u16)
}

fn unfold(folded: u16) -> u16 {
    (folded >> 1) ^ (folded & 1).wrapping_neg()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_is_the_line_of_least_squares() {
        let values = [3.0, 4.5, 4.0, 7.0, 9.5, 8.0];
        let mut run = Run::default();
        for (place, &value) in values.iter().enumerate() {
            run.add(value, true);
            let n = place as f64 + 1.0;
            let (mean_x, mean_y) = ((n - 1.0) / 2.0, values[..=place].iter().sum::<f64>() / n);
            let pairs = || values[..=place].iter().enumerate().map(|(x, y)| (x as f64 - mean_x, y - mean_y));
            let spread = pairs().map(|(x, _)| x * x).sum::<f64>();
            let slope = if spread > 0.0 { pairs().map(|(x, y)| x * y).sum::<f64>() / spread } else { 0.0 };
            assert!((run.next() - (mean_y + slope * (n - mean_x))).abs() < 1e-12, "{place}");
        }
        run.add(1.0, false);
        assert_eq!((run.next(), run.count), (1.0, 1));
    }
}
