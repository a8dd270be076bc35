/**
 * Rule for cutting edges of large triangles. A vertex shader morphs vertices and keeps edges straight, so long edges
 * are shown in the wrong place. The rule depends only on the two ends of an edge: all triangles at an edge cut it
 * alike, and no crack opens.
 *
 * All positions are relative to the centre O. With v = U−O, |v| ≤ u, A = |P−U|, B = |P−O|, the weight w of the user's
 * view, κ = w(1−w) and d the direction in which P is shown,
 *
 *   Q − U = (P−O) − w v + κ(A−B)(d_O − d_U) + a part along d and of higher order in u/D,
 *
 * where P−O is linear. Seen from D = B − u, the second derivatives of the other terms are at most those of
 * `errorFactorsAt` (rust/core/src/tessellate/bound.rs derives them, with greater factors, which were never reached); an
 * edge of length ℓ is off by a sixth of them times ℓ². The weight falls from 1 at nR to 0 at R, so its slope W =
 * 1/((1−n)R) changes there: an edge whose distances from the axis differ by c is off by W c/4 times u/D, wherever R is
 * during growth. So edges are cut at circles about the axis with spacing c; the radii at which R rests are among them.
 */
import type { Growth } from '../messages';

export type Rule = ReturnType<typeof createRule>;

/** Growth for which no triangle is large. */
export const NO_GROWTH: Growth = { radii: [], nearShare: 0.5, reach: 0 };

export type Vector = readonly [number, number, number];

/** Error where R rests, radians: half a pixel of a picture of 75° with 1,080 rows. */
export const TOLERANCE = 7e-4;
/** Share of the error for edges along the radius; the rest is for their lengths. */
const RANGE_SHARE = 0.3;
/** Greatest distance of users for whom the error is bounded where R rests, as a share of a point's ρ. */
const REACH_AT_REST = 0.1;
/** Greatest share of the first radius for which `reach` counts. */
const MAX_REACH = 0.35;
/** Least D as a share of B: points nearer to the user than to the centre are not cut more finely. */
const MIN_DISTANCE_SHARE = 0.75;
/** Share of ρ up to which c is acceptable for every user while R grows. */
const WIDTH_SHARE = 0.03;
/** Share of ρ up to which c is acceptable for every user where R rests. */
const WIDTH_SHARE_AT_REST = 0.004;
/** Length of the shortest edge that is cut, as a share of its ρ. */
const SHORTEST_SHARE = 0.002;
/** Tolerated overshoot of a circle, as a share of its radius. */
const OVERSHOOT = 5e-4;
/** Share of the first radius that is the least distance from the axis in the bounds. */
const CORE_SHARE = 1 / 8;
/** Factor by which points of a triangle may be nearer to the axis and to O than its edge. */
const SPREAD = 1.1;

export function createRule({ radii, nearShare, reach }: Growth, tolerance = TOLERANCE) {
  const first = radii[0] ?? 0;
  const toleranceFactor = tolerance / TOLERANCE;
  const outer = radii.at(-1) ?? 0;
  const inner = nearShare * first;
  const growthReach = Math.min(reach, MAX_REACH * first);
  const kinkCircles = [...new Set(radii.flatMap((radius) => [nearShare * radius, radius]))]
    .filter((radius) => radius > CORE_SHARE * first)
    .sort((a, b) => a - b);
  const maxRangeAtRest = (rho: number, distance: number, u: number): number =>
    Math.max(maxKinkRange(rho, distance, u), toleranceFactor * WIDTH_SHARE_AT_REST * rho);
  const maxRangeInGrowth = (rho: number, distance: number): number =>
    Math.max(maxKinkRange(rho, distance, growthReach), toleranceFactor * WIDTH_SHARE * rho);
  const fineCircles = subdivideRadii(kinkCircles, (rho) => maxRangeInGrowth(rho, rho));

  /** Greatest slope of the weight for points from a distance from the axis on, for all R. */
  function weightSlopeAt(rho: number): number {
    return rho < outer ? 1 / ((1 - nearShare) * Math.max(first, rho)) : 0;
  }

  /** Greatest c of an edge across which the slope changes, for users at a distance u. */
  function maxKinkRange(rho: number, distance: number, u: number): number {
    const q = u / distanceToUser(distance, u);
    return (4 * RANGE_SHARE * tolerance) / (q * (1 + q / 2) * (weightSlopeAt(rho) || 1e-9));
  }

  /** Factors of c², of an edge's squared horizontal length and of its squared length in six times its error, radians. */
  function errorFactorsAt(rho: number, distance: number, u: number, isFlat: boolean): Vector {
    const leastDistance = distanceToUser(distance, u);
    const q = u / leastDistance;
    const slope = isFlat ? 0 : weightSlopeAt(rho);
    const mixed = ((8 / 3) * q * q * slope) / leastDistance;
    const byRange = q * q * slope * slope + 0.75 * mixed;
    const byHorizontal = (q * (1 + q / 2) * slope) / Math.max(rho, CORE_SHARE * first);
    const byLength = (0.3 * q * q) / (leastDistance * leastDistance) + mixed / 3;
    return [byRange, byHorizontal, byLength];
  }

  const maxLengthError = 6 * tolerance * (1 - RANGE_SHARE);
  const userDistanceAt = (rho: number): number => Math.max(growthReach, REACH_AT_REST * rho);
  const shortestAt = (rho: number): number => SHORTEST_SHARE * Math.max(rho, CORE_SHARE * first);

  return {
    /** Radius beyond which no edge is cut: everything there is shown as O sees it, so flat surfaces stay flat. */
    outer,
    /** Whether no edge up to a length is cut, by the distances of its points from the axis and the least one from O. */
    isUncut(longest: number, [nearest, farthest]: readonly [number, number], distance: number): boolean {
      if (nearest >= outer || longest <= shortestAt(nearest)) return true;
      const [rho, leastDistance] = [nearest / SPREAD, distance / SPREAD];
      const isFlat = farthest <= inner;
      const u = userDistanceAt(farthest);
      const [byRange, byHorizontal, byLength] = errorFactorsAt(rho, leastDistance, u, isFlat);
      if ((byRange + byHorizontal + byLength) * longest * longest > maxLengthError) return false;
      if (isFlat || longest <= maxRangeAtRest(rho, leastDistance, u)) return true;
      const isAtKink = countBelow(kinkCircles, rho) < countBelow(kinkCircles, farthest);
      return !isAtKink && longest <= maxRangeInGrowth(rho, leastDistance);
    },
    /** Share of the way from a to b at which their edge is cut, 0 for no cut. Callers order the ends consistently. */
    share(a: Vector, b: Vector): number {
      const [dx, dy, dz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
      const [horizontal, length] = [Math.hypot(dx, dz), Math.hypot(dx, dy, dz)];
      const nearest = segmentDistance([a[0], 0, a[2]], [dx, 0, dz]);
      const shortest = shortestAt(nearest);
      if (nearest >= outer * (1 - OVERSHOOT) || length <= shortest) return 0;
      const farthest = Math.max(Math.hypot(a[0], a[2]), Math.hypot(b[0], b[2]));
      const isFlat = farthest <= inner * (1 + OVERSHOOT);
      const range = farthest - nearest;
      const [rho, distance] = [nearest / SPREAD, segmentDistance(a, [dx, dy, dz]) / SPREAD];
      const u = userDistanceAt(nearest);
      if (!isFlat && range > maxRangeAtRest(rho, distance, u)) {
        const circles = range > maxRangeInGrowth(rho, distance) ? fineCircles : kinkCircles;
        const cutShare = cutAt(circles, [a[0], a[2]], [dx, dz], [nearest, farthest]);
        // An edge that overshoots the outermost circle only slightly is practically beyond it.
        if (cutShare > 0 || farthest > outer * (1 + OVERSHOOT)) return cutShare;
      }
      const [byRange, byHorizontal, byLength] = errorFactorsAt(rho, distance, u, isFlat);
      const error = byRange * range * range + byHorizontal * horizontal * horizontal + byLength * length * length;
      const parts = Math.min(Math.ceil(Math.sqrt(error / maxLengthError) - 1e-9), Math.floor(length / shortest));
      return parts >= 2 ? Math.floor(parts / 2) / parts : 0;
    },
  };
}

/** D: least distance of a point from users at a distance u from O. */
function distanceToUser(distance: number, u: number): number {
  return Math.max(distance - u, MIN_DISTANCE_SHARE * distance, 1e-9);
}

/** Subdivides the intervals between ascending radii into steps of at most `spacing` metres. */
function subdivideRadii(radii: readonly number[], spacing: (rho: number) => number): number[] {
  return radii.flatMap((start, number) => {
    const end = radii[number + 1] ?? start;
    const steps = [0];
    for (let rho = start; rho < end; ) {
      rho += spacing(rho);
      steps.push(rho - start);
    }
    // The last step would pass the end; all steps are scaled down, because a narrow band would need narrow triangles.
    const share = (end - start) / (steps.at(-1) || 1);
    return steps.slice(0, Math.max(steps.length - 1, 1)).map((step) => start + share * step);
  });
}

/** Distance of the origin from a segment with a start (x, y, z) and an extent (dx, dy, dz). */
function segmentDistance([x, y, z]: Vector, [dx, dy, dz]: Vector): number {
  const squared = dx * dx + dy * dy + dz * dz;
  const share = squared > 0 ? Math.min(Math.max(-(x * dx + y * dy + z * dz) / squared, 0), 1) : 0;
  return Math.hypot(x + share * dx, y + share * dy, z + share * dz);
}

/**
 * Crossing of a segment in the ground plane with one of the circles that it passes: the one whose number has the most
 * factors of two, so that edges of a triangle are cut at the same circle. 0 if it passes none.
 */
function cutAt(
  circles: readonly number[],
  [x, z]: readonly [number, number],
  [dx, dz]: readonly [number, number],
  [nearest, farthest]: readonly [number, number],
): number {
  const low = countBelow(circles, nearest * (1 + OVERSHOOT));
  const high = countBelow(circles, farthest * (1 - OVERSHOOT));
  if (high <= low) return 0;
  const power = 31 - Math.clz32(low ^ high);
  const radius = circles[((high >> power) << power) - 1] as number;
  const squared = dx * dx + dz * dz;
  const projection = x * dx + z * dz;
  const root = Math.sqrt(projection * projection - squared * (x * x + z * z - radius * radius));
  const shares = [(-projection - root) / squared, (-projection + root) / squared];
  const inner = shares.filter((share) => share > 0 && share < 1);
  return inner.sort((a, b) => Math.abs(a - 0.5) - Math.abs(b - 0.5))[0] ?? 0;
}

/** Number of entries of an ascending list below a value. */
function countBelow(numbers: readonly number[], value: number): number {
  let [low, high] = [0, numbers.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((numbers[middle] as number) < value) low = middle + 1;
    else high = middle;
  }
  return low;
}
