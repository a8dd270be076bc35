/** Input by mouse, pen and touch: dragging, two fingers, double taps, the wheel, and pointer lock. */
import { applyDeadZone, type Drive, NO_MOTION } from './drive';

/** Radians per drag by the picture's height: for a walker's head, and for orbiting. */
const [LOOK_RADIANS, ORBIT_RADIANS] = [1.6, Math.PI] as const;
/** Pan per drag by the picture's height, as a multiple of the orbit's distance. */
const PAN = 1.5;
/** Zoom exponent per pixel of the wheel; pixels per unit of a wheel event: pixel, line, page. */
const WHEEL = 0.0015;
const WHEEL_PIXELS = [1, 16, 400] as const;
/** Distance in pixels from the left thumb's start to full speed, and the dead zone as a share of it. */
export const THUMB_REACH = 56;
const THUMB_DEAD_ZONE = 0.12;

export type Mode = 'walk' | 'orbit';

/** Left thumb: start position, and offset from it, in window pixels. */
export type Thumb = Readonly<Record<'x' | 'y' | 'right' | 'down', number>>;

export interface PointerActions {
  readonly mode: () => Mode;
  /** Turn a walker's head, and orbit, by radians to the left and up. */
  look(left: number, up: number): void;
  rotate(left: number, up: number): void;
  pan(right: number, up: number): void;
  zoom(factor: number): void;
  thumb(thumb: Thumb | null): void;
  /** Called on a double tap or double click; x and y are shares of the width and height, from the upper left. */
  go(x: number, y: number): void;
}

/** A finger, or a mouse with a button down. */
interface Press {
  readonly x: number;
  readonly y: number;
  /** `step` for the left thumb; `pan` for all buttons but the first. */
  readonly task: 'turn' | 'step' | 'pan';
}

export function createPointers(element: HTMLElement, actions: PointerActions) {
  const presses = new Map<number, Press>();
  const stop = new AbortController();
  let drive = NO_MOTION;

  const taps = createTaps(go);
  let isTouch = false;

  const scale = (): number => 1 / Math.max(element.clientHeight, 1);
  const isLocked = (): boolean => element.ownerDocument.pointerLockElement === element;

  function go({ clientX, clientY }: { readonly clientX: number; readonly clientY: number }): void {
    const { left, top, width, height } = element.getBoundingClientRect();
    // A locked pointer is in the middle of the picture.
    if (isLocked()) actions.go(0.5, 0.5);
    else actions.go((clientX - left) / Math.max(width, 1), (clientY - top) / Math.max(height, 1));
  }

  function down(event: PointerEvent): void {
    // A locked pointer looks around without buttons, and cannot be captured.
    if (isLocked()) return;
    isTouch = event.pointerType === 'touch';
    const isMouse = event.pointerType === 'mouse';
    const isFirst = event.button === 0 && !event.shiftKey;
    if (actions.mode() === 'walk' && isMouse && !isFirst) return;
    element.setPointerCapture(event.pointerId);
    if (isTouch) taps.down(event);
    const task = isThumb(event) ? 'step' : isFirst ? 'turn' : 'pan';
    presses.set(event.pointerId, { x: event.clientX, y: event.clientY, task });
    if (task === 'step') step({ x: event.clientX, y: event.clientY }, event);
  }

  /** Whether a touch controls walking: the first touch in the left half does. */
  function isThumb({ pointerType, clientX }: PointerEvent): boolean {
    if (actions.mode() !== 'walk' || pointerType !== 'touch') return false;
    if ([...presses.values()].some(({ task }) => task === 'step')) return false;
    const { left, width } = element.getBoundingClientRect();
    return clientX - left < width / 2;
  }

  function move(event: PointerEvent): void {
    const before = presses.get(event.pointerId);
    if (!before) {
      if (isLocked()) actions.look(-event.movementX * LOOK_RADIANS * scale(), -event.movementY * LOOK_RADIANS * scale());
      return;
    }
    if (before.task === 'step') return step(before, event);
    const after = { ...before, x: event.clientX, y: event.clientY };
    const other = [...presses].find(([id, { task }]) => id !== event.pointerId && task !== 'step')?.[1];
    const [x, y] = [(after.x - before.x) * scale(), (after.y - before.y) * scale()];
    presses.set(event.pointerId, after);
    if (actions.mode() === 'walk') actions.look(x * LOOK_RADIANS, y * LOOK_RADIANS);
    else if (other) pinch(before, after, other);
    else if (before.task === 'pan') actions.pan(-x * PAN, y * PAN);
    else actions.rotate(-x * ORBIT_RADIANS, -y * ORBIT_RADIANS);
  }

  function step({ x, y }: { x: number; y: number }, { clientX, clientY }: PointerEvent): void {
    const [right, back] = applyDeadZone((clientX - x) / THUMB_REACH, (clientY - y) / THUMB_REACH, THUMB_DEAD_ZONE);
    drive = { ...NO_MOTION, right, ahead: 0 - back };
    actions.thumb({ x, y, right: clientX - x, down: clientY - y });
  }

  /** Handles a move of one of two fingers: their midpoint pans, their distance zooms. */
  function pinch(before: Press, after: Press, other: Press): void {
    const [oldGap, newGap] = [before, after].map(({ x, y }) => Math.hypot(x - other.x, y - other.y));
    if (oldGap && newGap) actions.zoom(oldGap / newGap);
    const halfPan = 0.5 * PAN * scale();
    actions.pan(-(after.x - before.x) * halfPan, (after.y - before.y) * halfPan);
  }

  function up(event: PointerEvent): void {
    if (event.pointerType === 'touch') taps.up(event);
    if (presses.get(event.pointerId)?.task === 'step') stopThumb();
    presses.delete(event.pointerId);
  }

  function stopThumb(): void {
    drive = NO_MOTION;
    actions.thumb(null);
  }

  function wheel(event: WheelEvent): void {
    // With Ctrl, browsers report the wheel for their own zoom and for touchpad pinches; both zoom the scene here.
    if (actions.mode() !== 'orbit') return;
    event.preventDefault();
    actions.zoom(Math.exp(WHEEL * event.deltaY * (WHEEL_PIXELS[event.deltaMode] ?? 1) * (event.ctrlKey ? 6 : 1)));
  }

  /** Locks the pointer to look around without a button, until Escape. */
  function lock(): void {
    if (actions.mode() !== 'walk') return;
    // Browsers refuse a lock in frames and shortly after Escape; dragging still works.
    Promise.resolve(element.requestPointerLock()).catch(() => undefined);
  }

  const { signal } = stop;
  element.addEventListener('pointerdown', down, { signal });
  element.addEventListener('pointermove', move, { signal });
  element.addEventListener('pointerup', up, { signal });
  element.addEventListener('pointercancel', up, { signal });
  // Browsers time double clicks by the system's setting; few report double taps, which `taps` detects.
  element.addEventListener('dblclick', (event) => isTouch || go(event), { signal });
  element.addEventListener('wheel', wheel, { signal, passive: false });
  element.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });

  /** Discards all fingers, because the mode has changed. */
  function release(): void {
    presses.clear();
    stopThumb();
    if (isLocked()) element.ownerDocument.exitPointerLock();
  }

  return {
    /** Movement command of the left thumb. */
    get drive(): Drive {
      return drive;
    },
    lock,
    release,
    dispose(): void {
      release();
      stop.abort();
    },
  };
}

/** Greatest duration of a tap, and pause between two taps, milliseconds; greatest movement meanwhile, pixels. */
const [MAX_TAP_MS, MAX_PAUSE_MS, MAX_TAP_PIXELS] = [300, 400, 16] as const;

type Event = Pick<PointerEvent, 'pointerId' | 'clientX' | 'clientY' | 'timeStamp'>;

/** Detects double taps; `onDoubleTap` receives the second tap. */
export function createTaps(onDoubleTap: (event: Event) => void) {
  const downs = new Map<number, Event>();
  let last: Event | null = null;

  const isNear = (a: Event, b: Event): boolean => Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY) <= MAX_TAP_PIXELS;

  return {
    down(event: Event): void {
      // Two fingers at a time do not tap.
      if (downs.size > 0) last = null;
      downs.set(event.pointerId, event);
    },
    up(event: Event): void {
      const firstEvent = downs.get(event.pointerId);
      const isAlone = downs.size === 1;
      downs.delete(event.pointerId);
      const isTap = firstEvent && isAlone && event.timeStamp - firstEvent.timeStamp <= MAX_TAP_MS && isNear(firstEvent, event);
      if (!isTap) {
        last = null;
        return;
      }
      const isSecond = last !== null && event.timeStamp - last.timeStamp <= MAX_PAUSE_MS && isNear(last, event);
      last = isSecond ? null : event;
      if (isSecond) onDoubleTap(event);
    },
  };
}
