/** Flight along the view, sideways, up and down, at a speed proportional to the height; and the first pose. */
import { browserPads, combine, createKeys, type Drive, type KeyAxes, readPads } from '../control/drive';
import { createPointers, type Thumb } from '../control/pointers';
import { addScaled, ahead, clamp, MAX_PITCH, type Pose, rightOf, type Vector } from '../control/pose';
import type { Layout } from './store/layout';

/** Speed in metres per second, per metre of height above the ground. */
const SPEED_PER_HEIGHT = 0.6;
/** Least height from which the speed is computed, metres. */
const MIN_HEIGHT = 3;
/** Speed factor while Shift is pressed. */
const RUN_FACTOR = 4;
/** The mouse wheel multiplies the speed by 2^exponent; greatest absolute value of the exponent. */
const MAX_EXPONENT = 5;
/** Change of the exponent per pixel that the wheel scrolls. */
const EXPONENT_PER_PIXEL = 0.004;
/** Turning speed, radians per second. */
const TURN_SPEED = 1.2;
/** Greatest time per update, seconds: the pose does not jump when a hidden page is shown again. */
const MAX_UPDATE_SECONDS = 0.25;

/** Index of the keys' axis for vertical flight; up is positive. */
const VERTICAL = 4;
const [UP, DOWN] = [[0, 0, 0, 0, 1], [0, 0, 0, 0, -1]] as const;
const VERTICAL_KEYS: KeyAxes = { KeyE: UP, Space: UP, KeyQ: DOWN, KeyC: DOWN };

/**
 * Returns the pose after some seconds of input. `rise` is 1 for up and −1 for down, 2^`speedExponent` is a factor of
 * the speed, and `ground` is the height of the world's bottom, metres.
 */
export function advanceFlight(
  pose: Pose,
  drive: Drive,
  rise: number,
  speedExponent: number,
  ground: number,
  seconds: number,
): Pose {
  const yaw = pose.yaw + TURN_SPEED * drive.turn * seconds;
  const pitch = clamp(pose.pitch + TURN_SPEED * drive.look * seconds, -MAX_PITCH, MAX_PITCH);
  const height = Math.max(pose.position[1] - ground, MIN_HEIGHT);
  const step = SPEED_PER_HEIGHT * height * 2 ** speedExponent * (drive.isRunning ? RUN_FACTOR : 1) * seconds;
  let position: Vector = addScaled(pose.position, ahead({ yaw, pitch }), step * drive.ahead);
  position = addScaled(position, rightOf(yaw), step * drive.right);
  return { position: addScaled(position, [0, 1, 0], step * rise), yaw, pitch };
}

/** Flies a pose by input on an element, which should be focusable. */
export function createFly(
  element: HTMLElement,
  start: Pose,
  ground: () => number,
  onThumb: (thumb: Thumb | null) => void,
) {
  let pose = start;
  let speedExponent = 0;
  const keys = createKeys(window, VERTICAL_KEYS);
  const ignore = (): void => undefined;
  const pointers = createPointers(element, {
    ...{ rotate: ignore, pan: ignore, zoom: ignore, go: ignore },
    mode: () => 'walk',
    look(left, up) {
      pose = { ...pose, yaw: pose.yaw + left, pitch: clamp(pose.pitch + up, -MAX_PITCH, MAX_PITCH) };
    },
    thumb: onThumb,
  });

  element.addEventListener('wheel', (event) => {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : 1);
    speedExponent = clamp(speedExponent - EXPONENT_PER_PIXEL * pixels, -MAX_EXPONENT, MAX_EXPONENT);
  }, { passive: false });

  return {
    get pose(): Pose {
      return pose;
    },
    /** Base-2 logarithm of the speed factor. */
    get speedExponent(): number {
      return speedExponent;
    },
    /** Advances the pose by some seconds, and returns it. */
    update(seconds: number): Pose {
      const elapsed = seconds > 0 ? Math.min(seconds, MAX_UPDATE_SECONDS) : 0;
      const drive = combine(keys.drive, pointers.drive, readPads(browserPads()));
      const rise = Math.sign(keys.sumOf(VERTICAL));
      const isStill = rise === 0 && [drive.right, drive.ahead, drive.turn, drive.look].every((part) => part === 0);
      if (!isStill) pose = advanceFlight(pose, drive, rise, speedExponent, ground(), elapsed);
      return pose;
    },
    setPose(next: Pose): void {
      pose = next;
    },
  };
}

/** Distance of the first view from the world's centre, in widths of the world. */
const START_DISTANCE = 0.55;
/** Downward angle of the first view, radians. */
const START_SLOPE = 0.45;

/** Pose south of and above the world, looking at its centre. */
export function startPose({ origin, cell, counts }: Layout): Pose {
  const center = origin.map((low, axis) => low + (cell * (counts[axis] as number)) / 2) as [number, number, number];
  const distance = START_DISTANCE * cell * Math.max(counts[0], counts[2]);
  const [height, southward] = [distance * Math.sin(START_SLOPE), distance * Math.cos(START_SLOPE)];
  const position = [center[0], origin[1] + height, center[2] + southward] as const;
  return { position, yaw: 0, pitch: -START_SLOPE };
}
