/** Pointing by a held key or button, and the pointed place of the picture. */
import { hasOtherPurpose } from '../control/drive';

/** Code of the key, by its position; number of a mouse's middle button. */
const [KEY, MIDDLE_BUTTON] = ['KeyE', 1] as const;
const MIDDLE = [0.5, 0.5] as const;

/** Position as shares of the picture's width and height, from the upper left. */
export type Place = readonly [number, number];

export interface Hold {
  /** Whether the user points without holding anything. */
  isAlways: boolean;
  /** Pointed place; null while the user does not point. */
  readonly place: Place | null;
}

/** Creates the controls: key and mouse point at the cursor, or the middle without one; the button at the middle. */
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
    if (pressed.code === KEY && !hasOtherPurpose(pressed)) held.add('key');
  });
  listen(window, ['keyup'], (event) => {
    if ((event as KeyboardEvent).code === KEY) held.delete('key');
  });
  // The release of a key outside the window is not reported.
  listen(window, ['blur'], () => held.clear());
  // In the capture phase, before the controls, which use the same button to move.
  listen(window, ['pointerdown'], (event) => {
    const { target, pointerType, button: number, pointerId } = event as PointerEvent;
    if (target !== canvas || pointerType !== 'mouse' || number !== MIDDLE_BUTTON) return;
    event.stopImmediatePropagation();
    canvas.setPointerCapture(pointerId);
    held.add('mouse');
  }, true);
  // Prevents the browser from scrolling.
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
  // A long touch would open the browser's menu.
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
