/**
 * Rule for cutting edges of large triangles. A vertex shader morphs vertices but keeps edges straight, so the middle of
 * a long edge is shown in the wrong place. The rule depends only on the two ends of an edge: all triangles that share
 * an edge cut it at the same point, so no cracks open.
 *
 * All positions are relative to the centre O. With v = U−O, |v| ≤ u, A = |P−U|, B = |P−O|, the weight w of the user's
 * view, κ = w(1−w) and d the direction in which P is shown,
 *
 *   Q − U = (P−O) − w v + κ(A−B)(d_O − d_U) + a part along d and of higher order in u/D,
 *
 * where P−O is linear. Seen from D = B − u, the second derivatives of the other terms are at most those of
 * `errorFactorsAt` (rust/core/src/tessellate/bound.rs derives them with greater factors, which were never reached). The
 * error of an edge of length ℓ is at most a sixth of them times ℓ². The weight falls from 1 at nR to 0 at R, so its
 * slope W = 1/((1−n)R) changes there. The error of an edge whose distances from the axis differ by c is then W c/4
 * times u/D, wherever R is during growth. So edges are cut at circles about the axis with spacing c, among them the
 * circles of the radii at which R rests.
 */
import type { Growth } from '../messages';

export type Rule = ReturnType<typeof createRule>;

/** Growth for which no triangle is large. */
export const NO_GROWTH: Growth = { radii: [], nearShare: 0.5, reach: 0 };

export type Vector = readonly [number, number, number];

/** Greatest error while R rests, radians: half a pixel of a picture with 75° and 1,080 rows. */
export const TOLERANCE = 7e-4;
/** Share of the error that changes of the slope may cause; the curvature of the morph may cause the rest. */
const RANGE_SHARE = 0.3;
/** Greatest distance from O of users for whom the error is bounded while R rests, as a share of a point's ρ. */
const REACH_AT_REST = 0.1;
/** Greatest value of `reach` that is used, as a share of the first radius. */
const MAX_REACH = 0.35;
/** Least D as a share of B, so that edges very near the user are not cut ever more finely. */
const MIN_DISTANCE_SHARE = 0.75;
/** Spacing c that is always acceptable while R grows, as a share of ρ. */
const WIDTH_SHARE = 0.03;
/** Spacing c that is always acceptable while R rests, as a share of ρ. */
const WIDTH_SHARE_AT_REST = 0.004;
/** Length of the shortest edge that is cut, as a share of its ρ. */
const SHORTEST_SHARE = 0.002;
/** Distance by which an edge may cross a circle without being cut, as a share of the radius. */
const OVERSHOOT = 5e-4;
/** Least distance from the axis that the bounds assume, as a share of the first radius. */
const CORE_SHARE = 1 / 8;
/** Factor by which other points of a triangle may be nearer to the axis and to O than its edge. */
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

  /** Greatest slope of the weight, for all R, of points at least `rho` metres from the axis. */
  function weightSlopeAt(rho: number): number {
    return rho < outer ? 1 / ((1 - nearShare) * Math.max(first, rho)) : 0;
  }

  /** Greatest c of an edge along which the slope changes, for users at most u metres from O. */
  function maxKinkRange(rho: number, distance: number, u: number): number {
    const q = u / distanceToUser(distance, u);
    return (4 * RANGE_SHARE * tolerance) / (q * (1 + q / 2) * (weightSlopeAt(rho) || 1e-9));
  }

  /** Factors of c², squared horizontal length and squared length, whose sum is six times an edge's error, radians. */
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
    /** Radius beyond which no edge is cut: there the picture is that from O, in which flat surfaces stay flat. */
    outer,
    /** Whether no edge of at most `longest` metres is cut; the other arguments bound its distance from axis and O. */
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
    /**
     * Share of the way from a to b at which their edge is cut; 0 for no cut. Callers must order the ends consistently.
     */
    cutShare(a: Vector, b: Vector): number {
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
        const share = circleCut(circles, [a[0], a[2]], [dx, dz], [nearest, farthest]);
        // An edge beyond the outermost circle that reaches only slightly inside is not cut.
        if (share > 0 || farthest > outer * (1 + OVERSHOOT)) return share;
      }
      const [byRange, byHorizontal, byLength] = errorFactorsAt(rho, distance, u, isFlat);
      const error = byRange * range * range + byHorizontal * horizontal * horizontal + byLength * length * length;
      const parts = Math.min(Math.ceil(Math.sqrt(error / maxLengthError) - 1e-9), Math.floor(length / shortest));
      return parts >= 2 ? Math.floor(parts / 2) / parts : 0;
    },
  };
}

/** D: least distance between a point at `distance` metres from O and users at most u metres from O. */
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

/** Distance of the origin from the segment between (x, y, z) and (x + dx, y + dy, z + dz). */
function segmentDistance([x, y, z]: Vector, [dx, dy, dz]: Vector): number {
  const squared = dx * dx + dy * dy + dz * dz;
  const share = squared > 0 ? Math.min(Math.max(-(x * dx + y * dy + z * dz) / squared, 0), 1) : 0;
  return Math.hypot(x + share * dx, y + share * dy, z + share * dz);
}

/**
 * Share of a segment in the ground plane at which it crosses a circle; 0 if it crosses none. If it crosses several, the
 * circle is used whose number has the most factors of two, so that edges of a triangle are cut at the same circle.
 */
function circleCut(
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

/** Counts the entries of an ascending list that are below a value. */
function countBelow(numbers: readonly number[], value: number): number {
  let [low, high] = [0, numbers.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((numbers[middle] as number) < value) low = middle + 1;
    else high = middle;
  }
  return low;
}
