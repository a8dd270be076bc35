/** Whether the user holds something down to point, and at what part of the picture. */
import { isElsewhere } from '../control/keys';

/** The key, by its place on the keyboard, and the number of the middle button of a mouse. */
const [KEY, MIDDLE_BUTTON] = ['KeyE', 1] as const;
const MIDDLE = [0.5, 0.5] as const;

/** Parts of the picture's width and height, from the upper left. */
export type Place = readonly [number, number];

export interface Hold {
  /** Whether the user points also while nothing is held. */
  isAlways: boolean;
  /** Where the user points; null while it does not. */
  readonly place: Place | null;
}

/** The key and the mouse point at the cursor, or at the middle where there is none; a button of the page there. */
export function createHold(canvas: HTMLCanvasElement, button: HTMLElement): Hold {
  const held = new Set<'key' | 'mouse' | 'button'>();
  let cursor: Place = MIDDLE;
  let isAlways = false;

  type Action = (event: Event) => void;
  function listen(target: EventTarget, names: readonly string[], action: Action, capture = false): void {
    for (const name of names) target.addEventListener(name, action, { capture });
  }

  listen(window, ['keydown'], (event) => {
    const pressed = event as KeyboardEvent;
    if (pressed.code === KEY && !isElsewhere(pressed)) held.add('key');
  });
  listen(window, ['keyup'], (event) => {
    if ((event as KeyboardEvent).code === KEY) held.delete('key');
  });
  // A key that is let go elsewhere is not heard.
  listen(window, ['blur'], () => held.clear());
  // Before the controls, which move by the same button.
  listen(window, ['pointerdown'], (event) => {
    const { target, pointerType, button: number, pointerId } = event as PointerEvent;
    if (target !== canvas || pointerType !== 'mouse' || number !== MIDDLE_BUTTON) return;
    event.stopImmediatePropagation();
    canvas.setPointerCapture(pointerId);
    held.add('mouse');
  }, true);
  // Browsers scroll by it, else.
  listen(canvas, ['mousedown'], (event) => {
    if ((event as MouseEvent).button === MIDDLE_BUTTON) event.preventDefault();
  });
  listen(canvas, ['pointerup', 'pointercancel'], () => held.delete('mouse'));
  listen(canvas, ['pointermove', 'pointerleave'], (event) => {
    const { pointerType, clientX, clientY, type } = event as PointerEvent;
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const isCursor = pointerType === 'mouse' && type === 'pointermove';
    cursor = isCursor ? [(clientX - left) / Math.max(width, 1), (clientY - top) / Math.max(height, 1)] : MIDDLE;
  });
  listen(button, ['pointerdown'], (event) => {
    button.setPointerCapture((event as PointerEvent).pointerId);
    held.add('button');
  });
  listen(button, ['pointerup', 'pointercancel'], () => held.delete('button'));
  // A finger that stays would call up the browser's menu.
  listen(button, ['contextmenu'], (event) => event.preventDefault());

  return {
    get isAlways() {
      return isAlways;
    },
    set isAlways(next) {
      isAlways = next;
    },
    get place() {
      if (held.size === 0 && !isAlways) return null;
      const isLocked = document.pointerLockElement === canvas;
      return isLocked || (held.has('button') && held.size === 1) ? MIDDLE : cursor;
    },
  };
}
