//! GPU back end: the ray tracer's pictures, drawn by wgpu on Vulkan, Metal, DirectX 12 or OpenGL.
//!
//! A frame is drawn in two steps. The raster pass stores only the face that each pixel shows. Then a compute pass, the
//! resolve pass, intersects that face with the pixel's own ray, once per pixel, and evaluates the requested channels
//! (colour, range, numbers, position, normal) by the tracer's formulas. So pictures of both back ends differ only by
//! rounding, and hidden surfaces cost only their depth test.

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

    /// Python exports this text for custom shaders; nothing is drawn with it here.
    #[test]
    fn the_shader_for_view_vectors_is_valid() {
        let module = wgsl::parse_str(include_str!("../../../python/nearfar/stereo/view_vector.wgsl")).unwrap();
        Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module).unwrap();
        assert_eq!(module.functions.len(), 1);
    }
}
