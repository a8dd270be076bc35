//! Camera data for shaders: windows of an image, and the uniform block of a pass.

use bytemuck::{Pod, Zeroable};
use glam::{DMat3, DVec2, DVec3, DVec4};
use nearfar_core::camera::{Camera, Fov, Projection, direction_from_face};
use nearfar_core::render::{Limits, MAX_PLANES, Segment};

use super::inputs::{BLOCK, PASS_BLOCKS};
use super::picture::Picture;
use super::style::Parameters;
use super::window::{Outputs, Window};

/// Distance of the near plane, metres. The precision of reversed floating-point depth does not depend on it.
const NEAR: f64 = 1e-6;

/// The uniform block `Pass` of `scene.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(super) struct Pass {
    clip: [[f32; 4]; 4],
    eye: [f32; 4],
    backdrop: [f32; 4],
    start: [[f32; 4]; 3],
    direction: [[f32; 4]; 3],
    direction_remainder: [[f32; 4]; 3],
    footprint: [f32; 4],
    window: [u32; 4],
    environment: [u32; 4],
    outputs: [u32; 4],
    more_outputs: [u32; 4],
    segment: [f32; 4],
    planes: [[f32; 4]; MAX_PLANES],
    parameters: Parameters,
    /// Padding to whole blocks, so that the passes of two views form an array.
    unused: [[f32; 4]; 15],
}

const _: () = assert!(size_of::<Pass>() == PASS_BLOCKS * BLOCK);

/// Sample that a pass takes in each pixel of a window.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sampling {
    /// Position of the sample in its pixel.
    pub offset: [f64; 2],
    /// Side of the square that it represents, pixels.
    pub scale: f64,
    /// Weight in the pixel's colour.
    pub weight: f32,
    /// Whether its colour is added to the earlier samples.
    pub adds: bool,
}

impl Sampling {
    /// One sample at the pixel's centre.
    pub const CENTER: Self = Self { offset: [0.5, 0.5], scale: 1.0, weight: 1.0, adds: false };
}

/// Axes of a view: to the right, upwards and ahead.
pub(crate) struct Axes {
    pub right: DVec3,
    pub up: DVec3,
    pub ahead: DVec3,
    pub fov: Fov,
}

impl Axes {
    pub fn new(camera: &Camera) -> Self {
        let axes = DMat3::from_quat(camera.orientation);
        let (right, up, ahead) = (axes.x_axis, axes.y_axis, -axes.z_axis);
        match camera.projection {
            Projection::Perspective(fov) | Projection::Orthographic(fov) => Self { right, up, ahead, fov },
            Projection::CubeFace(face) => {
                let ahead = direction_from_face(face, 0.0, 0.0);
                let right = direction_from_face(face, 1.0, 0.0) - ahead;
                let up = ahead - direction_from_face(face, 0.0, 1.0);
                Self { right, up, ahead, fov: Fov { left: -1.0, right: 1.0, down: -1.0, up: 1.0 } }
            }
        }
    }
}

/// Returns the eye as the tracer rounds it: relative to the scenes' origin, in float32.
pub(super) fn eye_of(camera: &Camera, picture: &Picture) -> DVec3 {
    (camera.position - picture.origin).as_vec3().as_dvec3()
}

/// Returns the uniform block of a pass over a window. `farthest` is the maximum drawn depth, for parallel rays.
pub(super) fn pass_block(
    picture: &Picture,
    camera: &Camera,
    window: &Window,
    sampling: &Sampling,
    outputs: &Outputs,
    farthest: f64,
) -> Pass {
    let eye = eye_of(camera, picture);
    let near = if camera.is_parallel() { 0.0 } else { NEAR };
    let map_center = picture.backdrop.as_ref().map_or(DVec3::ZERO, |backdrop| backdrop.center);
    let from_map_center = camera.position - picture.origin - map_center;
    // Ray of the window's pixel (0, 0) through the sample's position, and its steps per pixel.
    let corner = DVec2::new(f64::from(window.column) + sampling.offset[0], f64::from(window.row) + sampling.offset[1]);
    let ray = |x: f64, y: f64| camera.ray(corner.x + x, corner.y + y);
    let (first, right, down) = (ray(0.0, 0.0), ray(1.0, 0.0), ray(0.0, 1.0));
    let directions = split_on_grid([first.1, right.1 - first.1, down.1 - first.1], window);
    let vec4 = |v: DVec3| v.as_vec3().extend(0.0).to_array();
    let map = picture.backdrop.as_ref().map(|backdrop| &backdrop.texels);
    let environment = map.map_or([0; 4], |map| [map.size, map.color.shift, map.range.shift, u32::from(map.has_range)]);
    let limits = picture.limits.unwrap_or(Limits::NONE).relative_to(eye);
    let (Segment { t_min, t_max }, planes) = (limits.segment, limits.planes());
    let [color, range, ids, position, normal, albedo, shading_normal, coverage] = *outputs;
    Pass {
        clip: clip_rows(camera, window, sampling, farthest).map(|row| row.as_vec4().to_array()),
        eye: eye.as_vec3().extend(near as f32).to_array(),
        backdrop: vec4(from_map_center),
        start: [first.0, right.0 - first.0, down.0 - first.0].map(vec4),
        direction: directions.map(|(grid, _)| vec4(grid)),
        direction_remainder: directions.map(|(_, remainder)| vec4(remainder)),
        footprint: [
            (camera.pixel_size() * sampling.scale) as f32,
            f32::from(camera.is_parallel()),
            sampling.weight,
            0.0,
        ],
        window: [window.width, window.height, 0, u32::from(sampling.adds)],
        environment,
        outputs: [color, range, ids, position],
        more_outputs: [normal, albedo, shading_normal, coverage],
        // Shaders have no infinity.
        segment: [t_min.min(f32::MAX), t_max.min(f32::MAX), f32::from(t_max.is_infinite()), planes.len() as f32],
        planes: std::array::from_fn(|i| planes.get(i).map_or([0.0; 4], |plane| plane.as_vec4().to_array())),
        parameters: picture.parameters,
        unused: [[0.0; 4]; 15],
    }
}

/// Splits the direction of pixel (0, 0) and its steps per pixel into multiples of a grid and remainders. The grid is so
/// coarse that shaders add and multiply its multiples exactly. A direction that is rounded three times would be off by
/// 10⁻⁷, which moves surfaces at a slope of 1 : 100 by 10⁻⁵ of their range.
fn split_on_grid(vectors: [DVec3; 3], window: &Window) -> [(DVec3, DVec3); 3] {
    let [first, right, down] = vectors.map(DVec3::abs);
    let largest = (first + right * f64::from(window.width) + down * f64::from(window.height)).max_element();
    let grid = (largest.log2().ceil() - 23.0).exp2();
    vectors.map(|v| {
        let coarse = (v / grid).round() * grid;
        (coarse, v - coarse)
    })
}

/// Returns the rows that map (point relative to the eye, 1) to clip space: reversed depth, 1 at the near plane and 0
/// at infinity; for parallel rays 1 at the image plane and 0 at the farthest depth.
fn clip_rows(camera: &Camera, window: &Window, sampling: &Sampling, farthest: f64) -> [DVec4; 4] {
    let Axes { right, up, ahead, fov } = Axes::new(camera);
    let center = DVec2::new(fov.left + fov.right, fov.down + fov.up);
    let size = DVec2::new(fov.right - fov.left, fov.up - fov.down);
    let (x, y, z, w) = if camera.is_parallel() {
        (
            (2.0 * right / size.x).extend(-center.x / size.x),
            (2.0 * up / size.y).extend(-center.y / size.y),
            (-ahead / farthest).extend(1.0),
            DVec4::W,
        )
    } else {
        (
            ((2.0 * right - center.x * ahead) / size.x).extend(0.0),
            ((2.0 * up - center.y * ahead) / size.y).extend(0.0),
            DVec4::new(0.0, 0.0, 0.0, NEAR),
            ahead.extend(0.0),
        )
    };
    // The window fills clip space, and the sample's position maps to the pixel's centre.
    let (width, height) = (f64::from(camera.width), f64::from(camera.height));
    let (columns, rows) = (f64::from(window.width), f64::from(window.height));
    let shift_x = width - columns - 2.0 * f64::from(window.column) + 2.0 * (0.5 - sampling.offset[0]);
    let shift_y = height - rows - 2.0 * f64::from(window.row) + 2.0 * (0.5 - sampling.offset[1]);
    [(x * width + w * shift_x) / columns, (y * height - w * shift_y) / rows, z, w]
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DQuat;

    #[test]
    fn clip_space_agrees_with_the_camera_in_every_window_and_sample() {
        let fov = Fov { left: -0.7, right: 1.1, down: -0.9, up: 0.4 };
        let projections = [Projection::Perspective(fov), Projection::Orthographic(fov), Projection::CubeFace(3)];
        for projection in projections {
            let turn = DQuat::from_rotation_y(0.4) * DQuat::from_rotation_x(0.3);
            let camera = Camera::new(DVec3::new(5.0, 2.0, -3.0), turn, projection, 64, 64).unwrap();
            for window in Window::split(64, 64, 500, 40) {
                let sampling = Sampling { offset: [0.3, 0.9], ..Sampling::CENTER };
                let rows = clip_rows(&camera, &window, &sampling, 100.0);
                let (start, direction) = camera.ray(33.3, 20.9);
                let point = start + 7.0 * direction;
                let clip = rows.map(|row| row.dot(point.extend(1.0)));
                let column = (clip[0] / clip[3] + 1.0) / 2.0 * f64::from(window.width) + f64::from(window.column);
                let row = (1.0 - clip[1] / clip[3]) / 2.0 * f64::from(window.height) + f64::from(window.row);
                // A sample at its position is drawn at the pixel's centre.
                assert!((column - 33.5).abs() < 1e-9 && (row - 20.5).abs() < 1e-9, "{projection:?} {column} {row}");
                assert!((0.0..=1.0).contains(&(clip[2] / clip[3])));
            }
        }
    }

    #[test]
    fn directions_have_the_error_of_one_rounding() {
        let window = Window { column: 0, row: 0, width: 4000, height: 3000 };
        let vectors =
            [DVec3::new(-0.71, 0.63, -1.1), DVec3::new(3.1e-4, 1e-9, 1.7e-4), DVec3::new(-1e-5, -3.3e-4, 0.0)];
        let parts = split_on_grid(vectors, &window);
        for (x, y) in [(0, 0), (1, 1), (1999, 1), (3999, 2999), (77, 2998)] {
            let (x, y) = (x as f32, y as f32);
            let [a, b, c] = parts.map(|(grid, _)| grid.as_vec3());
            let sum = a + x * b + y * c;
            let [a, b, c] = parts.map(|(_, remainder)| remainder.as_vec3());
            let got = (sum + (a + x * b + y * c)).as_dvec3();
            let exact = vectors[0] + f64::from(x) * vectors[1] + f64::from(y) * vectors[2];
            // Half a step of float32 at 2, plus the rounding of the small remainder.
            assert!((got - exact).abs().max_element() <= 1.01 * f64::from(f32::EPSILON), "{x} {y}");
        }
    }
}
