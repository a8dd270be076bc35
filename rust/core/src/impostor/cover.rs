//! Covering a tile's texels by as few planes as pay: a quadtree whose nodes choose between a few planes and their
//! children, by the number of quads, the number of texels and their errors.

use glam::{DMat3, DVec3};

use super::plane::Plane;
use super::strips::cells;
use super::tile::{APRON, SIDE, Texel, Tile, column_and_row};

/// Planes that a node with children may have; more are cheaper as four children.
const MAX_PLANES: usize = 5;
/// Width of the smallest nodes, texels.
const MIN_SIDE: usize = 4;
/// Texels whose planes are tried for each plane of a node.
const TRIED: usize = 8;
/// Greatest ratio of inverse depths within a rectangle: a plane that reaches almost to infinity there is refused.
const MAX_RATIO: f64 = 4.0;
/// Cost, in texels, of a texel that is shown at the end of its interval; it falls with the square of the error.
const ERROR_COST: f64 = 2.0;
/// Part of a texel's gain that is lost, while planes are compared, if the texel is shown at the end of its interval.
const ERROR_LOSS: f64 = 0.3;
/// Cost of two triangles in texels of the atlas: about 25 bytes of geometry against 0.4 bytes a texel.
const CELL_COST: f64 = 60.0;

/// Texels of a tile that one plane shows.
#[derive(Clone, Debug)]
pub struct Cover {
    /// The plane.
    pub plane: Plane,
    /// Texels, `row * SIDE + column` in the tile without its apron, ascending.
    pub texels: Vec<u16>,
}

/// A square of a tile, texels.
#[derive(Clone, Copy)]
struct Node {
    left: usize,
    top: usize,
    side: usize,
}

impl Node {
    fn rectangle(self) -> [usize; 4] {
        [self.left, self.top, self.left + self.side, self.top + self.side]
    }

    fn children(self) -> [Self; 4] {
        let side = self.side / 2;
        [(0, 0), (side, 0), (0, side), (side, side)].map(|(x, y)| Self { left: self.left + x, top: self.top + y, side })
    }
}

/// Returns planes that show each wanted texel of a tile exactly once.
pub fn cover(tile: &Tile) -> Vec<Cover> {
    merge(tile, solve(tile, Node { left: 0, top: 0, side: SIDE }).1)
}

/// Joins covers, also of different nodes, where one plane shows both and one rectangle costs less than two.
fn merge(tile: &Tile, covers: Vec<Cover>) -> Vec<Cover> {
    let mut order: Vec<(f64, Cover)> =
        covers.into_iter().map(|cover| (cost_of(tile, &cover.plane, &cover.texels), cover)).collect();
    loop {
        order.sort_by_key(|(_, cover)| std::cmp::Reverse(cover.texels.len()));
        let mut merged: Vec<(f64, Cover)> = Vec::with_capacity(order.len());
        let before = order.len();
        for (cost, cover) in order {
            let best = merged
                .iter()
                .enumerate()
                .filter_map(|(n, (other_cost, other))| {
                    let (joined_cost, joined) = join(tile, other, &cover, cost + other_cost)?;
                    Some((joined_cost - cost - other_cost, n, joined_cost, joined))
                })
                .min_by(|a, b| a.0.total_cmp(&b.0));
            match best {
                Some((_, n, joined_cost, joined)) => merged[n] = (joined_cost, joined),
                None => merged.push((cost, cover)),
            }
        }
        if merged.len() == before {
            return merged.into_iter().map(|(cost, cover)| refine(tile, cost, cover)).collect();
        }
        order = merged;
    }
}

/// Returns a cover with its cheapest plane: its present one, one of a few texels, or a fitted one.
fn refine(tile: &Tile, cost: f64, cover: Cover) -> Cover {
    let planes = tried(tile, &cover.texels).map(|texel| texel.plane).chain(fit(tile, &cover.texels));
    match cheapest(tile, planes, &cover.texels, cost) {
        Some((_, plane)) => Cover { plane, ..cover },
        None => cover,
    }
}

/// Returns a cover of the texels of two, and its cost; `None` if no plane shows both or the cost is not below `limit`.
fn join(tile: &Tile, a: &Cover, b: &Cover, limit: f64) -> Option<(f64, Cover)> {
    let [one, two] = [rectangle(&a.texels), rectangle(&b.texels)];
    let both = [one[0].min(two[0]), one[1].min(two[1]), one[2].max(two[2]), one[3].max(two[3])];
    if CELL_COST + outer_area(both) >= limit {
        return None;
    }
    let mut texels = [&a.texels[..], &b.texels[..]].concat();
    texels.sort_unstable();
    let planes = [a.plane, b.plane].into_iter().chain(fit(tile, &texels));
    cheapest(tile, planes, &texels, limit).map(|(cost, plane)| (cost, Cover { plane, texels }))
}

/// Returns the plane that shows all texels at the least cost, and the cost; `None` if no plane does so below `limit`.
fn cheapest(tile: &Tile, planes: impl Iterator<Item = Plane>, texels: &[u16], limit: f64) -> Option<(f64, Plane)> {
    let around = rectangle(texels);
    let fits = planes
        .filter(|plane| is_tame(tile, around, plane) && texels.iter().all(|&texel| shows(tile, plane, texel)))
        .map(|plane| (cost_of(tile, &plane, texels), plane));
    fits.filter(|(cost, _)| *cost < limit).min_by(|a, b| a.0.total_cmp(&b.0))
}

/// Returns some of the texels, evenly chosen.
fn tried<'a>(tile: &'a Tile, texels: &'a [u16]) -> impl Iterator<Item = &'a Texel> {
    let count = TRIED.min(texels.len());
    (0..count).map(move |n| tile_texel(tile, texels[(2 * n + 1) * texels.len() / (2 * count)]))
}

fn outer_area([left, top, right, bottom]: [usize; 4]) -> f64 {
    ((right - left + 2 * APRON) * (bottom - top + 2 * APRON)) as f64
}

fn solve(tile: &Tile, node: Node) -> (f64, Vec<Cover>) {
    let texels = wanted_texels(tile, node);
    if texels.is_empty() {
        return (0.0, Vec::new());
    }
    let is_least = node.side <= MIN_SIDE;
    let own = planes(tile, node, texels, if is_least { usize::MAX } else { MAX_PLANES });
    let cost = own
        .as_ref()
        .map_or(f64::INFINITY, |covers| covers.iter().map(|cover| cost_of(tile, &cover.plane, &cover.texels)).sum());
    let is_full = |covers: &Vec<Cover>| covers.len() == 1 && 4 * covers[0].texels.len() >= 3 * node.side * node.side;
    if let Some(covers) = own.as_ref().filter(|covers| is_least || is_full(covers) && cost < FULL_COST * area(node)) {
        return (cost, covers.clone());
    }
    let mut children = (0.0, Vec::new());
    for child in node.children() {
        let (child_cost, covers) = solve(tile, child);
        children.0 += child_cost;
        children.1.extend(covers);
    }
    match own {
        Some(covers) if cost <= children.0 => (cost, covers),
        _ => children,
    }
}

/// Cost by area at which the children of a full node with one plane are not tried.
const FULL_COST: f64 = 1.25;

fn area(node: Node) -> f64 {
    (node.side * node.side) as f64
}

fn wanted_texels(tile: &Tile, node: Node) -> Vec<u16> {
    let mut texels = Vec::new();
    for row in node.top..node.top + node.side {
        for column in node.left..node.left + node.side {
            if tile.texel_inside(column, row).kept {
                texels.push((row * SIDE + column) as u16);
            }
        }
    }
    texels
}

/// Covers texels greedily by the plane that shows most of the remaining ones; `None` if more than `limit` are needed.
fn planes(tile: &Tile, node: Node, mut texels: Vec<u16>, limit: usize) -> Option<Vec<Cover>> {
    let mut covers = Vec::new();
    while !texels.is_empty() {
        if covers.len() == limit {
            return None;
        }
        let plane = best_plane(tile, node, &texels);
        let (shown, rest): (Vec<u16>, Vec<u16>) = texels.into_iter().partition(|&texel| shows(tile, &plane, texel));
        covers.push(Cover { plane, texels: shown });
        texels = rest;
    }
    Some(covers)
}

fn tile_texel(tile: &Tile, number: u16) -> &Texel {
    let (column, row) = column_and_row(number);
    tile.texel_inside(column, row)
}

#[inline]
fn shows(tile: &Tile, plane: &Plane, number: u16) -> bool {
    let (column, row) = column_and_row(number);
    let texel = tile.texel_inside(column, row);
    let w = plane.w(tile.u(column), tile.v(row));
    texel.least <= w && w <= texel.greatest
}

/// Returns the plane that shows most texels and shows them best: of some texels' own planes, planes of constant depth and planes fitted to
/// what these show. Shows at least one.
fn best_plane(tile: &Tile, node: Node, texels: &[u16]) -> Plane {
    let gain = |plane: &Plane, texel: u16| 1.0 - ERROR_LOSS * square_error(tile, plane, texel);
    let gained = |plane: &Plane| {
        let shown = texels.iter().filter(|&&texel| shows(tile, plane, texel));
        shown.map(|&texel| gain(plane, texel)).sum::<f64>()
    };
    let better = |best: (f64, Plane), plane: Plane| {
        let sum = if is_tame(tile, node.rectangle(), &plane) { gained(&plane) } else { 0.0 };
        if sum > best.0 { (sum, plane) } else { best }
    };
    let planes = tried(tile, texels).flat_map(|texel| [texel.plane, Plane::frontal(texel.w)]);
    let best = planes.fold((0.0, Plane::frontal(0.0)), better);
    let shown: Vec<u16> = texels.iter().copied().filter(|&texel| shows(tile, &best.1, texel)).collect();
    fit(tile, &shown).map_or(best, |plane| better(best, plane)).1
}

/// Returns the square of a plane's error at a texel that it shows, as a share of the allowed error, 0 to 1.
fn square_error(tile: &Tile, plane: &Plane, number: u16) -> f64 {
    let (column, row) = column_and_row(number);
    let texel = tile.texel_inside(column, row);
    let off = plane.w(tile.u(column), tile.v(row)) - texel.w;
    let allowed = if off > 0.0 { texel.greatest - texel.w } else { texel.w - texel.least };
    (off / allowed).powi(2)
}

/// Returns whether a plane stays at usable depths over the whole rectangle and a texel around it.
fn is_tame(tile: &Tile, [left, top, right, bottom]: [usize; 4], plane: &Plane) -> bool {
    let [left, top, right, bottom] = [left as f64 - 1.0, top as f64 - 1.0, right as f64 + 1.0, bottom as f64 + 1.0];
    let corners = [(left, top), (right, top), (left, bottom), (right, bottom)]
        .map(|(x, y)| plane.w(tile.edge_u(x), tile.edge_v(y)));
    let (low, high) = corners.iter().fold((f64::INFINITY, 0.0f64), |(low, high), &w| (low.min(w), high.max(w)));
    low > 0.0 && high <= MAX_RATIO * low
}

/// Returns the plane of least squares through the depths of texels, weighted by the width of their intervals; `None` if
/// they lie on a line.
fn fit(tile: &Tile, texels: &[u16]) -> Option<Plane> {
    if texels.len() < 3 {
        return None;
    }
    let (mut products, mut sum) = (DMat3::ZERO, DVec3::ZERO);
    for &number in texels {
        let (column, row) = column_and_row(number);
        let texel = tile.texel_inside(column, row);
        let weight = 1.0 / (texel.greatest - texel.least).max(1e-12).powi(2);
        let terms = DVec3::new(1.0, tile.u(column), tile.v(row));
        products += DMat3::from_cols(terms * terms.x, terms * terms.y, terms * terms.z) * weight;
        sum += terms * texel.w * weight;
    }
    let plane = products.inverse() * sum;
    plane.is_finite().then(|| Plane(plane.to_array()))
}

/// Returns the cost of texels on a plane: of triangles, of the atlas, and of errors.
fn cost_of(tile: &Tile, plane: &Plane, texels: &[u16]) -> f64 {
    let rectangle = rectangle(texels);
    let cells = cells(plane, tile, rectangle.map(|edge| edge as isize));
    let errors: f64 = texels.iter().map(|&texel| square_error(tile, plane, texel)).sum();
    CELL_COST * (cells[0] * cells[1]) as f64 + outer_area(rectangle) + ERROR_COST * errors
}

/// Returns the rectangle around texels: left, top, right and bottom, of which the last two are not part of it.
pub fn rectangle(texels: &[u16]) -> [usize; 4] {
    texels.iter().fold([SIDE, SIDE, 0, 0], |[left, top, right, bottom], &number| {
        let (column, row) = column_and_row(number);
        [left.min(column), top.min(row), right.max(column + 1), bottom.max(row + 1)]
    })
}
