//! The images of one view, as many channels as were asked for.

/// Which images of a view are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Channels {
    /// Linear RGB.
    pub color: bool,
    /// Displayed distance |Q−U| in metres, infinite where nothing was hit.
    pub range: bool,
    /// Object, −1 where nothing was hit.
    pub object_id: bool,
    /// Triangle number in the scene, −1 where nothing was hit.
    pub face_id: bool,
    /// Unmorphed surface point relative to the scene's origin, NaN where nothing was hit.
    pub position: bool,
    /// Unit geometric normal towards the viewer, NaN where nothing was hit.
    pub normal: bool,
}

impl Channels {
    /// True where a channel other than colour is wanted: one ray through each pixel's centre.
    pub fn any_surface(&self) -> bool {
        self.range || self.object_id || self.face_id || self.position || self.normal
    }
}

/// Images in row-major order; those that were not asked for are empty.
#[derive(Debug, Default)]
pub struct Frame {
    /// Linear RGB.
    pub color: Vec<[f32; 3]>,
    /// Metres.
    pub range: Vec<f32>,
    /// Object numbers.
    pub object_id: Vec<i32>,
    /// Triangle numbers.
    pub face_id: Vec<i64>,
    /// Unmorphed points.
    pub position: Vec<[f32; 3]>,
    /// Unit normals.
    pub normal: Vec<[f32; 3]>,
}

impl Frame {
    /// Allocates the wanted images for a number of pixels, as if nothing was hit and all is black.
    pub fn new(channels: Channels, pixels: usize) -> Self {
        let size = |wanted: bool| if wanted { pixels } else { 0 };
        Self {
            color: vec![[0.0; 3]; size(channels.color)],
            range: vec![f32::INFINITY; size(channels.range)],
            object_id: vec![-1; size(channels.object_id)],
            face_id: vec![-1; size(channels.face_id)],
            position: vec![[f32::NAN; 3]; size(channels.position)],
            normal: vec![[f32::NAN; 3]; size(channels.normal)],
        }
    }
}
