import type { Making } from '../demand/place';

/** The panel's content; the viewer makes one a few times a second. */
export interface Status {
  /** Last ring that is shown, and the number of rings; ring 0 is the map alone. */
  readonly ring: number;
  readonly rings: number;
  /** The maps that are shown are not to be followed by finer ones. */
  readonly isSharp: boolean;
  /** How far the server is with the place that is shown, or that the user is about to go to; null where nothing is made. */
  readonly making: Making | null;
  /** Radius of the morph, metres. */
  readonly radius: number;
  /** Bytes that have arrived, and all that this region needs. */
  readonly received: number;
  readonly expected: number;
  /** Bits a second over the last second; null when nothing loads. */
  readonly rate: number | null;
  /** Milliseconds of a frame: mean of the last second, and the longest. */
  readonly frame: number;
  readonly longest: number;
  /** Triangles of the scene that are drawn, the smaller ones that they are drawn as, and all of the scene. */
  readonly triangles: number;
  readonly drawn: number;
  readonly sceneTriangles: number;
  /** Region in which the user is, and the number of regions; null where there are places everywhere. */
  readonly region: number;
  readonly regions: number | null;
  /** Metres from the centre, and metres at which the picture folds. */
  readonly away: number;
  readonly foldMargin: number;
  /** Sentences on what went wrong and what still works; empty if nothing did. */
  readonly problems: readonly string[];
}

/** Commands of the panel and the keys. */
export interface Commands {
  /** Where the picture is divided into conventional (left) and continuous (right), 0 to 1; null for continuous alone. */
  setDivider(share: number | null): void;
  setMode(mode: 'walk' | 'orbit'): void;
  /** Go back to the centre of the region. */
  home(): void;
  /** Go to the next place of several; absent where there is only one. */
  next?: () => void;
  /** Look around with the mouse without a button. */
  lookAround(): void;
  /** A PNG of the picture without the panel. */
  screenshot(): Promise<Blob>;
  /** A link to this pose. */
  link(): string;
  /** The headset, or why there is none; absent until that is known. */
  headset?: HeadsetCommand | string;
  /** Load again what failed. */
  retry(): void;
}

export interface HeadsetCommand {
  readonly isPresenting: boolean;
  /** Enter it, or leave it. */
  toggle(): Promise<void>;
}
