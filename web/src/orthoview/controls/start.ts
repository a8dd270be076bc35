/** Start pose without a link. */
import type { Pose } from '../../control/pose';
import type { Layout } from '../store/layout';

/** Distance from the centre in widths of the world, and downward angle of the view, radians. */
const [AWAY, DOWN] = [0.55, 0.45] as const;

/** Pose south of and above the world, looking at its centre. */
export function startOf({ origin, cell, counts }: Layout): Pose {
  const middle = origin.map((low, axis) => low + (cell * (counts[axis] as number)) / 2) as [number, number, number];
  const away = AWAY * cell * Math.max(counts[0], counts[2]);
  const position = [middle[0], origin[1] + away * Math.sin(DOWN), middle[2] + away * Math.cos(DOWN)] as const;
  return { position, yaw: 0, pitch: -DOWN };
}
