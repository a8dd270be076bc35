/** Card of the task: results so far, remaining time, and the figures of a trial at its end. */
import { button, make, write } from '../ui/dom';
import { milliseconds } from '../ui/format';
import { LEVELS, type Tallies } from './messages';

/** Content of the card. */
export interface CardState {
  /** Instruction for the user. */
  readonly words: string;
  readonly canStart: boolean;
  /** Null before the first trial. */
  readonly trial: TrialState | null;
  /** Scores of other groups, as text. */
  readonly others: string;
}

export interface TrialState {
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
  update(state: CardState): void;
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

  function showTrial({ title: name, over, ...state }: TrialState): void {
    write(title, name);
    figures.hidden = over;
    table.hidden = device.hidden = !over;
    const counts = [state.spheres, state.misses].map(String);
    const texts = [clock(state.left), state.level || '–', state.aiming || '–', ...counts];
    texts.forEach((text, at) => values[at] && write(values[at], text));
    state.tallies.forEach(({ spheres, seconds, misses }, at) => {
      const cells = [String(spheres), spheres > 0 ? (seconds / spheres).toFixed(2) : '–', String(misses)];
      cells.forEach((text, column) => {
        const cell = rows[at]?.[column];
        if (cell) write(cell, text);
      });
    });
    const rate = state.frames === null ? [] : [`${state.frames.toFixed(1)} frames a second`];
    const trip = state.roundTrip === null ? [] : [`round trip ${milliseconds(1000 * state.roundTrip)}`];
    write(device, [...rate, ...trip].join(', '));
  }

  return {
    update(state) {
      write(words, state.words);
      words.hidden = state.words === '';
      write(others, state.others);
      others.hidden = state.others === '';
      begin.hidden = !state.canStart;
      if (state.trial) showTrial(state.trial);
      else figures.hidden = table.hidden = device.hidden = true;
    },
  };
}

/** Formats a time as `2:05`, rounded up to whole seconds. */
function clock(seconds: number): string {
  const whole = Math.max(Math.ceil(seconds), 0);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}`;
}
