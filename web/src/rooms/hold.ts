/** Pointing while a key or button is held, and the point of the picture that is pointed at. */
import { hasOtherPurpose } from '../control/drive';

/** Physical code of the key that points. */
const POINTING_KEY = 'KeyE';
/** Number of a mouse's middle button, which also points. */
const MIDDLE_BUTTON = 1;
const PICTURE_CENTER = [0.5, 0.5] as const;

/** Position in the picture, as fractions of its width and height, from the upper left. */
export type ScreenPoint = readonly [number, number];

export type Hold = ReturnType<typeof createHold>;

/** Creates the controls. Key and mouse point at the cursor, if there is one, else at the centre, as `button` does. */
export function createHold(canvas: HTMLCanvasElement, button: HTMLElement) {
  const heldInputs = new Set<'key' | 'mouse' | 'button'>();
  let cursor: ScreenPoint = PICTURE_CENTER;

  window.addEventListener('keydown', (event) => {
    if (event.code === POINTING_KEY && !hasOtherPurpose(event)) heldInputs.add('key');
  });
  window.addEventListener('keyup', ({ code }) => {
    if (code === POINTING_KEY) heldInputs.delete('key');
  });
  // The release of a key outside the window is not reported.
  window.addEventListener('blur', () => heldInputs.clear());
  // In the capture phase, before the controls, which use the same button to move.
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
    /** Whether the user points without holding anything. */
    isAlwaysPointing: false,
    /** Point that the user points at; null while the user does not point. */
    get point(): ScreenPoint | null {
      if (heldInputs.size === 0 && !this.isAlwaysPointing) return null;
      const isLocked = document.pointerLockElement === canvas;
      return isLocked || (heldInputs.has('button') && heldInputs.size === 1) ? PICTURE_CENTER : cursor;
    },
  };
}
