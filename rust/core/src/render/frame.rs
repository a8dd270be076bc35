//! Images of one view; only requested channels are computed.

use crate::base::Result;
use crate::base::memory::{room_for, try_append, try_vec, try_with_capacity};

/// Declares a frame's images: first those of all samples of a pixel, then those of the ray through its centre, with
/// their values for a ray without a hit.
macro_rules! images {
    (
        samples { $($(#[doc = $about:literal])+ $sampled:ident: $color:ty,)+ }
        center { $($(#[doc = $what:literal])+ $central:ident: $value:ty = $miss:expr,)+ }
    ) => {
        /// Images to compute for a view.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct Channels {
            $($(#[doc = $about])+ pub $sampled: bool,)+
            $($(#[doc = $what])+ pub $central: bool,)+
        }

        impl Channels {
            /// Returns whether an image of all samples is requested.
            pub fn any_sampled(&self) -> bool {
                false $(|| self.$sampled)+
            }

            /// Returns whether an image is requested that needs one ray through each pixel's centre.
            pub fn any_surface(&self) -> bool {
                false $(|| self.$central)+
            }

            /// Returns whether an image is requested that needs the surface point, not only the ray's hit.
            pub fn needs_surface(&self) -> bool {
                self.position || self.normal || self.albedo || self.shading_normal
            }

            /// Requests an image by name; false for an unknown name.
            pub fn add(&mut self, name: &str) -> bool {
                match name {
                    $(stringify!($sampled) => self.$sampled = true,)+
                    $(stringify!($central) => self.$central = true,)+
                    _ => return false,
                }
                true
            }

            /// Fails if the requested images do not fit into memory.
            pub fn check_room(&self, pixels: u64) -> Result<()> {
                let size = |is_requested: bool, bytes: usize| if is_requested { bytes as u64 } else { 0 };
                let bytes = 0
                    $(+ size(self.$sampled, size_of::<$color>()))+
                    $(+ size(self.$central, size_of::<$value>()))+;
                room_for(bytes.saturating_mul(pixels))
            }
        }

        /// Channels of the ray through a pixel's centre; the default is a miss.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Sample {
            $($(#[doc = $what])+ pub $central: $value,)+
        }

        impl Default for Sample {
            fn default() -> Self {
                Self { $($central: $miss,)+ }
            }
        }

        /// Images in row-major order; images that were not requested are empty.
        #[derive(Debug, Default)]
        pub struct Frame {
            $($(#[doc = $about])+ pub $sampled: Vec<$color>,)+
            $($(#[doc = $what])+ pub $central: Vec<$value>,)+
        }

        impl Frame {
            /// Allocates the requested images for a renderer that writes every pixel. They are zero, because the system
            /// maps zeroed pages on first use; other values would take seconds for a large picture.
            pub fn new(channels: Channels, pixels: usize) -> Result<Self> {
                channels.check_room(pixels as u64)?;
                let size = |is_requested: bool| if is_requested { pixels } else { 0 };
                Ok(Self {
                    $($sampled: try_vec(<$color>::default(), size(channels.$sampled))?,)+
                    $($central: try_vec(<$value>::default(), size(channels.$central))?,)+
                })
            }

            /// Returns empty images with room for `pixels` pixels in each requested one.
            pub(super) fn with_capacity(channels: Channels, pixels: usize) -> Result<Self> {
                channels.check_room(pixels as u64)?;
                let size = |is_requested: bool| if is_requested { pixels } else { 0 };
                Ok(Self {
                    $($sampled: try_with_capacity(size(channels.$sampled))?,)+
                    $($central: try_with_capacity(size(channels.$central))?,)+
                })
            }

            /// Appends the images of another frame.
            pub(super) fn append(&mut self, other: &Self) -> Result<()> {
                $(try_append(&mut self.$sampled, &other.$sampled)?;)+
                $(try_append(&mut self.$central, &other.$central)?;)+
                Ok(())
            }

            /// Copies the images of a part, which is `columns` pixels wide, to its position in this frame.
            pub(crate) fn put(&mut self, part: &Self, width: usize, [left, top]: [usize; 2], columns: usize) {
                $(put_rows(&mut self.$sampled, &part.$sampled, width, [left, top], columns);)+
                $(put_rows(&mut self.$central, &part.$central, width, [left, top], columns);)+
            }

            /// Returns the channels of a pixel's centre; those not requested have the values of a miss.
            pub(crate) fn sample(&self, pixel: usize) -> Sample {
                let mut sample = Sample::default();
                $(if let Some(value) = self.$central.get(pixel) {
                    sample.$central = *value;
                })+
                sample
            }

            /// Appends a pixel to the requested images.
            #[inline]
            pub(crate) fn push(&mut self, channels: Channels, $($sampled: $color,)+ sample: &Sample) {
                $(if channels.$sampled {
                    self.$sampled.push($sampled);
                })+
                $(if channels.$central {
                    self.$central.push(sample.$central);
                })+
            }

            /// Splits the frame into bands of `pixels` pixels; the last may be shorter.
            pub(super) fn bands(&mut self, pixels: usize) -> Vec<Band<'_>> {
                let longest = 0 $(.max(self.$sampled.len()))+ $(.max(self.$central.len()))+;
                $(let mut $sampled = self.$sampled.chunks_mut(pixels);)+
                $(let mut $central = self.$central.chunks_mut(pixels);)+
                let next = |_| Band {
                    $($sampled: $sampled.next().unwrap_or_default(),)+
                    $($central: $central.next().unwrap_or_default(),)+
                };
                (0..longest.div_ceil(pixels)).map(next).collect()
            }
        }

        /// Consecutive rows of a frame, written by one task.
        #[derive(Debug)]
        pub(super) struct Band<'a> {
            $($sampled: &'a mut [$color],)+
            $($central: &'a mut [$value],)+
        }

        impl Band<'_> {
            $(
                #[doc = concat!("Stores a pixel's ", stringify!($sampled), " if it was requested.")]
                #[inline]
                pub fn $sampled(&mut self, pixel: usize, value: $color) {
                    set(self.$sampled, pixel, value);
                }
            )+

            /// Stores the pixel's other requested channels.
            #[inline]
            pub fn set_sample(&mut self, pixel: usize, sample: &Sample) {
                $(set(self.$central, pixel, sample.$central);)+
            }
        }
    };
}

images! {
    samples {
        /// Linear RGB.
        color: [f32; 3],
        /// Fraction of the samples that show a triangle, 0 to 1; neither sky nor map counts.
        coverage: f32,
    }
    center {
        /// Displayed distance |Q−U| in metres; infinite where nothing was hit.
        range: f32 = f32::INFINITY,
        /// Object number; −1 where nothing was hit.
        object_id: i32 = -1,
        /// Triangle number in the scene; −1 where nothing was hit.
        face_id: i64 = -1,
        /// Unmorphed surface point relative to the scene's origin; NaN where nothing was hit.
        position: [f32; 3] = [f32::NAN; 3],
        /// Unit geometric normal towards the viewer; NaN where nothing was hit.
        normal: [f32; 3] = [f32::NAN; 3],
        /// Linear RGB of the material, without light; NaN where nothing was hit.
        albedo: [f32; 3] = [f32::NAN; 3],
        /// Unit normal used for shading; NaN where nothing was hit.
        shading_normal: [f32; 3] = [f32::NAN; 3],
    }
}

#[inline]
fn set<T>(channel: &mut [T], pixel: usize, value: T) {
    if let Some(slot) = channel.get_mut(pixel) {
        *slot = value;
    }
}

fn put_rows<T: Copy>(image: &mut [T], part: &[T], width: usize, [left, top]: [usize; 2], columns: usize) {
    for (row, pixels) in (top..).zip(part.chunks_exact(columns)) {
        image[row * width + left..][..columns].copy_from_slice(pixels);
    }
}
