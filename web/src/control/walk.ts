/** Walking in first person at a constant eye height; plain arithmetic without a browser. */
import type { Drive } from './drive';
import { type Bounds, confine, settle } from './limit';
import type { Pose } from './pose';
import { bounded, rightOf, STEEPEST, type Vector } from './vector';

/** Metres a second, and how much faster people run. */
const [SPEED, HASTE] = [1.6, 3] as const;
/** Radians a second. */
const TURN = 1.4;
/** Seconds in which the speed comes to within 1/e of what is asked for, and the eye to its height. */
const [START, RISE] = [0.09, 0.25] as const;
/** Longest step of the arithmetic, seconds: turns are straight within it. */
const STEP = 1 / 120;

export interface Walk {
  readonly pose: Pose;
  /** Go on by some seconds. */
  update(seconds: number, drive: Drive): void;
  /** Turn at once, radians to the left and up. */
  look(left: number, up: number): void;
  /** Stand somewhere else; its height is the eye height from then on. */
  setPose(pose: Pose): void;
  /** Go on from where the user's own body has moved the head, at its height; the speed stays. */
  follow(pose: Pose): void;
  /** Take over where another mode has led; the eye goes back to its height in a moment. */
  resume(pose: Pose): void;
}

/** `isSudden`: speeds and heights change at once, for people whom gliding makes sick. */
export function createWalk(start: Pose, bounds: () => Bounds | null, isSudden: () => boolean): Walk {
  let { position, yaw, pitch } = start;
  let height = position[1];
  // Metres a second to the right and ahead.
  let velocity: readonly [number, number] = [0, 0];

  function step(seconds: number, drive: Drive): void {
    const turned = TURN * drive.turn * seconds;
    const middle = yaw + turned / 2;
    yaw += turned;
    pitch = bounded(pitch + TURN * drive.look * seconds, -STEEPEST, STEEPEST);
    const speed = SPEED * (drive.isHasty ? HASTE : 1);
    const [right, rightSpeed] = glide(velocity[0], speed * drive.right, seconds, isSudden());
    const [front, frontSpeed] = glide(velocity[1], speed * drive.ahead, seconds, isSudden());
    velocity = [rightSpeed, frontSpeed];
    const [x, , z] = rightOf(middle);
    const drop = isSudden() ? 0 : (position[1] - height) * Math.exp(-seconds / RISE);
    // Ahead on the ground is (z, −x), where right is (x, z).
    const wanted: Vector = [position[0] + x * right + z * front, height + drop, position[2] + z * right - x * front];
    position = settle(confine(position, wanted, bounds()), bounds(), seconds);
  }

  function follow(pose: Pose): void {
    ({ position, yaw, pitch } = pose);
    height = position[1];
  }

  return {
    get pose() {
      return { position, yaw, pitch };
    },
    update(seconds, drive) {
      const steps = Math.ceil(seconds / STEP);
      for (let number = 0; number < steps; number++) step(seconds / steps, drive);
    },
    look(left, up) {
      yaw += left;
      pitch = bounded(pitch + up, -STEEPEST, STEEPEST);
    },
    setPose(pose) {
      follow(pose);
      velocity = [0, 0];
    },
    follow,
    resume(pose) {
      ({ position, yaw, pitch } = pose);
      velocity = [0, 0];
    },
  };
}

/**
 * Metres gone and speed reached when the speed v tends to a goal g by dv/dt = (g − v) / START. The closed form makes
 * one long step equal many short ones.
 */
function glide(speed: number, goal: number, seconds: number, isSudden: boolean): readonly [number, number] {
  if (isSudden) return [goal * seconds, goal];
  const left = Math.exp(-seconds / START);
  return [goal * seconds + (speed - goal) * START * (1 - left), goal + (speed - goal) * left];
}
