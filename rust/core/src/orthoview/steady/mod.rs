//! Prevention of popping by reprojection of pictures to the camera of another moment.
//!
//! `Past::blend` mixes the previous picture into the new one where both show the same surface; `blur` averages a
//! picture over poses.

mod blur;
mod past;

pub use blur::blur;
pub use past::{Color, Fade, Image, Past};
