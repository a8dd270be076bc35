/** Panel with figures, and the buttons below the picture. */
import { button, icon, ICONS, make, write } from '../ui/dom';
import { bytes, count, metres, milliseconds, rate } from '../ui/format';
import type { Facts } from './show/resident';

const NAMES = {
  frame: 'Frame',
  splats: 'Splats',
  views: 'Views',
  waiting: 'Waiting',
  loaded: 'Loaded',
  memory: 'On the GPU',
  height: 'Height',
} as const;

export interface Figures {
  readonly facts: Facts;
  /** Duration of the last picture, milliseconds. */
  readonly frame: number;
  readonly received: number;
  /** Received bits per second; null while nothing arrives. */
  readonly rate: number | null;
  /** Height above the ground, metres. */
  readonly height: number;
  /** Base-2 logarithm of the speed factor. */
  readonly speedExponent: number;
}

export function createPanel(root: HTMLElement, home: () => void) {
  const values = new Map<string, HTMLElement>();
  const terms = Object.entries(NAMES).map(([key, name]) => {
    const value = make('dd', {}, '–');
    values.set(key, value);
    return make('div', {}, make('dt', {}, name), value);
  });
  const figures = make('div', { class: 'panel card', role: 'region', 'aria-label': 'Figures' });
  const chip = button('Figures', 'chip card', () => show(true));
  const hide = make('button', { type: 'button', 'aria-label': 'Hide the figures', title: 'Hide' }, icon(ICONS.close));
  hide.addEventListener('click', () => show(false));
  figures.append(
    make('header', {}, make('h1', {}, 'nearfar'), hide),
    make('div', { class: 'panel-body' }, make('dl', { class: 'figures' }, ...terms)),
  );
  const help = make('p', { class: 'note card', hidden: true }, HELP);
  const toggle = button('Help', 'tool', () => (help.hidden = !help.hidden));
  const tools = make('div', { class: 'tools' }, button('Home', 'tool', home), toggle);
  const rows = [make('div', { class: 'top' }, figures, chip), make('div', { class: 'bottom' }, help, tools)];
  root.append(make('div', { class: 'frame' }, ...rows));

  function show(isShown: boolean): void {
    figures.hidden = !isShown;
    chip.hidden = isShown;
  }
  // On a phone the panel would cover the picture.
  show(window.innerWidth > 600);

  return {
    update({ facts, frame, received, rate: bits, height, speedExponent }: Figures): void {
      const put = (name: keyof typeof NAMES, text: string): void => write(values.get(name) as HTMLElement, text);
      put('frame', milliseconds(frame));
      // Splats in the picture, then those of unoccluded parts.
      put('splats', count(facts.splats) + (facts.drawnSplats === null ? '' : `, ${count(facts.drawnSplats)} drawn`));
      put('views', facts.standIns > 0 ? `${facts.views}, ${facts.standIns} coarser` : String(facts.views));
      const unbuilt = facts.unbuilt > 0 ? `, ${count(facts.unbuilt)} cells not built yet` : '';
      put('waiting', (facts.waiting > 0 ? `${facts.waiting} views` : 'nothing') + unbuilt);
      put('loaded', bits === null ? bytes(received) : `${bytes(received)}, ${rate(bits)}`);
      put('memory', bytes(facts.bytes));
      const speed = speedExponent === 0 ? '' : `, speed × ${(2 ** speedExponent).toFixed(speedExponent < 0 ? 2 : 1)}`;
      put('height', metres(height) + speed);
    },
  };
}

const HELP =
  'Drag to look around. Fly with W A S D or the left thumb, up and down with E and Q, and turn with the arrow keys. ' +
  'Shift is four times as fast, the wheel changes the speed. The address in the browser leads back to this place.';
