/** Perspective cameras. */
import type { Triple } from '../store/layout';

/** Tangents of the angles from the axis to the picture's sides; left and down are negative. */
export interface Fov {
  readonly left: number;
  readonly right: number;
  readonly down: number;
  readonly up: number;
}

export interface Camera {
  readonly position: Triple;
  /** World directions of the picture's right and upper side, and backwards from the camera: unit vectors. */
  readonly right: Triple;
  readonly up: Triple;
  readonly back: Triple;
  readonly fov: Fov;
  /** Size in pixels. */
  readonly width: number;
  readonly height: number;
}

/** Camera from a pose: radians, yaw to the left, pitch up, and the full vertical field of view. */
export function cameraOf(
  { position, yaw, pitch }: { readonly position: Triple; readonly yaw: number; readonly pitch: number },
  angle: number,
  width: number,
  height: number,
): Camera {
  const [s, c, sp, cp] = [Math.sin(yaw), Math.cos(yaw), Math.sin(pitch), Math.cos(pitch)];
  const up = Math.tan(angle / 2);
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

/** Direction through a position in the picture, pixels from its upper left; its component along the axis is 1. */
export function directionAt({ right, up, back, fov, width, height }: Camera, x: number, y: number): Triple {
  const across = fov.left + ((fov.right - fov.left) * x) / width;
  const above = fov.up + ((fov.down - fov.up) * y) / height;
  return [0, 1, 2].map((axis) => {
    const [r, u, b] = [right[axis] as number, up[axis] as number, back[axis] as number];
    return across * r + above * u - b;
  }) as unknown as Triple;
}

/** Size of a pixel at a distance of 1 m, the geometric mean of its sides. */
export function pixelSize({ fov, width, height }: Camera): number {
  return Math.sqrt(((fov.right - fov.left) * (fov.up - fov.down)) / (width * height));
}

export function dot(a: Triple, b: Triple): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Triple, b: Triple): Triple {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

/** Unit vector of the same direction; up for a zero vector. */
export function unit(vector: Triple): Triple {
  const length = Math.sqrt(dot(vector, vector));
  return length > 0 ? [vector[0] / length, vector[1] / length, vector[2] / length] : [0, 1, 0];
}
