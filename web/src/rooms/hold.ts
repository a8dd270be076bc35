/** Pointing while a key or button is held, and the point of the picture that is pointed at. */
import { hasOtherPurpose } from '../control/drive';

/** Physical code of the key that points. */
const POINTING_KEY = 'KeyE';
/** Number of a mouse's middle button, which also points. */
const MIDDLE_BUTTON = 1;
const PICTURE_CENTER = [0.5, 0.5] as const;

/** Position in the picture, as fractions of its width and height, from the upper left. */
export type ScreenPoint = readonly [number, number];

export interface Hold {
  /** Whether the user points without holding anything. */
  isAlways: boolean;
  /** Point that the user points at; null while the user does not point. */
  readonly point: ScreenPoint | null;
}

/**
 * Creates the controls. Key and mouse point at the cursor, or at the picture's centre if there is no cursor; `button`
 * points at the centre.
 */
export function createHold(canvas: HTMLCanvasElement, button: HTMLElement): Hold {
  const heldInputs = new Set<'key' | 'mouse' | 'button'>();
  let cursor: ScreenPoint = PICTURE_CENTER;
  let isAlways = false;

  type Action = (event: Event) => void;
  function listen(target: EventTarget, types: readonly string[], action: Action, capture = false): void {
    for (const name of types) target.addEventListener(name, action, { capture });
  }

  listen(window, ['keydown'], (event) => {
    const keyEvent = event as KeyboardEvent;
    if (keyEvent.code === POINTING_KEY && !hasOtherPurpose(keyEvent)) heldInputs.add('key');
  });
  listen(window, ['keyup'], (event) => {
    if ((event as KeyboardEvent).code === POINTING_KEY) heldInputs.delete('key');
  });
  // The release of a key outside the window is not reported.
  listen(window, ['blur'], () => heldInputs.clear());
  // In the capture phase, before the controls, which use the same button to move.
  listen(window, ['pointerdown'], (event) => {
    const { target, pointerType, button: number, pointerId } = event as PointerEvent;
    if (target !== canvas || pointerType !== 'mouse' || number !== MIDDLE_BUTTON) return;
    event.stopImmediatePropagation();
    canvas.setPointerCapture(pointerId);
    heldInputs.add('mouse');
  }, true);
  // Prevents the browser from scrolling.
  listen(canvas, ['mousedown'], (event) => {
    if ((event as MouseEvent).button === MIDDLE_BUTTON) event.preventDefault();
  });
  listen(canvas, ['pointerup', 'pointercancel'], () => heldInputs.delete('mouse'));
  listen(canvas, ['pointermove', 'pointerleave'], (event) => {
    const { pointerType, clientX, clientY, type } = event as PointerEvent;
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const isCursor = pointerType === 'mouse' && type === 'pointermove';
    cursor = isCursor ? [(clientX - left) / Math.max(width, 1), (clientY - top) / Math.max(height, 1)] : PICTURE_CENTER;
  });
  listen(button, ['pointerdown'], (event) => {
    button.setPointerCapture((event as PointerEvent).pointerId);
    heldInputs.add('button');
  });
  listen(button, ['pointerup', 'pointercancel'], () => heldInputs.delete('button'));
  // A long touch would open the browser's menu.
  listen(button, ['contextmenu'], (event) => event.preventDefault());

  return {
    get isAlways() {
      return isAlways;
    },
    set isAlways(next) {
      isAlways = next;
    },
    get point() {
      if (heldInputs.size === 0 && !isAlways) return null;
      const isLocked = document.pointerLockElement === canvas;
      return isLocked || (heldInputs.has('button') && heldInputs.size === 1) ? PICTURE_CENTER : cursor;
    },
  };
}
