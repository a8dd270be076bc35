//! Descent to the last digit, where data is clean but for rounding. What is left leads along narrow valleys then, in
//! which second derivatives, being squares, lose the digits that tell the way: steps by Gauss and Newton, damped
//! (Marquardt 1963), from columns that are projected off what a and d explain (Kaufman 1975) keep them.

use super::descend::{Found, Limits};
use super::logistic::{Line, Room, Samples};

/// Residuals that are no more than this share of the total are nearly clean.
pub(super) const NEARLY: f64 = 1e-5;
/// Residuals of numbers of size 1 that a descent leaves at rounding, for each sample: ten times that of a number, squared.
const CLEAN: f64 = 1e-29;
/// Steps of one descent: a dozen are usual, hundreds along valleys that bend.
const STEPS: usize = 1000;
/// Of columns of length 1.
const DAMPING: f64 = 1e-3;
/// From one step to the next.
const EASING: f64 = 0.1;
/// After a step that gains nothing.
const STIFFENING: f64 = 8.0;
/// With more, steps are too short to gain anything.
const STIFFEST: f64 = 1e6;
/// A descent ends with a gain that is less, as a share of the residual.
const ENOUGH: f64 = 1e-9;
/// The longest step, in units of τ and of the logarithm of its rise.
const LONGEST: f64 = 2.0;
/// Descents start again where τ is this at the samples' better end: plateaus from near to far.
const ENDS: [f64; 5] = [1.0, -1.0, 3.0, -3.0, -6.0];

/// What a step needs, by (level, ln |rise|).
struct Local {
    line: Line,
    /// One over the lengths of both columns.
    per_length: [f64; 2],
    /// Of both columns' sum and difference, which are at right angles as both have length 1: product with the
    /// residual and square.
    axes: [(f64, f64); 2],
}

impl Local {
    /// `room` holds what `found` was evaluated to.
    fn new(found: &Found, count: usize, room: &Room, columns: &mut Columns) -> Self {
        let Found { line, sums } = *found;
        let away = sums.center();
        let line = line.seen_from(line.origin + away);
        let (p, first) = (&room.p.as_flattened()[..count], &room.first.as_flattened()[..count]);
        let (r, u) = (&room.r.as_flattened()[..count], &room.u.as_flattened()[..count]);
        let Columns { g, level, rise } = columns;
        g.clear();
        g.extend(p.iter().map(|p| p - sums.mean));
        level.clear();
        // p′ = p − p², of which p is projected off: without it tails keep their digits.
        level.extend(p.iter().map(|p| -sums.q * p * p));
        rise.clear();
        rise.extend(first.iter().zip(u).map(|(first, u)| sums.q * line.rise * first * (u - away)));
        let per_length = [level, rise].map(|column| {
            project(column, g, sums.square);
            let length = product(column, column).sqrt();
            let per_length = if length > 0.0 { 1.0 / length } else { 0.0 };
            column.iter_mut().for_each(|number| *number *= per_length);
            per_length
        });
        let axes = [1.0, -1.0].map(|sign| {
            g.clear();
            g.extend(columns.level.iter().zip(&columns.rise).map(|(one, other)| one + sign * other));
            (product(g, r), product(g, g))
        });
        Self { line, per_length, axes }
    }

    /// By how much an undamped step would lower the residual.
    fn promise(&self) -> f64 {
        self.axes.iter().map(|(slope, square)| if *square > 0.0 { slope * slope / square } else { 0.0 }).sum()
    }

    fn step(&self, damping: f64) -> [f64; 2] {
        let [sum, difference] = self.axes.map(|(slope, square)| slope / (square + damping));
        let step = [(sum + difference) * self.per_length[0], (sum - difference) * self.per_length[1]];
        let longest = step[0].abs().max(step[1].abs());
        if longest > LONGEST { step.map(|along| along * (LONGEST / longest)) } else { step }
    }
}

/// Room for columns of all samples.
#[derive(Default)]
struct Columns {
    g: Vec<f64>,
    level: Vec<f64>,
    rise: Vec<f64>,
}

/// Takes off what a and d explain; once more, as the first time leaves rounding of what it takes.
fn project(column: &mut [f64], g: &[f64], square: f64) {
    for _ in 0..2 {
        let mean = column.iter().sum::<f64>() / column.len() as f64;
        column.iter_mut().for_each(|number| *number -= mean);
        let share = if square > 0.0 { product(column, g) / square } else { 0.0 };
        column.iter_mut().zip(g).for_each(|(number, g)| *number -= share * g);
    }
}

fn product(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

/// The best of descents from `best` and from nearer plateaus than it may have strayed to.
pub(super) fn settle_all(samples: &Samples<'_>, limits: &Limits, best: &Found, room: &mut Room) -> Found {
    let mut columns = Columns::default();
    let mut best = settle(samples, limits, best.line, None, room, &mut columns);
    let end = best.line.rise.signum();
    let again = ENDS.map(|level| Line { level, rise: best.line.rise, origin: end });
    for line in again.into_iter()
    /*.chain(starts.iter().map(|start| start.line))*/
    {
        if best.sums.residual <= samples.count * CLEAN {
            break;
        }
        let found = settle(samples, limits, line, Some(&best), room, &mut columns);
        if found.sums.residual < best.sums.residual {
            best = found;
        }
    }
    best
}

/// Goes down from a line until nothing is gained, or until it comes to `rival`.
fn settle(
    samples: &Samples<'_>,
    limits: &Limits,
    line: Line,
    rival: Option<&Found>,
    room: &mut Room,
    columns: &mut Columns,
) -> Found {
    let count = samples.count as usize;
    let mut found = Found::at(samples, limits, line, room);
    let mut local = Local::new(&found, count, room, columns);
    let mut damping = DAMPING;
    for _ in 0..STEPS {
        if rival.is_some_and(|rival| found.leads_to(rival)) || local.promise() <= ENOUGH * found.sums.residual {
            break;
        }
        let step = local.step(damping);
        let line = Line { level: local.line.level + step[0], rise: local.line.rise * step[1].exp(), ..local.line };
        let trial = Found::at(samples, limits, line, room);
        let gain = found.sums.residual - trial.sums.residual;
        if gain > 0.0 {
            let is_done = gain <= ENOUGH * found.sums.residual;
            found = trial;
            if is_done {
                break;
            }
            local = Local::new(&found, count, room, columns);
            damping *= EASING;
        } else {
            // At rounding nothing is gained but by chance.
            damping = STIFFENING * damping.max(1e-12);
            if found.sums.residual <= samples.count * CLEAN || damping > STIFFEST {
                break;
            }
        }
    }
    found
}
