/** The user's floor in the world, and the head above it; plain arithmetic without a headset. */
import { type Bounds, within } from './limit';
import type { Pose } from './pose';
import { type Vector, wrapped } from './vector';

/** Where the origin of the headset's space lies in the world, metres, and how it is turned about the vertical axis. */
export interface Floor {
  readonly position: Vector;
  readonly yaw: number;
}

/** The head in the headset's space: metres from a point of the floor, and where it looks, radians. */
export type Head = Pose;

/** Metres from the floor to the eyes of somebody for whom a pose of the page stands. */
export const EYE_HEIGHT = 1.7;
/** Metres from the middle of the head to an eye, at most. */
export const EYE_APART = 0.04;

/** The point of the world at a point of the headset's space. */
export function worldOf({ position, yaw }: Floor, [x, y, z]: Vector): Vector {
  const [cos, sin] = [Math.cos(yaw), Math.sin(yaw)];
  return [position[0] + cos * x + sin * z, position[1] + y, position[2] - sin * x + cos * z];
}

/** The point of the headset's space at a point of the world. */
export function localOf({ position, yaw }: Floor, [x, y, z]: Vector): Vector {
  return worldOf({ position: [0, 0, 0], yaw: -yaw }, [x - position[0], y - position[1], z - position[2]]);
}

/** The head's pose in the world. */
export function inWorld(floor: Floor, head: Head): Pose {
  return { position: worldOf(floor, head.position), yaw: wrapped(floor.yaw + head.yaw), pitch: head.pitch };
}

/** The floor on which the head is above a point of the ground and looks along a yaw. */
export function floorUnder(ground: Vector, yaw: number, head: Head): Floor {
  const turned = { position: [0, 0, 0], yaw: wrapped(yaw - head.yaw) } as const;
  const [x, , z] = worldOf(turned, head.position);
  return { position: [ground[0] - x, ground[1], ground[2] - z], yaw: turned.yaw };
}

/** The floor after a turn to the left around the head, which stays where it is. */
export function turned(floor: Floor, head: Head, angle: number): Floor {
  const { position, yaw } = inWorld(floor, head);
  return floorUnder([position[0], floor.position[1], position[2]], yaw + angle, head);
}

/** The floor with the head above another point of the world; the height of the floor stays. */
export function moved(floor: Floor, head: Head, [x, , z]: Vector): Floor {
  const [headX, , headZ] = worldOf(floor, head.position);
  const [floorX, floorY, floorZ] = floor.position;
  return { ...floor, position: [floorX + x - headX, floorY, floorZ + z - headZ] };
}

/** The point, or one near it that lies within all of the walls. */
export function inside(point: Vector, bounds: Bounds | null): Vector {
  const walls = bounds?.shown ?? [];
  // Where two walls cross, the way to one of them may lead out of the other.
  return [...walls, ...walls].reduce((place: Vector, wall) => within(place, wall), point);
}

/** The bounds of the middle of a head, so that its eyes stay within others. */
export function headBounds(bounds: Bounds | null): Bounds | null {
  const inner = (limits: Bounds['open']): Bounds['open'] =>
    limits.map((limit) => ({ ...limit, metres: Math.max(limit.metres - EYE_APART, 0) }));
  return bounds && { open: inner(bounds.open), shown: inner(bounds.shown) };
}

/** A pose from a matrix of a headset (columns); a head that looks straight up or down has the yaw of its forehead. */
export function headOf(matrix: ArrayLike<number>): Head {
  const at = (index: number): number => matrix[index] ?? 0;
  const [x, y, z]: Vector = [-at(8), -at(9), -at(10)];
  const isSteep = Math.hypot(x, z) < STEEP;
  const [alongX, alongZ] = isSteep ? [-Math.sign(y) * at(4), -Math.sign(y) * at(6)] : [x, z];
  return {
    position: [at(12), at(13), at(14)],
    yaw: Math.atan2(-alongX, -alongZ),
    pitch: Math.atan2(y, Math.hypot(x, z)),
  };
}

/** Cosine of the pitch below which the horizontal part of a direction has too few digits. */
const STEEP = 0.05;
