/** First-person walking at a constant eye height; independent of a browser. */
import type { Drive } from './drive';
import { type Bounds, confine, leadBack } from './limit';
import { clamp, type Pose, rightOf, STEEPEST, type Vector } from './pose';

/** Walking speed, metres per second, and factor for running. */
const [SPEED, HASTE] = [1.6, 3] as const;
/** Turning speed, radians per second. */
const TURN = 1.4;
/** Time constants in seconds (to 1/e) of the speed, and of the eye's return to its height. */
const [START, RISE] = [0.09, 0.25] as const;
/** Longest integration step, seconds; within it the path is straight. */
const STEP = 1 / 120;

export interface Walk {
  readonly pose: Pose;
  /** Advances by some seconds. */
  update(seconds: number, drive: Drive): void;
  /** Turns at once, radians to the left and up. */
  look(left: number, up: number): void;
  /** Moves the user; the new height is the eye height from then on. */
  setPose(pose: Pose): void;
  /** Continues from a pose to which the user's own body has moved the head, with its height; the speed stays. */
  follow(pose: Pose): void;
  /** Takes over from another mode; the eye returns to its height in a moment. */
  resume(pose: Pose): void;
}

/** `isSudden` makes speeds and heights change at once, for users prone to motion sickness. */
export function createWalk(start: Pose, bounds: () => Bounds | null, isSudden: () => boolean): Walk {
  let { position, yaw, pitch } = start;
  let height = position[1];
  // Metres per second to the right and ahead.
  let velocity: readonly [number, number] = [0, 0];

  function step(seconds: number, drive: Drive): void {
    const turned = TURN * drive.turn * seconds;
    const middle = yaw + turned / 2;
    yaw += turned;
    pitch = clamp(pitch + TURN * drive.look * seconds, -STEEPEST, STEEPEST);
    const speed = SPEED * (drive.isRunning ? HASTE : 1);
    const [right, rightSpeed] = glide(velocity[0], speed * drive.right, seconds, isSudden());
    const [front, frontSpeed] = glide(velocity[1], speed * drive.ahead, seconds, isSudden());
    velocity = [rightSpeed, frontSpeed];
    const [x, , z] = rightOf(middle);
    const drop = isSudden() ? 0 : (position[1] - height) * Math.exp(-seconds / RISE);
    // Ahead on the ground is (z, −x) if right is (x, z).
    const wanted: Vector = [position[0] + x * right + z * front, height + drop, position[2] + z * right - x * front];
    position = leadBack(confine(position, wanted, bounds()), bounds(), seconds);
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
      pitch = clamp(pitch + up, -STEEPEST, STEEPEST);
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
 * Distance covered and speed reached when the speed v tends to a goal g by dv/dt = (g − v) / START. The closed form
 * makes one long step equal many short ones.
 */
function glide(speed: number, goal: number, seconds: number, isSudden: boolean): readonly [number, number] {
  if (isSudden) return [goal * seconds, goal];
  const left = Math.exp(-seconds / START);
  return [goal * seconds + (speed - goal) * START * (1 - left), goal + (speed - goal) * left];
}
