/** Figures of the panel: loading, drawing and position. Commands of the panel and the keys. */
import type { ServerProgress } from '../demand/place';
import { make, write } from './dom';
import { bytesOf, count, metres, milliseconds, percent, rate } from './format';

/** Content of the panel, created a few times a second. */
export interface Status {
  /** Number of the outermost visible ring, and number of rings; ring 0 is the map alone. */
  readonly ring: number;
  readonly rings: number;
  /** Whether no finer maps follow the visible ones. */
  readonly isSharp: boolean;
  /** Server's progress with the region that it computes for the user; null if it computes none. */
  readonly serverProgress: ServerProgress | null;
  /** Radius of the morph, metres. */
  readonly radius: number;
  /** Received bytes, and all bytes that this region needs. */
  readonly received: number;
  readonly expected: number;
  /** Bits per second over the last second; null when nothing loads. */
  readonly rate: number | null;
  /** Mean and maximum duration of frames over the last second, milliseconds. */
  readonly frame: number;
  readonly maxFrame: number;
  /** Triangles of the scene that are drawn; number drawn after they are split; all triangles of the scene. */
  readonly triangles: number;
  readonly drawn: number;
  readonly sceneTriangles: number;
  /** Region of the user, and number of regions; null if the server computes regions for any place. */
  readonly region: number;
  readonly regions: number | null;
  /** Distance from the centre, and distance at which the picture folds, metres. */
  readonly distance: number;
  readonly foldMargin: number;
  /** Sentences about problems and what still works; empty if there are none. */
  readonly problems: readonly string[];
}

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
  link(): string;
  /** Command for the headset, or why there is no headset; absent until the browser has answered. */
  headset?: HeadsetCommand | string;
  /** Loads again what could not be loaded. */
  retry(): void;
}

export interface HeadsetCommand {
  readonly isPresenting: boolean;
  /** Enters or leaves the headset. */
  toggle(): Promise<void>;
}

/** Returns the lines of the panel by name. */
export function linesOf(status: Status): Readonly<Record<string, string>> {
  const { ring, rings, radius, received, expected, frame, maxFrame, triangles, drawn, sceneTriangles } = status;
  const progress = progressText(status);
  return {
    Loaded: `${bytesOf(received, expected)} (${percent(received, expected)})`,
    Speed: isComplete(status) ? 'complete' : rate(status.rate),
    Ring: ring === 0 ? `map only, of ${rings}` : `${ring} of ${rings}`,
    Radius: ring === 0 ? UNUSED : metres(radius),
    Triangles: `${count(triangles)} of ${count(sceneTriangles)}`,
    'Split into': drawn > triangles ? count(drawn) : UNUSED,
    Frame: `${milliseconds(frame)}, at most ${milliseconds(maxFrame)}`,
    ...(progress === null ? { Region: `${status.region + 1} of ${status.regions ?? 1}` } : { Place: progress }),
    'From centre': `${metres(status.distance)} of ${metres(status.foldMargin)}`,
  };
}

const UNUSED = '–';

/** Whether every ring is shown and every byte is loaded. */
export function isComplete({ ring, rings, received, expected, isSharp }: Status): boolean {
  return ring >= rings && received >= expected && isSharp;
}

/** Server's progress in a few words; null if it computes nothing. */
export function progressText({ serverProgress, isSharp }: Status): string | null {
  if (!serverProgress) return null;
  const { stage } = serverProgress;
  if (stage === 'waiting')
    return serverProgress.before > 0 ? `waiting, behind ${serverProgress.before}` : 'being computed';
  if (stage === 'busy') return `server busy, next try in ${serverProgress.seconds} s`;
  if (stage === 'requested') return 'requested';
  return isSharp ? 'refined' : 'coarse, being refined';
}

/** Whether the server is busy, or computes regions of other users first. */
export function isDelayed({ serverProgress }: Status): boolean {
  return serverProgress?.stage === 'busy' || (serverProgress?.stage === 'waiting' && serverProgress.before > 0);
}

/** Short summary for small screens. */
export function summaryOf(status: Status): string {
  const progress = progressText(status);
  if (status.rings === 0 && progress !== null) return `place: ${progress}`;
  return `${percent(status.received, status.expected)} loaded, ring ${status.ring} of ${status.rings}`;
}

export function createFigures() {
  const lines = new Map<string, HTMLElement>();
  const list = make('dl', { class: 'figures' });
  const foldBar = make('div', { class: 'reach', 'aria-hidden': 'true' }, make('span', {}));
  const problems = make('ul', { class: 'problems' });

  function createLine(name: string): HTMLElement {
    const value = make('dd', {});
    list.append(make('div', {}, make('dt', {}, name), value));
    lines.set(name, value);
    return value;
  }

  return {
    element: make('div', { class: 'panel-body' }, list, foldBar, problems),
    update(status: Status): void {
      for (const [name, text] of Object.entries(linesOf(status))) write(lines.get(name) ?? createLine(name), text);
      const fraction = status.foldMargin > 0 ? Math.min(status.distance / status.foldMargin, 1) : 0;
      foldBar.style.setProperty('--share', fraction.toFixed(3));
      foldBar.dataset['near'] = String(fraction > 0.8);
      const texts = status.problems;
      if (texts.join('\n') !== [...problems.children].map(({ textContent }) => textContent).join('\n'))
        problems.replaceChildren(...texts.map((text) => make('li', {}, text)));
    },
  };
}
