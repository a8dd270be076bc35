//! Samplers: continuation of images beyond their sides, and the texels that are blended at a point.
//!
//! Khronos: glTF 2.0, section 5.26, with OpenGL's codes; wrapping as in OpenGL ES 3.0, section 3.8.10.

/// Continuation of an image beyond its sides.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// The image is repeated.
    #[default]
    Repeat,
    /// The image is repeated, and every second copy is mirrored.
    Mirror,
    /// The texels at the sides are repeated.
    Clamp,
}

/// Sampling of an image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sampler {
    /// Continuation along u and v.
    pub wrap: [Wrap; 2],
    /// Whether magnified texels are squares of one colour. If not, neighbours are blended.
    pub nearest: bool,
}

/// glTF's codes of magnification filters.
const NEAREST: u32 = 9728;
const LINEAR: u32 = 9729;

impl Wrap {
    const CODES: [(Self, u32); 3] = [(Self::Repeat, 10497), (Self::Mirror, 33648), (Self::Clamp, 33071)];

    /// Returns a coordinate's place in the image, from 0 to 1; 0 for coordinates that are not finite.
    #[inline]
    fn place(self, coordinate: f32) -> f32 {
        if !coordinate.is_finite() {
            return 0.0;
        }
        match self {
            Self::Repeat => coordinate - coordinate.floor(),
            Self::Mirror => {
                let within_pair = coordinate - 2.0 * (coordinate * 0.5).floor();
                if within_pair > 1.0 { 2.0 - within_pair } else { within_pair }
            }
            Self::Clamp => coordinate.clamp(0.0, 1.0),
        }
    }
}

impl Sampler {
    /// Creates a sampler from glTF's `wrapS`, `wrapT` and `magFilter`; `None` for unknown codes.
    pub fn from_gltf([wrap_s, wrap_t, filter]: [u32; 3]) -> Option<Self> {
        let wrap = |code: u32| Wrap::CODES.iter().find(|known| known.1 == code).map(|known| known.0);
        let is_known = filter == NEAREST || filter == LINEAR;
        is_known.then_some(Self { wrap: [wrap(wrap_s)?, wrap(wrap_t)?], nearest: filter == NEAREST })
    }

    /// Returns glTF's `wrapS`, `wrapT` and `magFilter`.
    pub fn to_gltf(self) -> [u32; 3] {
        let [wrap_s, wrap_t] = self.wrap.map(|wrap| Wrap::CODES[wrap as usize].1);
        [wrap_s, wrap_t, if self.nearest { NEAREST } else { LINEAR }]
    }

    /// Returns the texels that are blended at (u, v), v upwards, in a level of this size; with `nearest` all are equal.
    #[inline]
    pub(super) fn taps(self, [u, v]: [f32; 2], width: u32, height: u32, nearest: bool) -> TextureTaps {
        let [across, down] = self.wrap;
        let (left, right, x) = neighbours(u, width, across, nearest);
        let (upper, lower, y) = neighbours(1.0 - v, height, down, nearest);
        TextureTaps { columns: [left, right], rows: [upper, lower], weights: [x, y] }
    }
}

/// Four texels around a point, and the weights of the right column and the lower row.
pub(super) struct TextureTaps {
    columns: [u32; 2],
    rows: [u32; 2],
    weights: [f32; 2],
}

impl TextureTaps {
    #[inline]
    pub(super) fn blend<const N: usize>(&self, texel: impl Fn(u32, u32) -> [f32; N]) -> [f32; N] {
        let [x, y] = self.weights;
        let row = |row: u32| {
            let (left, right) = (texel(self.columns[0], row), texel(self.columns[1], row));
            std::array::from_fn::<f32, N, _>(|i| left[i] + (right[i] - left[i]) * x)
        };
        let (upper, lower) = (row(self.rows[0]), row(self.rows[1]));
        std::array::from_fn(|i| upper[i] + (lower[i] - upper[i]) * y)
    }
}

/// Returns the two texels whose centres enclose a coordinate, and the weight of the second. A period of 1 has `count`
/// texels. With `nearest`, both are the texel that contains the coordinate.
#[inline]
fn neighbours(coordinate: f32, count: u32, wrap: Wrap, nearest: bool) -> (u32, u32, f32) {
    let (place, last) = (wrap.place(coordinate) * count as f32, count - 1);
    if nearest {
        let texel = (place as u32).min(last);
        return (texel, texel, 0.0);
    }
    let x = place - 0.5;
    let floor = x.floor();
    // Beyond a side, a repeated image has the texel at the opposite side; other images repeat the texel at the side.
    let (before, after) = if wrap == Wrap::Repeat { (last, 0) } else { (0, last) };
    if floor < 0.0 {
        return (before, 0, x - floor);
    }
    // The place may round up to `count`.
    let first = (floor as u32).min(last);
    (first, if first == last { after } else { first + 1 }, x - floor)
}

#[cfg(test)]
mod tests {
    use super::*;

    const WRAPS: [Wrap; 3] = [Wrap::Repeat, Wrap::Mirror, Wrap::Clamp];

    /// Returns the texel of a number beyond the sides by the table of OpenGL ES 3.0.
    fn wrapped(number: i64, count: i64, wrap: Wrap) -> u32 {
        let mirrored = |a: i64| if a >= 0 { a } else { -(1 + a) };
        let texel = match wrap {
            Wrap::Repeat => number.rem_euclid(count),
            Wrap::Mirror => (count - 1) - mirrored(number.rem_euclid(2 * count) - count),
            Wrap::Clamp => number.clamp(0, count - 1),
        };
        texel as u32
    }

    #[test]
    fn texels_and_weights_follow_opengl() {
        for (wrap, count) in WRAPS.into_iter().flat_map(|wrap| [1u32, 2, 3, 5, 8].map(|count| (wrap, count))) {
            // Every texel has its own value, so that the blend shows both texels and their weights.
            let value = |texel: u32| f64::from(texel * texel + 3);
            for step in -333..333 {
                let coordinate = step as f32 / 97.0;
                let place = f64::from(coordinate) * f64::from(count);
                let (low, between) = ((place - 0.5).floor(), (place - 0.5) - (place - 0.5).floor());
                let [one, two] = [0, 1].map(|next| value(wrapped(low as i64 + next, i64::from(count), wrap)));
                let (first, second, weight) = neighbours(coordinate, count, wrap, false);
                let blend = value(first) * f64::from(1.0 - weight) + value(second) * f64::from(weight);
                // Rounding coordinates up to 4 to float32 moves the place by up to 4 · 2⁻²⁴ · 8 texels. Neighbours
                // differ by up to 60.
                assert!((blend - (one + (two - one) * between)).abs() < 2e-4, "{wrap:?} {count} {coordinate}");
                let texel = wrapped(place.floor() as i64, i64::from(count), wrap);
                // Where a coordinate lies on the border of two texels, rounding may choose either.
                if (place - place.round()).abs() > 1e-5 {
                    assert_eq!(neighbours(coordinate, count, wrap, true), (texel, texel, 0.0));
                }
            }
        }
    }

    #[test]
    fn wild_coordinates_stay_in_the_image() {
        let wild = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -f32::MIN_POSITIVE, -1e-9, 1e9, 1e30, -1e30];
        for (wrap, coordinate) in WRAPS.into_iter().flat_map(|wrap| wild.map(|coordinate| (wrap, coordinate))) {
            for nearest in [false, true] {
                let (first, second, weight) = neighbours(coordinate, 5, wrap, nearest);
                assert!(first < 5 && second < 5 && (0.0..=1.0).contains(&weight), "{wrap:?} {coordinate}");
            }
        }
    }

    #[test]
    fn codes_are_those_of_gltf() {
        let all = WRAPS.into_iter().flat_map(|u| WRAPS.map(|v| [u, v]));
        for sampler in all.flat_map(|wrap| [false, true].map(|nearest| Sampler { wrap, nearest })) {
            assert_eq!(Sampler::from_gltf(sampler.to_gltf()), Some(sampler));
        }
        assert_eq!(Sampler::default().to_gltf(), [10497, 10497, 9729]);
        assert_eq!(Sampler::from_gltf([33071, 33648, 9728]).unwrap().wrap, [Wrap::Clamp, Wrap::Mirror]);
        for wrong in [[0, 10497, 9729], [10497, 1, 9729], [10497, 10497, 9987]] {
            assert_eq!(Sampler::from_gltf(wrong), None);
        }
    }
}
