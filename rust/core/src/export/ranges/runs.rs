//! Line fits through the texels of a row or a column that lie on one plane.

/// Number of texels that a fit remembers.
const MEMORY: u32 = 128;

/// Least-squares line through the values of consecutive texels.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Run {
    value: f64,
    slope: f64,
    /// Number of texels on the line; 0 for none.
    pub count: u32,
}

impl Run {
    /// Extrapolates the line to the next texel.
    pub fn next(&self) -> f64 {
        self.value + self.slope
    }

    /// Adds the next texel; starts a new line if it does not fit.
    ///
    /// Least squares over n texels move the line by (4n − 2)/(n(n + 1)) of the error, and its slope by 6/(n(n + 1)).
    pub fn add(&mut self, value: f64, fits: bool) {
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
