/** Figures of the panel: loading, drawing and position. */
import { make, write } from './dom';
import { bytesOf, count, metres, milliseconds, percent, rate } from './format';
import type { Status } from './status';

/** Returns the lines of the panel by name. */
export function linesOf(status: Status): Readonly<Record<string, string>> {
  const { ring, rings, radius, received, expected, frame, longest, triangles, drawn, sceneTriangles } = status;
  return {
    Loaded: `${bytesOf(received, expected)} (${percent(received, expected)})`,
    Speed: isComplete(status) ? 'all is here' : rate(status.rate),
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
export function madeOf({ making, isSharp }: Status): string | null {
  if (!making) return null;
  const { stage } = making;
  if (stage === 'waiting') return making.before > 0 ? `waiting, ${making.before} before` : 'being made';
  if (stage === 'busy') return `server busy, again in ${making.seconds} s`;
  if (stage === 'asked') return 'asked for';
  return isSharp ? 'refined' : 'coarse, being refined';
}

/** Whether other places precede the wanted one, or the server is busy. */
export function isHeld({ making }: Status): boolean {
  return making?.stage === 'busy' || (making?.stage === 'waiting' && making.before > 0);
}

function placeOf(status: Status): Readonly<Record<string, string>> {
  const made = madeOf(status);
  if (made !== null) return { Place: made };
  return { Region: `${status.region + 1} of ${status.regions ?? 1}` };
}

/** Short summary for small screens. */
export function shortly(status: Status): string {
  const made = madeOf(status);
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
