/** Position of the headset's space in the world, its user's head, and destinations; independent of WebXR. */
import { type Bounds, clampToLimit } from './limit';
import { addScaled, ahead, type Pose, rightOf, unit, upOf, type Vector, wrapAngle } from './pose';

/** Origin of the headset's space in the world, metres, and its rotation about the vertical axis. */
export interface Floor {
  readonly position: Vector;
  readonly yaw: number;
}

/** Pose of the head in the headset's space, whose origin is on the floor. */
export type Head = Pose;

/** Height of the eyes above the floor, which poses without a headset assume, metres. */
export const EYE_HEIGHT = 1.7;
/** Greatest distance between the head's centre and an eye, metres. */
export const EYE_OFFSET = 0.04;

/** Converts a point from the headset's space to the world. */
export function worldOf({ position, yaw }: Floor, [x, y, z]: Vector): Vector {
  const [cos, sin] = [Math.cos(yaw), Math.sin(yaw)];
  return [position[0] + cos * x + sin * z, position[1] + y, position[2] - sin * x + cos * z];
}

/** Converts a point from the world to the headset's space. */
export function localOf({ position, yaw }: Floor, [x, y, z]: Vector): Vector {
  return worldOf({ position: [0, 0, 0], yaw: -yaw }, [x - position[0], y - position[1], z - position[2]]);
}

export function worldPose(floor: Floor, head: Head): Pose {
  return { position: worldOf(floor, head.position), yaw: wrapAngle(floor.yaw + head.yaw), pitch: head.pitch };
}

/** Floor that puts the head above a point of the ground, looking along a yaw. */
export function floorUnder(ground: Vector, yaw: number, head: Head): Floor {
  const turned = { position: [0, 0, 0], yaw: wrapAngle(yaw - head.yaw) } as const;
  const [x, , z] = worldOf(turned, head.position);
  return { position: [ground[0] - x, ground[1], ground[2] - z], yaw: turned.yaw };
}

/** Floor after a turn to the left around the head, which stays in place. */
export function turnFloor(floor: Floor, head: Head, angle: number): Floor {
  const { position, yaw } = worldPose(floor, head);
  return floorUnder([position[0], floor.position[1], position[2]], yaw + angle, head);
}

/** Floor that puts the head above another point of the world; the height of the floor does not change. */
export function moveFloor(floor: Floor, head: Head, [x, , z]: Vector): Floor {
  const [headX, , headZ] = worldOf(floor, head.position);
  const [floorX, floorY, floorZ] = floor.position;
  return { ...floor, position: [floorX + x - headX, floorY, floorZ + z - headZ] };
}

/** Moves a point inside all hard limits, approximately. */
export function clampToBounds(point: Vector, bounds: Bounds | null): Vector {
  const walls = bounds?.hard ?? [];
  // Moving inside one limit may move the point out of another one, so each is applied twice.
  return [...walls, ...walls].reduce((place: Vector, wall) => clampToLimit(place, wall), point);
}

/** Returns bounds of the head's centre with which both eyes stay within these bounds. */
export function headBounds(bounds: Bounds | null): Bounds | null {
  const shrink = (limits: Bounds['soft']): Bounds['soft'] =>
    limits.map((limit) => ({ ...limit, metres: Math.max(limit.metres - EYE_OFFSET, 0) }));
  return bounds && { soft: shrink(bounds.soft), hard: shrink(bounds.hard) };
}

/**
 * Returns the pose of a head from a headset's matrix, given by columns. If the head looks straight up or down, the yaw
 * is that of its forehead.
 */
export function headOf(matrix: ArrayLike<number>): Head {
  const at = (index: number): number => matrix[index] ?? 0;
  const [x, y, z]: Vector = [-at(8), -at(9), -at(10)];
  const isSteep = Math.hypot(x, z) < MIN_COSINE;
  const [alongX, alongZ] = isSteep ? [-Math.sign(y) * at(4), -Math.sign(y) * at(6)] : [x, z];
  return {
    position: [at(12), at(13), at(14)],
    yaw: Math.atan2(-alongX, -alongZ),
    pitch: Math.atan2(y, Math.hypot(x, z)),
  };
}

/** Cosine of the pitch below which a direction's horizontal part is too imprecise. */
const MIN_COSINE = 0.05;

/** Greatest height above the ground of a surface on which the user may stand, metres. */
const MAX_STEP_HEIGHT = 0.5;
/** Distance that the user keeps from other surfaces, metres. */
const MIN_DISTANCE = 1;
/** Step towards distant surfaces, metres. */
const FAR_STEP = 15;

/** Shape of a picture: its vertical field of view in degrees, and its width divided by its height. */
export type Frame = Readonly<Record<'fov' | 'aspect', number>>;

/** Unit vector from a pose to a place in the picture, given as shares of width and height from the upper left. */
export function directionTo(pose: Pose, [x, y]: readonly [number, number], { fov, aspect }: Frame): Vector {
  const height = Math.tan((fov * Math.PI) / 360);
  const across = addScaled(ahead(pose), rightOf(pose.yaw), (2 * x - 1) * height * aspect);
  return unit(addScaled(across, upOf(pose), (1 - 2 * y) * height));
}

/** Destination in a direction, at the eye's height; `hit` is the visible surface point in that direction, or null. */
export function destinationOf(eye: Vector, direction: Vector, hit: Vector | null): Vector {
  const ground = eye[1] - EYE_HEIGHT;
  if (hit && hit[1] <= ground + MAX_STEP_HEIGHT) return [hit[0], eye[1], hit[2]];
  const horizontal = Math.hypot(direction[0], direction[2]);
  if (horizontal === 0) return eye;
  const freeDistance = hit ? Math.hypot(hit[0] - eye[0], hit[2] - eye[2]) - MIN_DISTANCE : FAR_STEP;
  const groundDistance = direction[1] < 0 ? (EYE_HEIGHT * horizontal) / -direction[1] : Infinity;
  const step = Math.max(Math.min(freeDistance, groundDistance), 0) / horizontal;
  return [eye[0] + step * direction[0], eye[1], eye[2] + step * direction[2]];
}
