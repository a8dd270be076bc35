/** Destination of a user who wants to go to something in the picture. */
import type { Pose } from './pose';
import { ahead, addScaled, rightOf, upOf, type Vector } from './vector';

/** Eye height above the ground, and greatest height above the ground of a surface to stand on, metres. */
const [EYE_HEIGHT, STEP] = [1.7, 0.5] as const;
/** Distance that the user keeps from other surfaces, metres. */
const BEFORE = 1;
/** Step towards distant surfaces, metres. */
const LEAP = 15;

/**
 * Unit vector along which a pose sees a position in the picture, x and y from the upper left; `height` is the tangent
 * of half the vertical field of view, `ratio` is width divided by height.
 */
export function directionTo(pose: Pose, [x, y]: readonly [number, number], height: number, ratio: number): Vector {
  const across = addScaled(ahead(pose), rightOf(pose.yaw), (2 * x - 1) * height * ratio);
  const [dx, dy, dz] = addScaled(across, upOf(pose), (1 - 2 * y) * height);
  const size = Math.hypot(dx, dy, dz);
  return [dx / size, dy / size, dz / size];
}

/** Place at the eye's own height for a direction; `hit` is the surface point seen there, or null. */
export function placeFor(eye: Vector, direction: Vector, hit: Vector | null): Vector {
  const ground = eye[1] - EYE_HEIGHT;
  if (hit && hit[1] <= ground + STEP) return [hit[0], eye[1], hit[2]];
  const level = Math.hypot(direction[0], direction[2]);
  if (level === 0) return eye;
  const free = hit ? Math.hypot(hit[0] - eye[0], hit[2] - eye[2]) - BEFORE : LEAP;
  const toGround = direction[1] < 0 ? (EYE_HEIGHT * level) / -direction[1] : Number.POSITIVE_INFINITY;
  const away = Math.max(Math.min(free, toGround), 0);
  return [eye[0] + (away * direction[0]) / level, eye[1], eye[2] + (away * direction[2]) / level];
}
