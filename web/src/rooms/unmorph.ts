/** Morph on the CPU, as in shaders/scene.ts, and its inverse. */
import { Matrix3, Vector3, type Vector3Tuple } from 'three';
import { addScaled, clamp, subtract, type Vector } from '../control/pose';

/** Parameters of the morph; positions are relative to the centre, in metres. */
export interface Morph {
  /** Position of the eye. */
  readonly user: Vector;
  /** r1 and r2, metres. */
  readonly inner: number;
  readonly radius: number;
  readonly strength: number;
}

/** Greatest number of Newton steps, and least length of a step that is halved, as a fraction of the whole step. */
const [MAX_STEPS, MIN_FRACTION] = [40, 1e-3] as const;
/** Step of difference quotients, and tolerated error, both relative to the point's distance. */
const [RELATIVE_STEP, RELATIVE_ERROR] = [1e-5, 1e-7] as const;

/** Returns the position at which a point is shown, relative to the eye. */
export function applyMorph(p: Vector, { user, inner, radius, strength }: Morph): Vector {
  const offset = subtract(p, user);
  const rho = Math.hypot(p[0], p[2]);
  if (strength === 1 && rho <= inner) return offset;
  const w = strength * (radius > inner ? clamp((radius - rho) / (radius - inner), 0, 1) : 0);
  const [userRange, centerRange] = [Math.hypot(...offset), Math.hypot(...p)];
  const [a, b] = [w / Math.max(userRange, 1e-30), (1 - w) / Math.max(centerRange, 1e-30)];
  const mixed: Vector = [a * offset[0] + b * p[0], a * offset[1] + b * p[1], a * offset[2] + b * p[2]];
  const scale = (w * userRange + (1 - w) * centerRange) / (Math.hypot(...mixed) || 1);
  return [scale * mixed[0], scale * mixed[1], scale * mixed[2]];
}

/** Returns the point that is shown at a position relative to the eye; null if none is found, as in a fold. */
export function invertMorph(q: Vector, morph: Morph): Vector | null {
  const { user, inner, radius, strength } = morph;
  const unmorphed = addScaled(q, user, 1);
  if (strength === 1 && Math.hypot(unmorphed[0], unmorphed[2]) <= inner) return unmorphed;
  if (Math.hypot(q[0], q[2]) >= radius) return q;
  // Starts at the points that the user's view alone and the centre's view alone would show; smaller error first.
  const error = (start: Vector): number => Math.hypot(...subtract(applyMorph(start, morph), q));
  const [first, second] = error(unmorphed) <= error(q) ? [unmorphed, q] : [q, unmorphed];
  return solveFrom(first, q, morph) ?? solveFrom(second, q, morph);
}

/** Newton's method with step halving while the error grows. */
function solveFrom(start: Vector, q: Vector, morph: Morph): Vector | null {
  const maxError = RELATIVE_ERROR * Math.max(Math.hypot(...q), 1);
  let p = start;
  let error = subtract(q, applyMorph(p, morph));
  for (let step = 0; step < MAX_STEPS && Math.hypot(...error) > maxError; step++) {
    const matrix = jacobian(p, morph);
    if (!(Math.abs(matrix.determinant()) > 1e-9)) return null;
    const move = new Vector3(...error).applyMatrix3(matrix.invert()).toArray() as Vector3Tuple;
    for (let fraction = 1; fraction > MIN_FRACTION; fraction /= 2) {
      const next = addScaled(p, move, fraction);
      const nextError = subtract(q, applyMorph(next, morph));
      const isLast = fraction <= 2 * MIN_FRACTION;
      if (Math.hypot(...nextError) >= Math.hypot(...error) && !isLast) continue;
      [p, error] = [next, nextError];
      break;
    }
  }
  return Math.hypot(...error) <= maxError ? p : null;
}

/** Jacobian of the shown position by central differences. */
function jacobian(p: Vector, morph: Morph): Matrix3 {
  const step = RELATIVE_STEP * Math.max(Math.hypot(...p), 1);
  const columns = ([[1, 0, 0], [0, 1, 0], [0, 0, 1]] as const).map((axis) => {
    const [ahead, behind] = [applyMorph(addScaled(p, axis, step), morph), applyMorph(addScaled(p, axis, -step), morph)];
    return subtract(ahead, behind).map((difference) => difference / (2 * step));
  });
  return new Matrix3().fromArray(columns.flat());
}
