//! Prevention of popping by reprojection of pictures to the camera of another moment.
//!
//! `Past::blend` fades a picture into the previous one, surface by surface; `blur` averages a picture over poses.

mod blur;
mod past;

pub use blur::blur;
pub use past::{Color, Fade, Image, Past};
