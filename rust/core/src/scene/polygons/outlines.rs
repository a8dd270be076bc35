//! Polygons in flat arrays.

use std::ops::Range;

use crate::base::error::number;
use crate::base::{Error, Result, ensure};

/// Maximum absolute coordinate, so that products of four coordinates stay finite.
const MAX_COORDINATE: f64 = 1e30;

/// Polygons in a plane. A polygon is a sequence of rings: the first is its outer boundary, the others bound holes. A
/// ring is a sequence of points, closed implicitly. Either orientation is allowed.
#[derive(Debug, Clone, Copy)]
pub struct Polygons<'a> {
    pub(super) points: &'a [[f64; 2]],
    rings: &'a [i64],
    polygons: &'a [i64],
}

impl<'a> Polygons<'a> {
    /// Creates polygons: ring r is `points[rings[r]..rings[r + 1]]`, and polygon p has the rings
    /// `polygons[p]..polygons[p + 1]`.
    pub fn new(points: &'a [[f64; 2]], rings: &'a [i64], polygons: &'a [i64]) -> Result<Self> {
        ensure!(points.len() <= u32::MAX as usize, "points", "fewer than 2^32", points.len());
        check_offsets("rings", rings, points.len())?;
        check_offsets("polygons", polygons, rings.len() - 1)?;
        let far = |value: &&f64| value.is_nan() || value.abs() > MAX_COORDINATE;
        if let Some(&value) = points.as_flattened().iter().find(far) {
            return Err(Error::value("points", "numbers up to 1e30", number(value)));
        }
        Ok(Self { points, rings, polygons })
    }

    pub(super) fn len(&self) -> usize {
        self.polygons.len() - 1
    }

    /// Returns the point range of each ring of a polygon.
    pub(super) fn rings_of(&self, polygon: usize) -> impl Iterator<Item = Range<usize>> {
        let rings = self.polygons[polygon] as usize..self.polygons[polygon + 1] as usize;
        rings.map(|ring| self.rings[ring] as usize..self.rings[ring + 1] as usize)
    }
}

/// Checks that offsets begin with 0, end with `count` and never decrease.
pub(super) fn check_offsets(argument: &'static str, offsets: &[i64], count: usize) -> Result<()> {
    let is_ascending = offsets.first() == Some(&0)
        && offsets.last() == i64::try_from(count).ok().as_ref()
        && offsets.windows(2).all(|pair| pair[0] <= pair[1]);
    let expected = || format!("numbers that ascend from 0 to {count}");
    ensure!(is_ascending, argument, expected(), format!("{} other numbers", offsets.len()));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inconsistent_offsets_are_refused() {
        let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        for (rings, polygons) in
            [(vec![], vec![0]), (vec![0, 2], vec![0, 1]), (vec![0, 4, 3], vec![0, 2]), (vec![0, 3], vec![0, 2])]
        {
            assert!(matches!(Polygons::new(&points, &rings, &polygons), Err(Error::Value { .. })));
        }
        assert!(Polygons::new(&points, &[0, 3], &[]).is_err());
        for wrong in [f64::NAN, f64::INFINITY, -1e31] {
            let points = [[0.0, 0.0], [1.0, wrong], [0.0, 1.0]];
            assert!(Polygons::new(&points, &[0, 3], &[0, 1]).is_err(), "{wrong}");
        }
    }

    #[test]
    fn rings_are_found() {
        let points = [[0.0; 2]; 9];
        let polygons = Polygons::new(&points, &[0, 3, 3, 9], &[0, 0, 2, 3]).unwrap();
        assert_eq!(polygons.len(), 3);
        assert_eq!(polygons.rings_of(0).count(), 0);
        assert_eq!(polygons.rings_of(1).collect::<Vec<_>>(), [0..3, 3..3]);
        assert_eq!(polygons.rings_of(2).next(), Some(3..9));
        assert_eq!(polygons.rings_of(2).count(), 1);
    }
}
