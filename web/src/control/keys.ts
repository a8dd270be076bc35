/** Keys that move the user while held. */
import { type Drive, clampLength } from './drive';

/** Steps to the right and ahead, turns to the left and up, by physical key code. */
const AXES: Readonly<Record<string, readonly [number, number, number, number]>> = {
  KeyW: [0, 1, 0, 0],
  KeyS: [0, -1, 0, 0],
  KeyA: [-1, 0, 0, 0],
  KeyD: [1, 0, 0, 0],
  ArrowUp: [0, 1, 0, 0],
  ArrowDown: [0, -1, 0, 0],
  ArrowLeft: [0, 0, 1, 0],
  ArrowRight: [0, 0, -1, 0],
  PageUp: [0, 0, 0, 1],
  PageDown: [0, 0, 0, -1],
};

/** Whether a key moves the user, by its physical code. */
export function isMoving(code: string): boolean {
  return Object.hasOwn(AXES, code);
}

/** Whether a key event has another purpose: a browser shortcut, or typing into a field. */
export function isElsewhere(event: KeyboardEvent): boolean {
  if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return true;
  const { target } = event;
  return typeof Element !== 'undefined' && target instanceof Element && target.closest(TYPED) !== null;
}

const TYPED = 'input, textarea, select, [contenteditable], dialog[open]';

export interface Keys {
  readonly drive: Drive;
  dispose(): void;
}

/** Listens to keys of a window or an element. */
export function createKeys(source: EventTarget): Keys {
  const held = new Set<string>();
  const stop = new AbortController();
  const listen = (name: string, action: (event: Event) => void): void =>
    source.addEventListener(name, action, { signal: stop.signal });
  let isHasty = false;

  listen('keydown', (event) => {
    const pressed = event as KeyboardEvent;
    isHasty = pressed.shiftKey;
    if (!isMoving(pressed.code) || isElsewhere(pressed)) return;
    held.add(pressed.code);
    // Otherwise arrow keys scroll.
    pressed.preventDefault();
  });
  listen('keyup', (event) => {
    isHasty = (event as KeyboardEvent).shiftKey;
    held.delete((event as KeyboardEvent).code);
    // macOS sends no keyup events while Command is held.
    if ((event as KeyboardEvent).key === 'Meta') held.clear();
  });
  // A key released elsewhere sends no event.
  listen('blur', () => {
    held.clear();
    isHasty = false;
  });

  return {
    get drive() {
      const sums = [0, 0, 0, 0];
      for (const code of held) AXES[code]?.forEach((value, axis) => (sums[axis] = (sums[axis] ?? 0) + value));
      const [right = 0, ahead = 0, turn = 0, look = 0] = sums;
      const [across, along] = clampLength(right, ahead);
      return { right: across, ahead: along, turn: Math.sign(turn), look: Math.sign(look), isHasty };
    },
    dispose: () => stop.abort(),
  };
}
