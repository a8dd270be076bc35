//! The rig: two eyes, the camera behind them, and the plane on which all pictures meet.

use glam::{DMat3, DQuat, DVec2, DVec3};

use crate::base::{Result, ensure};
use crate::camera::{Fov, MAX_SIZE};

/// One eye of a headset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eye {
    /// Field of view in the eye's own axes, tangents.
    pub fov: Fov,
    /// Position in head axes, metres.
    pub position: DVec3,
    /// Unit quaternion eye→head; canted views are turned outwards.
    pub orientation: DQuat,
}

/// Index of an eye.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The left eye.
    Left = 0,
    /// The right eye.
    Right = 1,
}

impl Side {
    /// Both eyes, the left one first.
    pub const BOTH: [Self; 2] = [Self::Left, Self::Right];

    /// Returns the public name.
    pub fn name(self) -> &'static str {
        ["left", "right"][self as usize]
    }
}

/// Distances of the mono planes from the plane of the eyes, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Planes {
    /// m₁: points nearer than m₁ are not displaced.
    pub begin: f64,
    /// m₂ ≥ m₁: the eyes draw points nearer than m₂, the camera behind them draws farther ones. From m₁ to m₂, points
    /// move from their position in the eye's picture to their position in the camera's picture.
    pub end: f64,
}

impl Planes {
    /// Returns m: distance of the plane of the look-up homography, the harmonic mean of m₁ and m₂.
    pub fn mono(&self) -> f64 {
        if self.begin == self.end { self.begin } else { 2.0 / (1.0 / self.begin + 1.0 / self.end) }
    }
}

/// Two eyes, the planes, and the third camera, which is behind the eyes.
#[derive(Clone, Copy, Debug)]
pub struct Rig {
    /// Left and right eye; positions are relative to the middle between them.
    eyes: [Eye; 2],
    /// Middle between the eyes, in head axes.
    pub middle: DVec3,
    /// Mono planes.
    pub planes: Planes,
    /// Size of an eye's picture, pixels.
    pub size: (u32, u32),
    /// s: distance of the third camera behind the middle between the eyes, metres. It is the smallest distance at which
    /// the camera's view includes both eyes' views at infinity: ipd/2 divided by the smaller outer tangent.
    pub setback: f64,
    /// Field of view of the third camera: the hull of both eyes' views on the plane.
    pub center_fov: Fov,
    /// Size of the third camera's picture, whose pixels are as fine on the plane as those of the eyes (Eq. 8).
    pub center_size: (u32, u32),
    jitter: DVec2,
}

/// Published factor k of the overlap ε = k s m between the eyes' part of the scene and the third camera's.
const OVERLAP_FACTOR: f64 = 2.0;
/// Maximum distance between interpolated pixels, in pixels: half an eye's pixel and one of the third camera's.
const MAX_INTERPOLATION_PX: f64 = 1.5;
/// Maximum distance of a slanted surface from the line of sight for which the overlap suffices, metres.
const MAX_SURFACE_OFFSET: f64 = 1.0;
/// Minimum cosine of the angle between a view's corner and the head's forward axis, so that the corner meets the plane.
const MIN_FORWARD: f64 = 1e-6;

impl Rig {
    /// Creates a rig: checks the eyes and places the camera behind them. `size` is the picture of an eye, pixels.
    pub fn new(eyes: [Eye; 2], planes: Planes, size: (u32, u32)) -> Result<Self> {
        check_size(size)?;
        check_planes(planes)?;
        let [left, right] = eyes;
        let expected = format!("an eye to the right of the left one, whose x is {} m", left.position.x);
        ensure!(left.position.x < right.position.x, "right", expected, format!("x = {} m", right.position.x));
        let middle = 0.5 * (left.position + right.position);
        let eyes = eyes.map(|eye| Eye { position: eye.position - middle, ..eye });
        for (side, eye) in Side::BOTH.into_iter().zip(&eyes) {
            check_in_front(side, eye, planes.begin)?;
        }
        let setback = setback_of(Side::Left, &eyes[0])?.max(setback_of(Side::Right, &eyes[1])?);
        let footprints = eyes.map(|eye| footprint(&eye, planes.mono()));
        check_overlap(&footprints)?;
        let (low, high) = bounds(footprints.as_flattened());
        let plane_distance = planes.mono() + setback;
        let center_fov = Fov {
            left: low.x / plane_distance,
            right: high.x / plane_distance,
            down: low.y / plane_distance,
            up: high.y / plane_distance,
        };
        let center_size = center_size(&footprints, high - low, size)?;
        Ok(Self { eyes, middle, planes, size, setback, center_fov, center_size, jitter: DVec2::ZERO })
    }

    /// Returns the rig with the pixels of all pictures shifted right and down by a fraction of a pixel.
    pub fn jittered(&self, jitter: DVec2) -> Result<Self> {
        let is_valid = jitter.is_finite() && jitter.abs().max_element() <= 1.0;
        ensure!(is_valid, "jitter", "at most 1 pixel along each axis", jitter);
        Ok(Self { jitter, ..*self })
    }

    /// Returns an eye; its position is relative to the middle between both.
    pub fn eye(&self, side: Side) -> &Eye {
        &self.eyes[side as usize]
    }

    /// Returns ε: the distance before the plane m₂ from which the third camera draws, metres. It is at least the
    /// published k s m. For coarse pixels or a far plane, it is the change of depth over the interpolated pixels of a
    /// surface at `MAX_SURFACE_OFFSET`: m² / `MAX_SURFACE_OFFSET` per unit of tangent.
    pub fn overlap(&self) -> f64 {
        let (m, fov, (width, height)) = (self.planes.end, self.center_fov, self.center_size);
        let pixel = ((fov.right - fov.left) / f64::from(width)).max((fov.up - fov.down) / f64::from(height));
        (OVERLAP_FACTOR * self.setback * m)
            .max((MAX_INTERPOLATION_PX * pixel * m * m / MAX_SURFACE_OFFSET).min(0.5 * m))
    }

    /// Returns the homography of the plane: from pixels (x, y, 1) of the third camera to pixels (x w, y w, w) of an
    /// eye. w is the distance of the plane's point along the eye's axis, metres.
    pub fn homography(&self, side: Side) -> DMat3 {
        let eye = self.eye(side);
        let (m, p) = (self.planes.mono(), eye.position);
        let plane_distance = m + self.setback;
        // Maps tangents (x, y, 1) of the camera to the plane's point that it sees there, relative to the eye.
        let on_plane = DMat3::from_cols(
            DVec3::new(plane_distance, 0.0, 0.0),
            DVec3::new(0.0, plane_distance, 0.0),
            DVec3::new(-p.x, -p.y, -m - p.z),
        );
        let to_eye = DMat3::from_quat(eye.orientation).transpose();
        let facing = DMat3::from_diagonal(DVec3::new(1.0, 1.0, -1.0));
        let pixels = pixels_of(&eye.fov, self.size);
        let center = pixels_of(&self.center_fov, self.center_size);
        let [shift, unshift] = [self.jitter, -self.jitter].map(DMat3::from_translation);
        unshift * pixels * facing * to_eye * on_plane * center.inverse() * shift
    }
}

/// Returns the point of the plane at distance m that an eye sees at tangents (x, y), relative to the middle between the
/// eyes, in head axes.
pub(super) fn on_plane(eye: &Eye, tangents: DVec2, m: f64) -> DVec2 {
    let direction = eye.orientation * tangents.extend(-1.0);
    eye.position.truncate() + direction.truncate() * ((m + eye.position.z) / -direction.z)
}

/// Returns the minimum and maximum coordinates of points.
fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    points.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), &p| (low.min(p), high.max(p)))
}

/// Returns the corners of an eye's view on the plane: left bottom, right bottom, right top, left top.
fn footprint(eye: &Eye, m: f64) -> [DVec2; 4] {
    corners(&eye.fov).map(|corner| on_plane(eye, corner, m))
}

pub(super) fn corners(fov: &Fov) -> [DVec2; 4] {
    let Fov { left, right, down, up } = *fov;
    [(left, down), (right, down), (right, up), (left, up)].map(|(x, y)| DVec2::new(x, y))
}

/// Returns the matrix from tangents (x, y, 1) to pixels (x, y, 1).
fn pixels_of(fov: &Fov, (width, height): (u32, u32)) -> DMat3 {
    let x = f64::from(width) / (fov.right - fov.left);
    let y = f64::from(height) / (fov.up - fov.down);
    DMat3::from_cols(DVec3::new(x, 0.0, 0.0), DVec3::new(0.0, -y, 0.0), DVec3::new(-fov.left * x, fov.up * y, 1.0))
}

/// Returns the distance behind the middle from which a ray along the eye's outer edge starts on the head's axis.
fn setback_of(side: Side, eye: &Eye) -> Result<f64> {
    let (outwards, edge) = if side == Side::Left { (-1.0, eye.fov.left) } else { (1.0, eye.fov.right) };
    let slope = |y: f64| {
        let direction = eye.orientation * DVec3::new(edge, y, -1.0);
        outwards * direction.x / -direction.z
    };
    let min_slope = slope(eye.fov.down).min(slope(eye.fov.up));
    let expected = "an eye whose outer edge points outwards, away from the other eye";
    ensure!(min_slope > 0.0, side.name(), expected, format!("an outer tangent of {min_slope}"));
    Ok((outwards * eye.position.x / min_slope).max(0.0))
}

/// Returns the picture size by Eq. 8: the third camera's pixels are as large on the plane as those of the coarser eye.
/// For rotated eyes, whose scale varies over the plane, the mean size of pixels is used.
fn center_size(footprints: &[[DVec2; 4]; 2], hull: DVec2, (width, height): (u32, u32)) -> Result<(u32, u32)> {
    let mean_width = |[a, b, c, d]: [DVec2; 4]| 0.5 * ((b - a).length() + (c - d).length());
    let mean_height = |[a, b, c, d]: [DVec2; 4]| 0.5 * ((d - a).length() + (c - b).length());
    let pixels = |hull: f64, widths: [f64; 2], count: u32| {
        let quotient = widths.map(|width| hull / width * f64::from(count)).into_iter().fold(f64::INFINITY, f64::min);
        // Rounding must not add a pixel to an integer quotient.
        (quotient - 1e-6).ceil().max(1.0)
    };
    let size = [pixels(hull.x, footprints.map(mean_width), width), pixels(hull.y, footprints.map(mean_height), height)];
    let is_valid = size.iter().all(|&count| count <= f64::from(MAX_SIZE));
    let expected = format!("a plane for which the shared picture has at most {MAX_SIZE} pixels each way");
    ensure!(is_valid, "mono_plane", expected, format!("{} × {}", size[0], size[1]));
    Ok((size[0] as u32, size[1] as u32))
}

fn check_size((width, height): (u32, u32)) -> Result<()> {
    let is_valid = [width, height].iter().all(|length| (1..=MAX_SIZE).contains(length));
    ensure!(is_valid, "size", format!("1 to {MAX_SIZE} pixels each way"), format!("({width}, {height})"));
    Ok(())
}

fn check_planes(Planes { begin, end }: Planes) -> Result<()> {
    ensure!(begin.is_finite() && begin > 0.0, "mono_plane", "a distance above 0 metres", begin);
    let is_valid = end.is_finite() && end >= begin;
    ensure!(is_valid, "mono_plane", format!("a zone that ends at {begin} metres or farther"), end);
    Ok(())
}

/// Fails for eyes beyond the plane and for views whose corners do not meet it in front of the head.
fn check_in_front(side: Side, eye: &Eye, m: f64) -> Result<()> {
    let expected = format!("a plane in front of the {} eye, which is {} m ahead", side.name(), -eye.position.z);
    ensure!(m + eye.position.z > 0.0, "mono_plane", expected, m);
    let forward = |corner: DVec2| -(eye.orientation * corner.extend(-1.0)).z / corner.extend(-1.0).length();
    let is_ahead = corners(&eye.fov).into_iter().all(|corner| forward(corner) >= MIN_FORWARD);
    let expected = "a view whose corners lie less than 90° from the head's forward axis";
    ensure!(is_ahead, side.name(), expected, "one turned farther");
    Ok(())
}

/// Fails for views that do not overlap on the plane.
fn check_overlap(footprints: &[[DVec2; 4]; 2]) -> Result<()> {
    let [(left_low, left_high), (right_low, right_high)] = footprints.map(|corners| bounds(&corners));
    let expected = "a plane on which the views of both eyes overlap";
    let do_overlap = left_low.cmplt(right_high).all() && right_low.cmplt(left_high).all();
    ensure!(do_overlap, "mono_plane", expected, "views that do not overlap");
    Ok(())
}
