/** Projection of views into the picture, by linear functions of their pixels and depth steps; bounds of their parts. */
import { type Camera, directionAt, dot, type Frame, frameOf, subtract } from '../cut/camera';
import type { Part } from '../decode/pack';
import { type CellKey, cornerOf, type Layout, sideAt, stepsOf, type Triple } from '../store/layout';

/** Factor of the radius of surfels that are not connected with all their neighbours. */
export const BORDER_FACTOR = 1.27;
/** Squared radius of surfels, pixels². */
export const SQUARED_RADIUS = 0.5;
/** Least cosine between a surfel's normal and its view's direction: more oblique surfels are stretched no further. */
export const MIN_COSINE = 0.25;
/** Parts nearer than this multiple of the view's least distance have the whole picture as bounds. */
const CLOSE_FACTOR = 8;
/** Number of four-component vectors per view in the shader. */
export const VECTORS_PER_VIEW = 10;

/** Pixel grid of a view in the world. */
export interface Model {
  readonly frame: Frame;
  /** Width and height of a pixel, and length of a depth step, metres. */
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
  const start = corner.map((low, axis) => {
    const [x, y, z] = [right, up, toward].map((vector) => vector[axis]) as unknown as Triple;
    return low + side / 2 + (-x * extents[0] + y * extents[1] + z * extents[2]) / 2;
  }) as unknown as Triple;
  const steps = [scaleVector(right, pitch[0]), scaleVector(up, -pitch[1]), scaleVector(toward, -pitch[2])] as const;
  return { frame, pitch, start, steps, normalBits: layout.normalBits / 2 };
}

function scaleVector(vector: Triple, factor: number): Triple {
  return [vector[0] * factor, vector[1] * factor, vector[2] * factor];
}

/** Three linear functions X, Y, W of points: a point is shown at (X/W, Y/W), and W is its distance along the axis. */
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
  const gradient = (component: (axis: 0 | 1 | 2) => number): Triple => [component(0), component(1), component(2)];
  const rows = [
    gradient((axis) => kx * (right[axis] + fov.left * back[axis])),
    gradient((axis) => -ky * (up[axis] + fov.up * back[axis])),
    gradient((axis) => -back[axis]),
  ] as const;
  const corner = directionAt(camera, 0, 0);
  const [right1, down1] = [directionAt(camera, 1, 0), directionAt(camera, 0, 1)];
  return { eye: position, rows, rays: [corner, subtract(right1, corner), subtract(down1, corner)], width, height };
}

/** A view in the picture. */
export interface ProjectedView {
  /** (X, Y, W) at the corner of the first pixel, at the front, and its changes per column, row and depth step. */
  readonly start: Triple;
  readonly steps: readonly [Triple, Triple, Triple];
  /** Least W of visible splats; nearer ones would cover the whole picture. */
  readonly minW: number;
  /** Columns, rows and depth steps by which splats extend beyond their pixels. */
  readonly margin: Triple;
}

export function projectView(model: Model, { eye, rows }: Projector): ProjectedView {
  const { start, steps, pitch } = model;
  const project = (vector: Triple): Triple => [dot(rows[0], vector), dot(rows[1], vector), dot(rows[2], vector)];
  const [radius, ball] = [BORDER_FACTOR * Math.sqrt(SQUARED_RADIUS), ballRadius(model)];
  const marginOf = (size: number): number => Math.max(radius, ball / size) - 0.5;
  const slope = (radius * (pitch[0] + pitch[1])) / MIN_COSINE;
  return {
    start: project(subtract(start, eye)),
    steps: [project(steps[0]), project(steps[1]), project(steps[2])],
    minW: Math.max(pitch[0], pitch[1]),
    margin: [marginOf(pitch[0]), marginOf(pitch[1]), Math.max(slope, ball) / pitch[2]],
  };
}

/** Radius of a ball, metres: half the diagonal of its pixel. */
function ballRadius({ pitch }: Model): number {
  return Math.hypot(pitch[0], pitch[1]) / 2;
}

/** Bounds of a part in the picture: columns and rows [low, high). */
export interface PartBounds {
  readonly low: readonly [number, number];
  readonly high: readonly [number, number];
  /** 1/W of the part's nearest point; infinite if that point is nearer than `minW`. */
  readonly nearness: number;
}

/** Computes the bounds of a part in the picture; null if it is not visible. */
export function boundsOf(view: ProjectedView, { low, high }: Part, width: number, height: number): PartBounds | null {
  const { start, steps, minW, margin } = view;
  let [isLeft, isRight, isAbove, isBelow, isBehind] = [true, true, true, true, true];
  let nearest = Number.POSITIVE_INFINITY;
  const from: [number, number] = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
  const to: [number, number] = [Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let corner = 0; corner < 8; corner++) {
    const coordinate = (axis: 0 | 1 | 2): number =>
      (corner >> axis) & 1 ? high[axis] + margin[axis] : low[axis] - margin[axis];
    const [column, row, step] = [coordinate(0), coordinate(1), coordinate(2)];
    const valueOf = (n: 0 | 1 | 2): number => start[n] + column * steps[0][n] + row * steps[1][n] + step * steps[2][n];
    const [x, y, w] = [valueOf(0), valueOf(1), valueOf(2)];
    // One pixel of margin, as a splat covers at least its centre's pixel. Products are correct for w < 0, too.
    isLeft &&= x < -w;
    isRight &&= x > (width + 1) * w;
    isAbove &&= y < -w;
    isBelow &&= y > (height + 1) * w;
    isBehind &&= w < minW;
    nearest = Math.min(nearest, w);
    from[0] = Math.min(from[0], x / w);
    from[1] = Math.min(from[1], y / w);
    to[0] = Math.max(to[0], x / w);
    to[1] = Math.max(to[1], y / w);
  }
  if (isLeft || isRight || isAbove || isBelow || isBehind) return null;
  const nearness = nearest < minW ? Number.POSITIVE_INFINITY : 1 / nearest;
  // This near, a splat's ellipse, computed from derivatives at its centre, may extend far beyond the part.
  if (nearest < CLOSE_FACTOR * minW) return { low: [0, 0], high: [width, height], nearness };
  return {
    low: [Math.max(Math.floor(from[0]) - 1, 0), Math.max(Math.floor(from[1]) - 1, 0)],
    high: [Math.min(Math.floor(to[0]) + 2, width), Math.min(Math.floor(to[1]) + 2, height)],
    nearness,
  };
}

/** Whether the centres of a part's splats may lie in a box. */
export function mayLieIn(boxFunctions: readonly BoxFunction[], { low, high }: Part): boolean {
  return boxFunctions.every(([a, b, c, d]) => {
    let [least, greatest] = [d, d];
    // Centres of splats lie half a pixel and half a depth step inside this range.
    [a, b, c].forEach((factor, axis) => {
      const ends = [factor * (low[axis] as number), factor * (high[axis] as number)];
      least += Math.min(...ends);
      greatest += Math.max(...ends);
    });
    return least < 1 && greatest >= 0;
  });
}

/** Linear function of column, row and depth step whose values inside a box are between 0 and 1. */
export type BoxFunction = readonly [number, number, number, number];

/** One function for each axis of the box; without a box, the constant 0.5, which is always inside. */
export function boxFunctionsOf(model: Model, layout: Layout, box: CellKey | null): readonly BoxFunction[] {
  if (!box) return [0, 1, 2].map(() => [0, 0, 0, 0.5] as const);
  const side = sideAt(layout, box.level);
  const corner = cornerOf(layout, box.level, box.place);
  return [0, 1, 2].map((axis) => {
    const [column, row, step] = model.steps.map((vector) => (vector[axis] as number) / side) as unknown as Triple;
    return [column, row, step, ((model.start[axis] as number) - (corner[axis] as number)) / side] as const;
  });
}

/** Writes a view for the shaders into `target`, which holds `VECTORS_PER_VIEW` vectors of four numbers. */
export function writeView(
  target: Float32Array,
  model: Model,
  view: ProjectedView,
  boxFunctions: readonly BoxFunction[],
): void {
  const { frame, pitch } = model;
  const [right, up, toward] = frame.axes;
  const scale = 2 / (2 ** model.normalBits - 2);
  const put = (index: number, [x, y, z]: Triple, w: number): void => target.set([x, y, z, w], 4 * index);
  put(0, view.start, view.minW);
  put(1, view.steps[0], scale);
  put(2, view.steps[1], ballRadius(model) / Math.sqrt(SQUARED_RADIUS));
  put(3, view.steps[2], 0);
  put(4, scaleVector(right, pitch[0] / pitch[2]), 0);
  put(5, scaleVector(up, pitch[1] / pitch[2]), 0);
  put(6, toward, 0);
  boxFunctions.forEach((boxFunction, n) => target.set(boxFunction, 4 * (7 + n)));
}
