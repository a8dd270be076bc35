/** A line that divides the picture into conventional (left) and continuous (right), and that can be dragged. */
import { icon, make } from './dom';
import { ICONS } from './icons';

/** Parts of the width by which keys move it. */
const [STEP, LEAP] = [0.01, 0.1] as const;
/** Pixels from the line to a name, and from there to the edge. */
const BESIDE = 40;
/** Where it stands at first. */
export const MIDDLE = 0.5;

export interface Divider {
  /** Part of the picture that is conventional, 0 to 1; null while there is no divider. */
  readonly share: number | null;
  set(share: number | null): void;
  dispose(): void;
}

/** `changed` is told of every change, by the user or by `set`. */
export function createDivider(root: HTMLElement, changed: (share: number | null) => void): Divider {
  const label = (side: string, text: string): HTMLElement =>
    make('span', { class: `divider-label divider-${side}`, 'aria-hidden': 'true' }, text);
  const [left, right] = [label('left', 'Conventional'), label('right', 'Continuous')];
  const line = make(
    'div',
    {
      class: 'divider',
      role: 'slider',
      tabindex: '0',
      'aria-label': 'Divider between the conventional picture, left, and the continuous one, right',
      'aria-orientation': 'horizontal',
      'aria-valuemin': '0',
      'aria-valuemax': '100',
    },
    left,
    make('span', { class: 'divider-grip' }, icon(ICONS.grip)),
    right,
  );
  const layer = make('div', { class: 'divider-layer', hidden: true }, line);
  root.prepend(layer);
  const watch = new ResizeObserver(arrange);
  watch.observe(layer);
  let share: number | null = null;

  function set(next: number | null): void {
    const wanted = next === null || Number.isNaN(next) ? null : Math.min(Math.max(next, 0), 1);
    if (wanted === share) return;
    share = wanted;
    layer.hidden = share === null;
    if (share !== null) {
      const percent = String(Math.round(100 * share));
      // The policy of the page forbids style attributes, not properties that a script sets.
      layer.style.setProperty('--share', String(share));
      line.setAttribute('aria-valuenow', percent);
      line.setAttribute('aria-valuetext', `${percent} percent conventional`);
      arrange();
    }
    changed(share);
  }

  /** A name for which there is no room beside the line is not shown. */
  function arrange(): void {
    const [width, part] = [layer.clientWidth, share ?? MIDDLE];
    left.classList.toggle('is-cut', left.offsetWidth + BESIDE > part * width);
    right.classList.toggle('is-cut', right.offsetWidth + BESIDE > (1 - part) * width);
  }

  function drag(event: PointerEvent): void {
    if (!line.hasPointerCapture(event.pointerId)) return;
    const { left, width } = layer.getBoundingClientRect();
    set((event.clientX - left) / Math.max(width, 1));
  }

  line.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    line.setPointerCapture(event.pointerId);
    line.focus({ preventScroll: true });
    event.preventDefault();
  });
  line.addEventListener('pointermove', drag);
  line.addEventListener('keydown', (event) => {
    const next = nextShare(event.key, share ?? MIDDLE);
    if (next === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    set(next);
    // The same keys walk, else.
    event.preventDefault();
    event.stopPropagation();
  });

  return {
    get share() {
      return share;
    },
    set,
    dispose() {
      watch.disconnect();
      layer.remove();
    },
  };
}

/** Where a key moves the divider; null takes it away, undefined is another key. */
export function nextShare(key: string, share: number): number | null | undefined {
  const moves = new Map<string, number | null>([
    ['ArrowLeft', share - STEP],
    ['ArrowDown', share - STEP],
    ['ArrowRight', share + STEP],
    ['ArrowUp', share + STEP],
    ['PageDown', share - LEAP],
    ['PageUp', share + LEAP],
    ['Home', 0],
    ['End', 1],
    ['Escape', null],
  ]);
  const next = moves.get(key);
  return typeof next === 'number' ? Math.min(Math.max(next, 0), 1) : next;
}
