/** Mouse, pen and touch: dragging, two fingers, the wheel, and a locked pointer. */
import { beyondRest, type Drive, REST } from './drive';
import { createTaps } from './taps';

/** Radians by which dragging over the height of the picture turns a walker's head, and a view around its point. */
const [LOOK, AROUND] = [1.6, Math.PI] as const;
/** Parts of the distance by which dragging over the height of the picture moves an orbit's point. */
const PAN = 1.5;
/** Power of e by which a pixel of the wheel changes the distance; pixels of a line and of a page. */
const WHEEL = 0.0015;
const WHEEL_PIXELS = [1, 16, 400] as const;
/** Pixels from where the left thumb was set down to full speed, and the part of them that counts as at rest. */
export const THUMB_REACH = 56;
const THUMB_REST = 0.12;

export type Mode = 'walk' | 'orbit';

/** The left thumb: where it was set down, and where it is from there, pixels of the window. */
export interface Thumb {
  readonly x: number;
  readonly y: number;
  readonly right: number;
  readonly down: number;
}

export interface PointerActions {
  readonly mode: () => Mode;
  /** Turn a walker's head, or go around the point: radians to the left and up. */
  look(left: number, up: number): void;
  rotate(left: number, up: number): void;
  pan(right: number, up: number): void;
  zoom(factor: number): void;
  /** The left thumb has moved, or is gone. */
  thumb(thumb: Thumb | null): void;
  /** Two taps or clicks ask for a place, in parts of the picture's width and height from its upper left. */
  go(x: number, y: number): void;
}

export interface Pointers {
  /** Request of the left thumb. */
  readonly drive: Drive;
  /** Look around with the mouse without a button, until Escape. */
  lock(): void;
  /** Forget all fingers: the mode has changed. */
  release(): void;
  dispose(): void;
}

/** A finger or a mouse with a button down. */
interface Down {
  readonly x: number;
  readonly y: number;
  /** `step`: the left thumb; `pan`: another button than the first. */
  readonly task: 'turn' | 'step' | 'pan';
}

export function createPointers(element: HTMLElement, actions: PointerActions): Pointers {
  const downs = new Map<number, Down>();
  const stop = new AbortController();
  let drive = REST;

  const taps = createTaps(go);
  let isTouch = false;

  const scale = (): number => 1 / Math.max(element.clientHeight, 1);
  const isLocked = (): boolean => element.ownerDocument.pointerLockElement === element;

  function go({ clientX, clientY }: { readonly clientX: number; readonly clientY: number }): void {
    const { left, top, width, height } = element.getBoundingClientRect();
    // A locked pointer is in the middle.
    if (isLocked()) actions.go(0.5, 0.5);
    else actions.go((clientX - left) / Math.max(width, 1), (clientY - top) / Math.max(height, 1));
  }

  function down(event: PointerEvent): void {
    // A locked pointer looks around by itself, and cannot be captured.
    if (isLocked()) return;
    isTouch = event.pointerType === 'touch';
    const isMouse = event.pointerType === 'mouse';
    const isFirst = event.button === 0 && !event.shiftKey;
    if (actions.mode() === 'walk' && isMouse && !isFirst) return;
    element.setPointerCapture(event.pointerId);
    if (isTouch) taps.down(event);
    const task = isThumb(event) ? 'step' : isFirst ? 'turn' : 'pan';
    downs.set(event.pointerId, { x: event.clientX, y: event.clientY, task });
    if (task === 'step') step({ x: event.clientX, y: event.clientY }, event);
  }

  /** The first touch in the left half walks. */
  function isThumb({ pointerType, clientX }: PointerEvent): boolean {
    if (actions.mode() !== 'walk' || pointerType !== 'touch') return false;
    if ([...downs.values()].some(({ task }) => task === 'step')) return false;
    const { left, width } = element.getBoundingClientRect();
    return clientX - left < width / 2;
  }

  function move(event: PointerEvent): void {
    const before = downs.get(event.pointerId);
    if (!before) {
      if (isLocked()) actions.look(-event.movementX * LOOK * scale(), -event.movementY * LOOK * scale());
      return;
    }
    if (before.task === 'step') {
      step(before, event);
      return;
    }
    const after = { ...before, x: event.clientX, y: event.clientY };
    const other = [...downs].find(([id, { task }]) => id !== event.pointerId && task !== 'step')?.[1];
    const [x, y] = [(after.x - before.x) * scale(), (after.y - before.y) * scale()];
    downs.set(event.pointerId, after);
    if (actions.mode() === 'walk') actions.look(x * LOOK, y * LOOK);
    else if (other) pinch(before, after, other);
    else if (before.task === 'pan') actions.pan(-x * PAN, y * PAN);
    else actions.rotate(-x * AROUND, -y * AROUND);
  }

  function step({ x, y }: { x: number; y: number }, { clientX, clientY }: PointerEvent): void {
    const [right, down] = beyondRest((clientX - x) / THUMB_REACH, (clientY - y) / THUMB_REACH, THUMB_REST);
    drive = { ...REST, right, ahead: 0 - down };
    actions.thumb({ x, y, right: clientX - x, down: clientY - y });
  }

  /** One of two fingers has moved: their middle pans, their distance zooms. */
  function pinch(before: Down, after: Down, other: Down): void {
    const [was, is] = [before, after].map(({ x, y }) => Math.hypot(x - other.x, y - other.y));
    if (was && is) actions.zoom(was / is);
    const half = (0.5 * PAN) * scale();
    actions.pan(-(after.x - before.x) * half, (after.y - before.y) * half);
  }

  function up(event: PointerEvent): void {
    if (event.pointerType === 'touch') taps.up(event);
    if (downs.get(event.pointerId)?.task === 'step') rest();
    downs.delete(event.pointerId);
  }

  function rest(): void {
    drive = REST;
    actions.thumb(null);
  }

  function wheel(event: WheelEvent): void {
    // With Ctrl it is the browser's own zoom; pinching on a touchpad reads the same, and is meant for the scene.
    if (actions.mode() !== 'orbit') return;
    event.preventDefault();
    actions.zoom(Math.exp(WHEEL * event.deltaY * (WHEEL_PIXELS[event.deltaMode] ?? 1) * (event.ctrlKey ? 6 : 1)));
  }

  function lock(): void {
    if (actions.mode() !== 'walk') return;
    // Browsers refuse it in frames and shortly after Escape; dragging still works.
    Promise.resolve(element.requestPointerLock()).catch(() => undefined);
  }

  const { signal } = stop;
  element.addEventListener('pointerdown', down, { signal });
  element.addEventListener('pointermove', move, { signal });
  element.addEventListener('pointerup', up, { signal });
  element.addEventListener('pointercancel', up, { signal });
  // At the speed that the system is set to; of two taps only some browsers tell, so these are told apart here.
  element.addEventListener('dblclick', (event) => isTouch || go(event), { signal });
  element.addEventListener('wheel', wheel, { signal, passive: false });
  element.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });

  function release(): void {
    downs.clear();
    rest();
    if (isLocked()) element.ownerDocument.exitPointerLock();
  }

  return {
    get drive() {
      return drive;
    },
    lock,
    release,
    dispose() {
      release();
      stop.abort();
    },
  };
}
