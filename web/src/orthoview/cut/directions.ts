/** Axes of a direction's views. */
import type { Triple } from '../store/layout';
import { cross, unit } from './camera';

export interface Frame {
  /** Unit vectors to the right, upwards and towards the viewer. */
  readonly axes: readonly [Triple, Triple, Triple];
  /** Extents of a unit cube along the axes. */
  readonly extents: Triple;
}

/** right = y × toward, or x for views along y, and up = toward × right. */
export function frameOf(toward: Triple): Frame {
  const right: Triple = toward[0] === 0 && toward[2] === 0 ? [1, 0, 0] : [toward[2], 0, -toward[0]];
  const axes = [right, cross(toward, right), toward] as const;
  const extents = axes.map((axis) => {
    const sum = Math.abs(axis[0]) + Math.abs(axis[1]) + Math.abs(axis[2]);
    return sum / Math.hypot(...axis);
  }) as unknown as Triple;
  return { axes: [unit(axes[0]), unit(axes[1]), unit(axes[2])], extents };
}

/** Width or height of a cell's widest view, as a multiple of the cell's side. */
export function widest(directions: readonly Triple[]): number {
  return Math.max(...directions.flatMap((direction) => frameOf(direction).extents.slice(0, 2)));
}
