/** Figures of the panel: loading, drawing and position; and the commands of the panel and the keys. */
import type { ServerProgress } from '../demand/place';
import { make, write } from './dom';
import { bytesOf, count, metres, milliseconds, percent, rate } from './format';

/** Content of the panel, created a few times a second. */
export interface Status {
  /** Last visible ring, and the number of rings; ring 0 is the map alone. */
  readonly ring: number;
  readonly rings: number;
  /** Whether no finer maps follow the visible ones. */
  readonly isSharp: boolean;
  /** Server's progress with the current place or the one that the user is moving to; null if nothing is made. */
  readonly making: ServerProgress | null;
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

/** Returns the lines of the panel by name. */
export function linesOf(status: Status): Readonly<Record<string, string>> {
  const { ring, rings, radius, received, expected, frame, longest, triangles, drawn, sceneTriangles } = status;
  return {
    Loaded: `${bytesOf(received, expected)} (${percent(received, expected)})`,
    Speed: isComplete(status) ? 'complete' : rate(status.rate),
    Ring: ring === 0 ? `map only, of ${rings}` : `${ring} of ${rings}`,
    Radius: ring === 0 ? UNUSED : metres(radius),
    Triangles: `${count(triangles)} of ${count(sceneTriangles)}`,
    'Split into': drawn > triangles ? count(drawn) : UNUSED,
    Frame: `${milliseconds(frame)}, at most ${milliseconds(longest)}`,
    ...placeOf(status),
    'From centre': `${metres(status.away)} of ${metres(status.foldMargin)}`,
  };
}

const UNUSED = '–';

/** Whether every ring is shown and every byte is loaded. */
export function isComplete({ ring, rings, received, expected, isSharp }: Status): boolean {
  return ring >= rings && received >= expected && isSharp;
}

/** Progress of the server with the place, in a few words; null if nothing is made. */
export function progressText({ making, isSharp }: Status): string | null {
  if (!making) return null;
  const { stage } = making;
  if (stage === 'waiting') return making.before > 0 ? `waiting, behind ${making.before}` : 'being computed';
  if (stage === 'busy') return `server busy, next try in ${making.seconds} s`;
  if (stage === 'asked') return 'requested';
  return isSharp ? 'refined' : 'coarse, being refined';
}

/** Whether other places precede the wanted one, or the server is busy. */
export function isHeld({ making }: Status): boolean {
  return making?.stage === 'busy' || (making?.stage === 'waiting' && making.before > 0);
}

function placeOf(status: Status): Readonly<Record<string, string>> {
  const made = progressText(status);
  if (made !== null) return { Place: made };
  return { Region: `${status.region + 1} of ${status.regions ?? 1}` };
}

/** Short summary for small screens. */
export function summaryOf(status: Status): string {
  const made = progressText(status);
  if (status.rings === 0 && made !== null) return `place: ${made}`;
  return `${percent(status.received, status.expected)} loaded, ring ${status.ring} of ${status.rings}`;
}

export interface Figures {
  readonly element: HTMLElement;
  update(status: Status): void;
}

export function createFigures(): Figures {
  const lines = new Map<string, HTMLElement>();
  const list = make('dl', { class: 'figures' });
  const reach = make('div', { class: 'reach', 'aria-hidden': 'true' }, make('span', {}));
  const problems = make('ul', { class: 'problems' });

  function line(name: string): HTMLElement {
    const found = lines.get(name);
    if (found) return found;
    const value = make('dd', {});
    list.append(make('div', {}, make('dt', {}, name), value));
    lines.set(name, value);
    return value;
  }

  return {
    element: make('div', { class: 'panel-body' }, list, reach, problems),
    update(status) {
      for (const [name, text] of Object.entries(linesOf(status))) write(line(name), text);
      const share = status.foldMargin > 0 ? Math.min(status.away / status.foldMargin, 1) : 0;
      reach.style.setProperty('--share', share.toFixed(3));
      reach.dataset['near'] = String(share > 0.8);
      const texts = status.problems;
      if (texts.join('\n') !== [...problems.children].map(({ textContent }) => textContent).join('\n')) {
        problems.replaceChildren(...texts.map((text) => make('li', {}, text)));
      }
    },
  };
}
