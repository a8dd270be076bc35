/** Elements over the picture: the divider, the mark of the left thumb, and a line while the server loads the scene. */
import { type Thumb, THUMB_REACH } from '../control/pointers';
import { icon, ICONS, make } from './dom';

/** Shares of the width by which keys move the divider. */
const [KEY_STEP, PAGE_STEP] = [0.01, 0.1] as const;
/** Pixels that a label needs beside its own width: from the line to the label, and from the label to the edge. */
const LABEL_MARGIN = 40;
/** Initial position of the divider. */
export const MIDDLE = 0.5;

/** Creates a divider; calls `onChange` after each change by the user or by `set`. */
export function createDivider(root: HTMLElement, onChange: (share: number | null) => void) {
  const label = (side: string, text: string): HTMLElement =>
    make('span', { class: `divider-label divider-${side}`, 'aria-hidden': 'true' }, text);
  const [left, right] = [label('left', 'Conventional'), label('right', 'Continuous')];
  const line = make(
    'div',
    {
      class: 'divider', role: 'slider', tabindex: '0', 'aria-orientation': 'horizontal',
      'aria-label': 'Divider between the conventional picture, left, and the continuous one, right',
      'aria-valuemin': '0', 'aria-valuemax': '100',
    },
    left,
    make('span', { class: 'divider-grip' }, icon(ICONS.grip)),
    right,
  );
  const layer = make('div', { class: 'divider-layer', hidden: true }, line);
  root.prepend(layer);
  new ResizeObserver(updateLabels).observe(layer);
  let share: number | null = null;

  /** Sets the share of the width that is conventional, 0 to 1; null removes the divider. */
  function set(next: number | null): void {
    const newShare = next === null || Number.isNaN(next) ? null : Math.min(Math.max(next, 0), 1);
    if (newShare === share) return;
    share = newShare;
    layer.hidden = share === null;
    if (share !== null) {
      const percent = String(Math.round(100 * share));
      // The page's security policy forbids style attributes, but scripts may set style properties.
      layer.style.setProperty('--share', String(share));
      line.setAttribute('aria-valuenow', percent);
      line.setAttribute('aria-valuetext', `${percent} percent conventional`);
      updateLabels();
    }
    onChange(share);
  }

  /** Hides labels that have too little room beside the line. */
  function updateLabels(): void {
    const [width, part] = [layer.clientWidth, share ?? MIDDLE];
    left.classList.toggle('is-cut', left.offsetWidth + LABEL_MARGIN > part * width);
    right.classList.toggle('is-cut', right.offsetWidth + LABEL_MARGIN > (1 - part) * width);
  }

  line.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    line.setPointerCapture(event.pointerId);
    line.focus({ preventScroll: true });
    event.preventDefault();
  });
  line.addEventListener('pointermove', (event) => {
    if (!line.hasPointerCapture(event.pointerId)) return;
    const { left, width } = layer.getBoundingClientRect();
    set((event.clientX - left) / Math.max(width, 1));
  });
  line.addEventListener('keydown', (event) => {
    const next = nextShare(event.key, share ?? MIDDLE);
    if (next === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    set(next);
    // The same keys would also move the user.
    event.preventDefault();
    event.stopPropagation();
  });

  return { set };
}

/** Returns where a key moves the divider: null removes the divider, undefined means that the key does not move it. */
export function nextShare(key: string, share: number): number | null | undefined {
  const moves = new Map<string, number | null>([
    ['ArrowLeft', share - KEY_STEP],
    ['ArrowDown', share - KEY_STEP],
    ['ArrowRight', share + KEY_STEP],
    ['ArrowUp', share + KEY_STEP],
    ['PageDown', share - PAGE_STEP],
    ['PageUp', share + PAGE_STEP],
    ['Home', 0],
    ['End', 1],
    ['Escape', null],
  ]);
  const next = moves.get(key);
  return typeof next === 'number' ? Math.min(Math.max(next, 0), 1) : next;
}

export function createThumbMark(root: HTMLElement) {
  const ring = make('div', { class: 'thumb', hidden: true, 'aria-hidden': 'true' }, make('span', {}));
  root.append(ring);
  return {
    show(thumb: Thumb | null): void {
      ring.hidden = thumb === null;
      if (!thumb) return;
      const { x, y, right, down } = thumb;
      const share = Math.min(1, THUMB_REACH / Math.max(Math.hypot(right, down), 1));
      const offsets = { '--x': x, '--y': y, '--right': right * share, '--down': down * share };
      for (const [name, pixels] of Object.entries(offsets)) ring.style.setProperty(name, `${pixels}px`);
    },
  };
}

/** Creates the line that says that the server loads the scene. */
export function createLoadingLine(root: HTMLElement) {
  const line = make('p', { class: 'wait card', role: 'status' }, 'The server loads the scene…');
  return { show: (): void => root.append(line), hide: (): void => line.remove() };
}
