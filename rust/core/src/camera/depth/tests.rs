use super::*;
use crate::base::Progress;
use crate::camera::{Fov, Projection};

const FOV: Fov = Fov { left: -1.0, right: 0.5, down: -0.25, up: 0.75 };
const PLANES: Planes = Planes { near: 0.1, far: f64::INFINITY, reverse: true };

fn ranges(buffer: &DepthBuffer, depth: &[f64]) -> Vec<f64> {
    let mut found = vec![0.0; depth.len()];
    buffer.ranges(depth, &mut found, &Progress::new()).unwrap();
    found
}

#[test]
fn a_matrix_agrees_with_planes_and_tangents() {
    let (n, f) = (0.1, 500.0);
    let Fov { left: l, right: r, down: b, up: t } = FOV;
    // D3D and WebGPU with reversed depth: n (f − z)/((f − n) z).
    let (g, h) = (n / (f - n), f * n / (f - n));
    let rows = [
        [2.0 / (r - l), 0.0, (r + l) / (r - l), 0.0],
        [0.0, 2.0 / (t - b), (t + b) / (t - b), 0.0],
        [0.0, 0.0, g, h],
        [0.0, 0.0, -1.0, 0.0],
    ];
    let planes = Planes { near: n, far: f, reverse: true };
    let from_planes = DepthBuffer::new(Projection::Perspective(FOV), planes, 70, 3).unwrap();
    let from_matrix = DepthBuffer::from_matrix(rows, 0.0, 70, 3).unwrap();
    let depth: Vec<f64> = (0..420).map(|i| f64::from(i) / 419.0).collect();
    for (a, b) in ranges(&from_planes, &depth).into_iter().zip(ranges(&from_matrix, &depth)) {
        // The rounding of the matrix's entries grows by the factor f/n at the far plane.
        assert!(a == b || (a / b - 1.0).abs() < 1e-11, "{a} {b}");
    }
}

#[test]
fn the_first_refused_value_is_named() {
    let buffer = DepthBuffer::new(Projection::Perspective(FOV), PLANES, 100, 40).unwrap();
    let mut depth = vec![0.5f32; 3 * 4000];
    let mut found = depth.clone();
    assert!(buffer.ranges(&depth, &mut found, &Progress::new()).is_ok());
    depth[9000] = 1.5;
    depth[8003] = f32::NAN;
    let message = buffer.ranges(&depth, &mut found, &Progress::new()).unwrap_err().to_string();
    assert!(message.contains("NaN in row 0, column 3 of image 2"), "{message}");
    found[50] = 0.01;
    let message = buffer.depths(&found, &mut depth, &Progress::new()).unwrap_err().to_string();
    assert!(message.contains("ranges: expected") && message.contains("row 0, column 50 of image 0"), "{message}");
}

#[test]
fn invalid_projections_are_refused() {
    let view = |planes| DepthBuffer::new(Projection::Orthographic(FOV), planes, 4, 4).is_ok();
    assert!(view(Planes { near: 0.0, far: 10.0, reverse: false }));
    assert!(!view(PLANES));
    assert!(!view(Planes { near: 5.0, far: 5.0, reverse: false }));
    let rows = |last| [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.1], last];
    let matrix = |rows| DepthBuffer::from_matrix(rows, 0.0, 4, 4).is_ok();
    assert!(matrix(rows([0.0, 0.0, -1.0, 0.0])));
    assert!(!matrix(rows([0.0, 0.0, -0.5, 0.0])));
    assert!(!matrix(rows([0.0, 0.0, 0.0, 1.0])));
    assert!(!matrix([[0.0; 4]; 4]));
    assert!(!matrix([[f64::NAN; 4]; 4]));
}
