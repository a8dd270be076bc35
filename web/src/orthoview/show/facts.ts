/** Facts of the last picture of a tree, for the panel and for tests. */
import type { FrameCounts } from '../draw/drawer';
import type { Choice } from './stand_in';
import type { Graphics } from './start';
import type { Stock } from './stock';

export interface Facts extends FrameCounts {
  /** Views in the picture; stand-ins among them; outstanding requests. */
  readonly views: number;
  readonly standIns: number;
  readonly waiting: number;
  /** Number of cells for which nothing is loaded. */
  readonly holes: number;
  /** Splats of unoccluded parts in the last finished picture; null if it is unknown. */
  readonly unhidden: number | null;
  /** Leaves drawn as geometry, with their guests. */
  readonly leaves: number;
  /** Bytes on the GPU; number of views. */
  readonly bytes: number;
  readonly kept: number;
  /** Whether all views of the cut for this camera are loaded. */
  readonly isComplete: boolean;
  readonly graphics: Graphics | null;
}

/** Facts before the first picture. */
export const NOTHING: Omit<Facts, 'unhidden'> = {
  views: 0,
  standIns: 0,
  waiting: 0,
  holes: 0,
  splats: 0,
  leaves: 0,
  triangles: 0,
  calls: 0,
  bytes: 0,
  kept: 0,
  isComplete: false,
  graphics: null,
};

/** Facts of a picture that do not depend on requests. */
export function factsOf({ shown, near, holes }: Choice, counts: FrameCounts, { bytes, views: kept }: Stock) {
  const standIns = shown.filter(({ box }) => box !== null).length;
  return { views: shown.length, standIns, holes, ...counts, leaves: near.length, bytes, kept };
}
