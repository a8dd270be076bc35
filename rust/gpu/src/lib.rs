//! The GPU back end: what the ray tracer does, drawn by wgpu on Vulkan, Metal, DirectX 12 or OpenGL.
//!
//! A frame is drawn in two steps. The raster pass stores which face each pixel shows, and nothing else. Then a compute
//! pass works out what is known of that face along the pixel's own ray (colour, range, numbers, position, normal), once
//! for each pixel and in the wanted channels only, by the tracer's formulas. So pictures of both back ends differ by
//! rounding alone, and what is hidden costs nothing but its depth.

pub mod device;
mod upload;
pub mod draw;
pub mod render;
pub mod compute;
pub mod splat;

pub use device::{AdapterKind, AdapterReport, Counters, Device};
pub use draw::{DeviceFrame, Job};
pub use render::reduced::Reduced;

#[cfg(test)]
mod tests {
    use wgpu::naga::front::wgsl;
    use wgpu::naga::valid::{Capabilities, ValidationFlags, Validator};

    /// Python returns this text to those who shade by themselves; it draws nothing here.
    #[test]
    fn the_shader_for_view_vectors_is_valid() {
        let module = wgsl::parse_str(include_str!("../../../python/nearfar/stereo/view_vector.wgsl")).unwrap();
        Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module).unwrap();
        assert_eq!(module.functions.len(), 1);
    }
}
