import type { Making } from '../demand/place';

/** Content of the panel, created a few times a second. */
export interface Status {
  /** Last visible ring, and the number of rings; ring 0 is the map alone. */
  readonly ring: number;
  readonly rings: number;
  /** Whether no finer maps follow the visible ones. */
  readonly isSharp: boolean;
  /** Server's progress with the current place or the one that the user is moving to; null if nothing is made. */
  readonly making: Making | null;
  /** Radius of the morph, metres. */
  readonly radius: number;
  /** Received bytes, and all bytes that this region needs. */
  readonly received: number;
  readonly expected: number;
  /** Bits per second over the last second; null when nothing loads. */
  readonly rate: number | null;
  /** Milliseconds per frame: mean over the last second, and maximum. */
  readonly frame: number;
  readonly longest: number;
  /** Drawn triangles of the scene; triangles after their subdivision; all triangles of the scene. */
  readonly triangles: number;
  readonly drawn: number;
  readonly sceneTriangles: number;
  /** Region of the user, and the number of regions; null if places are made anywhere. */
  readonly region: number;
  readonly regions: number | null;
  /** Distance from the centre, and distance at which the picture folds, metres. */
  readonly away: number;
  readonly foldMargin: number;
  /** Sentences about problems and what still works; empty if there are none. */
  readonly problems: readonly string[];
}

/** Commands of the panel and the keys. */
export interface Commands {
  /** Sets the position of the divider between conventional (left) and continuous (right), 0 to 1; null removes it. */
  setDivider(share: number | null): void;
  setMode(mode: 'walk' | 'orbit'): void;
  /** Moves back to the centre of the region. */
  home(): void;
  /** Moves to the next place; absent if there is only one. */
  next?: () => void;
  /** Looks around with the mouse without a button. */
  lookAround(): void;
  /** Returns a PNG of the picture without the panel. */
  screenshot(): Promise<Blob>;
  /** Returns a link to this pose. */
  link(): string;
  /** Headset, or why there is none; absent until that is known. */
  headset?: HeadsetCommand | string;
  /** Reloads what failed. */
  retry(): void;
}

export interface HeadsetCommand {
  readonly isPresenting: boolean;
  /** Enters or leaves the headset. */
  toggle(): Promise<void>;
}
