//! What kernels read and write.

/// float32 or float64.
pub trait Real: Copy + PartialOrd + Send + Sync + 'static {
    /// The same value.
    fn wide(self) -> f64;
    /// Rounded once.
    fn narrow(value: f64) -> Self;
}

impl Real for f32 {
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
    #[inline(always)]
    fn wide(self) -> f64 {
        self
    }
    #[inline(always)]
    fn narrow(value: f64) -> Self {
        value
    }
}
