/** Card of the task: results so far, remaining time, and the figures of a trial at its end. */
import { button, make, write } from '../ui/dom';
import { milliseconds } from '../ui/format';
import { LEVELS, type Tallies } from './messages';

/** Content of the card. */
export interface Told {
  /** Instruction for the user. */
  readonly words: string;
  readonly canStart: boolean;
  /** Null before the first trial. */
  readonly trial: TrialTold | null;
  /** Scores of other groups, as text. */
  readonly others: string;
}

export interface TrialTold {
  /** Title, such as `Trial 1 of 3`. */
  readonly title: string;
  readonly left: number;
  /** Level of the sphere; empty without a sphere. */
  readonly level: string;
  readonly aiming: string;
  readonly spheres: number;
  readonly misses: number;
  readonly over: boolean;
  readonly tallies: Tallies;
  /** Frames per second, and round-trip time in seconds; null if unknown. */
  readonly frames: number | null;
  readonly roundTrip: number | null;
}

export interface CollectPanel {
  update(told: Told): void;
}

/** Builds the card above the page's buttons; `start` begins a run. */
export function createPanel(root: HTMLElement, start: () => void): CollectPanel {
  const words = make('p', { class: 'collect-words', role: 'status' });
  const title = make('h2', {}, 'Sphere collection');
  const names = ['Left', 'Level', 'Aiming', 'Spheres', 'Misses'] as const;
  const values = names.map(() => make('dd', {}));
  const figures = make(
    'dl',
    { class: 'collect-figures' },
    ...names.map((name, at) => make('div', {}, make('dt', {}, name), values[at] ?? '')),
  );
  const others = make('p', { class: 'collect-words' });
  const rows = LEVELS.map(() => [make('td', {}), make('td', {}), make('td', {})]);
  const table = make(
    'table',
    { class: 'collect-table' },
    make('tr', {}, ...['Level', 'Spheres', 'Seconds', 'Misses'].map((name) => make('th', { scope: 'col' }, name))),
    ...LEVELS.map((level, at) => make('tr', {}, make('th', { scope: 'row' }, level), ...(rows[at] ?? []))),
  );
  const device = make('p', { class: 'collect-words' });
  const begin = button('Start', 'button-main', start);
  const card = make(
    'section',
    { class: 'card collect', 'aria-label': 'Sphere collection' },
    make('header', {}, title, begin),
    figures,
    table,
    device,
    others,
    words,
  );
  root.querySelector('.bottom')?.prepend(card);

  function tellTrial({ title: name, over, ...told }: TrialTold): void {
    write(title, name);
    figures.hidden = over;
    table.hidden = device.hidden = !over;
    const counts = [told.spheres, told.misses].map(String);
    const texts = [clock(told.left), told.level || '–', told.aiming || '–', ...counts];
    texts.forEach((text, at) => values[at] && write(values[at], text));
    told.tallies.forEach(({ spheres, seconds, misses }, at) => {
      const cells = [String(spheres), spheres > 0 ? (seconds / spheres).toFixed(2) : '–', String(misses)];
      cells.forEach((text, column) => {
        const cell = rows[at]?.[column];
        if (cell) write(cell, text);
      });
    });
    const rate = told.frames === null ? [] : [`${told.frames.toFixed(1)} frames a second`];
    const trip = told.roundTrip === null ? [] : [`round trip ${milliseconds(1000 * told.roundTrip)}`];
    write(device, [...rate, ...trip].join(', '));
  }

  return {
    update(told) {
      write(words, told.words);
      words.hidden = told.words === '';
      write(others, told.others);
      others.hidden = told.others === '';
      begin.hidden = !told.canStart;
      if (told.trial) tellTrial(told.trial);
      else figures.hidden = table.hidden = device.hidden = true;
    },
  };
}

/** Formats a time as `2:05`, rounded up to whole seconds. */
function clock(seconds: number): string {
  const whole = Math.max(Math.ceil(seconds), 0);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}`;
}
