/** CPU version of the morph in shaders/near.ts, and its inverse: the world point that is shown at a place. */
import { subtract, type Vector } from '../control/pose';

/** Parameters of the morph; positions are relative to the centre, in metres. */
export interface Morph {
  /** Position of the eye. */
  readonly user: Vector;
  /** r1 and r2, metres. */
  readonly inner: number;
  readonly radius: number;
  readonly strength: number;
}

/** Greatest number of steps; relative step of the difference quotients; relative error for convergence. */
const [STEPS, SLOPE, FOUND] = [40, 1e-5, 1e-7] as const;

/** Returns the shown position of a point relative to the eye. */
export function shownAt(p: Vector, { user, inner, radius, strength }: Morph): Vector {
  const away = subtract(p, user);
  const rho = Math.hypot(p[0], p[2]);
  if (strength === 1 && rho <= inner) return away;
  const w = strength * (radius > inner ? Math.min(Math.max((radius - rho) / (radius - inner), 0), 1) : 0);
  const [byUser, byCenter] = [Math.hypot(...away), Math.hypot(...p)];
  const [a, b] = [w / Math.max(byUser, 1e-30), (1 - w) / Math.max(byCenter, 1e-30)];
  const mixed: Vector = [a * away[0] + b * p[0], a * away[1] + b * p[1], a * away[2] + b * p[2]];
  const share = (w * byUser + (1 - w) * byCenter) / (Math.hypot(...mixed) || 1);
  return [share * mixed[0], share * mixed[1], share * mixed[2]];
}

/** Returns the point that is shown at a position relative to the eye; null if none is found, as beyond a fold. */
export function pointShownAt(q: Vector, morph: Morph): Vector | null {
  const { user, inner, radius, strength } = morph;
  const near: Vector = [q[0] + user[0], q[1] + user[1], q[2] + user[2]];
  if (strength === 1 && Math.hypot(near[0], near[2]) <= inner) return near;
  if (Math.hypot(q[0], q[2]) >= radius) return q;
  // Starts at the point that either view alone would give, the one with the smaller error first.
  const starts = [near, q].sort((a, b) => size(shownAt(a, morph), q) - size(shownAt(b, morph), q));
  for (const start of starts) {
    const found = solveFrom(start, q, morph);
    if (found) return found;
  }
  return null;
}

/** Newton's method with step halving while the error grows. */
function solveFrom(start: Vector, q: Vector, morph: Morph): Vector | null {
  const most = FOUND * Math.max(Math.hypot(...q), 1);
  let p = start;
  let error = subtract(q, shownAt(p, morph));
  for (let step = 0; step < STEPS && Math.hypot(...error) > most; step++) {
    const move = solve(jacobian(p, morph), error);
    if (!move) return null;
    for (let share = 1; share > 1e-3; share /= 2) {
      const next: Vector = [p[0] + share * move[0], p[1] + share * move[1], p[2] + share * move[2]];
      const left = subtract(q, shownAt(next, morph));
      if (Math.hypot(...left) >= Math.hypot(...error) && share > 2e-3) continue;
      [p, error] = [next, left];
      break;
    }
  }
  return Math.hypot(...error) <= most ? p : null;
}

/** Jacobian of the shown position by central differences, in columns. */
function jacobian(p: Vector, morph: Morph): readonly [Vector, Vector, Vector] {
  const length = SLOPE * Math.max(Math.hypot(...p), 1);
  const along = (axis: number): Vector => {
    const moved = (by: number): Vector => p.map((value, at) => (at === axis ? value + by : value)) as unknown as Vector;
    const [x, y, z] = subtract(shownAt(moved(length), morph), shownAt(moved(-length), morph));
    return [x / (2 * length), y / (2 * length), z / (2 * length)];
  };
  return [along(0), along(1), along(2)];
}

/** Solves a linear system by Cramer's rule; null if it is singular. */
function solve([a, b, c]: readonly [Vector, Vector, Vector], right: Vector): Vector | null {
  const whole = determinant(a, b, c);
  if (!(Math.abs(whole) > 1e-9)) return null;
  return [determinant(right, b, c) / whole, determinant(a, right, c) / whole, determinant(a, b, right) / whole];
}

function determinant(a: Vector, b: Vector, c: Vector): number {
  return (
    a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) + c[0] * (a[1] * b[2] - a[2] * b[1])
  );
}

function size(a: Vector, b: Vector): number {
  return Math.hypot(...subtract(a, b));
}
