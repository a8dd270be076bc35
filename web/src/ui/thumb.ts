/** Mark where the left thumb was set down to walk, and of its displacement. */
import { type Thumb, THUMB_REACH } from '../control/pointers';
import { make } from './dom';

export interface ThumbMark {
  show(thumb: Thumb | null): void;
  dispose(): void;
}

export function createThumbMark(root: HTMLElement): ThumbMark {
  const ring = make('div', { class: 'thumb', hidden: true, 'aria-hidden': 'true' }, make('span', {}));
  root.append(ring);
  return {
    show(thumb) {
      ring.hidden = thumb === null;
      if (!thumb) return;
      const { x, y, right, down } = thumb;
      const share = Math.min(1, THUMB_REACH / Math.max(Math.hypot(right, down), 1));
      const places = { '--x': x, '--y': y, '--right': right * share, '--down': down * share };
      for (const [name, pixels] of Object.entries(places)) ring.style.setProperty(name, `${pixels}px`);
    },
    dispose: () => ring.remove(),
  };
}
