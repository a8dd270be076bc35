/** Shared task of the users of a room. */
import type { Pose } from '../control/pose';
import type { Vector } from '../control/vector';
import type { Guests } from '../show/picture';
import type { FromServer } from './frames';
import type { Place } from './hold';
import type { Body } from './pose';

/** Shared task, which draws its meshes like those of guests. */
export interface Activity extends Guests {
  /** Whether users point even without holding a button. */
  readonly isPointing: boolean;
  /** Handles a frame of the server. */
  heard(frame: FromServer, now: number): void;
  /** Updates the task before each frame with the user's pose and the body that others see. */
  frame(pose: Pose, body: Body, now: number): void;
  /** Returns the world point at a place of the picture; null if the scene determines it. */
  targetAt(pose: Pose, place: Place): Vector | null;
}
