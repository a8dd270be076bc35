/** Flying along the view, sideways, up and down, at a speed proportional to the height; the pose at the start. */
import { browserPads, combine, createKeys, type Drive, hasOtherPurpose, readPads } from '../control/drive';
import { createPointers, type Thumb } from '../control/pointers';
import { addScaled, ahead, clamp, type Pose, rightOf, STEEPEST, type Vector } from '../control/pose';
import type { Layout } from './store/layout';

/** Metres per second for each metre above the ground, and least height that counts, metres. */
const [SPEED, LOWEST] = [0.6, 3] as const;
/** Factor with Shift; greatest exponent (powers of two) of the wheel's speed factor, and exponent per wheel pixel. */
const [HASTE, FASTEST, WHEEL] = [4, 5, 0.004] as const;
/** Turning speed, radians per second. */
const TURN = 1.2;
/** Longest time per update, seconds: a page that was hidden continues where it was. */
const LONGEST = 0.25;

/** Vertical direction by physical key code; up is positive. */
const RISE: Readonly<Record<string, number>> = { KeyE: 1, Space: 1, KeyQ: -1, KeyC: -1 };

/** Pose after some seconds of commands; `rise` is upward. `ground` is the height of the world's bottom, metres. */
export function advanceFlight(
  pose: Pose,
  drive: Drive,
  rise: number,
  power: number,
  ground: number,
  seconds: number,
): Pose {
  const yaw = pose.yaw + TURN * drive.turn * seconds;
  const pitch = clamp(pose.pitch + TURN * drive.look * seconds, -STEEPEST, STEEPEST);
  const height = Math.max(pose.position[1] - ground, LOWEST);
  const way = SPEED * height * 2 ** power * (drive.isRunning ? HASTE : 1) * seconds;
  let position: Vector = addScaled(pose.position, ahead({ yaw, pitch }), way * drive.ahead);
  position = addScaled(position, rightOf(yaw), way * drive.right);
  return { position: addScaled(position, [0, 1, 0], way * rise), yaw, pitch };
}

export interface Fly {
  readonly pose: Pose;
  /** Speed exponent, as a power of two. */
  readonly power: number;
  /** Pose after further seconds. */
  update(seconds: number): Pose;
  setPose(pose: Pose): void;
}

/** Controls a pose by input on an element, which should be focusable. */
export function createFly(
  element: HTMLElement,
  start: Pose,
  ground: () => number,
  onThumb: (thumb: Thumb | null) => void,
): Fly {
  let pose = start;
  let power = 0;
  const held = new Set<string>();
  const keys = createKeys(window);
  const turn = (left: number, up: number): void => {
    pose = { ...pose, yaw: pose.yaw + left, pitch: clamp(pose.pitch + up, -STEEPEST, STEEPEST) };
  };
  const none = (): void => undefined;
  const pointers = createPointers(element, {
    mode: () => 'walk',
    look: turn,
    rotate: none,
    pan: none,
    zoom: none,
    thumb: onThumb,
    go: none,
  });

  window.addEventListener('keydown', (event) => {
    if (!Object.hasOwn(RISE, event.code) || hasOtherPurpose(event)) return;
    held.add(event.code);
    // Otherwise the space bar presses buttons.
    if (!(event.target instanceof HTMLButtonElement)) event.preventDefault();
  });
  window.addEventListener('keyup', ({ code }) => held.delete(code));
  window.addEventListener('blur', () => held.clear());
  element.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      power = clamp(power - WHEEL * event.deltaY * (event.deltaMode === 1 ? 16 : 1), -FASTEST, FASTEST);
    },
    { passive: false },
  );

  return {
    get pose() {
      return pose;
    },
    get power() {
      return power;
    },
    update(seconds) {
      const spent = seconds > 0 ? Math.min(seconds, LONGEST) : 0;
      const drive = combine(keys.drive, pointers.drive, readPads(browserPads()));
      const rise = Math.sign([...held].reduce((sum, code) => sum + (RISE[code] ?? 0), 0));
      const isStill = rise === 0 && [drive.right, drive.ahead, drive.turn, drive.look].every((part) => part === 0);
      if (!isStill) pose = advanceFlight(pose, drive, rise, power, ground(), spent);
      return pose;
    },
    setPose(next) {
      pose = next;
    },
  };
}

/** Distance from the centre in widths of the world, and downward angle of the view, radians. */
const [AWAY, DOWN] = [0.55, 0.45] as const;

/** Pose south of and above the world, looking at its centre. */
export function startOf({ origin, cell, counts }: Layout): Pose {
  const middle = origin.map((low, axis) => low + (cell * (counts[axis] as number)) / 2) as [number, number, number];
  const away = AWAY * cell * Math.max(counts[0], counts[2]);
  const position = [middle[0], origin[1] + away * Math.sin(DOWN), middle[2] + away * Math.cos(DOWN)] as const;
  return { position, yaw: 0, pitch: -DOWN };
}
