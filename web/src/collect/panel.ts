/** Card of the task: remaining time and results during a trial, and the trial's figures at its end. */
import { button, make, write } from '../ui/dom';
import { milliseconds } from '../ui/format';
import { LEVELS, type Trial } from './messages';
import type { Task } from './task';

export interface CardState {
  readonly instruction: string;
  readonly canStart: boolean;
  /** Scores of other groups, as text. */
  readonly otherScores: string;
  /** Null outside the room. */
  readonly task: Task | null;
  readonly now: number;
  /** Frames per second; null if unknown. */
  readonly frameRate: number | null;
  /** Seconds; null if unknown. */
  readonly roundTrip: number | null;
}

/** Builds the card above the page's buttons; `start` begins a run. */
export function createPanel(root: HTMLElement, start: () => void) {
  const instruction = make('p', { class: 'collect-words', role: 'status' });
  const title = make('h2', {}, 'Sphere collection');
  const figureNames = ['Left', 'Level', 'Aiming', 'Spheres', 'Misses'] as const;
  const figureCells = figureNames.map(() => make('dd', {}));
  const figures = make(
    'dl',
    { class: 'collect-figures' },
    ...figureNames.map((name, index) => make('div', {}, make('dt', {}, name), figureCells[index] ?? '')),
  );
  const otherScores = make('p', { class: 'collect-words' });
  const rows = LEVELS.map(() => [make('td', {}), make('td', {}), make('td', {})]);
  const table = make(
    'table',
    { class: 'collect-table' },
    make('tr', {}, ...['Level', 'Spheres', 'Seconds', 'Misses'].map((name) => make('th', { scope: 'col' }, name))),
    ...LEVELS.map((level, index) => make('tr', {}, make('th', { scope: 'row' }, level), ...(rows[index] ?? []))),
  );
  const speedLine = make('p', { class: 'collect-words' });
  const startButton = button('Start', 'button-main', start);
  const card = make(
    'section',
    { class: 'card collect', 'aria-label': 'Sphere collection' },
    make('header', {}, title, startButton),
    figures,
    table,
    speedLine,
    otherScores,
    instruction,
  );
  root.querySelector('.bottom')?.prepend(card);

  function showTrial(task: Task, trial: Trial, { now, frameRate, roundTrip }: CardState): void {
    write(title, `Trial ${trial.trial} of ${trial.trials}`);
    figures.hidden = trial.over;
    table.hidden = speedLine.hidden = !trial.over;
    const aiming = task.sphere ? `${task.aims.length}/${task.needed}` : '–';
    const counts = [task.count, task.collectedMisses + task.misses].map(String);
    const texts = [formatClock(trial.duration - task.elapsed(now)), task.sphere?.level ?? '–', aiming, ...counts];
    texts.forEach((text, index) => figureCells[index] && write(figureCells[index], text));
    trial.tallies.forEach(({ spheres, seconds, misses }, index) => {
      const cells = [String(spheres), spheres > 0 ? (seconds / spheres).toFixed(2) : '–', String(misses)];
      cells.forEach((text, column) => {
        const cell = rows[index]?.[column];
        if (cell) write(cell, text);
      });
    });
    const rateText = frameRate === null ? [] : [`${frameRate.toFixed(1)} frames a second`];
    const tripText = roundTrip === null ? [] : [`round trip ${milliseconds(1000 * roundTrip)}`];
    write(speedLine, [...rateText, ...tripText].join(', '));
  }

  return {
    update(state: CardState): void {
      write(instruction, state.instruction);
      instruction.hidden = state.instruction === '';
      write(otherScores, state.otherScores);
      otherScores.hidden = state.otherScores === '';
      startButton.hidden = !state.canStart;
      if (state.task?.trial) showTrial(state.task, state.task.trial, state);
      else figures.hidden = table.hidden = speedLine.hidden = true;
    },
  };
}

/** Formats a time as `2:05`, rounded up to whole seconds. */
function formatClock(seconds: number): string {
  const rounded = Math.max(Math.ceil(seconds), 0);
  return `${Math.floor(rounded / 60)}:${String(rounded % 60).padStart(2, '0')}`;
}
