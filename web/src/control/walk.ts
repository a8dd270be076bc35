/** First-person walking at a constant eye height; independent of a browser. */
import type { Drive } from './drive';
import { type Bounds, confine, leadBack } from './limit';
import { clamp, MAX_PITCH, type Pose, rightOf, type Vector } from './pose';

/** Walking speed, metres per second. */
const SPEED = 1.6;
/** Running speed divided by walking speed. */
const RUN_FACTOR = 3;
/** Turning speed, radians per second. */
const TURN_SPEED = 1.4;
/** Seconds in which the difference from the goal speed falls to 1/e. */
const SPEED_TIME = 0.09;
/** Seconds in which the eye's difference from its height falls to 1/e. */
const HEIGHT_TIME = 0.25;
/** Longest integration step, seconds; the path is straight within a step. */
const MAX_STEP = 1 / 120;

/** Creates a walker; `isSudden` makes speed and height change at once, for users prone to motion sickness. */
export function createWalk(start: Pose, bounds: () => Bounds | null, isSudden: () => boolean) {
  let { position, yaw, pitch } = start;
  let height = position[1];
  // Metres per second to the right and ahead.
  let velocity: readonly [number, number] = [0, 0];

  function step(seconds: number, drive: Drive): void {
    const turnAngle = TURN_SPEED * drive.turn * seconds;
    const middleYaw = yaw + turnAngle / 2;
    yaw += turnAngle;
    pitch = clamp(pitch + TURN_SPEED * drive.look * seconds, -MAX_PITCH, MAX_PITCH);
    const speed = SPEED * (drive.isRunning ? RUN_FACTOR : 1);
    const [rightDistance, rightSpeed] = glide(velocity[0], speed * drive.right, seconds, isSudden());
    const [aheadDistance, aheadSpeed] = glide(velocity[1], speed * drive.ahead, seconds, isSudden());
    velocity = [rightSpeed, aheadSpeed];
    const [x, , z] = rightOf(middleYaw);
    const heightError = isSudden() ? 0 : (position[1] - height) * Math.exp(-seconds / HEIGHT_TIME);
    // Ahead on the ground is (z, −x) if right is (x, z).
    const target: Vector = [
      position[0] + x * rightDistance + z * aheadDistance,
      height + heightError,
      position[2] + z * rightDistance - x * aheadDistance,
    ];
    position = leadBack(confine(position, target, bounds()), bounds(), seconds);
  }

  /** Continues from the pose of a tracked head, whose height becomes the eye height; the speed does not change. */
  function follow(pose: Pose): void {
    ({ position, yaw, pitch } = pose);
    height = position[1];
  }

  return {
    get pose(): Pose {
      return { position, yaw, pitch };
    },
    update(seconds: number, drive: Drive): void {
      const steps = Math.ceil(seconds / MAX_STEP);
      for (let number = 0; number < steps; number++) step(seconds / steps, drive);
    },
    /** Turns at once, radians to the left and up. */
    look(left: number, up: number): void {
      yaw += left;
      pitch = clamp(pitch + up, -MAX_PITCH, MAX_PITCH);
    },
    /** Moves the user; the new height is the eye height from then on. */
    setPose(pose: Pose): void {
      follow(pose);
      velocity = [0, 0];
    },
    follow,
    /** Continues from the pose of another mode at speed 0; the eye then returns to its height. */
    resume(pose: Pose): void {
      ({ position, yaw, pitch } = pose);
      velocity = [0, 0];
    },
  };
}

/**
 * Returns the distance and the final speed if the speed v tends to a goal g by dv/dt = (g − v) / SPEED_TIME. The closed
 * form makes one long step equal many short ones.
 */
function glide(speed: number, goal: number, seconds: number, isSudden: boolean): readonly [number, number] {
  if (isSudden) return [goal * seconds, goal];
  const decay = Math.exp(-seconds / SPEED_TIME);
  return [goal * seconds + (speed - goal) * SPEED_TIME * (1 - decay), goal + (speed - goal) * decay];
}
