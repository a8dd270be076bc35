/** View frustum as half-spaces. */
import type { Triple } from '../store/layout';
import { type Camera, cross, directionAt, dot, unit } from './camera';

/** Position of a box relative to a frustum. */
export type Side = 'outside' | 'across' | 'inside';

/** A half-space n·x + d ≥ 0. */
interface Plane {
  readonly normal: Triple;
  readonly offset: number;
}

/** Half-spaces of a picture's sides, and the one in front of the camera. */
export function frustumOf(camera: Camera): readonly Plane[] {
  const { position, width, height } = camera;
  const middle = directionAt(camera, width / 2, height / 2);
  const inside: Triple = [position[0] + middle[0], position[1] + middle[1], position[2] + middle[2]];
  const plane = (normal: Triple, through: Triple): Plane => {
    const own = unit(normal);
    const toward: Triple = [inside[0] - through[0], inside[1] - through[1], inside[2] - through[2]];
    const turned: Triple = dot(own, toward) < 0 ? [-own[0], -own[1], -own[2]] : own;
    return { normal: turned, offset: -dot(turned, through) };
  };
  const places = [
    [0, 0],
    [width, 0],
    [width, height],
    [0, height],
  ] as const;
  const corners = places.map(([x, y]) => directionAt(camera, x, y));
  const corner = (n: number): Triple => corners[n % 4] as Triple;
  const sides = [0, 1, 2, 3].map((n) => plane(cross(corner(n), corner(n + 1)), position));
  return [...sides, plane([-camera.back[0], -camera.back[1], -camera.back[2]], position)];
}

/** Position of a cube: outside of one half-space, across one, or inside of all. */
export function sideOf(planes: readonly Plane[], center: Triple, side: number): Side {
  let found: Side = 'inside';
  for (const { normal, offset } of planes) {
    const distance = dot(normal, center) + offset;
    const reach = ((Math.abs(normal[0]) + Math.abs(normal[1]) + Math.abs(normal[2])) * side) / 2;
    if (distance < -reach) return 'outside';
    if (distance < reach) found = 'across';
  }
  return found;
}
