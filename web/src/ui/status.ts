/** Figures of the panel: what is loaded and drawn, and where the user is. Commands of its buttons and keys. */
import type { ServerProgress } from '../demand/place';
import { make, write } from './dom';
import { bytesOf, count, metres, milliseconds, percent, rate } from './format';

/** What the panel shows. */
export interface Status {
  /** Number of the outermost visible ring, and number of rings; ring 0 is the map alone. */
  readonly ring: number;
  readonly rings: number;
  /** Whether the visible maps are the finest. */
  readonly isSharp: boolean;
  /** Server's progress with the region that it computes for the user; null if it computes none. */
  readonly serverProgress: ServerProgress | null;
  /** Radius of the morph, metres. */
  readonly radius: number;
  /** Bytes received of the files of this region, and bytes of all of them. */
  readonly received: number;
  readonly expected: number;
  /** Bits per second over the last second; null when nothing arrives. */
  readonly rate: number | null;
  /** Mean and greatest duration of the frames of the last second, milliseconds. */
  readonly frame: number;
  readonly maxFrame: number;
  /** Triangles of the scene in the picture; triangles into which these are split; all triangles of the scene. */
  readonly triangles: number;
  readonly drawn: number;
  readonly sceneTriangles: number;
  /** Region of the user, and number of regions; null if the server computes regions for any place. */
  readonly region: number;
  readonly regions: number | null;
  /** Distance from the centre, and distance at which the picture folds, metres. */
  readonly distance: number;
  readonly foldMargin: number;
  /** Sentences about what does not work at present. */
  readonly problems: readonly string[];
}

export interface Commands {
  /** Sets the position of the divider between conventional (left) and continuous (right), 0 to 1; null removes it. */
  setDivider(share: number | null): void;
  setMode(mode: 'walk' | 'orbit'): void;
  /** Moves back to the centre of the region. */
  home(): void;
  /** Moves to the next place; missing if there is only one. */
  next?: () => void;
  /** Looks around with the mouse without a button. */
  lookAround(): void;
  /** Returns a PNG of the picture without the panel. */
  screenshot(): Promise<Blob>;
  link(): string;
  /** Command for the headset, or a sentence why there is none; missing until the browser has answered. */
  headset?: HeadsetCommand | string;
  /** Tries again to load what could not be loaded. */
  retry(): void;
}

export interface HeadsetCommand {
  readonly isPresenting: boolean;
  /** Enters or leaves the headset. */
  toggle(): Promise<void>;
}

/** Returns the texts of the panel by the names of its lines. */
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

/** Whether all rings are shown and all files are loaded. */
export function isComplete({ ring, rings, received, expected, isSharp }: Status): boolean {
  return ring >= rings && received >= expected && isSharp;
}

/** Returns the server's progress in a few words; null if it computes nothing for the user. */
export function progressText({ serverProgress, isSharp }: Status): string | null {
  if (!serverProgress) return null;
  const { stage } = serverProgress;
  if (stage === 'waiting')
    return serverProgress.before > 0 ? `waiting, behind ${serverProgress.before}` : 'being computed';
  if (stage === 'busy') return `server busy, next try in ${serverProgress.seconds} s`;
  if (stage === 'requested') return 'requested';
  return isSharp ? 'refined' : 'coarse, being refined';
}

/** Whether the user has to wait because the server is busy or computes for other users first. */
export function isDelayed({ serverProgress }: Status): boolean {
  return serverProgress?.stage === 'busy' || (serverProgress?.stage === 'waiting' && serverProgress.before > 0);
}

/** Returns a short summary, for small screens. */
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
