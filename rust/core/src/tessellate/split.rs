//! Splits triangles by the rule of their edges.

use glam::DVec3;

use super::edge::Cut;
use super::rule::Rule;
use super::settings::Precision;
use crate::base::Result;

/// A triangle or a piece of one, with the weights of its corners on the whole triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Positions of its corners.
    pub corners: [DVec3; 3],
    /// Weights of the whole triangle's corners at each corner. One weight of exactly 0 marks an edge, two a corner.
    pub weights: [[f64; 3]; 3],
}

/// Weights of a whole triangle's own corners.
const CORNER_WEIGHTS: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Height of a triangle, relative to its longest edge, below which it covers no pixel.
const MIN_HEIGHT: f64 = 1e-9;

/// Maximum depth of splits. The rule ends long before, but rounding could make an edge reappear.
const MAX_DEPTH: u32 = 192;

/// Number of pieces between two reports.
const PIECES_PER_REPORT: usize = 4096;

type Corner = (DVec3, [f64; 3]);

impl Piece {
    /// Creates a whole triangle.
    pub fn of_triangle(corners: [DVec3; 3]) -> Self {
        Self { corners, weights: CORNER_WEIGHTS }
    }

    /// Returns pieces that cover a triangle; a single piece is the triangle itself. Pieces for which `is_unseen` is
    /// true are omitted. `report` receives the number of new pieces after every few thousand and may stop the split.
    pub fn split(
        self,
        rule: &Rule,
        precision: Precision,
        is_unseen: impl Fn(&[DVec3; 3]) -> bool,
        report: impl Fn(usize) -> Result<()>,
    ) -> Result<Vec<Self>> {
        let (mut pieces, mut pending) = (Vec::new(), vec![(self, 0)]);
        let mut reported = 0;
        while let Some((piece, depth)) = pending.pop() {
            if is_unseen(&piece.corners) {
                continue;
            }
            let parts = if depth < MAX_DEPTH { piece.parts(rule, precision) } else { None };
            match parts {
                Some(parts) => pending.extend(parts.into_iter().map(|part| (part, depth + 1))),
                None => pieces.push(piece),
            }
            if pieces.len() >= reported + PIECES_PER_REPORT {
                report(pieces.len() - reported)?;
                reported = pieces.len();
            }
        }
        Ok(pieces)
    }

    /// Returns the parts after one split; `None` if the rule leaves the piece whole.
    fn parts(&self, rule: &Rule, precision: Precision) -> Option<Vec<Self>> {
        let corner = |i: usize| (self.corners[i], self.weights[i]);
        let [a, b, c] = [corner(0), corner(1), corner(2)];
        let edges = [[a, b, c], [b, c, a], [c, a, b]];
        let cuts = edges.into_iter().filter_map(|edge| cut(rule, precision, edge[0], edge[1]).map(|m| (edge, m)));
        let longest = cuts.max_by(|(_, (_, size)), (_, (_, other))| size.total_cmp(other));
        let parts = if let Some(([a, b, c], (m, _))) = longest {
            vec![[a, m, c], [m, b, c]]
        } else {
            let [s, t, u] = rule.inner_split_point(&self.corners)?;
            let middle = (
                precision.round(a.0 * s + b.0 * t + c.0 * u),
                std::array::from_fn(|i| a.1[i] * s + b.1[i] * t + c.1[i] * u),
            );
            vec![[a, b, middle], [b, c, middle], [c, a, middle]]
        };
        let piece = |corners: [Corner; 3]| Self { corners: corners.map(|c| c.0), weights: corners.map(|c| c.1) };
        Some(parts.into_iter().map(piece).collect())
    }

    /// Returns whether a triangle has no visible area.
    pub fn is_thin([a, b, c]: &[DVec3; 3]) -> bool {
        let [a, b, c] = [*a, *b, *c];
        let longest = (b - a).length_squared().max((c - b).length_squared()).max((a - c).length_squared());
        (b - a).cross(c - a).length() <= MIN_HEIGHT * longest
    }
}

/// Returns the new vertex on an edge, and the edge's size. The ends are ordered, so both triangles get the same bits.
fn cut(rule: &Rule, precision: Precision, a: Corner, b: Corner) -> Option<(Corner, f64)> {
    let (a, b) = if (a.0.x, a.0.y, a.0.z) > (b.0.x, b.0.y, b.0.z) { (b, a) } else { (a, b) };
    let Cut { fraction, size } = rule.cut(a.0, b.0)?;
    let point = precision.round(a.0.lerp(b.0, fraction));
    let weights = std::array::from_fn(|i| a.1[i] + (b.1[i] - a.1[i]) * fraction);
    // A point that rounds to an end would cause endless splits.
    (point != a.0 && point != b.0).then_some(((point, weights), size))
}
