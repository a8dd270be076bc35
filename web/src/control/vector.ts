/** Directions of a pose, and clamping of numbers. */
import type { Pose } from './pose';

export type Vector = readonly [number, number, number];

/** Greatest pitch, radians: straight up has no yaw. */
export const STEEPEST = 1.5;

export function bounded(value: number, least: number, greatest: number): number {
  return Math.min(Math.max(value, least), greatest);
}

/** Angle wrapped to [−π, π]. */
export function wrapped(angle: number): number {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}

/** Unit vector along which a pose looks. */
export function ahead({ yaw, pitch }: Pick<Pose, 'yaw' | 'pitch'>): Vector {
  return [-Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), -Math.cos(yaw) * Math.cos(pitch)];
}

/** Horizontal unit vector to the right. */
export function rightOf(yaw: number): Vector {
  return [Math.cos(yaw), 0, -Math.sin(yaw)];
}

/** Unit vector that points up in the picture. */
export function upOf({ yaw, pitch }: Pick<Pose, 'yaw' | 'pitch'>): Vector {
  return [Math.sin(yaw) * Math.sin(pitch), Math.cos(pitch), Math.cos(yaw) * Math.sin(pitch)];
}

/** a + share · b. */
export function addScaled(a: Vector, b: Vector, share: number): Vector {
  return [a[0] + share * b[0], a[1] + share * b[1], a[2] + share * b[2]];
}

export function minus(a: Vector, b: Vector): Vector {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function isSamePose(a: Pose, b: Pose): boolean {
  return a.yaw === b.yaw && a.pitch === b.pitch && a.position.every((value, axis) => value === b.position[axis]);
}
