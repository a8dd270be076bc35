/** Movement commands of keys, touch and gamepads, as fractions of full speed. */

/** Current movement commands, as fractions of full speed from −1 to 1. */
export interface Drive {
  /** Steps to the right and ahead. */
  readonly right: number;
  readonly ahead: number;
  /** Turns to the left and up. */
  readonly turn: number;
  readonly look: number;
  readonly isRunning: boolean;
}

export const NO_MOTION: Drive = { right: 0, ahead: 0, turn: 0, look: 0, isRunning: false };

/** Adds commands, and limits the sum to full speed. */
export function combine(...drives: readonly Drive[]): Drive {
  const sum = (part: (drive: Drive) => number): number => drives.reduce((total, drive) => total + part(drive), 0);
  const [right, ahead] = clampLength(sum((drive) => drive.right), sum((drive) => drive.ahead));
  const [turn, look] = clampLength(sum((drive) => drive.turn), sum((drive) => drive.look));
  return { right, ahead, turn, look, isRunning: drives.some((drive) => drive.isRunning) };
}

/** Limits a vector to length 1. */
function clampLength(x: number, y: number): readonly [number, number] {
  const length = Math.max(Math.hypot(x, y), 1);
  return [x / length, y / length];
}

/** Applies a dead zone to the position of a stick: 0 up to the zone's edge, then growing linearly to 1. */
export function applyDeadZone(x: number, y: number, deadZone: number): readonly [number, number] {
  const length = Math.hypot(x, y);
  if (!(length > deadZone)) return [0, 0];
  const scale = Math.min((length - deadZone) / (1 - deadZone), 1) / length;
  return [x * scale, y * scale];
}

/** For each physical key code: steps to the right and ahead, turns to the left and up, then axes of the caller. */
export type KeyAxes = Readonly<Record<string, readonly number[]>>;

const AXES: KeyAxes = {
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

/** Whether the key with a physical code moves the user. */
export function isMovementKey(code: string): boolean {
  return Object.hasOwn(AXES, code);
}

/** Whether a key event has another purpose: a browser shortcut, or typing into a field. */
export function hasOtherPurpose(event: KeyboardEvent): boolean {
  if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return true;
  const { target } = event;
  return typeof Element !== 'undefined' && target instanceof Element && target.closest(TEXT_FIELDS) !== null;
}

const TEXT_FIELDS = 'input, textarea, select, [contenteditable], dialog[open]';

/** Listens to the keys of a window or an element; `extraAxes` adds keys. */
export function createKeys(source: EventTarget, extraAxes: KeyAxes = {}) {
  const axesByCode = { ...AXES, ...extraAxes };
  const pressedCodes = new Set<string>();
  const controller = new AbortController();
  const listen = (name: string, action: (event: KeyboardEvent) => void): void =>
    source.addEventListener(name, action as EventListener, { signal: controller.signal });
  let isRunning = false;

  listen('keydown', (event) => {
    isRunning = event.shiftKey;
    if (!Object.hasOwn(axesByCode, event.code) || hasOtherPurpose(event)) return;
    pressedCodes.add(event.code);
    // Otherwise arrow keys would scroll the page. The space bar must still press a focused button.
    if (event.code !== 'Space' || !(event.target instanceof HTMLButtonElement)) event.preventDefault();
  });
  listen('keyup', ({ shiftKey, code, key }) => {
    isRunning = shiftKey;
    pressedCodes.delete(code);
    // macOS sends no keyup events while Command is held.
    if (key === 'Meta') pressedCodes.clear();
  });
  // A key released elsewhere sends no event.
  listen('blur', () => {
    pressedCodes.clear();
    isRunning = false;
  });

  /** Sum of the pressed keys along an axis. */
  const sumOf = (axis: number): number =>
    [...pressedCodes].reduce((sum, code) => sum + (axesByCode[code]?.[axis] ?? 0), 0);

  return {
    sumOf,
    get drive(): Drive {
      const [right, ahead, turn, look] = [sumOf(0), sumOf(1), sumOf(2), sumOf(3)];
      const [clampedRight, clampedAhead] = clampLength(right, ahead);
      return { right: clampedRight, ahead: clampedAhead, turn: Math.sign(turn), look: Math.sign(look), isRunning };
    },
    dispose: (): void => controller.abort(),
  };
}

/** Dead zone as a fraction of a stick's range: worn sticks do not return to 0. */
const DEAD_ZONE = 0.18;
/** Buttons for running, by number in the standard layout: left shoulder, left stick. */
const RUN_BUTTONS = [4, 10] as const;

/** Subset of the browser's Gamepad. */
export interface Pad {
  readonly connected: boolean;
  readonly mapping: string;
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean }[];
}

/** Combines the commands of all gamepads that have the standard layout. */
export function readPads(pads: readonly (Pad | null)[]): Drive {
  return combine(...pads.flatMap((pad) => (pad?.connected && pad.mapping === 'standard' ? [driveOf(pad)] : [])));
}

function driveOf({ axes, buttons }: Pad): Drive {
  const [right, back] = applyDeadZone(axes[0] ?? 0, axes[1] ?? 0, DEAD_ZONE);
  const [clockwise, down] = applyDeadZone(axes[2] ?? 0, axes[3] ?? 0, DEAD_ZONE);
  const isRunning = RUN_BUTTONS.some((number) => buttons[number]?.pressed ?? false);
  // Subtracted from 0, so that a stick at rest gives 0 instead of −0.
  return { right, ahead: 0 - back, turn: 0 - clockwise, look: 0 - down, isRunning };
}

export function browserPads(): readonly (Pad | null)[] {
  // Pages without https, or with a policy against gamepads, throw here.
  try {
    return navigator.getGamepads?.() ?? [];
  } catch {
    return [];
  }
}
