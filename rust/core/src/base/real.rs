//! What kernels read and write.

/// float32 or float64.
pub trait Real: Copy + PartialOrd + Send + Sync + 'static {
    /// The same value.
    fn wide(self) -> f64;
    /// Rounded once.
    fn narrow(value: f64) -> Self;
    /// By how much, as a share, a rounded number may lie beyond the float64 that it was rounded from.
    const SLACK: f64;
}

impl Real for f32 {
    const SLACK: f64 = f32::EPSILON as f64 / 2.0;
    #[inline(always)]
    fn wide(self) -> f64 {
        f64::from(self)
    }
    #[inline(always)]
    fn narrow(value: f64) -> Self {
        value as f32
    }
}

impl Real for f64 {
    const SLACK: f64 = 0.0;
    #[inline(always)]
    fn wide(self) -> f64 {
        self
    }
    #[inline(always)]
    fn narrow(value: f64) -> Self {
        value
    }
}
