/** Operations on unit quaternions (x, y, z, w). */
import type { Vector } from '../control/vector';
import type { Rotation } from './pose';

/** Cosine of half an angle above which rotations are interpolated linearly. */
const NEARLY = 0.9995;

/** Rotation of a view with a yaw and a pitch. */
export function rotationOf(yaw: number, pitch: number): Rotation {
  const [sy, cy, sp, cp] = [Math.sin(yaw / 2), Math.cos(yaw / 2), Math.sin(pitch / 2), Math.cos(pitch / 2)];
  return [cy * sp, sy * cp, -sy * sp, cy * cp];
}

/** Upright rotation whose −z points along a direction of any length. */
export function rotationAlong([x, y, z]: Vector): Rotation {
  return rotationOf(Math.atan2(-x, -z), Math.atan2(y, Math.hypot(x, z)));
}

/** Applies a rotation to a vector. */
export function rotated([x, y, z, w]: Rotation, [a, b, c]: Vector): Vector {
  const [tx, ty, tz] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [a + w * tx + y * tz - z * ty, b + w * ty + z * tx - x * tz, c + w * tz + x * ty - y * tx];
}

/** Interpolates spherically along the shorter arc; shares beyond 1 extrapolate. */
export function slerp(from: Rotation, to: Rotation, share: number): Rotation {
  const dot = from.reduce((sum, part, axis) => sum + part * (to[axis] ?? 0), 0);
  const sign = dot < 0 ? -1 : 1;
  let [a, b] = [1 - share, share];
  if (Math.abs(dot) < NEARLY) {
    const angle = Math.acos(Math.abs(dot));
    [a, b] = [Math.sin((1 - share) * angle) / Math.sin(angle), Math.sin(share * angle) / Math.sin(angle)];
  }
  const mixed = from.map((part, axis) => a * part + sign * b * (to[axis] ?? 0));
  const size = Math.hypot(...mixed) || 1;
  return mixed.map((part) => part / size) as unknown as Rotation;
}
