/** Pointing at the picture while a key or button is held. */
import { hasOtherPurpose } from '../control/drive';

/** Physical code of the key that points. */
const POINTING_KEY = 'KeyE';
/** Number of a mouse's middle button, which also points. */
const MIDDLE_BUTTON = 1;
const PICTURE_CENTER = [0.5, 0.5] as const;

/** Position in the picture, as fractions of its width and height, from the upper left. */
export type ScreenPoint = readonly [number, number];

export type Hold = ReturnType<typeof createHold>;

/**
 * Creates the controls of the pointer. The key and the mouse point at the cursor, or at the centre if there is no
 * cursor; `button` points at the centre.
 */
export function createHold(canvas: HTMLCanvasElement, button: HTMLElement) {
  const heldInputs = new Set<'key' | 'mouse' | 'button'>();
  let cursor: ScreenPoint = PICTURE_CENTER;

  window.addEventListener('keydown', (event) => {
    if (event.code === POINTING_KEY && !hasOtherPurpose(event)) heldInputs.add('key');
  });
  window.addEventListener('keyup', ({ code }) => {
    if (code === POINTING_KEY) heldInputs.delete('key');
  });
  // Browsers do not report the release of a key outside the window.
  window.addEventListener('blur', () => heldInputs.clear());
  // This listener is called in the capture phase, before those of the movement controls, which use the same button.
  window.addEventListener('pointerdown', (event) => {
    const { target, pointerType, button: number, pointerId } = event;
    if (target !== canvas || pointerType !== 'mouse' || number !== MIDDLE_BUTTON) return;
    event.stopImmediatePropagation();
    canvas.setPointerCapture(pointerId);
    heldInputs.add('mouse');
  }, { capture: true });
  // Prevents the browser from scrolling.
  canvas.addEventListener('mousedown', (event) => {
    if (event.button === MIDDLE_BUTTON) event.preventDefault();
  });
  canvas.addEventListener('pointermove', ({ pointerType, clientX, clientY }) => {
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const place = [(clientX - left) / Math.max(width, 1), (clientY - top) / Math.max(height, 1)] as const;
    cursor = pointerType === 'mouse' ? place : PICTURE_CENTER;
  });
  canvas.addEventListener('pointerleave', () => (cursor = PICTURE_CENTER));
  button.addEventListener('pointerdown', ({ pointerId }) => {
    button.setPointerCapture(pointerId);
    heldInputs.add('button');
  });
  // A long touch would open the browser's menu.
  button.addEventListener('contextmenu', (event) => event.preventDefault());
  for (const name of ['pointerup', 'pointercancel'] as const) {
    canvas.addEventListener(name, () => heldInputs.delete('mouse'));
    button.addEventListener(name, () => heldInputs.delete('button'));
  }

  return {
    /** Whether the user also points without holding a key or button. */
    isAlwaysPointing: false,
    /** Point that the user points at; null while the user does not point. */
    get point(): ScreenPoint | null {
      if (heldInputs.size === 0 && !this.isAlwaysPointing) return null;
      const isLocked = document.pointerLockElement === canvas;
      return isLocked || (heldInputs.has('button') && heldInputs.size === 1) ? PICTURE_CENTER : cursor;
    },
  };
}
