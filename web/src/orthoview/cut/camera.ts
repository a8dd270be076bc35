/** Perspective cameras, their frustums, and the axes of orthographic views. */
import type { Triple } from '../store/layout';

/** Tangents of the angles from the axis to the picture's sides; left and down are negative. */
export type Fov = Readonly<Record<'left' | 'right' | 'down' | 'up', number>>;

export interface Camera {
  readonly position: Triple;
  /** World unit vectors to the right, upwards and backwards. */
  readonly right: Triple;
  readonly up: Triple;
  readonly back: Triple;
  readonly fov: Fov;
  /** Size in pixels. */
  readonly width: number;
  readonly height: number;
}

/** Camera at a pose (radians, yaw to the left, pitch up); `fovY` is the full vertical field of view, radians. */
export function cameraOf(
  { position, yaw, pitch }: { readonly position: Triple; readonly yaw: number; readonly pitch: number },
  fovY: number,
  width: number,
  height: number,
): Camera {
  const [s, c, sp, cp] = [Math.sin(yaw), Math.cos(yaw), Math.sin(pitch), Math.cos(pitch)];
  const up = Math.tan(fovY / 2);
  const right = (up * width) / height;
  return {
    position,
    right: [c, 0, -s],
    up: [s * sp, cp, c * sp],
    back: [s * cp, -sp, c * cp],
    fov: { left: -right, right, down: -up, up },
    width,
    height,
  };
}

/** World direction through a position in the picture (pixels from the upper left); its length along the axis is 1. */
export function directionAt({ right, up, back, fov, width, height }: Camera, x: number, y: number): Triple {
  const tangentX = fov.left + ((fov.right - fov.left) * x) / width;
  const tangentY = fov.up + ((fov.down - fov.up) * y) / height;
  const component = (axis: 0 | 1 | 2): number => tangentX * right[axis] + tangentY * up[axis] - back[axis];
  return [component(0), component(1), component(2)];
}

/** Geometric mean of a pixel's width and height at a distance of 1 m, metres. */
export function pixelSize({ fov, width, height }: Camera): number {
  return Math.sqrt(((fov.right - fov.left) * (fov.up - fov.down)) / (width * height));
}

export function subtract(a: Triple, b: Triple): Triple {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function dot(a: Triple, b: Triple): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: Triple, b: Triple): Triple {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

/** Unit vector of the same direction; up for a zero vector. */
export function unit(vector: Triple): Triple {
  const length = Math.sqrt(dot(vector, vector));
  return length > 0 ? [vector[0] / length, vector[1] / length, vector[2] / length] : [0, 1, 0];
}

export interface Frame {
  /** Unit vectors to the right, upwards and towards the viewer. */
  readonly axes: readonly [Triple, Triple, Triple];
  /** Extents of a unit cube along the axes. */
  readonly extents: Triple;
}

/** Frame of a view: right = y × toward, or x if `toward` is along y; up = toward × right. */
export function frameOf(toward: Triple): Frame {
  const right: Triple = toward[0] === 0 && toward[2] === 0 ? [1, 0, 0] : [toward[2], 0, -toward[0]];
  const axes = [right, cross(toward, right), toward] as const;
  const extents = axes.map((axis) => {
    const sum = Math.abs(axis[0]) + Math.abs(axis[1]) + Math.abs(axis[2]);
    return sum / Math.hypot(...axis);
  }) as unknown as Triple;
  return { axes: [unit(axes[0]), unit(axes[1]), unit(axes[2])], extents };
}

/** Greatest width or height of a cell's views, in multiples of the cell's side. */
export function maxExtent(directions: readonly Triple[]): number {
  return Math.max(...directions.flatMap((direction) => frameOf(direction).extents.slice(0, 2)));
}

/** Position of a cube relative to a frustum. */
export type Containment = 'outside' | 'across' | 'inside';

/** A half-space n·x + d ≥ 0. */
interface Plane {
  readonly normal: Triple;
  readonly offset: number;
}

/** Half-spaces whose intersection is the frustum: one for each side of the picture, and one in front of the camera. */
export function frustumOf(camera: Camera): readonly Plane[] {
  const { position, back, width, height } = camera;
  const middleDirection = directionAt(camera, width / 2, height / 2);
  /** Half-space on the side of the picture's middle; its plane passes through the camera. */
  const halfSpace = (planeNormal: Triple): Plane => {
    const [x, y, z] = unit(planeNormal);
    const normal: Triple = dot([x, y, z], middleDirection) < 0 ? [-x, -y, -z] : [x, y, z];
    return { normal, offset: -dot(normal, position) };
  };
  const places = [[0, 0], [width, 0], [width, height], [0, height]] as const;
  const corners = places.map(([x, y]) => directionAt(camera, x, y));
  const corner = (n: number): Triple => corners[n % 4] as Triple;
  return [...[0, 1, 2, 3].map((n) => halfSpace(cross(corner(n), corner(n + 1)))), halfSpace(back)];
}

/** A cube is outside if it is outside one half-space, inside if it is inside all, and otherwise across. */
export function containmentOf(planes: readonly Plane[], center: Triple, side: number): Containment {
  let containment: Containment = 'inside';
  for (const { normal, offset } of planes) {
    const distance = dot(normal, center) + offset;
    const reach = ((Math.abs(normal[0]) + Math.abs(normal[1]) + Math.abs(normal[2])) * side) / 2;
    if (distance < -reach) return 'outside';
    if (distance < reach) containment = 'across';
  }
  return containment;
}
