//! Watertight ray–triangle intersection.
//!
//! Woop, Benthin, Wald: Watertight ray/triangle intersection, JCGT 2(1), 2013. Corners are sheared so that the ray
//! becomes the z axis; an edge's sign is then the same for both triangles that share it, and 0 counts as inside.

use glam::Vec3;

/// A ray direction's shear: which axis becomes z, and by how much the others lean.
#[derive(Clone, Copy, Debug)]
pub struct Shear {
    axes: [usize; 3],
    scale: Vec3,
}

impl Shear {
    /// The longest component becomes z.
    #[inline]
    pub fn new(direction: Vec3) -> Self {
        let size = direction.abs();
        let z = if size.x > size.y && size.x > size.z {
            0
        } else if size.y > size.z {
            1
        } else {
            2
        };
        let (mut x, mut y) = ((z + 1) % 3, (z + 2) % 3);
        if direction[z] < 0.0 {
            std::mem::swap(&mut x, &mut y);
        }
        let scale = Vec3::new(direction[x] / direction[z], direction[y] / direction[z], 1.0 / direction[z]);
        Self { axes: [x, y, z], scale }
    }

    /// Parameter along the ray and the weights of b and c; none for a miss.
    #[inline]
    pub fn intersect(&self, origin: Vec3, a: Vec3, b: Vec3, c: Vec3) -> Option<(f32, f32, f32)> {
        let [a, b, c] = [a - origin, b - origin, c - origin].map(|p| {
            let z = p[self.axes[2]];
            Vec3::new(p[self.axes[0]] - self.scale.x * z, p[self.axes[1]] - self.scale.y * z, self.scale.z * z)
        });
        let mut u = c.x * b.y - c.y * b.x;
        let mut v = a.x * c.y - a.y * c.x;
        let mut w = b.x * a.y - b.y * a.x;
        if u == 0.0 || v == 0.0 || w == 0.0 {
            // In float64 the products of float32 are exact, so a zero that remains is a true one.
            let exact = |px: f32, py: f32, qx: f32, qy: f32| {
                (f64::from(px) * f64::from(qy) - f64::from(py) * f64::from(qx)) as f32
            };
            (u, v, w) = (exact(c.x, c.y, b.x, b.y), exact(a.x, a.y, c.x, c.y), exact(b.x, b.y, a.x, a.y));
        }
        if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
            return None;
        }
        let determinant = u + v + w;
        if determinant == 0.0 {
            return None;
        }
        let t = (u * a.z + v * b.z + w * c.z) / determinant;
        Some((t, v / determinant, w / determinant))
    }
}
