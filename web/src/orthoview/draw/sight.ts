/** View in front of a camera: linear functions of its pixels and depth steps, and the visibility of its parts. */
import { type Camera, directionAt, dot, type Frame, frameOf } from '../cut/camera';
import type { Part } from '../decode/pack';
import { cornerOf, type Layout, sideAt, stepsOf, type Triple } from '../store/layout';

/** Radius factor of surfels that are not connected with all neighbours; squared radius of surfels in pixels. */
export const [BORDER, SQUARED_RADIUS] = [1.27, 0.5] as const;
/** Least cosine between a surfel's normal and the direction of its view. */
export const MIN_COSINE = 0.25;
/** Multiple of a view's least distance below which the bounds of a part in the picture are not computed. */
const CLOSE = 8;
/** Number of four-component vectors per view in the shader. */
export const VECTORS = 10;

/** Cell that bounds the centres of the splats. */
export interface Box {
  readonly level: number;
  readonly place: Triple;
}

/** Data of a view that do not depend on the camera. */
export interface Model {
  readonly frame: Frame;
  /** Extents of a pixel and of a depth step, metres. */
  readonly pitch: Triple;
  /** World position of the corner of the first pixel, at the front. */
  readonly start: Triple;
  /** Vectors of one column, one row and one depth step, metres. */
  readonly steps: readonly [Triple, Triple, Triple];
  readonly normalBits: number;
}

export function modelOf(layout: Layout, level: number, place: Triple, direction: number): Model {
  const side = sideAt(layout, level);
  const corner = cornerOf(layout, level, place);
  const frame = frameOf(layout.directions[direction] as Triple);
  const extents = frame.extents.map((extent) => extent * side) as unknown as Triple;
  const pitch: Triple = [extents[0] / layout.size, extents[1] / layout.size, extents[2] / stepsOf(layout)];
  const [right, up, toward] = frame.axes;
  const start = corner.map(
    (low, axis) =>
      low + side / 2 +
      (-(right[axis] as number) * extents[0] + (up[axis] as number) * extents[1] +
        (toward[axis] as number) * extents[2]) /
        2,
  ) as unknown as Triple;
  const scaled = (vector: Triple, factor: number): Triple => [
    vector[0] * factor,
    vector[1] * factor,
    vector[2] * factor,
  ];
  const steps = [scaled(right, pitch[0]), scaled(up, -pitch[1]), scaled(toward, -pitch[2])] as const;
  return { frame, pitch, start, steps, normalBits: layout.normalBits / 2 };
}

/** Three linear functions (X, Y, W) of points: a point is shown at X/W, Y/W, and W is its distance along the axis. */
export interface Projector {
  readonly eye: Triple;
  /** Gradients of the functions, pixels and metres. */
  readonly rows: readonly [Triple, Triple, Triple];
  /** Direction through the picture's upper left corner, and its changes by a pixel to the right and down. */
  readonly rays: readonly [Triple, Triple, Triple];
  readonly width: number;
  readonly height: number;
}

export function projectorOf(camera: Camera): Projector {
  const { position, right, up, back, fov, width, height } = camera;
  const [kx, ky] = [width / (fov.right - fov.left), height / (fov.up - fov.down)];
  const row = (of: (axis: number) => number): Triple => [of(0), of(1), of(2)];
  const rows = [
    row((n) => kx * ((right[n] as number) + fov.left * (back[n] as number))),
    row((n) => -ky * ((up[n] as number) + fov.up * (back[n] as number))),
    row((n) => -(back[n] as number)),
  ] as const;
  const first = directionAt(camera, 0, 0);
  const step = (x: number, y: number): Triple => {
    const other = directionAt(camera, x, y);
    return [other[0] - first[0], other[1] - first[1], other[2] - first[2]];
  };
  return { eye: position, rows, rays: [first, step(1, 0), step(0, 1)], width, height };
}

export interface Sight {
  /** Functions at the corner of the first pixel, at the front; their changes per column, row and depth step. */
  readonly start: Triple;
  readonly steps: readonly [Triple, Triple, Triple];
  /** Least W of visible splats: nearer ones would cover the whole picture. */
  readonly least: number;
  /** Columns, rows and depth steps by which splats extend beyond their pixels. */
  readonly margin: Triple;
}

export function sightOf(model: Model, { eye, rows }: Projector): Sight {
  const { start, steps, pitch } = model;
  const offset: Triple = [start[0] - eye[0], start[1] - eye[1], start[2] - eye[2]];
  const along = (vector: Triple): Triple => [dot(rows[0], vector), dot(rows[1], vector), dot(rows[2], vector)];
  const [radius, ball] = [BORDER * Math.sqrt(SQUARED_RADIUS), ballOf(model)];
  const across = (size: number): number => Math.max(radius, ball / size) - 0.5;
  const slope = (radius * (pitch[0] + pitch[1])) / MIN_COSINE;
  return {
    start: along(offset),
    steps: [along(steps[0]), along(steps[1]), along(steps[2])],
    least: Math.max(pitch[0], pitch[1]),
    margin: [across(pitch[0]), across(pitch[1]), Math.max(slope, ball) / pitch[2]],
  };
}

/** Radius of a ball, the bounding circle of its pixel, metres. */
function ballOf({ pitch }: Model): number {
  return Math.hypot(pitch[0], pitch[1]) / 2;
}

/** Bounds of a part of a view in the picture: first column and row, and those after the last. */
export interface Seen {
  readonly low: readonly [number, number];
  readonly high: readonly [number, number];
  /** 1/W of its nearest point; infinite if that is too near. */
  readonly nearness: number;
}

/** Computes the bounds of a part in the picture; null if it is not visible. */
export function seenOf(
  { start, steps, least, margin }: Sight,
  { low, high }: Part,
  width: number,
  height: number,
): Seen | null {
  let [left, right, above, below, behind] = [true, true, true, true, true];
  let nearest = Number.POSITIVE_INFINITY;
  const from = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY] as [number, number];
  const to = [Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY] as [number, number];
  for (let corner = 0; corner < 8; corner++) {
    const at = low.map((lowest, axis) =>
      (corner >> axis) & 1 ? (high[axis] as number) + (margin[axis] as number) : lowest - (margin[axis] as number),
    );
    const value = (of: 0 | 1 | 2): number =>
      start[of] + (at[0] as number) * steps[0][of] + (at[1] as number) * steps[1][of] +
      (at[2] as number) * steps[2][of];
    const [x, y, w] = [value(0), value(1), value(2)];
    // One pixel of margin for that of a splat's centre. Products keep the comparison right for corners behind the eye.
    left &&= x < -w;
    right &&= x > (width + 1) * w;
    above &&= y < -w;
    below &&= y > (height + 1) * w;
    behind &&= w < least;
    nearest = Math.min(nearest, w);
    from[0] = Math.min(from[0], x / w);
    from[1] = Math.min(from[1], y / w);
    to[0] = Math.max(to[0], x / w);
    to[1] = Math.max(to[1], y / w);
  }
  if (left || right || above || below || behind) return null;
  const nearness = nearest < least ? Number.POSITIVE_INFINITY : 1 / nearest;
  // At this distance the ellipse from the derivative at a splat's centre may extend far beyond the part.
  if (nearest < CLOSE * least) return { low: [0, 0], high: [width, height], nearness };
  return {
    low: [Math.max(Math.floor(from[0]) - 1, 0), Math.max(Math.floor(from[1]) - 1, 0)],
    high: [Math.min(Math.floor(to[0]) + 2, width), Math.min(Math.floor(to[1]) + 2, height)],
    nearness,
  };
}

/** Whether the centres of a part's splats may lie in a box. */
export function isIn(rows: readonly Row[], { low, high }: Part): boolean {
  return rows.every(([a, b, c, d]) => {
    const ends = [a, b, c].map((factor, axis) => {
      // A splat's centre lies half a pixel and half a depth step behind its least coordinates.
      const [from, to] = [factor * (low[axis] as number), factor * (high[axis] as number)];
      return [Math.min(from, to), Math.max(from, to)] as const;
    });
    const sum = (end: 0 | 1): number => ends.reduce((total, each) => total + each[end], d);
    return sum(0) < 1 && sum(1) >= 0;
  });
}

/** Linear function of columns, rows and depth steps that is between 0 and 1 in a box. */
export type Row = readonly [number, number, number, number];

/** Functions of a box along the world's axes; constant functions of 0.5 without a box. */
export function rowsOf(model: Model, layout: Layout, box: Box | null): readonly Row[] {
  if (!box) return [0, 1, 2].map(() => [0, 0, 0, 0.5] as const);
  const side = sideAt(layout, box.level);
  const corner = cornerOf(layout, box.level, box.place);
  return [0, 1, 2].map((axis) => {
    const factor = (n: 0 | 1 | 2): number => (model.steps[n][axis] as number) / side;
    return [
      factor(0),
      factor(1),
      factor(2),
      ((model.start[axis] as number) - (corner[axis] as number)) / side,
    ] as const;
  });
}

/** Writes the numbers of a view for the shader; `target` holds `VECTORS` vectors of four numbers. */
export function writeView(target: Float32Array, model: Model, sight: Sight, rows: readonly Row[]): void {
  const { frame, pitch } = model;
  const [right, up, toward] = frame.axes;
  const scale = 2 / (2 ** model.normalBits - 2);
  const put = (at: number, [x, y, z]: Triple, w: number): void => target.set([x, y, z, w], 4 * at);
  const scaled = (vector: Triple, factor: number): Triple => [
    vector[0] * factor,
    vector[1] * factor,
    vector[2] * factor,
  ];
  put(0, sight.start, sight.least);
  put(1, sight.steps[0], scale);
  put(2, sight.steps[1], ballOf(model) / Math.sqrt(SQUARED_RADIUS));
  put(3, sight.steps[2], 0);
  put(4, scaled(right, pitch[0] / pitch[2]), 0);
  put(5, scaled(up, pitch[1] / pitch[2]), 0);
  put(6, toward, 0);
  rows.forEach((row, n) => target.set(row, 4 * (7 + n)));
}
